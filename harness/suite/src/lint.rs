//! Reports the mistakes and the doubtful places in a folder of case files.

use std::path::Path;

use crate::{CaseFileError, Suite};

/// One finding of `stickler lint`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LintFinding {
    /// The severity of the finding.
    pub severity: LintSeverity,
    /// The message and its place.
    pub what: CaseFileError,
}

/// The severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LintSeverity {
    /// An error: the file, or a part of it, cannot be used. A run reports it too.
    Error,
    /// A warning: the cases can be run, but the file probably does not say what its author meant.
    Warning,
}

/// Reads the suite at `dir`, whose sources may speak for these built-in `engines`; returns its mistakes and warnings, ordered by
/// file and line.
pub fn lint(dir: &Path, engines: &[&str]) -> Vec<LintFinding> {
    let mut suite = Suite::load(dir);
    suite.errors.extend(suite.sources.unknown_engines(engines));
    suite.errors.extend(suite.sources.unprinted(&suite.cases));
    suite.findings()
}

impl Suite {
    /// Returns the mistakes and warnings for the files of a suite that was loaded as a whole, ordered by file and line.
    pub fn findings(&self) -> Vec<LintFinding> {
        let finding = |severity| {
            move |what: &CaseFileError| LintFinding {
                severity,
                what: what.clone(),
            }
        };
        let errors = self.errors.iter().map(finding(LintSeverity::Error));
        // Where something else is wrong, that may be the reason.
        let unused = match self.errors.is_empty() && self.remarks.is_empty() {
            true => self.sources.unused(self),
            false => Vec::new(),
        };
        let still_there = self.withdrawn_and_there();
        let warnings = self.remarks.iter().chain(&unused).chain(&still_there);
        let warnings = warnings.map(finding(LintSeverity::Warning));
        let mut findings: Vec<LintFinding> = errors.chain(warnings).collect();
        findings.sort_by(|a, b| (&a.what, a.severity).cmp(&(&b.what, b.severity)));
        findings.dedup();
        findings
    }
}
