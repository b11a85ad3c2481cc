//! The suite that ships with Stickler is sound.

use std::collections::BTreeSet;
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

/// The standard functions whose names a program could also give to something of its own.
/// Basis: iec-61131-3: third edition, Tables 28 to 36.
const STANDARD_FUNCTIONS: &str = "ABS ACOS ADD ADD_DT_TIME ADD_TIME ADD_TOD_TIME ASIN ATAN ATAN2 CONCAT COS DELETE DIV EQ EXP EXPT FIND \
    GE GT INSERT LE LEFT LEN LIMIT LN LOG LT MAX MID MIN MOVE MUL MUX NE REPLACE RIGHT ROL ROR SEL SHL SHR SIN SQRT SUB TAN TRUNC";

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
fn no_program_gives_the_name_of_a_standard_function_to_something_else() {
    // A compiler may take the name for the function's, and no document says that it must not.
    let suite = shipped();
    let mut found = BTreeSet::new();
    for case in &suite.cases {
        for word in words(&case.source) {
            let behind = &case.source[word.as_ptr().addr() - case.source.as_ptr().addr() + word.len()..];
            // `LT#` begins a duration.
            let is_call_or_literal = behind.trim_start().starts_with(['(', '#']);
            let is_function = |name: &str| name.eq_ignore_ascii_case(word);
            if !is_call_or_literal && STANDARD_FUNCTIONS.split_whitespace().any(is_function) {
                found.insert(format!("{}: {word}", case.file));
            }
        }
    }
    let found: Vec<String> = found.into_iter().collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
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
    // What no source says of the systems that are known in part is open.
    let mut documented = DialectName::ALL.to_vec();
    documented.retain(|dialect| !dialect.base().is_known_in_part());
    assert_eq!(suite.dialects.resolve("all").unwrap(), documented);
    assert!(!suite.version.is_empty());
}
