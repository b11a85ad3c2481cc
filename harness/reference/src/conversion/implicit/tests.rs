//! Tests of `implicit.rs`.

use super::*;
use ElementaryType::{Byte, Dint, Dt, Dword, Int, Ldt, Lint, Lreal, Ltime, Real, Time, Udint, Uint};
use stickler_types::DialectName;

fn widens(from: ElementaryType, to: ElementaryType, dialect: DialectName) -> bool {
    implicit(from, to, Dialect::of(dialect)).is_some()
}

/// Counts the pairs of different types that convert.
fn pairs(dialect: DialectName) -> usize {
    let all = ElementaryType::ALL;
    let convert = |from| {
        all.into_iter()
            .filter(move |&to| from != to && widens(from, to, dialect))
            .count()
    };
    all.into_iter().map(convert).sum()
}

#[test]
fn each_dialect_has_as_many_pairs_as_its_tables() {
    // Integers 18, integers to reals 12, bit strings 6, REAL to LREAL, short and long forms 8.
    assert_eq!(pairs(DialectName::IRONPLC_ED2), 45);
    assert_eq!(pairs(DialectName::IRONPLC_ED3), 45);
    for dialect in [DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3] {
        assert!(widens(Time, Ltime, dialect) && widens(Ldt, Dt, dialect));
    }
    // And 12 of the cross-family table.
    assert_eq!(pairs(DialectName::IRONPLC_RUSTY), 57);
    assert_eq!(pairs(DialectName::MATIEC), 0);
    // 41 cells of the coloured table, and TIME to LTIME.
    assert_eq!(pairs(DialectName::PLCNEXT), 42);
    // 14 numbers and bit strings into each other, BOOL into them, bit strings into BOOL, short and long forms.
    assert_eq!(pairs(DialectName::STRUCPP), 14 * 13 + 14 + 4 + 8);
    // And 8 durations, dates and times into each other, but for the long and short forms, and into and from 14 numbers.
    assert_eq!(
        pairs(DialectName::RUSTY),
        pairs(DialectName::STRUCPP) + 8 * 7 - 8 + 2 * 8 * 14
    );
}

#[test]
fn every_type_stands_for_itself() {
    for name in DialectName::ALL {
        for ty in ElementaryType::ALL {
            assert_eq!(
                implicit(ty, ty, Dialect::of(name)),
                Some(Conversion::identity(ty))
            );
        }
    }
}

#[test]
fn operands_of_which_each_stands_for_the_other_take_the_wider_type() {
    for (one, other, common) in [
        (Int, Dint, Dint),
        (Int, Real, Real),
        (Lint, Real, Real),
        (Int, Lreal, Lreal),
        (Byte, Int, Int),
        (Byte, Dword, Dword),
        (Udint, Time, Time),
        (Time, Ltime, Ltime),
    ] {
        let found = [wider_operand(one, other), wider_operand(other, one)];
        assert_eq!(found, [common; 2], "{one} and {other}");
    }
    assert_eq!(wider_operand(Int, Uint), Int);
}
