//! Tests that every kind of error is planted, and planted in one place.

use super::*;
use crate::model::{Type, Variable, VariableSection};
use crate::oracles::judge_planted;
use crate::reader::read;
use crate::writer::{Style, write};
use std::collections::{BTreeMap, BTreeSet};
use stickler_types::{DialectName, ElementaryType};

/// A program that has a place for every kind of error.
const EXAMPLE: &str = include_str!("example.st");

/// Returns the dialects that have all that the example uses.
fn dialects() -> impl Iterator<Item = DialectName> {
    let has_all = |dialect: &DialectName| {
        let used = stickler_syntax::features::features(EXAMPLE, dialect.rules());
        used.iter().all(|feature| !dialect.rules().lacks(feature))
    };
    DialectName::ALL.into_iter().filter(has_all)
}

fn example(dialect: DialectName) -> Program {
    read(EXAMPLE, dialect).expect("it is a program of the model")
}

/// Returns bytes that choose differently for every number.
fn choices(number: u64) -> Vec<u8> {
    crate::random::bytes(number, 96)
}

#[test]
fn there_are_many_kinds_each_of_its_own_name() {
    let names: BTreeSet<_> = kind_names().collect();
    assert_eq!(names.len(), KINDS.len());
    assert!(names.len() > 90, "{}", names.len());
}

#[test]
fn every_code_of_the_design_is_planted() {
    // The codes that errors are planted for.
    let listed = "P0001 P0002 P0003 P0004 P0010 P2008 P2026 P2027 P4007 P4011 P4014 P4016 P4017 P4018 P4021 P4022 P4023 \
                  P4024 P4025 P4026 P4027 P4033 P4035 P4039 P4040 P2038 P2039 P2040 P4005 P4049 P4053 P4058 P4059 P4069 P4072";
    for code in listed.split_whitespace() {
        assert!(KINDS.iter().any(|kind| kind.code.as_str() == code), "{code}");
    }
}

#[test]
fn every_kind_is_planted_in_the_example_and_found() {
    let mut wrong = Vec::new();
    for kind in kind_names() {
        let mut planted_anywhere = false;
        for dialect in dialects() {
            let sound = example(dialect);
            for number in 0..12 {
                let Some(planted) = plant_kind(&sound, kind, &choices(number)) else {
                    continue;
                };
                planted_anywhere = true;
                wrong.extend(judge_planted(&sound, &planted, &Style::default()).err());
            }
        }
        assert!(planted_anywhere, "{kind} is planted in no dialect");
    }
    let messages: Vec<_> = wrong
        .iter()
        .map(|failure| (&failure.symptom, &failure.message))
        .collect();
    let of_each_kind: BTreeMap<_, _> = messages.into_iter().collect();
    assert!(
        of_each_kind.is_empty(),
        "{} failures: {of_each_kind:#?}",
        wrong.len()
    );
}

#[test]
fn what_is_planted_changes_the_text_on_the_line_that_is_told() {
    for dialect in dialects() {
        let sound = example(dialect);
        for number in 0..200 {
            let planted = plant(&sound, &choices(number)).expect("a place for an error");
            let (without, with) = (
                write(&sound, &Style::default()),
                write(&planted.program, &Style::default()),
            );
            assert_ne!(without.text, with.text, "{}", planted.kind);
            let line = usize::try_from(planted.line(&without, &with)).expect("a short text");
            let line_text = with.text.lines().nth(line - 1).unwrap_or_default();
            let known = without.text.lines().filter(|line| *line == line_text).count();
            let now = with.text.lines().filter(|line| *line == line_text).count();
            assert!(
                now > known,
                "{}: line {line} is not new in\n{}",
                planted.kind,
                with.text
            );
        }
    }
}

/// Returns the lines that a kind plants in the example, trimmed.
fn planted_lines(kind: &str, dialect: DialectName) -> BTreeSet<String> {
    let sound = example(dialect);
    let style = Style::default();
    let without = write(&sound, &style);
    let lines = (0..200).filter_map(|number| {
        let planted = plant_kind(&sound, kind, &choices(number))?;
        let with = write(&planted.program, &style);
        let line = usize::try_from(planted.line(&without, &with)).ok()?;
        with.text.lines().nth(line - 1).map(|line| line.trim().to_owned())
    });
    lines.collect()
}

#[test]
fn a_selector_that_is_no_integer_may_convert_to_one_elsewhere() {
    for dialect in dialects() {
        let lines = planted_lines("a selector that is no integer", dialect);
        let of_bits: &[&str] = match dialect.rules().bit_strings_as_integers {
            true => &[],
            false => &["w", "NOT w"],
        };
        for selector in ["t", "t + t"].iter().chain(of_bits) {
            let line = format!("CASE {selector} OF");
            assert!(lines.contains(&line), "{line} in {dialect}: {lines:#?}");
        }
    }
}

#[test]
fn fields_elements_and_bits_of_constants_are_assigned() {
    for dialect in dialects() {
        let lines = planted_lines("a part of a constant assigned", dialect);
        let assigned = |target: &str| lines.iter().any(|line| line.starts_with(target));
        for part in ["planted.x := ", "planted.y := ", "planted[1] := "] {
            assert!(assigned(part), "{part} in {dialect}: {lines:#?}");
        }
        for bit in ["planted.0 := ", "planted.x.15 := ", "planted[1].0 := "] {
            assert_eq!(
                assigned(bit),
                dialect.rules().documents.bits,
                "{bit} in {dialect}: {lines:#?}"
            );
        }
    }
}

#[test]
fn no_constant_is_an_operand_of_a_planted_operation() {
    for dialect in dialects() {
        let mut sound = example(dialect);
        for ty in ElementaryType::ALL {
            sound.main.variables.push(Variable {
                name: format!("fixed_{ty}"),
                ty: Type::Elementary(ty),
                section: VariableSection::Constant,
                initial: None,
            });
        }
        let style = Style::default();
        let kind = "a value of another type assigned";
        let texts = (0..200).filter_map(|number| {
            let planted = plant_kind(&sound, kind, &choices(number))?;
            Some(write(&planted.program, &style).text)
        });
        let texts: Vec<String> = texts.collect();
        // Of omron no source says what does not convert.
        let is_planted = texts.is_empty() || texts.iter().any(|text| text.contains(":= fixed_"));
        assert!(is_planted, "{dialect}");
        for text in texts {
            let sum = text
                .lines()
                .find(|line| line.contains("fixed_") && line.contains(" + "));
            assert_eq!(sum, None, "{dialect}");
        }
    }
}

#[test]
fn no_bytes_plant_the_first_kind() {
    let planted = plant(&example(DialectName::MATIEC), &[]).expect("a place for an error");
    assert_eq!(Some(planted.kind), kind_names().next());
}

#[test]
fn an_unknown_kind_is_planted_nowhere() {
    let sound = example(DialectName::PLCNEXT);
    assert_eq!(plant_kind(&sound, "no such kind", &[]), None);
}
