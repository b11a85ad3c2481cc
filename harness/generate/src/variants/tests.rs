//! Tests of variants: their values against the evaluator, which knows nothing of texts, and their texts against their
//! descriptions.

use super::*;
use crate::evaluate::evaluate;
use crate::generator::{GeneratorSettings, program};
use crate::model::Program;
use crate::random::Random;
use crate::reader::read;
use crate::writer::{Style, write};
use arbitrary::Unstructured;
use stickler_types::{DialectName, Value};

/// Returns pseudorandom bytes of a length that makes a program of some size.
fn bytes(seed: u64) -> Vec<u8> {
    crate::random::bytes(seed, 600)
}

fn made(seed: u64) -> Program {
    program(&bytes(seed), &GeneratorSettings::default())
}

/// Returns the values that `other`, which has the variables of `original` and more, gives for everything observed of
/// `original`.
fn values_in(other: &Program, original: &Program) -> Option<Vec<(String, Value)>> {
    let evaluation = evaluate(other, 1).ok()?;
    let observed = original.observed();
    let kept = |path: &str| observed.iter().any(|(name, _)| name == path);
    Some(
        evaluation
            .values
            .into_iter()
            .filter(|(path, _)| kept(path))
            .collect(),
    )
}

/// Returns a program with something for every variant: loops of each kind, a bit, an implicit conversion, a call, both sides
/// of an IF.
pub(crate) fn everything() -> Program {
    read(EVERYTHING, DialectName::IRONPLC_ED3).expect("it is a program of the model")
}

const EVERYTHING: &str = include_str!("everything.st");

type VariantChange = fn(&mut Program, &mut Random<'_, '_>) -> usize;

#[test]
fn what_changes_the_model_changes_no_value() {
    let changes: [(&str, VariantChange); 7] = [
        ("hoist", operands::hoist),
        ("type_all", operands::type_all),
        ("swap", operands::swap),
        ("split", operands::split),
        ("unroll", loops::unroll),
        ("insert", dead_code::insert),
        ("branches", loops::swap_branches),
    ];
    for (name, change) in changes {
        let mut changed = 0;
        for seed in 0..200 {
            let original = if seed % 20 == 0 { everything() } else { made(seed) };
            let mut other = original.clone();
            let choices = bytes(seed + 1_000_000);
            changed += change(&mut other, &mut Random::new(&mut Unstructured::new(&choices)));
            let expected = values_in(&original, &original);
            assert!(expected.is_some(), "seed {seed} has values");
            assert_eq!(
                values_in(&other, &original),
                expected,
                "{name} of seed {seed}:\n{}\nof\n{}",
                write(&other, &Style::default()).text,
                write(&original, &Style::default()).text
            );
        }
        assert!(changed > 0, "{name} finds something to change");
    }
}

#[test]
fn every_variant_has_another_text_for_a_program_that_has_everything() {
    for variant in Variant::ALL {
        let varied =
            (0..20).filter_map(|seed| variant.text(&everything(), &mut Unstructured::new(&bytes(seed))));
        let canonical = write(&everything(), &Style::default()).text;
        assert!(
            varied.filter(|text| *text != canonical).count() > 0,
            "{}",
            variant.as_str()
        );
    }
}

#[test]
fn names_of_variants_are_distinct() {
    let mut names: Vec<&str> = Variant::ALL.iter().map(|variant| variant.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Variant::ALL.len());
}

#[test]
fn the_case_of_letters_changes_outside_of_texts_only() {
    let said = EVERYTHING.replace(
        "    bits : BYTE;\n",
        "    bits : BYTE;\n    said : STRING := 'a$'b$$';\n",
    );
    let original = read(&said, DialectName::IRONPLC_ED3).unwrap();
    let canonical = write(&original, &Style::default()).text;
    let varied = Variant::Capitals
        .text(&original, &mut Unstructured::new(&bytes(5)))
        .unwrap();
    assert_ne!(varied, canonical);
    assert!(varied.eq_ignore_ascii_case(&canonical));
    assert!(
        canonical.contains("'a$'b$$'") && varied.contains("'a$'b$$'"),
        "{varied}"
    );
}
