//! What is wrong or doubtful in a folder of case files.

use std::path::Path;

use crate::{CaseFileError, Suite};

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
    Suite::load(dir).findings()
}

impl Suite {
    /// Everything that is wrong or doubtful in the files of the suite, ordered by file and line.
    pub fn findings(&self) -> Vec<Finding> {
        let finding = |severity| {
            move |what: &CaseFileError| Finding {
                severity,
                what: what.clone(),
            }
        };
        let errors = self.errors.iter().map(finding(Severity::Error));
        let warnings = self.remarks.iter().map(finding(Severity::Warning));
        let mut findings: Vec<Finding> = errors.chain(warnings).collect();
        findings.sort_by(|a, b| (&a.what, a.severity).cmp(&(&b.what, b.severity)));
        findings.dedup();
        findings
    }
}
