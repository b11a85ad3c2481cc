//! Compares the fast form with the exact one: at the boundaries of every source, and on scattered operands.

use super::Bulk;
use crate::{Operation, Signature, functions, signatures, value};
use std::collections::HashSet;
use stickler_types::{
    BitsAsInteger, ConversionChoices, DialectName, ElementaryType, Family, MomentUnits, OutOfRange, Rounding,
    Value,
};

/// Returns the signatures of all functions of a dialect.
fn all_signatures(dialect: DialectName) -> impl Iterator<Item = Signature> {
    let names = functions(dialect).into_iter();
    names.flat_map(move |name| signatures(&name, dialect))
}

/// Returns every signature that has a fast form, each once whatever its name.
fn quick_signatures() -> Vec<Signature> {
    let mut seen = HashSet::new();
    let dialect = DialectName::IRONPLC_ED3;
    all_signatures(dialect)
        .filter(|signature| Bulk::new(signature, &dialect.rules().conversions).is_some())
        .filter(|signature| seen.insert((signature.operation, signature.operands.clone(), signature.result)))
        .collect()
}

/// Returns the choices that affect the conversion of numbers: every combination of those of reals, and each other choice once.
fn all_choices() -> impl Iterator<Item = ConversionChoices> {
    use Rounding::{HalfAwayFromZero, HalfToEven, Truncate};
    [Truncate, HalfToEven, HalfAwayFromZero]
        .into_iter()
        .flat_map(|rounding| {
            OutOfRange::ALL
                .iter()
                .map(move |out_of_range| (rounding, *out_of_range))
        })
        .map(|(rounding, out_of_range)| ConversionChoices {
            rounding,
            out_of_range,
            truncation_out_of_range: out_of_range,
            ..DialectName::MATIEC.rules().conversions
        })
        .chain(
            [DialectName::RUSTY, DialectName::STRUCPP, DialectName::CODESYS]
                .map(|dialect| dialect.rules().conversions),
        )
}

/// Returns whether the operand is a REAL number of days or of counts, the result a TIME of 32 bits, or the bits of the operand are copied.
fn is_slow(signature: &Signature, choices: &ConversionChoices) -> bool {
    let (from, to) = (signature.operands[0], signature.result);
    let is_real = from == ElementaryType::Real;
    let copies = from.is_signed() && to.is_bit_string() || from.is_bit_string() && to.is_signed();
    copies && choices.bits_as_integer == BitsAsInteger::Copy
        || match choices.moment_units {
            MomentUnits::Seconds | MomentUnits::DaysSince1990 => false,
            MomentUnits::DaysAndMilliseconds => is_real && to.family() == Family::Date,
            MomentUnits::Counts => is_real && to.is_moment(),
            MomentUnits::ShortTime => to == ElementaryType::Time,
        }
}

/// Returns bit patterns around each power of two and of ten, around each exponent of REAL, and scattered ones.
fn operands(ty: ElementaryType) -> Vec<u64> {
    let mut bits: Vec<i64> = (0..=32)
        .map(|n| 1 << n)
        .chain((0..10).map(|n| 10_i64.pow(n)))
        .collect();
    if ty.is_real() {
        bits.extend((0..512).map(|exponent| exponent << 23));
        // Halves, and what lies beside them.
        bits.extend((0..16).map(|n| i64::from((n as f32 / 2.0).to_bits())));
        bits.extend((0..64).map(|n| i64::from(((1_u64 << n) as f32 + 0.5).to_bits())));
    }
    let near = bits.iter().flat_map(|bits| (-3..=3).map(move |by| bits + by));
    let scattered = (0..1500_i64).map(|n| n.wrapping_mul(0x5851_F42D_4C95_7F2D) >> 7);
    let both = near.chain(scattered).flat_map(|bits| [bits, -bits]);
    both.map(|bits| ty.wrap(bits.into())).collect()
}

#[test]
fn the_quick_form_agrees_with_the_exact_one() {
    let found = quick_signatures();
    assert!(found.len() > 150, "only {}", found.len());
    for signature in &found {
        let from = signature.operands[0];
        let operands = operands(from);
        // How numbers are rounded matters to reals only.
        let choices = all_choices().skip(if from.is_real() { 0 } else { 5 });
        for choices in choices {
            let Some(bulk) = Bulk::new(signature, &choices) else {
                assert!(is_slow(signature, &choices), "{signature:?}");
                continue;
            };
            let mut results = vec![0; operands.len()];
            bulk.fill(&operands, &mut results);
            for (operand, result) in operands.iter().zip(results) {
                let operand = Value::plain(from, *operand);
                let exact = value(signature, std::slice::from_ref(&operand), &choices);
                let quick = Value::plain(signature.result, result);
                assert_eq!(
                    quick, exact,
                    "{} of {operand} with {choices:?}",
                    signature.function
                );
            }
        }
    }
}

#[test]
fn every_signature_of_at_most_32_bits_without_texts_has_a_quick_form() {
    for dialect in DialectName::ALL {
        for signature in all_signatures(dialect) {
            let plain = |ty: &ElementaryType| !ty.is_text() && ty.bits() <= 32;
            let choices = dialect.rules().conversions;
            let has_none = match signature.result.family() {
                Family::Date => choices.moment_units == MomentUnits::DaysSince1990,
                Family::Real => signature.operation != Operation::Convert,
                _ => false,
            };
            let quick = signature.operands.len() == 1
                && !has_none
                && signature.operands.iter().all(plain)
                && !signature.result.is_text();
            let bulk = Bulk::new(&signature, &choices);
            assert_eq!(
                bulk.is_some(),
                quick && !is_slow(&signature, &choices),
                "{signature:?}"
            );
        }
    }
}

#[test]
fn what_is_held_together_can_fall_apart() {
    // The same comparison with another rule finds the difference.
    let signature = &signatures("REAL_TO_INT", DialectName::MATIEC)[0];
    let operand = 2.5_f32.to_bits().into();
    let with = |rounding| {
        let choices = ConversionChoices {
            rounding,
            ..DialectName::MATIEC.rules().conversions
        };
        let mut result = [0];
        let bulk = Bulk::new(signature, &choices).expect("it has a quick form");
        bulk.fill(&[operand], &mut result);
        result[0]
    };
    assert_eq!(signature.operation, Operation::Convert);
    assert_eq!(
        [
            Rounding::Truncate,
            Rounding::HalfToEven,
            Rounding::HalfAwayFromZero
        ]
        .map(with),
        [2, 2, 3]
    );
}
