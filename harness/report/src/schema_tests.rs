//! Tests the published schemas of `events.jsonl` and `results.json`, what is written against them, and what is refused.
//!
//! To write the schemas again after a change: `cargo xtask bless`.

use crate::events::{self, LogLine};
use crate::golden_tests::difference;
use crate::results::{self, ResultsDocument};
use crate::{sample, schema_check};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use stickler_conversions::overview::Statements;
use stickler_run::{CaseEvent, Event, Fact, Verdict};

/// Returns the schema of what is written of a type.
fn schema_of<T: JsonSchema>() -> Schema {
    let settings = SchemaSettings::default().for_serialize();
    settings.into_generator().into_root_schema_for::<T>()
}

/// Returns the path of a published schema.
fn published(report: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("schemas");
    folder.join(format!("{report}.schema.json"))
}

fn read(path: PathBuf) -> Value {
    serde_json::from_slice(&fs::read(path).expect("a file")).expect("JSON")
}

/// Returns a run with each kind of element that the reports have.
fn full_run() -> Vec<Event> {
    let mut events = sample::with_sources(sample::run_with_baseline());
    let passed_oddly = CaseEvent {
        got: vec![Fact::RejectedSilently],
        ..sample::open_case("t::p(3)")
    };
    let cases = [
        sample::case("t::p(1)", Verdict::Pass),
        sample::open_case("t::p(2)"),
        passed_oddly,
        sample::case("broken", Verdict::Crash),
    ];
    let baseline_cases = events.iter().filter_map(|event| match event {
        Event::Case(case) => Some(case.clone()),
        _ => None,
    });
    let mut run = sample::run_of(baseline_cases.chain(cases).collect());
    if let (Event::Header(full), Event::Header(counted)) = (&mut events[0], &run[0]) {
        full.cases = counted.cases;
        full.filters = vec!["widening".to_owned()];
    }
    run[0] = events.remove(0);
    sample::with_causes(run, [sample::cause("a cause", 1, Verdict::Crash)])
}

#[test]
fn the_golden_schemas_are_those_of_the_code() {
    for (report, schema) in [
        ("events", schema_of::<LogLine<'static>>()),
        ("results", schema_of::<ResultsDocument<'static>>()),
    ] {
        let text = format!("{:#}\n", schema.as_value());
        assert_eq!(difference(&published(report), &text), None);
    }
}

#[test]
fn what_a_run_writes_fits_the_schemas_and_has_every_key_of_the_document() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    sample::report(folder.path(), &full_run());
    assert_fits(folder.path());
}

/// Asserts that the log and the results in a folder of reports fit their schemas, and that the results have every key of theirs.
pub(crate) fn assert_fits(reports: &Path) {
    let schemas = ["events", "results"].map(|report| read(published(report)));
    let log = fs::read_to_string(reports.join(events::NAME)).expect("a log");
    for line in log.lines() {
        let line: Value = serde_json::from_str(line).expect("JSON");
        assert_eq!(schema_check::misfit(&schemas[0], &line), None, "{line}");
    }
    let document = read(reports.join(results::NAME));
    assert_eq!(schema_check::misfit(&schemas[1], &document), None);
    let keys = |object: &Value| {
        object
            .as_object()
            .map(|object| BTreeSet::from_iter(object.keys().cloned()))
    };
    assert_eq!(keys(&document), keys(&schemas[1]["properties"]));
}

/// Edits a line of a log, and returns what a site says of the log, and the schema of the line.
fn edited(number: usize, edit: impl FnOnce(&mut Value)) -> (String, Option<String>) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let log = String::from_utf8(events::log_of(&full_run())).expect("text");
    let mut lines: Vec<Value> = log
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    edit(&mut lines[number - 1]);
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    let path = folder.path().join("handed-in.jsonl");
    fs::write(&path, text).expect("written");
    let site = folder.path().join("site");
    let refused = match crate::site::write(&[path], false, &site, &Statements::default()) {
        Ok(_) => String::new(),
        Err(error) => crate::parts::describe_error(&error),
    };
    let misfit = schema_check::misfit(&read(published("events")), &lines[number - 1]);
    (refused, misfit)
}

type Edit = fn(&mut Value);

#[test]
fn what_does_not_fit_the_schema_is_refused_with_its_line_what_was_expected_and_what_was_found() {
    let edits: [(usize, Edit, &[&str]); 8] = [
        (3, |case| case["type"] = json!("passed"), &["`passed`", "`fail`"]),
        (7, |case| case[2] = json!("12"), &["\"12\"", "expected"]),
        (
            1,
            |header| header["engines"][0]["name"] = json!(7),
            &["`7`", "string"],
        ),
        (
            2,
            |group| drop(group.as_object_mut().map(|keys| keys.remove("number"))),
            &["missing field `number`"],
        ),
        (
            14,
            |footer| footer["totals"]["pass"] = json!(-1),
            &["`-1`", "u64"],
        ),
        (
            3,
            |case| case["got"][0]["fact"] = json!("pondered"),
            &["`pondered`"],
        ),
        (14, |footer| footer["duration_ms"] = json!(0.5), &["`0.5`", "u64"]),
        (1, |header| header["engines"] = json!({}), &["map", "sequence"]),
    ];
    for (number, edit, parts) in edits {
        let (refused, misfit) = edited(number, edit);
        assert!(
            refused.contains(&format!("line {number} of")),
            "{number}: {refused}"
        );
        for part in parts {
            assert!(refused.contains(part), "{number}: {part}: {refused}");
        }
        assert!(misfit.is_some(), "{number}: the schema does not refuse it");
    }
}

#[test]
fn lines_that_contradict_each_other_are_refused_with_both() {
    let edits: [(usize, Edit, &str); 7] = [
        (
            1,
            |header| header["started"] = json!("yesterday"),
            "the run began at `yesterday`, which is no time such as 2026-09-01T12:00:00Z",
        ),
        (
            1,
            |header| header["engines"][0]["name"] = json!(" "),
            "line 1 of the event log: expected an engine with a name, found \" \"",
        ),
        (
            1,
            |header| header["engines"] = json!([]),
            "line 1 of the event log: expected at least one engine, found none",
        ),
        (
            1,
            |header| {
                let engine = header["engines"][0].clone();
                header["engines"].as_array_mut().expect("a list").push(engine);
            },
            "line 1 of the event log: expected engines with names of their own, found \"reference\" a second time",
        ),
        (
            2,
            |group| group["group"]["engine"] = json!("<b>"),
            "line 3 of the event log: expected an engine that the header names, found \"<b>\"",
        ),
        (
            10,
            |case| case["case"] = json!("(2)"),
            "line 10 of the event log: expected each case of an engine once, found \"widening/t::p(2)@ironplc-ed2\" a second time",
        ),
        (
            14,
            |footer| footer["engines"][0]["totals"]["pass"] = json!(9000),
            "line 14 of the event log: expected 3 pass cases on \"reference\", as many as the log lists, found 9000",
        ),
    ];
    for (number, edit, expected) in edits {
        let (refused, _) = edited(number, edit);
        assert!(refused.contains(expected), "{expected}\n{refused}");
    }
}

#[test]
fn keys_that_are_not_known_are_no_mistake() {
    let (refused, misfit) = edited(3, |case| case["mood"] = json!("fine"));
    assert_eq!((refused.as_str(), misfit), ("", None));
}
