//! Tests the published schema of `results.json`, what is written against it, and what is refused.
//!
//! To write the schema again after a change of the document: `cargo xtask bless`.

use super::SCHEMA;
use super::document::ResultsDocument;
use super::read::parse;
use crate::{sample, schema_check};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use stickler_run::{CaseEvent, Event, Fact, Verdict};

/// Returns the results that a run writes.
fn written(events: &[Event]) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    sample::report(folder.path(), events);
    fs::read(folder.path().join(super::NAME)).expect("results")
}

/// Returns a run with each kind of element that the document has.
fn full_run() -> Vec<Event> {
    let mut events = sample::run_with_baseline();
    // The footer, which counts other cases.
    events.pop();
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
    let baseline_cases = events.split_off(1).into_iter().filter_map(|event| match event {
        Event::Case(case) => Some(case),
        _ => None,
    });
    let mut run = sample::run_of(baseline_cases.chain(cases).collect());
    run[0] = with_cases(events.remove(0), run.len() - 2);
    let at = run.len() - 1;
    run.insert(at, Event::Cause(sample::cause("a cause", 1, Verdict::Crash)));
    run
}

fn with_cases(header: Event, cases: usize) -> Event {
    match header {
        Event::Header(mut header) => {
            header.cases = cases as u64;
            header.filters = vec!["widening".to_owned()];
            Event::Header(header)
        }
        other => other,
    }
}

#[test]
fn the_golden_schema_is_that_of_the_code() {
    let schema = schemars::schema_for!(ResultsDocument<'static>);
    let text = format!("{:#}\n", schema.as_value());
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas/results.schema.json");
    if std::env::var_os("STICKLER_BLESS").is_some() {
        fs::write(&path, &text).expect("written");
    }
    let published = fs::read_to_string(&path)
        .unwrap_or_default()
        .replace("\r\n", "\n");
    assert!(
        published == text,
        "results.schema.json is out of date; `cargo xtask bless` writes it"
    );
}

#[test]
fn what_a_run_writes_fits_the_schema_and_has_every_key_of_it() {
    let schema: Value = serde_json::from_str(SCHEMA).expect("a schema");
    for events in [full_run(), sample::run(), sample::run_by_line()] {
        let document: Value = serde_json::from_slice(&written(&events)).expect("JSON");
        assert_eq!(schema_check::misfit(&schema, &document), None);
        let keys = |object: &Value| -> Vec<String> {
            let mut keys: Vec<String> = object.as_object().expect("an object").keys().cloned().collect();
            keys.sort();
            keys
        };
        assert_eq!(keys(&document), keys(&schema["properties"]));
    }
}

#[test]
fn what_is_written_is_read_back_but_for_what_the_document_does_not_hold() {
    let run = full_run();
    let mut read: Vec<Event> = parse(&written(&run)).expect("results").into_events().collect();
    let mut expected = run;
    for events in [&mut read, &mut expected] {
        for event in events.iter_mut() {
            match event {
                Event::Header(header) => {
                    header.command = String::new();
                    header
                        .engines
                        .iter_mut()
                        .for_each(|engine| engine.commands.clear());
                }
                Event::Case(case) => case.expectation = 0,
                Event::Footer(_) | Event::Cause(_) => {}
            }
        }
        // The document has the cases that did not pass first.
        events.sort_by_key(|event| match event {
            Event::Case(case) => (1, case.verdict == Verdict::Pass, case.id.clone()),
            Event::Header(_) => (0, false, String::new()),
            Event::Cause(_) => (2, false, String::new()),
            Event::Footer(_) => (3, false, String::new()),
        });
    }
    assert_eq!(read, expected);
}

/// Edits a document, and returns what the reader says of it, and the schema.
fn edited(edit: impl FnOnce(&mut Value)) -> (String, Option<String>) {
    let mut document: Value = serde_json::from_slice(&written(&full_run())).expect("JSON");
    edit(&mut document);
    let schema: Value = serde_json::from_str(SCHEMA).expect("a schema");
    let text = serde_json::to_vec(&document).expect("JSON");
    let refused = match parse(&text) {
        Ok(_) => String::new(),
        Err(error) => error.to_string(),
    };
    (refused, schema_check::misfit(&schema, &document))
}

#[test]
fn what_does_not_fit_the_schema_is_refused_with_its_place_what_was_expected_and_what_was_found() {
    type Edit = fn(&mut Value);
    let edits: [(Edit, &str, &[&str]); 8] = [
        (
            |all| all["cases"][0]["verdict"] = json!("passed"),
            "cases[0].verdict",
            &["`passed`", "`fail`"],
        ),
        (
            |all| all["passed"][1]["duration_us"]["(2)"] = json!("12"),
            "passed[1].duration_us.(2)",
            &["\"12\"", "expected"],
        ),
        (
            |all| all["engines"][0]["name"] = json!(7),
            "engines[0].name",
            &["`7`", "string"],
        ),
        (
            |all| drop(all.as_object_mut().map(|keys| keys.remove("passed"))),
            ".",
            &["missing field `passed`"],
        ),
        (
            |all| all["engines"][0]["totals"]["pass"] = json!(-1),
            "engines[0].totals.pass",
            &["`-1`", "u64"],
        ),
        (
            |all| all["cases"][0]["got"][0]["fact"] = json!("pondered"),
            "cases[0].got[0].fact",
            &["`pondered`"],
        ),
        (
            |all| all["duration_ms"] = json!(0.5),
            "duration_ms",
            &["`0.5`", "u64"],
        ),
        (|all| all["engines"] = json!({}), "engines", &["map", "sequence"]),
    ];
    for (edit, path, parts) in edits {
        let (refused, misfit) = edited(edit);
        assert!(refused.starts_with(&format!("{path}: ")), "{path}: {refused}");
        for part in parts {
            assert!(refused.contains(part), "{path}: {part}: {refused}");
        }
        assert!(misfit.is_some(), "{path}: the schema does not refuse it");
    }
}

#[test]
fn parts_that_contradict_each_other_are_refused_with_both() {
    type Edit = fn(&mut Value);
    let edits: [(Edit, &str); 9] = [
        (
            |all| all["started"] = json!("yesterday"),
            "started: expected a time such as 2026-09-01T12:00:00Z, found \"yesterday\"",
        ),
        (
            |all| all["engines"][0]["name"] = json!(" "),
            "engines[0].name: expected a name, found \" \"",
        ),
        (
            |all| all["engines"] = json!([]),
            "engines: expected at least one engine, found none",
        ),
        (
            |all| {
                let engine = all["engines"][0].clone();
                all["engines"].as_array_mut().expect("a list").push(engine);
            },
            "engines[1].name: expected a name that no other engine has, found \"reference\" a second time",
        ),
        (
            |all| all["cases"][0]["engine"] = json!("<b>"),
            "cases[0]: expected an engine that `engines` names, found \"<b>\"",
        ),
        (
            |all| all["cases"][0]["verdict"] = json!("pass"),
            "cases[0].verdict: expected a verdict other than pass",
        ),
        (
            |all| all["cases"][1] = all["cases"][0].clone(),
            "cases[1]: expected each case of an engine once, found \"widening/mended@ironplc-ed2\" a second time",
        ),
        (
            |all| all["passed"][0]["dialects"] = json!(["a", "b"]),
            "passed[0].duration_us.(1): expected 2 elements, one for each of `dialects`, found 1",
        ),
        (
            |all| all["engines"][0]["totals"]["pass"] = json!(9000),
            "engines[0].totals.pass: expected 3, as many cases as the document lists, found 9000",
        ),
    ];
    for (edit, expected) in edits {
        let (refused, _) = edited(edit);
        assert!(refused.starts_with(expected), "{expected}\n{refused}");
    }
}

#[test]
fn a_file_that_is_no_whole_document_of_this_format_is_named_as_what_it_is() {
    let whole = written(&full_run());
    let cut = &whole[..whole.len() / 2];
    let refused = |text: &[u8]| match parse(text) {
        Ok(_) => String::new(),
        Err(error) => error.to_string(),
    };
    assert!(
        refused(cut).contains("it was cut short, so copy it again"),
        "{}",
        refused(cut)
    );
    assert!(refused(b" \n").contains("empty"));
    assert!(refused(b"hello").contains("no JSON"));
    assert!(refused(b"[]").contains("no number under the key `format`"));
    assert!(refused(b"{\"version\": \"2.1.0\"}").contains("no number under the key `format`"));
    let of_format = |format: u32| {
        let mut document: Value = serde_json::from_slice(&whole).expect("JSON");
        document["format"] = json!(format);
        refused(&serde_json::to_vec_pretty(&document).expect("JSON"))
    };
    assert!(of_format(1).contains("format 1, which an earlier version of Stickler wrote"));
    assert!(of_format(9).contains("format 9, which a later version of Stickler wrote"));
    assert!(refused(b"{\"format\":1,\n\"stick").contains("format 1, which an earlier"));
    assert_eq!(of_format(2), "");
}

#[test]
fn keys_that_are_not_known_are_no_mistake() {
    let (refused, misfit) = edited(|all| all["cases"][0]["mood"] = json!("fine"));
    assert_eq!((refused.as_str(), misfit), ("", None));
}
