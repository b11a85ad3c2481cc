//! What is wrong or doubtful in a folder of case files.

use std::path::Path;
use std::sync::Arc;

use crate::{Acceptance, Case, CaseFileError, Suite};

/// One thing that `stickler lint` says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// How bad it is.
    pub severity: Severity,
    /// What and where it is.
    pub what: CaseFileError,
}

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The file, or a part of it, cannot be used; a run says so too.
    Error,
    /// The cases can be run, but the file does not say what its author meant.
    Warning,
}

/// Reads the suite at `dir` and says everything that is wrong or doubtful, ordered by file and line.
pub fn lint(dir: &Path) -> Vec<Finding> {
    let suite = Suite::load(dir);
    let mut doubts = suite.remarks.clone();
    doubts.extend(cases_that_cannot_fail(&suite.cases));
    let errors = suite.errors.into_iter().map(|what| Finding {
        severity: Severity::Error,
        what,
    });
    let warnings = doubts.into_iter().map(|what| Finding {
        severity: Severity::Warning,
        what,
    });
    let mut findings: Vec<Finding> = errors.chain(warnings).collect();
    findings.sort_by(|a, b| (&a.what, a.severity).cmp(&(&b.what, b.severity)));
    findings.dedup();
    findings
}

/// Says of each place in a file once that its cases claim nothing.
fn cases_that_cannot_fail(cases: &[Case]) -> Vec<CaseFileError> {
    let mut found = Vec::new();
    let mut last: Option<(&Arc<str>, u32)> = None;
    for case in cases.iter().filter(|case| claims_nothing(case)) {
        if last.replace((&case.file, case.line)) == Some((&case.file, case.line)) {
            continue;
        }
        found.push(CaseFileError {
            file: case.file.to_string(),
            line: case.line,
            key: None,
            message: format!(
                "the case `{}` claims nothing but that the program is accepted",
                case.id
            ),
            hint: Some("if that is the claim, say `(*! ok *)` on the line that matters".to_owned()),
        });
    }
    found
}

/// Whether no mark says what the program is there for. What is only recorded is meant to be so.
fn claims_nothing(case: &Case) -> bool {
    let expectation = &case.expectation;
    expectation.accepted == Acceptance::Required
        && expectation.values.is_empty()
        && expectation.clean_lines.is_empty()
        && expectation.fault.is_none()
        && expectation.rendered.is_none()
        && case.observe.is_empty()
}
