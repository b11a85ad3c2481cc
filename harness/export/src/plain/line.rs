//! A line of `cases.jsonl`: everything that a case asks and expects, for programs.

use crate::source_line::SourceLine;
use serde::Serialize;
use std::collections::BTreeSet;
use stickler_suite::{Acceptance, Case, ExpectedDiagnostic, Sources};

/// A case.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(super) struct CaseLine<'a> {
    /// The stable id; together with the dialect it names the case.
    id: &'a str,
    /// The dialect in which the program is read.
    dialect: &'a str,
    /// One line for a person.
    title: &'a str,
    /// The question that cases of several dialects share, where it has one: `REAL_TO_INT(REAL#2.5)`.
    question: Option<String>,
    /// The features of the language that the program uses.
    features: BTreeSet<String>,
    /// The program; its lines are those that diagnostics and faults name.
    program: &'a str,
    /// The number of scans that it runs.
    scans: u32,
    /// The variables that are written before certain scans.
    set: Vec<SetLine<'a>>,
    /// The time since the start at which certain scans begin.
    clock: Vec<ClockLine>,
    /// What must come.
    expected: ExpectedLine<'a>,
    /// Where that is said.
    source: SourceLine<'a>,
    /// The file of Structured Text by which the case is tried by hand; null where it has none.
    file: Option<String>,
}

/// A variable that is written before a scan.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct SetLine<'a> {
    /// The scan, from 1.
    before: u32,
    /// The variable, or a path to an element or a field.
    name: &'a str,
    /// The value, as a typed literal.
    value: String,
}

/// The time at which a scan begins.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct ClockLine {
    /// The scan, from 1.
    before: u32,
    /// Nanoseconds since the start of the program.
    nanoseconds: i64,
}

/// What must come.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct ExpectedLine<'a> {
    /// `accepted`, `rejected`, or `open` where no source says which.
    program: &'static str,
    /// The errors that must be there, and no others, where the program is rejected.
    errors: Vec<DiagnosticLine>,
    /// The warnings that must be there.
    warnings: Vec<DiagnosticLine>,
    /// The values that variables must have.
    values: Vec<ValueLine<'a>>,
    /// The variables whose values are of interest, and which no source states.
    recorded: Vec<&'a str>,
    /// The fault at which the run must stop.
    fault: Option<FaultLine>,
    /// The lines of the statements in normal form, where the case asks for that.
    rendered: Option<Vec<&'a str>>,
}

/// A diagnostic.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct DiagnosticLine {
    /// The line of the program, from 1.
    line: u32,
    /// The code: `stickler explain CODE` says what it means.
    code: &'static str,
}

/// A value.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct ValueLine<'a> {
    /// The variable, or a path to an element or a field.
    name: &'a str,
    /// The scan after which it has the value; null for the last.
    after: Option<u32>,
    /// The value, as a typed literal.
    value: String,
}

/// A fault.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct FaultLine {
    /// The kind.
    kind: String,
    /// The line of the program, from 1.
    line: u32,
}

impl<'a> CaseLine<'a> {
    /// Returns the line of a case with its file.
    pub(super) fn new(case: &'a Case, sources: &'a Sources, file: Option<String>) -> CaseLine<'a> {
        let set = case.set.iter().map(|setting| SetLine {
            before: setting.before,
            name: &setting.name,
            value: setting.value.to_string(),
        });
        let clock = case.clock.iter().map(|time| ClockLine {
            before: time.before,
            nanoseconds: time.nanoseconds,
        });
        CaseLine {
            id: &case.id,
            dialect: case.dialect.as_str(),
            title: &case.title,
            question: case.question.as_ref().map(ToString::to_string),
            features: case.features().into_iter().map(Into::into).collect(),
            program: &case.source,
            scans: case.scans,
            set: set.collect(),
            clock: clock.collect(),
            expected: ExpectedLine::new(case),
            source: SourceLine::new(&*case.basis, sources),
            file,
        }
    }
}

impl<'a> ExpectedLine<'a> {
    fn new(case: &'a Case) -> ExpectedLine<'a> {
        let expectation = &*case.expectation;
        let lines = |all: &[ExpectedDiagnostic]| {
            let line = |one: &ExpectedDiagnostic| DiagnosticLine {
                line: one.line,
                code: one.code.as_str(),
            };
            all.iter().map(line).collect()
        };
        let values = expectation.values.iter().map(|value| ValueLine {
            name: &value.name,
            after: value.after,
            value: value.value.to_string(),
        });
        let is_asserted = |name: &str| expectation.values.iter().any(|value| &*value.name == name);
        let recorded = case.observe.iter().map(|observe| &*observe.name);
        ExpectedLine {
            program: match expectation.accepted {
                Acceptance::Required => "accepted",
                Acceptance::Rejected => "rejected",
                Acceptance::Observed => "open",
            },
            errors: lines(&expectation.diagnostics),
            warnings: lines(&expectation.warnings),
            values: values.collect(),
            recorded: recorded.filter(|name| !is_asserted(name)).collect(),
            fault: expectation.fault.map(|fault| FaultLine {
                kind: fault.fault.to_string(),
                line: fault.line,
            }),
            rendered: expectation
                .rendered
                .as_ref()
                .map(|text| text.lines.iter().map(|line| &**line).collect()),
        }
    }
}
