//! The suite that ships with Stickler is sound.

use std::path::Path;

use stickler_suite::Suite;
use stickler_types::DialectName;

#[test]
fn lint_has_nothing_to_say_and_every_dialect_has_an_entry() {
    let suite = Suite::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases"));
    let findings: Vec<String> = suite
        .findings()
        .iter()
        .map(|finding| finding.what.to_string())
        .collect();
    assert!(findings.is_empty(), "{}", findings.join("\n"));
    let entries: Vec<DialectName> = suite.dialects.entries().map(|(name, _)| name).collect();
    assert_eq!(entries, DialectName::ALL);
    assert_eq!(suite.dialects.resolve("all").unwrap(), DialectName::ALL);
    assert!(!suite.version.is_empty());
}
