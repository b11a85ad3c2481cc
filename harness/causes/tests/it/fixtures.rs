//! Cases and suites made by hand, and the causes that are found on an engine.

use std::sync::Arc;
use stickler_causes::{FailedCases, Search, SearchLimits, find};
use stickler_engines::{Ability, Engine, Grade, Identity};
use stickler_run::{Cause, Event, Plan, run};
use stickler_suite::{Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedValue, Suite};
use stickler_types::{DialectName, Observation, Value};
use stickler_workers::Cancellation;

/// Returns the identity of an engine that speaks two dialects and is judged by codes.
pub fn identity() -> Identity {
    Identity {
        name: "defective".to_owned(),
        version: "1".to_owned(),
        dialects: vec![DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3],
        abilities: vec![Ability::Execute],
        grade: Grade::Code,
        lacks: Vec::new(),
    }
}

/// Returns a case of the third edition with a program that must end with a value (`into = REAL#5.0`), or be rejected (`7 P4035`).
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
    } else {
        let (line, code) = must.split_once(' ').expect("a line and a code");
        expectation.accepted = Acceptance::Rejected;
        expectation.diagnostics.push(ExpectedDiagnostic {
            line: line.parse().expect("a number"),
            code: code.parse().expect("a code"),
        });
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

/// Returns a suite of these cases.
pub fn suite(cases: Vec<Case>) -> Suite {
    let mut suite = Suite::default();
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
pub fn titles(found: &[Cause]) -> Vec<(u64, &str)> {
    found
        .iter()
        .map(|cause| (cause.number(), cause.title.as_str()))
        .collect()
}
