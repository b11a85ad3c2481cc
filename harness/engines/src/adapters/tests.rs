//! The tests that are tables in `tests/adapters.md`: what functions that several adapters share make of texts.

use super::command::{CommandTemplate, Filling};
use super::probe_variable::{ProbeVariable, with_probes};
use super::recipe::{PROGRAM, Recipe};
use super::settings::{copied_by_scan, with_settings};
use super::source::{enumeration, main_program, own_configuration};
use super::values::{ValueExpression, functions, kinds, statement, value, values};
use super::{builder, driver, rename, rusty, strucpp};
use crate::{Observation, RunRequest, Setting};
use std::collections::HashSet;
use std::path::Path;
use stickler_mdtest::{Example, check_examples};
use stickler_types::{DialectName, ElementaryType, Value};

#[test]
fn golden_texts_of_adapters() {
    check_examples("tests/adapters.md", |example| {
        let of_program = of_program(example).unwrap_or_else(|| of_text(example));
        of_program.unwrap_or_else(|| "none".to_owned())
    });
}

/// Returns what a function makes of the program of an example; `None` where the example has none.
fn of_program(example: &Example) -> Option<Option<String>> {
    let source = example.get("source").filter(|_| example.get("type").is_none())?;
    let request = RunRequest::once(DialectName::IRONPLC_ED2, source, &[]);
    let main = main_program(&request);
    Some(match example.wanted() {
        "main" => main.map(|main| {
            let returns = if main.returns { " and returns" } else { "" };
            format!("{}{returns}: {}", main.name, &source[main.inside])
        }),
        "instance" => own_configuration(&request, example.text("of"))
            .map(|found| format!("{} in {} of {}", found.instance, found.resource, found.name)),
        "enumeration" => enumeration(&request, example.text("of")).map(|values| values.join(", ")),
        "with settings" => {
            let set: Vec<Setting> = example.text("set").lines().map(setting).collect();
            with_settings(&RunRequest { set: &set, ..request })
        }
        "with copies" => {
            let scans = 1..=example.text("scans").parse().unwrap();
            let after = |scan| Observation {
                after: Some(scan),
                ..Observation::last("x", "INT")
            };
            let observe: Vec<Observation> = scans.map(after).collect();
            let request = RunRequest {
                scans: 6,
                observe: &observe,
                ..request
            };
            copied_by_scan(&request).map(|copied| {
                let names: Vec<&str> = copied.observe.iter().map(|copy| &*copy.name).collect();
                format!("{}\n{}", names.join(", "), copied.text)
            })
        }
        _ => main.map(|main| with_probes(source, &main, &probes(example))),
    })
}

/// Returns what a function makes of a command, or of a text that a program prints; `None` where it makes nothing.
fn of_text(example: &Example) -> Option<String> {
    let text = example.text("text");
    let template = CommandTemplate::parse(example.text("command"), &["file", "dialect", "LIB"]);
    match example.wanted() {
        "legend" => Recipe::of(PROGRAM, "").legend(&probes(example)).shown.pop(),
        "without the suffix of MAIN" => {
            let names = HashSet::from(["MAIN".to_owned()]);
            Some(rename::without(text, &names, "_program"))
        }
        "places" => Some(format!("{:?}", rename::places_named(text))),
        "words" => Some(format!("{:?}", template.unwrap().filled(&fill))),
        "of a shell" => Some(template.unwrap().for_shell(&fill).1),
        "mistake" => template.err(),
        "has LIB" => Some(template.unwrap().has("LIB").to_string()),
        "parts of 3" => Some(format!("{:?}", driver::parts(text, 3))),
        "short" => Some(rusty::short(text)),
        "capitals" => {
            let found: Vec<_> = strucpp::capitals(text).filter(|name| !name.is_empty()).collect();
            Some(found.join(", "))
        }
        "without folder" => Some(builder::without_folder(text, Path::new(example.text("folder")))),
        "functions" => Some(functions(text)).filter(|functions| !functions.is_empty()),
        _ => of_value(example),
    }
}

/// Returns what a function makes of a value of a type, or of what a driver printed of it.
fn of_value(example: &Example) -> Option<String> {
    let observe = [Observation::last("x", example.text("type"))];
    let request = RunRequest::once(DialectName::RUSTY, example.text("source"), &observe);
    let kinds = match kinds(&request, |ty| ty != ElementaryType::Ltime) {
        Ok(kinds) => kinds,
        Err(mistake) => return Some(mistake),
    };
    let v = || "v".to_owned();
    let printed = match example.text("form") {
        "" if example.wanted() == "values" => return values(example.text("text"), &request, &kinds).err(),
        "" => return value(&kinds[0], example.text("text")).map(|value| value.to_string()),
        "number" => ValueExpression::Number(v()),
        "timespec" => ValueExpression::Timespec(v()),
        "nanoseconds" => ValueExpression::Nanoseconds(v()),
        "days" => ValueExpression::Days(v()),
        _ => ValueExpression::Text {
            condition: "at < v.len".to_owned(),
            unit: "v.body[at]".to_owned(),
        },
    };
    Some(statement(&observe[0], &kinds[0], &printed))
}

/// Reads a line such as `1: a := BOOL#TRUE`.
fn setting(line: &str) -> Setting {
    let (before, assigned) = line.split_once(": ").unwrap();
    let (name, value) = assigned.split_once(" := ").unwrap();
    Setting {
        before: before.parse().unwrap(),
        name: name.into(),
        value: Value::parse(value).unwrap(),
    }
}

/// Reads the probe variables of an example, a line `name = expression` each.
fn probes(example: &Example) -> Vec<ProbeVariable> {
    let probe = |line: &str| {
        let (name, expression) = line.split_once(" =").unwrap();
        ProbeVariable {
            name: name.to_owned(),
            type_name: "INT".to_owned(),
            expression: expression.trim().to_owned(),
        }
    };
    example.text("probes").lines().map(probe).collect()
}

fn fill(name: &str) -> Filling<'static> {
    match name {
        "file" => Filling::text("program.st"),
        "dialect" => Filling::text("ed 2"),
        _ => Filling::Variable("LIB", Path::new("/opt/lib")),
    }
}
