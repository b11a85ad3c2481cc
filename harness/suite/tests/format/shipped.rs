//! The suite that ships with Stickler is sound.

use std::path::Path;

use stickler_suite::{Severity, Suite};
use stickler_types::DialectName;

#[test]
fn no_case_file_has_a_mistake_and_every_dialect_has_an_entry() {
    let suite = Suite::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases"));
    let findings = suite.findings();
    let errors = findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error);
    let errors: Vec<String> = errors.map(|finding| finding.what.to_string()).collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
    let entries: Vec<DialectName> = suite.dialects.entries().map(|(name, _)| name).collect();
    assert_eq!(entries, DialectName::ALL);
    assert_eq!(suite.dialects.resolve("all").unwrap(), DialectName::ALL);
    assert!(!suite.version.is_empty());
}
