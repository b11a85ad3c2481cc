//! Findings for tests.

use crate::finding::{
    Confirmation, DIFFERENTIAL, EngineInfo, ExpectedBehavior, Finding, FindingOrigin, ObservedValue,
};
use crate::oracle::Mismatch;

/// Returns a finding of an engine of this name.
pub(crate) fn finding(engine: &str, symptom: &str, rule: &[&str], lines: u64) -> Finding {
    let mismatch = Mismatch {
        place: 7,
        subject: engine.to_owned(),
        symptom: symptom.to_owned(),
        rule: Vec::new(),
        size: 0,
    };
    let begun = Finding::begin(DIFFERENTIAL, &mismatch, 1);
    Finding {
        engine: Some(EngineInfo {
            name: engine.to_owned(),
            version: "1".to_owned(),
            asked_for: format!("cmd:{engine}"),
        }),
        rule: rule.iter().map(|&part| part.to_owned()).collect(),
        dialect: Some("ironplc-ed3".to_owned()),
        standing: Confirmation::Confirmed,
        origin: FindingOrigin {
            smallest: true,
            size_found: 74,
            size: lines,
            ..begun.origin
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
        reproduce: vec!["stickler fuzz --replay FINDING".to_owned()],
        program: Some("PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := 5;\nEND_PROGRAM\n".to_owned()),
        original: Some("PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := 2 + 3;\nEND_PROGRAM\n".to_owned()),
        input: vec![1, 2, 3],
        ..begun
    }
    .named()
}
