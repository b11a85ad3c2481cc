//! A small run for the tests of this crate, and helpers to build and inspect its parts.

use crate::{Overview, Reports};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use stickler_conversions::overview::Statements;
use stickler_run::{
    BaselineNote, CaseEvent, Cause, EngineHeader, EngineTotals, Event, ExplainedCases, FORMAT, Fact, Footer,
    Grade, Header, Observed, Reproducer, Source, Totals, Verdict,
};
use stickler_types::{Diagnostic, Severity, Value};

/// Returns the fact that a variable has a value, given as a typed literal.
pub(crate) fn value(name: &str, literal: &str) -> Fact {
    Fact::Value {
        name: name.to_owned(),
        value: Value::parse(literal).expect("a typed literal"),
    }
}

/// Returns an expected diagnostic.
pub(crate) fn error(line: u32, code: &str) -> Fact {
    Fact::Diagnostic(Diagnostic {
        line: Some(line),
        code: Some(code.to_owned()),
        ..Diagnostic::default()
    })
}

/// Returns an expected warning.
pub(crate) fn warning(line: u32, code: &str) -> Fact {
    Fact::Warning(Diagnostic {
        severity: Severity::Warning,
        line: Some(line),
        code: Some(code.to_owned()),
        ..Diagnostic::default()
    })
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

/// Returns a case with this id and verdict.
pub(crate) fn case(id: &str, verdict: Verdict) -> CaseEvent {
    let right = value("into", "INT#-128");
    // In the events of a run, a case that passes has no expected and actual facts.
    let (line, expected, got) = match verdict {
        Verdict::Pass => (None, Vec::new(), Vec::new()),
        Verdict::Xpass => (Some(7), vec![right.clone()], vec![right]),
        _ => (Some(7), vec![right], vec![value("into", "INT#128")]),
    };
    CaseEvent {
        id: format!("widening/{id}"),
        dialect: "ironplc-ed2".to_owned(),
        engine: "reference".to_owned(),
        verdict,
        basis: "ironplc-type-conversions: Integer widening".to_owned(),
        file: "conformance-cases/widening/integer.toml".to_owned(),
        line,
        area: "widening".to_owned(),
        title: "SINT widens to INT".to_owned(),
        expectation: 0x1234_5678,
        expected,
        got,
        duration_us: 12,
        ..CaseEvent::default()
    }
}

/// Returns a cause with this title, which explains so many cases with this verdict.
pub(crate) fn cause(title: &str, cases: u64, verdict: Verdict) -> Cause {
    let case = case("t::a(1)", verdict);
    Cause {
        engine: case.engine,
        symptom: "value".to_owned(),
        construct: title.to_owned(),
        title: title.to_owned(),
        shown: Reproducer {
            case: case.id,
            dialect: case.dialect.clone(),
            basis: case.basis.clone(),
            about: case.title,
            program: "PROGRAM m END_PROGRAM\n".to_owned(),
            expected: vec![value("into", "INT#-128")],
            got: vec![value("into", "INT#128")],
            ..Reproducer::default()
        },
        cases: vec![ExplainedCases {
            probe: "widening/t::a".to_owned(),
            dialect: case.dialect,
            basis: case.basis,
            verdict,
            cases,
        }],
        ..Cause::default()
    }
}

/// Returns a case that asserts nothing but that the program is accepted.
pub(crate) fn open_case(id: &str) -> CaseEvent {
    CaseEvent {
        open: true,
        observations: vec![Observed {
            name: "r".to_owned(),
            value: "INT#3".to_owned(),
        }],
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
    BaselineNote {
        at: "b/reference.toml:7".to_owned(),
        verdict: Verdict::Fail,
        others: Vec::new(),
        reason: "rounds".to_owned(),
        link: Some("https://example.org/1".to_owned()),
    }
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
    header(&mut events).sources = vec![Source {
        key: "ironplc-type-conversions".to_owned(),
        title: "Type Conversions".to_owned(),
        publisher: "IronPLC".to_owned(),
        kind: SourceKind::Document,
        address: "https://example.org/{section}#{anchor}".to_owned(),
        read: "0.239".to_owned(),
        engines: vec!["reference".to_owned()],
        limitations: [("P9999".to_owned(), "arrays".to_owned())].into(),
        ..Source::default()
    }];
    events
}

/// Returns a whole run of these cases.
pub(crate) fn run_of(cases: Vec<CaseEvent>) -> Vec<Event> {
    let mut totals = Totals::default();
    cases.iter().for_each(|case| totals.count(case.verdict));
    let header = Header {
        format: FORMAT,
        stickler: "0.1.0".to_owned(),
        suite: "0.1.0".to_owned(),
        started: "2026-09-01T12:00:00Z".to_owned(),
        command: "stickler run".to_owned(),
        engines: vec![EngineHeader {
            name: "reference".to_owned(),
            version: "0.1.0".to_owned(),
            dialects: vec!["ironplc-ed2".to_owned()],
            strict: Grade::Code,
            rerun: "stickler run --filter '{id}@{dialect}'".to_owned(),
            commands: BTreeMap::from([("ironplc-ed2".to_owned(), "ironplcc check program.st".to_owned())]),
        }],
        cases: cases.len() as u64,
        ..Header::default()
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
    let entries = fs::read_dir(folder).expect("the folder");
    let mut names: Vec<String> = entries
        .map(|entry| {
            entry
                .expect("an entry")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    names.sort();
    names
}
