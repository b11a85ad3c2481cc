//! Tests of the reduction of texts: the results are small, well-formed, and keep their symptom.

use crate::{Interestingness, ReductionBudget, StopReason, text};
use serde::Deserialize;
use stickler_types::DialectName;

/// A text with one of everything.
const MACHINE: &str = include_str!("tests/machine.st");

/// The file of reductions, whose head says what each key means.
#[derive(Deserialize)]
struct Reductions {
    reduction: Vec<ReducedText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReducedText {
    name: String,
    start: Option<String>,
    dialect: Option<String>,
    broken: Option<String>,
    to: Vec<Remainder>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Remainder {
    words: Vec<String>,
    lines: Option<usize>,
    #[serde(default)]
    has: Vec<String>,
    #[serde(default)]
    lacks: Vec<String>,
}

fn accepted(text: &str, dialect: DialectName) {
    let diagnostics = stickler_reference::errors(text, dialect);
    assert!(diagnostics.is_empty(), "{diagnostics:?}\n{text}");
}

#[test]
fn what_remains_of_each_text_is_what_its_words_need() {
    let file: Reductions =
        toml::from_str(include_str!("tests/reductions.toml")).expect("the file is readable");
    for ReducedText {
        name,
        start,
        dialect,
        broken,
        to,
    } in file.reduction
    {
        let start = start.as_deref().unwrap_or(MACHINE);
        let dialect = dialect.map_or(DialectName::IRONPLC_ED3, |name| name.parse().expect("a dialect"));
        let check = |text: &str| {
            if broken.is_none() {
                accepted(text, dialect)
            }
        };
        check(start);
        for Remainder {
            words,
            lines,
            has,
            lacks,
        } in to
        {
            let shows = |text: &str| Interestingness::from(words.iter().all(|word| text.contains(word)));
            let found = text(start, dialect, shows, &ReductionBudget::default());
            let rest = &found.value;
            check(rest);
            assert_eq!(found.ended, StopReason::Smallest, "{name}");
            assert!(
                lines.is_none_or(|most| rest.trim().lines().count() <= most),
                "{name}: {words:?}\n{rest}"
            );
            let missing = has.iter().find(|part| !rest.contains(*part));
            let left = lacks.iter().find(|part| rest.contains(*part));
            assert_eq!((missing, left), (None, None), "{name}: {words:?}\n{rest}");
        }
    }
}

#[test]
fn one_variable_takes_the_place_of_others_and_of_calls() {
    let start = "PROGRAM main\nVAR\n    a : DWORD;\n    b : DWORD;\n    c : UDINT;\nEND_VAR\n    a := SEL(TRUE, b, \
                 UDINT_TO_DWORD(c));\nEND_PROGRAM\n";
    let dialect = DialectName::IRONPLC_ED3;
    accepted(start, dialect);
    let without_literals =
        |text: &str| Interestingness::from(text.contains("SEL(TRUE, ") && !text.contains(['0', '1']));
    let found = text(start, dialect, without_literals, &ReductionBudget::default());
    accepted(&found.value, dialect);
    assert!(found.value.contains("a := SEL(TRUE, a, a);"), "{}", found.value);
    assert_eq!(found.value.matches(" : ").count(), 1, "{}", found.value);
}

#[test]
fn one_of_several_statements_on_a_line_goes_where_no_semicolon_alone_is_taken() {
    let start = "TYPE\n    POINT : STRUCT\n        y : INT;\n    END_STRUCT;\nEND_TYPE\n\nPROGRAM main\nVAR\n    got : INT;\nEND_VAR\n\
                 VAR_TEMP\n    it : POINT;\nEND_VAR\n    it.y := 0; got := 0;\nEND_PROGRAM\n";
    let takes = |text: &str| {
        let has_all = ["it : POINT", "VAR_TEMP", "got := 0"]
            .iter()
            .all(|part| text.contains(part));
        let is_empty = |line: &str| line.trim_start().starts_with(';') || line.contains("; ;");
        Interestingness::from(has_all && !text.lines().any(is_empty))
    };
    let found = text(
        start,
        DialectName::IRONPLC_ED3,
        takes,
        &ReductionBudget::default(),
    );
    assert!(!found.value.contains("it.y"), "{}", found.value);
}

#[test]
fn a_rejected_text_gets_no_new_faults() {
    let start = MACHINE.replace("total : DINT;", "total : INT;");
    let codes = |text: &str| {
        let diagnostics = stickler_reference::errors(text, DialectName::IRONPLC_ED3);
        let codes: Vec<String> = diagnostics.iter().filter_map(|one| one.code.clone()).collect();
        codes
    };
    let before = codes(&start);
    assert!(!before.is_empty());
    let mut all = Vec::new();
    let same = |text: &str| {
        let now = codes(text);
        all.extend(now.clone());
        Interestingness::from(now.contains(&before[0]))
    };
    let found = text(
        &start,
        DialectName::IRONPLC_ED3,
        same,
        &ReductionBudget::default(),
    );
    assert!(all.iter().all(|code| before.contains(code)), "{all:?}");
    assert!(found.value.lines().count() <= 8, "{}", found.value);
}
