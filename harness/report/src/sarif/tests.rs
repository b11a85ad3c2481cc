//! Tests the places of a report, and what it tells of results that it leaves out; golden texts show the rest.

use super::{diagnostics_as_sarif, json, uri};
use crate::sample;
use crate::unexpected::MAX_CASES;
use serde_json::Value;
use stickler_mdtest::schema as schema_check;
use stickler_run::Verdict;
use stickler_types::Diagnostic;

/// The part of the public schema of SARIF that a report uses. It knows no other key.
const PART: &str = include_str!("part.schema.json");

/// Asserts that a report fits the schema, but for the form of addresses and times.
pub(crate) fn assert_valid(report: &Value) {
    let schema: Value = serde_json::from_str(PART).expect("a schema");
    assert_eq!(schema_check::misfit(&schema, report), None);
}

#[test]
fn what_is_left_out_is_told() {
    let cases = (0..MAX_CASES + 20).map(|number| sample::case(&format!("a{number}"), Verdict::Fail));
    let text = json(&sample::overview(&sample::run_of(cases.collect()))).expect("JSON");
    let report: Value = serde_json::from_slice(&text).expect("JSON");
    assert_valid(&report);
    let run = &report["runs"][0];
    assert_eq!(run["results"].as_array().map(Vec::len), Some(MAX_CASES));
    assert_eq!(
        run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"],
        "20 more cases are not as expected and left out here; events.jsonl.gz has all"
    );
}

#[test]
fn an_absolute_path_is_an_address_of_a_file() {
    assert_eq!(uri("/a folder/a.toml"), "file:///a%20folder/a.toml");
    assert_eq!(uri(r"cases\a.toml"), "cases/a.toml");
}

#[test]
fn each_code_of_diagnostics_is_a_rule() {
    let diagnostic = |code: Option<&str>, line| Diagnostic {
        code: code.map(str::to_owned),
        line: Some(line),
        ..Diagnostic::default()
    };
    let found = [
        diagnostic(Some("P4007"), 3),
        diagnostic(None, 1),
        diagnostic(Some("P4007"), 5),
    ];
    let found = found.iter().map(|diagnostic| ("a b.st", diagnostic));
    let text = diagnostics_as_sarif(found, "stickler", "2026-01-01T00:00:00Z").expect("JSON");
    let report: Value = serde_json::from_slice(&text).expect("JSON");
    assert_valid(&report);
    let run = &report["runs"][0];
    assert_eq!(run["tool"]["driver"]["rules"].as_array().map(Vec::len), Some(2));
    assert_eq!(run["results"][2]["ruleIndex"], run["results"][0]["ruleIndex"]);
}
