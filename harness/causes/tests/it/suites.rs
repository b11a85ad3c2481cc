//! Cases and suites made by hand, and the causes that are found on a compiler.

use std::path::Path;
use std::sync::Arc;
use stickler_causes::{FailedCases, Search, SearchLimits, find};
use stickler_engines::Engine;
use stickler_run::{Cause, Event, Plan, run};
use stickler_suite::{Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedValue, Suite};
use stickler_types::{DialectName, Observation, Value};
use stickler_workers::Cancellation;

/// Returns a case of the third edition with a program that must end with a value (`into = REAL#5.0`), be rejected (`7 P4035`),
/// be accepted (`accepted`), or of which nobody decides what must happen (`open`).
pub fn case(id: &str, program: &str, must: &str) -> Case {
    let mut expectation = Expectation::default();
    let mut observe = Vec::new();
    if let Some((name, value)) = must.split_once(" = ") {
        let value = Value::parse(value).expect("a literal");
        observe.push(Observation::last(name, value.type_name()));
        expectation.values.push(ExpectedValue {
            name: name.into(),
            after: None,
            value,
            line: 1,
        });
    } else if let Some((line, code)) = must.split_once(' ') {
        expectation.accepted = Acceptance::Rejected;
        expectation.diagnostics.push(ExpectedDiagnostic {
            line: line.parse().expect("a number"),
            code: code.parse().expect("a code"),
        });
    } else if must == "open" {
        expectation.accepted = Acceptance::Observed;
    }
    Case {
        title: "A title".into(),
        basis: format!("a-source: {}", id.split("::").next().unwrap_or_default()).into(),
        file: "conformance-cases/area/file.toml".into(),
        area: "area".into(),
        expectation: Arc::new(expectation),
        observe: observe.into(),
        ..Case::of_program(id, DialectName::IRONPLC_ED3, program)
    }
}

/// Returns a suite of these cases, without sources.
pub fn suite(cases: Vec<Case>) -> Suite {
    let mut suite = Suite::default();
    suite.cases = cases;
    suite
}

/// Returns a suite of these cases with the sources and features of Stickler's own.
pub fn suite_with_sources(cases: Vec<Case>) -> Suite {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let mut suite = Suite::load_files(&folder, &[], |_, _| false);
    suite.cases = cases;
    suite
}

/// Runs a suite on an engine, and returns the causes of the cases that fail.
pub fn causes(suite: &Suite, engine: &dyn Engine, jobs: usize, limits: SearchLimits) -> Vec<Cause> {
    let plan = Plan {
        jobs,
        ..Plan::default()
    };
    let cancel = Cancellation::new();
    let engines: [&dyn Engine; 1] = [engine];
    let mut failed = FailedCases::new(&plan, &engines);
    let mut sink = |event: Event| failed.take(&event);
    run(&plan, suite, &engines, &mut sink, &cancel).expect("a run");
    let search = Search {
        plan: &plan,
        suite,
        engines: &engines,
        stores: &[],
        limits,
        cancel: &cancel,
    };
    let mut reported = Vec::new();
    let found = find(&failed, &search, &mut |progress| reported.push(progress)).expect("causes");
    assert!(reported.last().is_none_or(|last| last.done == last.of));
    found
}

/// Returns the number of cases and the title of each cause.
pub fn titles(found: &[Cause]) -> Vec<String> {
    let title = |cause: &Cause| format!("{} {}", cause.number(), cause.title);
    found.iter().map(title).collect()
}
