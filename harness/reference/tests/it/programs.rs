//! The programs of `tests/programs`: what is wrong with them, and what they compute.
//!
//! `st` is followed by the dialects, of which `ironplc-ed3` is meant where none is named, and by options: `scans=2`, `steps=1000`,
//! and `repaired`, which applies every suggestion and expects that nothing is wrong then. The marks are those of
//! [`stickler_mdtest`]; `nothing` is the value that is not observed any more behind a fault. A program without an `error` mark is
//! accepted. `expressions` and `constants` are rows, which [`expression_gives`] and [`constant`] put into programs.

use stickler_mdtest::{Block, Difference, Marks, Reported, differences, same};
use stickler_reference::conversion::{conversion_function_name, implicit};
use stickler_reference::{Limits, check, errors, run, variables};
use stickler_types::{
    Diagnostic, Dialect, DialectName, ElementaryType, Observation, Outcome, RunRequest, Setting, Value,
};

#[test]
fn programs_are_judged_and_run_as_their_marks_say() {
    stickler_mdtest::check(
        concat!(env!("CARGO_MANIFEST_DIR"), "/tests/programs"),
        |block| match block.kind() {
            "st" => programs(block),
            "pairs" => pairs(block),
            "listed" => block.rows(listed),
            "constants" => block.rows(constant),
            "expressions" => block.rows(|expression, value| expression_gives(block, expression, value)),
            _ => vec![Difference::new(1, "no test reads such a block")],
        },
    );
}

/// What stands behind the fence of a program.
struct Options {
    dialects: Vec<DialectName>,
    scans: u32,
    limits: Limits,
    repaired: bool,
    errors_only: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            dialects: Vec::new(),
            scans: 1,
            limits: Limits::default(),
            repaired: false,
            errors_only: false,
        }
    }
}

impl Options {
    fn of(block: &Block) -> Options {
        let mut options = Options::default();
        for word in block.options() {
            match word.split_once('=') {
                Some(("scans", count)) => options.scans = count.parse().expect("a number of scans"),
                Some(("steps", count)) => options.limits.steps = count.parse().expect("a number of steps"),
                _ if word == "repaired" => options.repaired = true,
                _ if word == "all" => options.dialects.extend(DialectName::ALL),
                _ => options.dialects.push(word.parse().expect("a dialect")),
            }
        }
        if options.dialects.is_empty() {
            options.dialects.push(DialectName::IRONPLC_ED3);
        }
        options
    }
}

fn programs(block: &Block) -> Vec<Difference> {
    let options = Options::of(block);
    let mut found = Vec::new();
    for one in block.programs() {
        let marks = match one.marks() {
            Ok(marks) => marks,
            Err(wrong) => return vec![wrong],
        };
        for &dialect in &options.dialects {
            let of_dialect =
                |other: Difference| Difference::new(other.line, format!("{dialect}: {}", other.what));
            let differences = program(&one.text, &marks, dialect, &options).into_iter();
            found.extend(differences.map(|other| one.place(of_dialect(other))));
        }
    }
    found
}

/// Checks a program in a dialect, and runs it where its marks say what it computes.
fn program(text: &str, marks: &Marks, dialect: DialectName, options: &Options) -> Vec<Difference> {
    let checked = if options.errors_only { errors } else { check };
    let diagnostics = checked(text, dialect);
    let reported: Vec<_> = diagnostics.iter().map(|one| reported(one, text)).collect();
    let mut found = differences(&marks.diagnostics, &reported);
    if options.repaired {
        let left = checked(&repaired(text, &diagnostics), dialect);
        found.extend(
            left.iter()
                .map(|one| Difference::new(1, format!("after the repair: {one}"))),
        );
    }
    if !marks.values.is_empty() || marks.fault.is_some() {
        found.extend(execution(text, marks, dialect, options));
    }
    found
}

/// The bytes of a text that a diagnostic points at.
fn span(diagnostic: &Diagnostic, text: &str) -> std::ops::Range<usize> {
    let place = |line: Option<u32>, column: Option<u32>| {
        let (line, column) = (line.expect("a line") as usize, column.expect("a column") as usize);
        let before: usize = text.split_inclusive('\n').take(line - 1).map(str::len).sum();
        let in_line = text[before..].char_indices().nth(column - 1);
        in_line.map_or(text.len(), |(at, _)| before + at)
    };
    place(diagnostic.line, diagnostic.column)..place(diagnostic.end_line, diagnostic.end_column)
}

fn reported(diagnostic: &Diagnostic, text: &str) -> Reported {
    Reported {
        line: diagnostic.line.expect("a line"),
        severity: diagnostic.severity.as_str(),
        code: diagnostic.code.clone().expect("a code"),
        at: text[span(diagnostic, text)].to_owned(),
        message: diagnostic.message.clone(),
        suggestion: diagnostic.suggestion.clone(),
    }
}

/// Writes each suggestion in its place, the last one first.
fn repaired(text: &str, diagnostics: &[Diagnostic]) -> String {
    let mut repaired = text.to_owned();
    for diagnostic in diagnostics.iter().rev() {
        if let Some(suggestion) = &diagnostic.suggestion {
            repaired.replace_range(span(diagnostic, text), suggestion);
        }
    }
    repaired
}

/// Runs a program, and compares its fault and its values.
fn execution(text: &str, marks: &Marks, dialect: DialectName, options: &Options) -> Vec<Difference> {
    let observation = |value: &stickler_mdtest::Value| Observation {
        after: value.after,
        ..Observation::last(&value.path, "")
    };
    let setting = |(before, name, literal): &(u32, String, String)| Setting {
        before: *before,
        name: name.as_str().into(),
        value: Value::parse(literal).expect("a typed literal"),
    };
    let observe: Vec<_> = marks.values.iter().map(observation).collect();
    let set: Vec<_> = marks.settings.iter().map(setting).collect();
    let request = RunRequest {
        scans: options.scans,
        set: &set,
        ..RunRequest::once(dialect, text, &observe)
    };
    let (fault, values) = match run(&request, options.limits) {
        Ok(Outcome::Executed { values, .. }) => (None, values),
        Ok(Outcome::Faulted {
            fault, line, values, ..
        }) => (Some((fault.to_string(), line.unwrap_or(0))), values),
        other => return vec![Difference::new(1, format!("not executed: {other:?}"))],
    };
    let mut found = Vec::new();
    if fault != marks.fault {
        let line = marks.fault.as_ref().map_or(1, |(_, line)| *line as usize);
        found.push(Difference::new(
            line,
            format!("     got {fault:?}\nexpected {:?}", marks.fault),
        ));
    }
    for (mark, observation) in marks.values.iter().zip(&observe) {
        let got = values.iter().find(|(key, _)| observation.key().is(key));
        let got = got.map_or_else(|| "nothing".to_owned(), |(_, value)| value.to_string());
        let expected =
            Value::parse(&mark.literal).map_or_else(|_| mark.literal.clone(), |value| value.to_string());
        found.extend(
            same(got, expected)
                .err()
                .map(|what| Difference::new(mark.line, what)),
        );
    }
    found
}

/// Holds a program to its marks that has no block of its own.
fn told(text: &str, dialect: DialectName) -> Result<(), String> {
    let marks = Marks::of(text)?;
    let found = program(text, &marks, dialect, &Options::default());
    let found: Vec<_> = found
        .iter()
        .map(|one| format!("line {} of\n{text}: {}", one.line, one.what))
        .collect();
    if found.is_empty() {
        Ok(())
    } else {
        Err(found.join("\n"))
    }
}

/// Holds each program to its marks for every pair of types: see `tests/programs/pairs.md`.
fn pairs(block: &Block) -> Vec<Difference> {
    let mut found = Vec::new();
    let mut suggested = 0;
    for (dialect, from, to) in pairs_of_types() {
        let function = conversion_function_name(from, to, Dialect::of(dialect));
        let options = Options {
            repaired: function.is_some(),
            errors_only: true,
            ..Options::default()
        };
        for one in block.programs() {
            let text = one.text.replace("FROM", from.name()).replace("INTO", to.name());
            let text = text.replace(
                "FUNCTION(",
                &format!("{}(", function.as_deref().unwrap_or("FUNCTION")),
            );
            let mut marks = Marks::of(&text).expect("marks");
            if implicit(from, to, Dialect::of(dialect)).is_some() {
                marks.diagnostics.clear();
            } else if function.is_some() {
                suggested += 1;
            } else {
                for mark in &mut marks.diagnostics {
                    mark.suggests = Some(String::new());
                }
            }
            let about = |other: Difference| {
                one.place(Difference::new(1, format!("{dialect}: {text}\n{}", other.what)))
            };
            found.extend(program(&text, &marks, dialect, &options).into_iter().map(about));
        }
    }
    assert!(
        suggested > 5_000 * block.programs().len(),
        "only {suggested} programs are repaired"
    );
    found
}

/// Every pair of types that a dialect has, in every dialect.
fn pairs_of_types() -> impl Iterator<Item = (DialectName, ElementaryType, ElementaryType)> {
    DialectName::ALL.into_iter().flat_map(|dialect| {
        let types = move || {
            ElementaryType::ALL
                .into_iter()
                .filter(move |&ty| Dialect::of(dialect).may_name(ty))
        };
        types().flat_map(move |from| types().map(move |to| (dialect, from, to)))
    })
}

#[test]
fn a_suggestion_for_a_constant_that_is_a_limit_makes_the_program_acceptable() {
    let mut count = 0;
    for (dialect, from, to) in pairs_of_types().filter(|(_, _, to)| to.is_integer()) {
        let value = match conversion_function_name(ElementaryType::Int, from, Dialect::of(dialect)) {
            Some(function) => format!("{function}(INT#3)"),
            None if from == ElementaryType::Int => "3".to_owned(),
            None => continue,
        };
        let text = format!(
            "PROGRAM main VAR CONSTANT d : {from} := {value}; n : {to} := d; END_VAR
             VAR a : ARRAY[0..n] OF BOOL; hit : BOOL; END_VAR
             CASE 3 OF n: hit := TRUE; END_CASE; END_PROGRAM"
        );
        let diagnostics = check(&text, dialect);
        if diagnostics.iter().any(|one| one.suggestion.is_some()) {
            let repaired = repaired(&text, &diagnostics);
            assert_eq!(check(&repaired, dialect), [], "{dialect}: {repaired}");
            count += 1;
        }
    }
    assert!(count > 400, "only {count} were repaired");
}

/// Compares the first elementary values of a program with the names of a row, each of which can be observed: a row of `listed`.
fn listed(text: &str, names: &str) -> Result<(), String> {
    let found = variables(text, DialectName::IRONPLC_ED3, 20);
    let observe: Vec<_> = found.iter().map(|name| Observation::last(name, "")).collect();
    let request = RunRequest::once(DialectName::IRONPLC_ED3, text, &observe);
    run(&request, Limits::default()).map_err(|error| error.to_string())?;
    same(found.join(" "), names.to_owned())
}

/// Runs an expression, and compares what it gives: a row of `expressions`, `declarations | expression = value`.
fn expression_gives(block: &Block, row: &str, value: &str) -> Result<(), String> {
    let (variables, expression) = row.split_once('|').unwrap_or(("", row));
    let ty = match Value::parse(value) {
        Ok(value) => value.type_name().to_owned(),
        Err(_) => "LREAL".to_owned(),
    };
    let mark = match value.strip_prefix("fault ") {
        Some(fault) => format!("(*! fault {fault} *)"),
        None => format!("(*! values\nresult = {value}\n*)"),
    };
    let text = format!(
        "PROGRAM main VAR {variables} result : {ty}; END_VAR result := {expression}; END_PROGRAM {mark}"
    );
    Options::of(block)
        .dialects
        .into_iter()
        .try_for_each(|dialect| told(&text, dialect))
}

/// Holds an expression to the number that it stands for wherever a constant may stand and as the program runs, whether the
/// constants in it are global or local: a row of `constants`, `declarations | expression = number`.
fn constant(row: &str, number: &str) -> Result<(), String> {
    let (constants, expression) = row.split_once('|').unwrap_or(("", row));
    let (constants, expression) = (constants.trim(), expression.trim());
    let rest = include_str!("../programs/constant.st")
        .replace("{expression}", expression)
        .replace("{number}", number);
    let global = format!(
        "VAR_GLOBAL CONSTANT {constants} n : LINT := {expression}; END_VAR
         TYPE E : (RED := {expression}, GREEN); END_TYPE PROGRAM main {rest}"
    );
    let local = format!(
        "TYPE E : (RED := {number}); END_TYPE
         PROGRAM main VAR CONSTANT {constants} n : LINT := {expression}; END_VAR {rest}"
    );
    told(&global, DialectName::IRONPLC_ED3)?;
    told(&local, DialectName::IRONPLC_ED3)
}
