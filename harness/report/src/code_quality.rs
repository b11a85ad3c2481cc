//! `gl-code-quality-report.json`: the unexpected results of a run for GitLab, which shows them in merge requests.
//!
//! Basis: GitLab, "Code Quality", <https://docs.gitlab.com/ci/testing/code_quality/#code-quality-report-format>: an array of objects with these keys, and
//! severities from `info` to `blocker`.

use crate::overview::Overview;
use crate::unexpected::Unexpected;
use serde::Serialize;

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

/// Returns the content of the file.
///
/// # Errors
/// Returns the error of serde_json.
pub(crate) fn json(overview: &Overview) -> serde_json::Result<Vec<u8>> {
    let violations: Vec<Violation> = Unexpected::all(overview).map(violation).collect();
    serde_json::to_vec(&violations)
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
