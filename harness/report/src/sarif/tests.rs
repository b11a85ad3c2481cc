use super::{json, uri};
use crate::overview::MAX_KEPT_FAILURES;
use crate::{sample, schema_check};
use serde_json::Value;
use stickler_run::{CaseEvent, Cause, Event, Verdict};

/// The part of the public schema of SARIF that a report uses. It knows no other key.
const PART: &str = include_str!("part.schema.json");

/// Writes the report of a run, and checks it against the schema, but for the form of addresses and times.
fn report(events: &[Event]) -> Value {
    let text = json(&sample::overview(events)).expect("JSON");
    let report: Value = serde_json::from_slice(&text).expect("JSON");
    let schema: Value = serde_json::from_str(PART).expect("a schema");
    assert_eq!(schema_check::misfit(&schema, &report), None);
    report["runs"][0].clone()
}

fn with_causes(cases: Vec<CaseEvent>, causes: Vec<Cause>) -> Vec<Event> {
    sample::with_causes(sample::run_of(cases), causes)
}

#[test]
fn each_claim_is_a_rule_and_each_failing_case_a_result_of_it() {
    let run = report(&sample::with_sources(sample::run()));
    let [rule] = &run["tool"]["driver"]["rules"].as_array().expect("rules")[..] else {
        panic!("one claim: {run}")
    };
    assert_eq!(rule["id"], "ironplc-type-conversions: Integer widening");
    assert_eq!(
        rule["helpUri"],
        "https://example.org/Integer%20widening#integer-widening"
    );
    let [result] = &run["results"].as_array().expect("results")[..] else {
        panic!("one case fails: {run}")
    };
    assert_eq!(
        (&result["ruleId"], &result["ruleIndex"], &result["level"]),
        (&rule["id"], &0.into(), &"error".into())
    );
    let place = &result["locations"][0]["physicalLocation"];
    assert_eq!(
        place["artifactLocation"]["uri"],
        "conformance-cases/widening/integer.toml"
    );
    assert_eq!(place["region"]["startLine"], 7);
    let message = result["message"]["text"].as_str().expect("a message");
    for part in [
        "reference: widening/broken@ironplc-ed2: fail: SINT widens to INT\n",
        "expected:\ninto = INT#-128\n\ngot:\ninto = INT#128\n",
        "rerun:\nstickler run --filter 'widening/broken@ironplc-ed2'",
    ] {
        assert!(message.contains(part), "{part} in {message}");
    }
}

#[test]
fn a_cause_is_one_result_for_all_of_its_cases() {
    let mut cause = sample::cause("accepts a string", 3, Verdict::Fail);
    (cause.shown.file, cause.shown.line) = ("conformance-cases/widening/t.toml".to_owned(), Some(9));
    let known = sample::cause("known", 2, Verdict::Xfail);
    let differing = sample::cause("differs", 2, Verdict::Differs);
    let cases = vec![
        sample::case("t::a(1)", Verdict::Fail),
        sample::case("mended", Verdict::Xpass),
    ];
    let run = report(&with_causes(cases, vec![known, cause, differing]));
    let results = run["results"].as_array().expect("results");
    let titles = results.iter().map(|result| {
        let text = result["message"]["text"].as_str().expect("a message");
        text.lines().next().unwrap_or_default()
    });
    assert_eq!(
        titles.collect::<Vec<_>>(),
        [
            "reference: accepts a string (3 cases)",
            "reference: widening/mended@ironplc-ed2: passes, but its baseline expects it not to: SINT widens to INT",
        ]
    );
    let place = &results[0]["locations"][0]["physicalLocation"];
    assert_eq!(
        (&place["artifactLocation"]["uri"], &place["region"]["startLine"]),
        (&"conformance-cases/widening/t.toml".into(), &9.into())
    );
    let key = |result: &Value| result["partialFingerprints"]["primaryLocationLineHash"].clone();
    assert_ne!(key(&results[0]), key(&results[1]));
}

#[test]
fn what_is_left_out_and_what_is_broken_is_told() {
    let cases = (0..MAX_KEPT_FAILURES + 20).map(|number| sample::case(&format!("a{number}"), Verdict::Fail));
    let mut events = sample::run_of(cases.collect());
    sample::header(&mut events).broken_files = vec!["a.st:1: `colour`: unknown key".to_owned()];
    let run = report(&events);
    assert_eq!(run["results"].as_array().map(Vec::len), Some(MAX_KEPT_FAILURES));
    let invocation = &run["invocations"][0];
    assert_eq!(
        invocation["toolExecutionNotifications"][0]["message"]["text"],
        "20 more cases are not as expected and left out here; results.json has all"
    );
    assert_eq!(
        invocation["toolConfigurationNotifications"][0]["message"]["text"],
        "some cases were not run: a.st:1: `colour`: unknown key"
    );
    let stale = report(&sample::run_with_baseline());
    let text = &stale["invocations"][0]["toolConfigurationNotifications"][0]["message"]["text"];
    assert_eq!(text, "b/reference.toml:12: widening/gone* fits no case");
}

#[test]
fn whatever_an_engine_says_the_report_is_valid() {
    let case = CaseEvent {
        got: vec![sample::rendered(&["\u{0}\u{1b}[31m\u{ffff}]]><&\"'\u{7f}\\"])],
        title: "a\n\"b\"\t<c>".to_owned(),
        file: "my cases/ä#?%.toml".to_owned(),
        line: None,
        ..sample::case("a(STRING,'x y')", Verdict::Crash)
    };
    let run = report(&sample::run_of(vec![case]));
    let text = run["results"][0]["message"]["text"].as_str().expect("a message");
    let first = text.lines().next();
    assert_eq!(
        first,
        Some("reference: widening/a(STRING,'x y')@ironplc-ed2: crash: a \"b\" <c>")
    );
    assert!(text.contains("\\u{1b}[31m"), "{text}");
    assert_eq!(
        run["results"][0]["locations"][0]["physicalLocation"],
        serde_json::json!({"artifactLocation": {"uri": "my%20cases/%C3%A4%23%3F%25.toml"}})
    );
}

#[test]
fn an_absolute_path_is_an_address_of_a_file() {
    assert_eq!(uri("/a folder/a.toml"), "file:///a%20folder/a.toml");
    assert_eq!(uri(r"cases\a.toml"), "cases/a.toml");
}
