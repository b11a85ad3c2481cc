//! `gl-code-quality-report.json`: the unexpected results of a run for GitLab, which shows them in merge requests.
//!
//! Basis: GitLab, "Code Quality", <https://docs.gitlab.com/ci/testing/code_quality/#code-quality-report-format>: an array of objects with these keys, and
//! severities from `info` to `blocker`.

use crate::ReportError;
use crate::overview::Overview;
use crate::pending::PendingFile;
use crate::unexpected::Unexpected;
use serde::Serialize;
use std::path::PathBuf;

/// The file, written when the run is over.
pub(crate) struct CodeQuality {
    file: PendingFile,
}

/// One unexpected result.
#[derive(Serialize)]
struct Violation {
    description: String,
    check_name: String,
    fingerprint: String,
    severity: &'static str,
    location: IssueLocation,
}

#[derive(Serialize)]
struct IssueLocation {
    path: String,
    lines: IssueLines,
}

#[derive(Serialize)]
struct IssueLines {
    begin: u32,
}

impl CodeQuality {
    /// Creates the file.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be created.
    pub(crate) fn create(path: PathBuf) -> Result<CodeQuality, ReportError> {
        Ok(CodeQuality {
            file: PendingFile::create(path)?,
        })
    }

    /// Writes the file; a run that was cut short gets none, since the service takes what is missing for mended.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written.
    pub(crate) fn finish(mut self, overview: &Overview) -> Result<(), ReportError> {
        if overview.footer.is_none() {
            return Ok(());
        }
        let path = self.file.path().to_owned();
        let violations: Vec<Violation> = Unexpected::all(overview).map(violation).collect();
        serde_json::to_writer(&mut self.file, &violations)
            .map_err(|error| ReportError::writing(&path)(error.into()))?;
        self.file.commit()
    }
}

/// Returns the object of a result. The service shows only the description, in one line, and wants a path and a line.
fn violation(unexpected: Unexpected) -> Violation {
    Violation {
        description: unexpected.title,
        check_name: unexpected.basis,
        fingerprint: unexpected.key,
        severity: "major",
        location: IssueLocation {
            path: unexpected.file,
            lines: IssueLines {
                begin: unexpected.line.unwrap_or(1),
            },
        },
    }
}

#[cfg(test)]
mod tests {
    use super::CodeQuality;
    use crate::{Overview, sample};
    use std::fs;
    use stickler_run::{Event, Verdict};

    fn report(events: &[Event]) -> Option<serde_json::Value> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("gl-code-quality-report.json");
        let report = CodeQuality::create(path.clone()).expect("a file");
        let mut overview = Overview::default();
        events.iter().for_each(|event| overview.take(event));
        report.finish(&overview).expect("written");
        let text = fs::read_to_string(path).ok()?;
        Some(serde_json::from_str(&text).expect("JSON"))
    }

    #[test]
    fn what_is_not_as_expected_is_a_violation_with_a_fingerprint_of_its_own() {
        let cases = vec![
            sample::case("t::a(1)", Verdict::Pass),
            sample::case("t::a(2)", Verdict::Fail),
            sample::case("t::a(3)", Verdict::Crash),
            sample::case("t::a(4)", Verdict::Differs),
        ];
        let report = report(&sample::run_of(cases)).expect("a report");
        let [first, second] = &report.as_array().expect("an array")[..] else {
            panic!("two are not as expected: {report}")
        };
        let expected = serde_json::json!({
            "description": "reference: widening/t::a(2)@ironplc-ed2: fail: SINT widens to INT",
            "check_name": "ironplc-type-conversions: Integer widening",
            "fingerprint": "reference: widening/t::a(2)@ironplc-ed2",
            "severity": "major",
            "location": {"path": "conformance-cases/widening/integer.toml", "lines": {"begin": 7}},
        });
        assert_eq!(first, &expected);
        assert_ne!(first["fingerprint"], second["fingerprint"]);
    }

    #[test]
    fn a_run_without_violations_has_an_empty_array_and_one_that_was_cut_short_no_report() {
        let events = sample::run_of(vec![sample::case("a", Verdict::Pass)]);
        assert_eq!(report(&events), Some(serde_json::json!([])));
        assert_eq!(report(&events[..2]), None);
    }
}
