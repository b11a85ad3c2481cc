//! Tests that a sweep finds conversions with one small error.

use crate::support::{Spoilt, findings, sweep};
use stickler_conversions::sweep::SweepFindings;
use stickler_mdtest::check_examples;
use stickler_types::DialectName;

/// Returns the findings of a sweep over the reference's conversion, whose results `spoil` changes.
fn spoilt(function: &str, spoil: impl Fn(u64, u64) -> u64 + Sync) -> SweepFindings {
    let sweep = sweep(function, DialectName::MATIEC);
    assert_eq!(findings(&sweep, &sweep.reference).mismatches, 0, "{function}");
    let converter = Spoilt { sweep: &sweep, spoil };
    findings(&sweep, &converter)
}

/// Returns what an error in a conversion makes of an operand and its right result.
fn spoiled(error: &str, operand: u64, right: u64) -> u64 {
    match error {
        "a sign that is not extended" => operand & 0xFF,
        "a sign that is extended where there is none" => i64::from(operand as i8).cast_unsigned(),
        "saturation where a number wraps" => operand.cast_signed().clamp(-128, 127).cast_unsigned(),
        "one wrong input among all" => right ^ u64::from(operand == 54_321),
        "a digit above nine" if operand & 0xF > 9 => 0,
        "a digit above nine" => right,
        "a lost digit" => right & 0x7F,
        "a text of which only the beginning counts" => right.min(80),
        "a boolean that looks at one bit only" => operand & 1,
        _ => right + 1,
    }
}

/// Shows the number of wrong results, and the first operand with the right and the wrong result.
#[test]
fn golden_errors() {
    check_examples("tests/examples/errors.md", |example| {
        let (error, function) = (example.text("error"), example.text("function"));
        let found = spoilt(function, |operand, right| spoiled(error, operand, right));
        let first = &found.first[0];
        // No document speaks of these functions.
        assert_eq!(first.basis.is_none(), function.contains("BCD"), "{error}");
        let [operand, expected, got] = [&first.operands[0], &first.expected, &first.got];
        format!("{} from {operand}: {expected} became {got}", found.mismatches)
    });
}

#[test]
fn the_first_differences_come_in_order_and_all_are_counted() {
    let found = spoilt("UINT_TO_WORD", |_, right| right ^ 1);
    let places: Vec<u64> = found.first.iter().map(|difference| difference.place).collect();
    assert_eq!(places, (0..10).collect::<Vec<u64>>());
    assert_eq!(found.mismatches, 65_536);
}
