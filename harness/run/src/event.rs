//! The events of a run: a header, one event for each case and engine, the causes of what failed, a footer. Every report is a
//! projection of them and adds no facts; a stream without its footer is a truncated run. Basis: reports/README.md.

mod cause;
mod header;
mod verdict;

pub use cause::{Cause, ExplainedCases, Neighbour, Reduced, RepeatedOutcome, Repeats, Reproducer};
pub use header::{BaselineHeader, DefinedHeader, EngineHeader, Header, OutdatedEntry, PROGRAM};
pub(crate) use header::{RERUN_DIALECT, RERUN_ID, rerun};
pub use verdict::{Totals, Verdict};

use crate::Fact;
use serde::{Deserialize, Serialize};
use stickler_engines::Grade;
use stickler_types::Question;

/// The version of the event format.
pub const FORMAT: u32 = 4;

/// An event of a run. Its form in a log is up to the log.
#[derive(Clone, PartialEq, Debug)]
pub enum Event {
    /// The first event.
    Header(Header),
    /// The result of a case on an engine; these events come in the order of the suite.
    Case(CaseEvent),
    /// A feature that an engine lacks, or a cause of failing cases, where the causes were searched for; these events come after the cases.
    Cause(Cause),
    /// The last event of a run that was not cut short.
    Footer(Footer),
}

/// The result of a case on an engine.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct CaseEvent {
    /// The id of the case; together with the dialect and the engine it is unique in a run.
    pub id: String,
    /// The dialect of the case.
    pub dialect: String,
    /// The name of the engine.
    pub engine: String,
    /// The verdict, after the engine's baseline was applied.
    pub verdict: Verdict,
    /// Whether the document leaves the result open: the case asserts nothing, or only that the program is accepted, and
    /// records what the engine does.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub open: bool,
    /// The grade of a rejection or a fault; `None` where neither was expected or neither came.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grade: Option<Grade>,
    /// The title of the case.
    pub title: String,
    /// The claim that the case checks: document and section.
    pub basis: String,
    /// The area of the case: its folder, the first part of its id.
    pub area: String,
    /// The path of the case file.
    pub file: String,
    /// The line of the case in the case file, from 1; `None` where it passed, since nobody looks for it then.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// A fingerprint of the expectation, by which two runs see whether they expected the same.
    #[serde(skip)]
    pub expectation: u32,
    /// The expected facts, in a fixed order; empty where the case passed and `got` adds nothing to them.
    pub expected: Vec<Fact>,
    /// The actual facts, in the order of `expected`, so that a diff of their texts shows the deviation; empty where
    /// `expected` is.
    pub got: Vec<Fact>,
    /// The time that the engine took, in microseconds.
    pub duration_us: u64,
    /// The observations, which are recorded and not judged.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub observations: Vec<Observed>,
    /// The whole program, where the engine did not meet the expectation, with a timing diagram of several scans as a comment behind it;
    /// `None` otherwise, since the case file has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// The question that the program asks; `None` where it asks none, or where `program` is.
    #[serde(skip)]
    pub question: Option<Question>,
    /// The note of the engine's baseline on the case; `None` where no entry matters to it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub baseline: Option<BaselineNote>,
}

impl CaseEvent {
    /// Returns where the case stands: its file, and its line where that is known.
    pub fn place(&self) -> String {
        match self.line {
            Some(line) => format!("{}:{line}", self.file),
            None => self.file.clone(),
        }
    }

    /// Returns the part of the id that the cases of a table's probe share, or the whole id where the case comes from no table.
    pub fn probe(&self) -> &str {
        self.id.split_once('(').map_or(&self.id, |(probe, _)| probe)
    }

    /// Returns the verdict of the case as if there were no baseline.
    pub fn actual_verdict(&self) -> Verdict {
        match (self.verdict, &self.baseline) {
            (Verdict::Xfail, Some(note)) => note.verdict,
            (Verdict::Xfail, None) => Verdict::Fail,
            (Verdict::Xpass, _) => Verdict::Pass,
            (verdict, _) => verdict,
        }
    }
}

/// The note of a baseline on a case.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BaselineNote {
    /// The file and line of the entry.
    pub at: String,
    /// The verdict that the entry expects. For a case whose verdict is [`Verdict::Xfail`], the actual verdict.
    pub verdict: Verdict,
    /// The alternative verdicts that the entry expects, for a compiler whose answer varies from run to run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<Verdict>,
    /// The reason that the entry states.
    pub reason: String,
    /// The address of further information, where the entry has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
}

impl BaselineNote {
    /// Returns all verdicts that the entry expects.
    pub fn verdicts(&self) -> Vec<Verdict> {
        [&[self.verdict], &self.others[..]].concat()
    }

    /// Returns the note for a case with this actual verdict, which is one of the expected ones.
    pub(crate) fn of_xfail(&self, came: Verdict) -> BaselineNote {
        let mut others = self.verdicts();
        others.retain(|verdict| *verdict != came);
        BaselineNote {
            verdict: came,
            others,
            ..self.clone()
        }
    }
}

/// An observation: a result that is recorded and not judged.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Observed {
    /// The observed variable (`q`, `a[1]`, `q@3`), or `acceptance`, or `fault`.
    pub name: String,
    /// The value of the variable as a typed literal; `accepted` or `rejected` for an acceptance; the kind of fault for a
    /// fault.
    pub value: String,
}

/// The facts of a run that are known after its last case.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Footer {
    /// The number of times that each verdict came in the whole run.
    pub totals: Totals,
    /// The verdict counts of each engine, in the order of the header.
    pub engines: Vec<EngineTotals>,
    /// The duration of the run until its last case, in milliseconds.
    pub duration_ms: u64,
    /// The duration of the search for causes behind it, in milliseconds; `None` where there was none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub causes_ms: Option<u64>,
}

/// The verdict counts of one engine.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EngineTotals {
    /// The name of the engine.
    pub name: String,
    /// The number of times that each verdict came on the engine.
    pub totals: Totals,
}
