//! Findings for tests.

use crate::finding::{EngineInfo, Finding, FindingOrigin};

/// Returns a finding of an engine of this name.
pub(crate) fn finding(engine: &str, symptom: &str, rule: &[&str], lines: u64) -> Finding {
    let begun: Finding = serde_json::from_str(include_str!("sample.json")).expect("a finding");
    let program = |body: &str| format!("PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    {body}\nEND_PROGRAM\n");
    Finding {
        stickler: env!("CARGO_PKG_VERSION").to_owned(),
        engine: Some(EngineInfo {
            name: engine.to_owned(),
            version: "1".to_owned(),
            asked_for: format!("cmd:{engine}"),
        }),
        symptom: symptom.to_owned(),
        rule: rule.iter().map(|&part| part.to_owned()).collect(),
        origin: FindingOrigin {
            size: lines,
            ..begun.origin
        },
        program: Some(program("x := 5;")),
        original: Some(program("x := 2 + 3;")),
        input: vec![1, 2, 3],
        ..begun
    }
    .named()
}
