//! The result of a trace: whether everything came out as expected, and what did not.

use super::basis::Used;
use super::variables;
use crate::output::{BAD, GOOD};
use serde::Serialize;
use std::io::{self, Write};
use std::sync::Arc;
use stickler_types::{Outcome, Value};

/// The maximum number of differences of a trace that are shown.
const MAX_SHOWN: usize = 8;

/// The verdict of a trace whose values are all as expected.
const PASS: &str = "pass";

/// A value that must come out after a scan.
pub(super) struct Expected {
    /// The scan, from 1.
    pub scan: u32,
    /// The variable as a trace names it.
    pub name: String,
    /// The path of the variable in the program.
    pub path: Arc<str>,
    /// The value.
    pub value: Value,
}

/// The result of a trace, as `--json` prints it.
#[derive(Default, Serialize)]
pub(super) struct TraceResult {
    /// The file of the program.
    pub program: String,
    /// The name of the trace, or its number.
    pub trace: String,
    /// `pass`, `fail`, `fault`, `rejected`, `not-run`, or `misfit` where the trace does not fit the program.
    verdict: &'static str,
    /// The reason why the program did not run to its end; `None` where it did.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    /// The values that are not as expected, in the order of the scans.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    differences: Vec<Difference>,
    /// The standard functions and function blocks that the program uses, on whose sources or choices a verdict of the reference rests.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub uses: Vec<Used>,
}

/// A value that is not the expected one.
#[derive(Serialize)]
struct Difference {
    scan: u32,
    name: String,
    expected: String,
    /// `None` where the program did not come so far.
    found: Option<String>,
}

impl TraceResult {
    /// Returns the result of a trace that has no values.
    pub(super) fn without_values(verdict: &'static str, reason: String) -> TraceResult {
        TraceResult {
            verdict,
            reason: Some(reason),
            ..TraceResult::default()
        }
    }

    /// Compares an outcome with what is expected, in the order in which the values were asked for.
    pub(super) fn of(outcome: Outcome, expected: &[Expected], tolerance: f64) -> TraceResult {
        let (values, reason) = match outcome {
            Outcome::Executed { values, .. } => (values, None),
            Outcome::Faulted {
                fault, line, values, ..
            } => {
                let place = line.map_or_else(String::new, |line| format!("line {line}: "));
                (
                    values,
                    Some(format!("{place}the program stops with the fault {fault}")),
                )
            }
            other => return TraceResult::without_values("not-run", other.to_string()),
        };
        // After a fault the values of later scans are missing; each value is known by its key.
        let mut values = values.into_iter().peekable();
        let mut differences = Vec::new();
        for Expected {
            scan,
            name,
            path,
            value,
        } in expected
        {
            let key = format!("{path}@{scan}");
            let found = values.next_if(|(name, _)| *name == key).map(|(_, value)| value);
            let agrees = |found: &Value| variables::agrees(found, value, tolerance);
            if !found.as_ref().is_some_and(agrees) {
                differences.push(Difference {
                    scan: *scan,
                    name: name.clone(),
                    expected: value.to_string(),
                    found: found.map(|found| found.to_string()),
                });
            }
        }
        TraceResult {
            verdict: match reason {
                Some(_) => "fault",
                None if differences.is_empty() => PASS,
                None => "fail",
            },
            reason,
            differences,
            ..TraceResult::default()
        }
    }

    /// Returns whether the program ran to its end and all values are as expected.
    pub(super) fn is_pass(&self) -> bool {
        self.verdict == PASS
    }

    /// Writes the result for a person, with the file where there are several.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub(super) fn write(&self, names_file: bool, out: &mut dyn Write) -> io::Result<()> {
        let (style, word) = if self.is_pass() {
            (GOOD, "pass")
        } else {
            (BAD, "FAIL")
        };
        let file = if names_file {
            format!("{}: ", self.program)
        } else {
            String::new()
        };
        let reason = self.reason.as_ref().map(|reason| format!(": {reason}"));
        let reason = reason.unwrap_or_default();
        writeln!(out, "{style}{word}{style:#} {file}{}{reason}", self.trace)?;
        for Difference {
            scan,
            name,
            expected,
            found,
        } in self.differences.iter().take(MAX_SHOWN)
        {
            let found = found.as_ref().map(|found| format!("= {found}"));
            let found = found.as_deref().unwrap_or("was not reached");
            writeln!(out, "     scan {scan}: {name} {found}, expected {expected}")?;
        }
        match self.differences.len().saturating_sub(MAX_SHOWN) {
            0 => Ok(()),
            more => writeln!(out, "     ... and {more} more"),
        }
    }
}
