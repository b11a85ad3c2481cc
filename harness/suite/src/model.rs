//! Cases and expectations, as the rest of the harness sees them.
//!
//! The texts are shared (`Arc<str>`), because sixty thousand cases of one table have most of theirs in common.

use serde::{Deserialize, Serialize};
use std::sync::Arc;

use crate::citations::is_stated;
use crate::places::Placement;

use stickler_types::{
    Acceptance, ClockSetting, Code, DialectName, Fault, MatrixWord, Observation, ObservationKey, Question,
    RunRequest, Setting, Value,
};

/// One program in one dialect, with one expectation.
///
/// Keyed by [`Case::id`] and [`Case::dialect`]; [`Case::key`] writes both.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The stable id: ASCII, without spaces, `folder/file` or `folder/file::probe(ROW,COLUMN,VALUE)`.
    pub id: Arc<str>,
    /// The dialect in which the program is read.
    pub dialect: DialectName,
    /// One line for a person.
    pub title: Arc<str>,
    /// The source and section that the expectation comes from, `source: section`; [`NOT_STATED`](crate::NOT_STATED) for a case
    /// that asserts nothing.
    pub basis: Arc<str>,
    /// A paragraph for a person, where the file gives one.
    pub summary: Option<Arc<str>>,
    /// The case file, relative to the suite's parent folder, with forward slashes.
    pub file: Arc<str>,
    /// The first folder below the suite's root: `widening`, `bit-access`, …
    pub area: Arc<str>,
    /// The 1-based line in [`Case::file`] that the case stands on: line 1 of a program, the row of a table.
    pub line: u32,
    /// The program, with blanks in place of its marks, so that lines stay what they are in the file.
    pub source: Arc<str>,
    /// The number of scans that the program runs; at least 1.
    pub scans: u32,
    /// Words to select cases by.
    pub tags: Arc<[Arc<str>]>,
    /// The simulated time before certain scans, ordered by scan.
    pub clock: Arc<[ClockSetting]>,
    /// Variables that are written before certain scans, ordered by scan.
    pub set: Arc<[Setting]>,
    /// The expectation: acceptance, diagnostics, values, a fault or a rendered text.
    pub expectation: Arc<Expectation>,
    /// All variables whose values an engine has to give back, each once: those asserted and those only recorded.
    pub observe: Arc<[Observation]>,
    /// The question of the program, where its table states one.
    pub question: Option<Arc<Question>>,
    /// The cell of the matrix, for a case that comes from one.
    pub cell: Option<Arc<MatrixCell>>,
    /// The places of which the program was put together, if it was.
    pub placement: Option<Arc<Placement>>,
}

impl Case {
    /// Returns whether another case has the same program and the same expectation.
    pub(crate) fn asks_the_same_as(&self, other: &Case) -> bool {
        // Where a file asserts a value does not matter.
        let without_lines = |case: &Case| {
            let mut expectation = (*case.expectation).clone();
            expectation.values.iter_mut().for_each(|value| value.line = 0);
            expectation
        };
        self.source == other.source
            && (Arc::ptr_eq(&self.expectation, &other.expectation)
                || without_lines(self) == without_lines(other))
            && self.observe == other.observe
            && (self.scans, &self.set, &self.clock) == (other.scans, &other.set, &other.clock)
    }

    /// Returns whether another version of the case claims the same, wherever its program has the lines.
    pub(crate) fn claims_the_same_as(&self, other: &Case) -> bool {
        let without_lines = |case: &Case| {
            let mut expectation = case.expectation.with_lines(|_| 0);
            expectation.values.iter_mut().for_each(|value| value.line = 0);
            expectation.clean_lines.clear();
            expectation
        };
        without_lines(self) == without_lines(other)
    }

    /// Returns a case of a program that stands in no case file. It expects that the program is accepted, and observes nothing.
    pub fn of_program(id: &str, dialect: DialectName, source: &str) -> Case {
        Case {
            id: id.into(),
            dialect,
            title: Arc::default(),
            basis: Arc::default(),
            summary: None,
            file: Arc::default(),
            area: Arc::default(),
            line: 1,
            source: source.into(),
            scans: 1,
            tags: Arc::default(),
            clock: Arc::default(),
            set: Arc::default(),
            expectation: Arc::default(),
            observe: Arc::default(),
            question: None,
            cell: None,
            placement: None,
        }
    }

    /// Returns the key of results: `id@dialect`.
    pub fn key(&self) -> String {
        format!("{}@{}", self.id, self.dialect)
    }

    /// Returns the request for an engine: the program and what to observe of it, never the expectation.
    pub fn request(&self) -> RunRequest<'_> {
        RunRequest {
            dialect: self.dialect,
            source: &self.source,
            scans: self.scans,
            observe: &self.observe,
            clock: &self.clock,
            set: &self.set,
        }
    }

    /// Returns whether the expectation comes from the definition of the case's dialect, and not from a document about the
    /// dialect that it extends.
    pub fn is_stated(&self) -> bool {
        is_stated(&self.basis, self.dialect)
    }

    /// Returns whether the case only records: it asserts nothing but that the program is accepted, if that.
    pub fn is_open(&self) -> bool {
        self.expectation.is_open(&self.observe)
    }
}

/// The expectation of a case: the results of an engine that conforms.
///
/// Basis: conformance-cases/README.md (marks).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Expectation {
    /// Whether the program must be accepted.
    pub accepted: Acceptance,
    /// The diagnostics that must be there, ordered by line; empty unless [`Acceptance::Rejected`].
    pub diagnostics: Vec<ExpectedDiagnostic>,
    /// The warnings that must be there, ordered by line. Others may be there as well, except on a clean line.
    pub warnings: Vec<ExpectedDiagnostic>,
    /// Lines of the program that no diagnostic, error or warning, may name (`ok` marks), ascending.
    pub clean_lines: Vec<u32>,
    /// The values that variables must have after a scan.
    pub values: Vec<ExpectedValue>,
    /// The fault that must end the run.
    pub fault: Option<ExpectedFault>,
    /// The text that the renderer must return for the bodies of the program organization units.
    pub rendered: Option<ExpectedText>,
}

impl Expectation {
    /// Returns the expectation of a program whose lines have other numbers.
    pub(crate) fn with_lines(&self, line: impl Fn(u32) -> u32) -> Expectation {
        let mut moved = self.clone();
        let diagnostics = moved.diagnostics.iter_mut().chain(&mut moved.warnings);
        let diagnostics = diagnostics.map(|expected| &mut expected.line);
        let fault = moved.fault.iter_mut().map(|expected| &mut expected.line);
        let rendered = moved.rendered.iter_mut().map(|expected| &mut expected.line);
        let lines = diagnostics
            .chain(&mut moved.clean_lines)
            .chain(fault)
            .chain(rendered);
        lines.for_each(|number| *number = line(*number));
        moved
    }

    /// Returns whether a case with this expectation, which observes these variables, only records: it asserts nothing but that
    /// the program is accepted, if that.
    pub(crate) fn is_open(&self, observe: &[Observation]) -> bool {
        let Expectation {
            accepted,
            diagnostics,
            warnings,
            clean_lines,
            values,
            fault,
            rendered,
        } = self;
        let tells = !(diagnostics.is_empty() && warnings.is_empty() && clean_lines.is_empty());
        let asserts = tells || !values.is_empty() || fault.is_some() || rendered.is_some();
        match accepted {
            _ if asserts => false,
            Acceptance::Required => !observe.is_empty(),
            Acceptance::Rejected => false,
            Acceptance::Observed => true,
        }
    }
}

/// A diagnostic that must be there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ExpectedDiagnostic {
    /// The 1-based line of the program.
    pub line: u32,
    /// The code of the diagnostic.
    pub code: Code,
}

/// A value that a variable must have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExpectedValue {
    /// The variable or path: `a[1]`, `rec.field`.
    pub name: Arc<str>,
    /// The 1-based scan after which the variable must have the value; `None` for the last scan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub after: Option<u32>,
    /// The value that the variable must have, or a number that it must be near.
    #[serde(deserialize_with = "stickler_types::deserialize_expected")]
    pub value: Value,
    /// The 1-based line of the case file that asserts it.
    pub line: u32,
}

impl ExpectedValue {
    /// Returns the key under which an engine returns the value.
    pub fn key(&self) -> ObservationKey<'_> {
        ObservationKey {
            name: &self.name,
            after: self.after,
        }
    }
}

/// The fault that must end the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExpectedFault {
    /// The kind of fault.
    pub fault: Fault,
    /// The 1-based line of the program on which execution stops.
    pub line: u32,
}

/// The text that the renderer must return.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpectedText {
    /// The lines of the bodies of the program organization units, trimmed, without empty lines at the start and the end.
    pub lines: Vec<Box<str>>,
    /// The 1-based line of the program on which the mark stands.
    pub line: u32,
}

/// The cell of a matrix that a case comes from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct MatrixCell {
    /// The probe's name: `assignment`.
    pub probe: Arc<str>,
    /// The row's name, the source type: `INT`.
    pub row: Arc<str>,
    /// The column's name, the target type: `DINT`.
    pub column: Arc<str>,
    /// The word of the cell, which tells whether the types convert.
    pub word: MatrixWord,
}
