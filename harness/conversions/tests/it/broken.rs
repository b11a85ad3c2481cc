//! Tests that a sweep finds conversions with one small error.

use crate::support::{Spoilt, findings, sweep};
use stickler_conversions::sweep::{Difference, SweepFindings};
use stickler_types::DialectName;

/// Returns the findings of a sweep over the reference's conversion, whose results `spoil` changes.
fn spoilt(function: &str, spoil: impl Fn(u64, u64) -> u64 + Sync) -> SweepFindings {
    let sweep = sweep(function, DialectName::MATIEC);
    assert_eq!(findings(&sweep, &sweep.reference).mismatches, 0, "{function}");
    let converter = Spoilt { sweep: &sweep, spoil };
    findings(&sweep, &converter)
}

fn first(found: &SweepFindings) -> [String; 3] {
    let first: &Difference = &found.first[0];
    [&first.operands[0], &first.expected, &first.got].map(ToString::to_string)
}

/// An error in a conversion: its name, the function, what becomes of an operand and its right result, the number of wrong results, and the
/// first operand with the right and the wrong result.
type Error = (
    &'static str,
    &'static str,
    fn(u64, u64) -> u64,
    u64,
    [&'static str; 3],
);

const ERRORS: [Error; 8] = [
    (
        "a sign that is not extended",
        "SINT_TO_WORD",
        |operand, _| operand & 0xFF,
        128,
        ["SINT#-128", "WORD#16#FF80", "WORD#16#0080"],
    ),
    (
        "a sign that is extended where there is none",
        "BYTE_TO_INT",
        |operand, _| i64::from(operand as i8).cast_unsigned(),
        128,
        ["BYTE#16#80", "INT#128", "INT#-128"],
    ),
    // Of the 65 280 numbers outside, one in 256 wraps to the limit that it is nearest to: -129 … give 127, 127+256 …
    (
        "saturation where a number wraps",
        "INT_TO_SINT",
        |operand, _| operand.cast_signed().clamp(-128, 127).cast_unsigned(),
        65_280 - 254,
        ["INT#128", "SINT#-128", "SINT#127"],
    ),
    (
        "one wrong input among all",
        "UINT_TO_INT",
        |operand, right| right ^ u64::from(operand == 54_321),
        1,
        ["UINT#54321", "INT#-11215", "INT#-11216"],
    ),
    (
        "a digit above nine",
        "BYTE_BCD_TO_USINT",
        |operand, right| if operand & 0xF > 9 { 0 } else { right },
        6 * 16,
        ["BYTE#16#0A", "USINT#10", "USINT#0"],
    ),
    (
        "a lost digit",
        "USINT_TO_BCD_BYTE",
        |_, right| right & 0x7F,
        40,
        ["USINT#80", "BYTE#16#80", "BYTE#16#00"],
    ),
    (
        "a boolean that looks at one bit only",
        "INT_TO_BOOL",
        |operand, _| operand & 1,
        32_767,
        ["INT#2", "BOOL#TRUE", "BOOL#FALSE"],
    ),
    (
        "a text with other characters",
        "SINT_TO_STRING",
        |_, right| right + 1,
        256,
        ["SINT#0", "STRING#'0'", "STRING#'1'"],
    ),
];

#[test]
fn each_error_is_found_with_all_its_inputs() {
    for (error, function, spoil, mismatches, difference) in ERRORS {
        let found = spoilt(function, spoil);
        assert_eq!(
            (found.mismatches, first(&found)),
            (mismatches, difference.map(str::to_owned)),
            "{error}"
        );
        // No document speaks of these functions.
        let is_open = function.contains("BCD");
        assert_eq!(found.first[0].basis.is_none(), is_open, "{error}");
    }
}

#[test]
fn the_first_differences_come_in_order_and_all_are_counted() {
    let found = spoilt("UINT_TO_WORD", |_, right| right ^ 1);
    let places: Vec<u64> = found.first.iter().map(|difference| difference.place).collect();
    assert_eq!(places, (0..10).collect::<Vec<u64>>());
    assert_eq!(found.mismatches, 65_536);
}
