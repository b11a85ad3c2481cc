//! The suite that ships with Stickler is sound.

use std::path::Path;

use stickler_suite::{Acceptance, Suite};
use stickler_types::DialectName;

/// The keywords of the standard that the reference takes for names, since what they begin is not implemented there.
/// Basis: iec-61131-3: second edition, Annex C.
const KEYWORDS: [&str; 12] = [
    "ACTION",
    "END_ACTION",
    "END_STEP",
    "END_TRANSITION",
    "FROM",
    "F_EDGE",
    "INITIAL_STEP",
    "READ_ONLY",
    "READ_WRITE",
    "R_EDGE",
    "STEP",
    "TRANSITION",
];

fn shipped() -> Suite {
    Suite::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases"))
}

/// The words of a program outside comments and texts.
fn words(source: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = source;
    while let Some(at) = rest.find(|c: char| c.is_ascii_alphabetic() || "_('\"/".contains(c)) {
        rest = &rest[at..];
        let behind = |end: &str| {
            rest[1..]
                .find(end)
                .map_or(rest.len(), |found| 1 + found + end.len())
        };
        let length = match rest.as_bytes() {
            [b'(', b'*', ..] => behind("*)"),
            [b'/', b'/', ..] => behind("\n"),
            [b'\'', ..] => behind("'"),
            [b'"', ..] => behind("\""),
            [b'(' | b'/', ..] => 1,
            _ => {
                let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
                let word = &rest[..end.unwrap_or(rest.len())];
                words.push(word);
                word.len()
            }
        };
        rest = &rest[length..];
    }
    words
}

#[test]
fn no_program_that_must_be_accepted_has_a_keyword_for_a_name() {
    // Compilers that know sequential function charts would reject it for that.
    let suite = shipped();
    let accepted = suite
        .cases
        .iter()
        .filter(|case| case.expectation.accepted != Acceptance::Rejected);
    let mut files: Vec<String> = accepted
        .filter(|case| {
            let keyword = |word: &&str| KEYWORDS.iter().any(|keyword| keyword.eq_ignore_ascii_case(word));
            words(&case.source).iter().any(keyword)
        })
        .map(|case| case.file.to_string())
        .collect();
    files.sort();
    files.dedup();
    assert!(files.is_empty(), "{}", files.join("\n"));
}

#[test]
fn lint_has_nothing_to_say_and_every_dialect_has_an_entry() {
    let suite = shipped();
    let findings: Vec<String> = suite
        .findings()
        .iter()
        .map(|finding| finding.what.to_string())
        .collect();
    assert!(findings.is_empty(), "{}", findings.join("\n"));
    let entries: Vec<DialectName> = suite.dialects.entries().map(|(name, _)| name).collect();
    assert_eq!(entries, DialectName::ALL);
    // What no source says of the recorded systems is open.
    let mut documented = DialectName::ALL.to_vec();
    documented.retain(|dialect| !dialect.base().is_recorded());
    assert_eq!(suite.dialects.resolve("all").unwrap(), documented);
    assert!(!suite.version.is_empty());
}
