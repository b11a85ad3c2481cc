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

#[cfg(test)]
mod tests {
    use super::json;
    use crate::sample;
    use stickler_run::{CaseEvent, Verdict};

    fn report(cases: Vec<CaseEvent>) -> serde_json::Value {
        let text = json(&sample::overview(&sample::run_of(cases))).expect("JSON");
        serde_json::from_slice(&text).expect("JSON")
    }

    #[test]
    fn what_is_not_as_expected_is_a_violation_with_a_fingerprint_of_its_own() {
        let cases = vec![
            sample::case("t::a(1)", Verdict::Pass),
            sample::case("t::a(2)", Verdict::Fail),
            sample::case("t::a(3)", Verdict::Crash),
            sample::case("t::a(4)", Verdict::Differs),
        ];
        let report = report(cases);
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
    fn a_run_without_violations_has_an_empty_array() {
        let cases = vec![sample::case("a", Verdict::Pass)];
        assert_eq!(report(cases), serde_json::json!([]));
    }
}
