//! `gl-code-quality-report.json`: the unexpected results of a run for GitLab, which shows them in merge requests.
//!
//! Basis: GitLab, "Code Quality", <https://docs.gitlab.com/ci/testing/code_quality/#code-quality-report-format>: an array of objects with these keys, and
//! severities from `info` to `blocker`.

use crate::overview::Overview;
use crate::unexpected::Unexpected;
use serde_json::{Value, json};

/// Returns the content of the file.
///
/// # Errors
/// Returns the error of serde_json.
pub(crate) fn json(overview: &Overview) -> serde_json::Result<Vec<u8>> {
    let violations: Vec<Value> = Unexpected::all(overview).map(violation).collect();
    serde_json::to_vec(&violations)
}

/// Returns the object of a result. The service shows only the description, in one line, and wants a path and a line.
fn violation(unexpected: Unexpected) -> Value {
    json!({
        "description": unexpected.title,
        "check_name": unexpected.basis,
        "fingerprint": unexpected.key,
        "severity": "major",
        "location": { "path": unexpected.file, "lines": { "begin": unexpected.line.unwrap_or(1) } },
    })
}
