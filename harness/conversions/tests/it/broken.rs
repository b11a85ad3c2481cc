//! Tests that a sweep finds conversions with one small error.

use crate::support::{Spoilt, findings, sweep};
use stickler_conversions::sweep::{Converter, Difference, SweepFindings};
use stickler_types::{DialectName, Value};

/// Returns the findings of a sweep over the reference's conversion, whose results `spoil` changes.
fn spoilt(function: &str, spoil: impl Fn(u64, u64) -> u64 + Sync) -> SweepFindings {
    let sweep = sweep(function, DialectName::MATIEC);
    assert_eq!(findings(&sweep, &sweep.reference).mismatches, 0, "{function}");
    let converter = Spoilt { sweep: &sweep, spoil };
    findings(&sweep, &converter)
}

fn first(found: &SweepFindings) -> [String; 3] {
    let Difference {
        operands,
        expected,
        got,
        ..
    } = &found.first[0];
    [operands[0].to_string(), expected.to_string(), got.to_string()]
}

#[test]
fn a_sign_that_is_not_extended() {
    let found = spoilt("SINT_TO_WORD", |operand, _| operand & 0xFF);
    assert_eq!(found.mismatches, 128);
    assert_eq!(first(&found), ["SINT#-128", "WORD#16#FF80", "WORD#16#0080"]);
    assert_eq!(
        found.first[0].basis,
        Some("forgeiec-conversion-functions: Range and precision")
    );
}

#[test]
fn a_sign_that_is_extended_where_there_is_none() {
    let found = spoilt("BYTE_TO_INT", |operand, _| {
        i64::from(operand as i8).cast_unsigned()
    });
    assert_eq!(found.mismatches, 128);
    assert_eq!(first(&found), ["BYTE#16#80", "INT#128", "INT#-128"]);
}

#[test]
fn saturation_where_a_number_wraps() {
    let found = spoilt("INT_TO_SINT", |operand, _| {
        operand.cast_signed().clamp(-128, 127).cast_unsigned()
    });
    // Of the 65 280 numbers outside, one in 256 wraps to the limit that it is nearest to: -129 … give 127, 127+256 …
    assert_eq!(found.mismatches, 65_280 - 254);
    assert_eq!(first(&found), ["INT#128", "SINT#-128", "SINT#127"]);
}

#[test]
fn one_wrong_input_among_all() {
    let found = spoilt("UINT_TO_INT", |operand, right| {
        right ^ u64::from(operand == 54_321)
    });
    assert_eq!(found.mismatches, 1);
    assert_eq!(first(&found)[0], "UINT#54321");
    assert_eq!(found.first[0].place, 54_321);
}

#[test]
fn a_digit_above_nine_and_a_lost_digit() {
    let found = spoilt(
        "BYTE_BCD_TO_USINT",
        |operand, right| {
            if operand & 0xF > 9 { 0 } else { right }
        },
    );
    assert_eq!(found.mismatches, 6 * 16);
    assert_eq!(first(&found), ["BYTE#16#0A", "USINT#10", "USINT#0"]);
    assert_eq!(found.first[0].basis, None, "no document speaks of such digits");
    let found = spoilt("USINT_TO_BCD_BYTE", |_, right| right & 0x7F);
    assert_eq!(first(&found), ["USINT#80", "BYTE#16#80", "BYTE#16#00"]);
}

#[test]
fn a_boolean_that_looks_at_one_bit_only() {
    let found = spoilt("INT_TO_BOOL", |operand, _| operand & 1);
    assert_eq!(found.mismatches, 32_767);
    assert_eq!(first(&found), ["INT#2", "BOOL#TRUE", "BOOL#FALSE"]);
}

#[test]
fn the_first_differences_come_in_order_and_all_are_counted() {
    let found = spoilt("UINT_TO_WORD", |_, right| right ^ 1);
    let places: Vec<u64> = found.first.iter().map(|difference| difference.place).collect();
    assert_eq!(places, (0..10).collect::<Vec<u64>>());
    assert_eq!(found.mismatches, 65_536);
}

/// A converter whose texts are all wrong in the same way.
struct Shouting<'s>(&'s dyn Converter);

impl Converter for Shouting<'_> {
    fn convert_all(&self, operands: &[u64], results: &mut [u64]) {
        self.0.convert_all(operands, results);
    }

    fn convert(&self, operands: &[Value]) -> Value {
        match self.0.convert(operands) {
            Value::Text { ty, mut units } => {
                units.push(u16::from(b'!'));
                Value::text(ty, units)
            }
            plain => plain,
        }
    }
}

#[test]
fn a_text_with_a_character_too_many() {
    let sweep = sweep("SINT_TO_STRING", DialectName::MATIEC);
    assert_eq!(findings(&sweep, &sweep.reference).mismatches, 0);
    let found = findings(&sweep, &Shouting(&sweep.reference));
    assert_eq!(found.mismatches, 256);
    assert_eq!(first(&found), ["SINT#0", "STRING#'0'", "STRING#'0!'"]);
}
