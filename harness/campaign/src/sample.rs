//! Findings for tests.

use crate::finding::{
    Confirmation, DIFFERENTIAL, EngineInfo, ExpectedBehavior, FORMAT, Finding, FindingOrigin, ObservedValue,
};

/// Returns a finding of an engine of this name.
pub(crate) fn finding(engine: &str, symptom: &str, rule: &[&str], lines: u64) -> Finding {
    Finding {
        format: FORMAT,
        id: String::new(),
        stickler: env!("CARGO_PKG_VERSION").to_owned(),
        target: DIFFERENTIAL.to_owned(),
        engine: Some(EngineInfo {
            name: engine.to_owned(),
            version: "1".to_owned(),
            asked_for: format!("cmd:{engine}"),
        }),
        symptom: symptom.to_owned(),
        rule: rule.iter().map(|&part| part.to_owned()).collect(),
        cause: None,
        dialect: Some("ironplc-ed3".to_owned()),
        standing: Confirmation::Confirmed,
        origin: FindingOrigin {
            seed: 1,
            place: 7,
            open: false,
            smallest: true,
            tries: 10,
            size_found: 74,
            size: lines,
        },
        message: "x: expected INT#5, got INT#6".to_owned(),
        expected: ExpectedBehavior::Values {
            values: vec![ObservedValue {
                name: "x".to_owned(),
                value: "INT#5".to_owned(),
            }],
            basis: Some("iec-61131-3: 7.3".to_owned()),
            opened: Vec::new(),
        },
        outcomes: Vec::new(),
        reproduce: vec!["stickler fuzz --replay FINDING".to_owned()],
        fingerprint: String::new(),
        program: Some("PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := 5;\nEND_PROGRAM\n".to_owned()),
        original: Some("PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := 2 + 3;\nEND_PROGRAM\n".to_owned()),
        input: vec![1, 2, 3],
    }
    .named()
}
