//! Tests what is exported without a harness: its schema, and that the files alone give the verdicts of the suite on the reference.

use super::program::CHECK;
use super::{CASES, PROGRAMS, SCHEMA, export_plain, file_name};
use crate::ExportError;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use stickler_engines::{Observation, Outcome, RunRequest};
use stickler_mdtest::schema::misfit;
use stickler_reference::Limits;
use stickler_suite::{Acceptance, Case, Suite};
use stickler_types::{DialectName, Value};

/// Returns the suite, of whose cases every 211th is tried.
fn suite() -> Suite {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let mut suite = Suite::load(&folder);
    let mut number = 0;
    suite.cases.retain(|_| {
        number += 1;
        number % 211 == 0
    });
    suite
}

#[test]
fn the_files_alone_give_the_verdicts_of_the_suite() {
    let suite = suite();
    let cases: Vec<&Case> = suite.cases.iter().collect();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let into = folder.path().join("plain");
    let exported = export_plain(&cases, &suite.sources, &into).expect("an export");
    assert!(exported.programs > 500, "{exported:?}");
    let schema = fs::read(into.join(SCHEMA)).expect("the schema");
    let schema = serde_json::from_slice(&schema).expect("JSON");
    let by_key: BTreeMap<_, &Case> = cases
        .iter()
        .map(|case| ((&*case.id, case.dialect.as_str()), *case))
        .collect();
    let lines = fs::read_to_string(into.join(CASES)).expect("the lines");
    assert_eq!(lines.lines().count(), cases.len());
    let mut tried = 0;
    for line in lines.lines() {
        let line: serde_json::Value = serde_json::from_str(line).expect("JSON");
        assert_eq!(misfit(&schema, &line), None, "{line}");
        let word = |key: &str| line[key].as_str().unwrap_or_default();
        let case = by_key[&(word("id"), word("dialect"))];
        if let Some(file) = line["file"].as_str() {
            assert!(file.starts_with(PROGRAMS));
            judge(case, &fs::read_to_string(into.join(file)).expect("a program"));
            tried += 1;
        }
    }
    assert_eq!(tried, exported.programs);
    assert_eq!(
        export_plain(&[], &suite.sources, &into).expect("replaced").cases,
        0
    );
    assert!(!into.join(PROGRAMS).exists());
    fs::remove_file(into.join(SCHEMA)).expect("removed");
    let into_another = export_plain(&cases, &suite.sources, &into);
    assert!(matches!(into_another, Err(ExportError::Occupied(..))));
}

#[test]
fn the_arguments_of_a_case_make_no_folder() {
    let case = Case::of_program("language/large::one(LINT_/_DINT)", DialectName::IEC_ED3, "");
    let name = file_name(&case, &mut BTreeSet::new());
    assert_eq!(name, "programs/iec-ed3/language/large/one_LINT___DINT_.st");
}

/// Asserts that a file alone tells what the case expects, and that the reference does it.
fn judge(case: &Case, text: &str) {
    let key = format!("{}@{}\n{text}", case.id, case.dialect);
    assert!(text.contains(&*case.basis), "{key}");
    let names = stickler_reference::variables(text, case.dialect, usize::MAX);
    let checks = names
        .into_iter()
        .filter(|name| name.starts_with(CHECK) && !name.ends_with("scan"));
    let observe: Vec<Observation> = checks.map(|name| Observation::last(&name, "BOOL")).collect();
    let request = RunRequest {
        scans: case.scans,
        ..RunRequest::once(case.dialect, text, &observe)
    };
    let outcome = stickler_reference::run(&request, Limits::default()).expect("an outcome");
    let names_line = |line: Option<u32>| text.contains(&format!(" line {}: ", line.unwrap_or_default()));
    match (case.expectation.accepted, outcome) {
        (Acceptance::Rejected, Outcome::Rejected { diagnostics }) => {
            assert!(names_line(diagnostics[0].line), "{diagnostics:?} {key}");
        }
        (Acceptance::Required, Outcome::Faulted { fault, line, .. }) => {
            assert!(names_line(line), "{line:?} {key}");
            assert_eq!(
                Some(fault),
                case.expectation.fault.map(|expected| expected.fault),
                "{key}"
            );
        }
        (Acceptance::Required, Outcome::Executed { values, .. }) => {
            assert_eq!(values.len(), case.expectation.values.len(), "{key}");
            for (name, value) in values {
                assert_eq!(Ok(&value), Value::parse("BOOL#TRUE").as_ref(), "{name} of {key}");
            }
        }
        (_, outcome) => panic!("{outcome} of {key}"),
    }
}
