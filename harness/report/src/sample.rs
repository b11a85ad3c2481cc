//! A small run for the tests of this crate, and helpers to build and inspect its parts.

use crate::{Overview, Reports};
use serde::de::DeserializeOwned;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;
use stickler_conversions::overview::Statements;
use stickler_run::{
    BaselineNote, CaseEvent, Cause, EngineHeader, EngineTotals, Event, Fact, Footer, Header, Totals, Verdict,
};
use stickler_types::{Diagnostic, Value};

/// Returns the fact that a variable has a value, given as a typed literal.
pub(crate) fn value(name: &str, literal: &str) -> Fact {
    Fact::Value {
        name: name.to_owned(),
        value: Value::parse(literal).expect("a typed literal"),
    }
}

/// Returns a diagnostic of an engine; line 0 stands for none, and so does an empty code.
pub(crate) fn reported(line: u32, code: &str, message: &str) -> Fact {
    Fact::Diagnostic(Diagnostic {
        line: (line > 0).then_some(line),
        code: (!code.is_empty()).then(|| code.to_owned()),
        message: message.to_owned(),
        ..Diagnostic::default()
    })
}

/// Returns a part of the run in `sample.toml`.
fn part<T: DeserializeOwned>(name: &str) -> T {
    static PARTS: LazyLock<toml::Table> =
        LazyLock::new(|| include_str!("sample.toml").parse().expect("tables"));
    PARTS[name].clone().try_into().expect(name)
}

/// Returns a case with this id and verdict.
pub(crate) fn case(id: &str, verdict: Verdict) -> CaseEvent {
    let mut case: CaseEvent = part("case");
    // In the events of a run, a case that passes has no expected and actual facts.
    match verdict {
        Verdict::Pass => (case.line, case.expected, case.got) = (None, Vec::new(), Vec::new()),
        Verdict::Xpass => case.got.clone_from(&case.expected),
        _ => {}
    }
    CaseEvent {
        id: format!("widening/{id}"),
        verdict,
        expectation: 0x1234_5678,
        ..case
    }
}

/// Returns a cause with this title, which explains so many cases with this verdict.
pub(crate) fn cause(title: &str, cases: u64, verdict: Verdict) -> Cause {
    let mut cause: Cause = part("cause");
    (cause.cases[0].verdict, cause.cases[0].cases) = (verdict, cases);
    Cause {
        construct: title.to_owned(),
        title: title.to_owned(),
        ..cause
    }
}

/// Returns a case that asserts nothing but that the program is accepted.
pub(crate) fn open_case(id: &str) -> CaseEvent {
    CaseEvent {
        open: true,
        observations: vec![part("observed")],
        ..case(id, Verdict::Pass)
    }
}

/// Returns a whole run: two passes, one open case, one failure.
pub(crate) fn run() -> Vec<Event> {
    run_of(vec![
        case("first", Verdict::Pass),
        open_case("open"),
        case("second", Verdict::Pass),
        case("broken", Verdict::Fail),
    ])
}

/// Returns the note of a baseline on a case.
pub(crate) fn baseline_note() -> BaselineNote {
    part("note")
}

/// Returns the header of a run, to be changed.
pub(crate) fn header(events: &mut [Event]) -> &mut Header {
    match events.first_mut() {
        Some(Event::Header(header)) => header,
        _ => panic!("a run begins with a header"),
    }
}

/// Returns a run with causes behind its cases.
pub(crate) fn with_causes(mut events: Vec<Event>, causes: impl IntoIterator<Item = Cause>) -> Vec<Event> {
    let footer = events.len() - 1;
    events.splice(footer..footer, causes.into_iter().map(Event::Cause));
    events
}

/// Returns a whole run of these cases on several engines.
pub(crate) fn run_on(engines: &[&str], cases: Vec<CaseEvent>) -> Vec<Event> {
    let mut events = run_of(cases);
    let header = header(&mut events);
    header.engines = engines
        .iter()
        .map(|name| EngineHeader {
            name: (*name).to_owned(),
            ..header.engines[0].clone()
        })
        .collect();
    events
}

/// Returns a run whose header names the source of its cases.
pub(crate) fn with_sources(mut events: Vec<Event>) -> Vec<Event> {
    header(&mut events).sources = vec![part("source")];
    events
}

/// Returns a whole run of these cases.
pub(crate) fn run_of(cases: Vec<CaseEvent>) -> Vec<Event> {
    let mut totals = Totals::default();
    cases.iter().for_each(|case| totals.count(case.verdict));
    let header = Header {
        cases: cases.len() as u64,
        ..part("header")
    };
    let engines = vec![EngineTotals {
        name: "reference".to_owned(),
        totals,
    }];
    let mut events = vec![Event::Header(header)];
    events.extend(cases.into_iter().map(Event::Case));
    events.push(Event::Footer(Footer {
        totals,
        engines,
        duration_ms: 34,
        causes_ms: None,
    }));
    events
}

/// Returns the overview of a run.
pub(crate) fn overview(events: &[Event]) -> Overview {
    let mut overview = Overview::default();
    events.iter().for_each(|event| overview.take(event));
    overview
}

/// Writes every report of a run into a folder.
pub(crate) fn report(folder: &Path, events: &[Event]) {
    let mut reports = Reports::create(Some(folder), Statements::default(), false).expect("a folder");
    assert!(events.iter().all(|event| reports.take(event)));
    reports.finish().expect("finished");
}

/// Returns the names of the entries of a folder, sorted.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder").flatten();
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let mut names: Vec<String> = entries.map(name).collect();
    names.sort();
    names
}
