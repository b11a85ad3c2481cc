//! Tests of `implicit.rs`.

use super::*;
use ElementaryType::{
    Bool, Byte, Char, Date, Dint, Dt, Dword, Int, Ldt, Lint, Lreal, Ltime, Lword, Real, Sint, String, Time,
    Udint, Uint, Ulint, Usint, Word, Wstring,
};
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
fn ironplc_widens_what_its_matrices_say() {
    let dialect = DialectName::IRONPLC_ED2;
    for (from, to) in [
        (Sint, Int),
        (Usint, Int),
        (Udint, Lint),
        (Uint, Real),
        (Lint, Lreal),
        (Ulint, Lreal),
    ] {
        assert!(widens(from, to, dialect), "{} to {}", from.name(), to.name());
    }
    for (from, to) in [
        (Usint, Sint),
        (Uint, Int),
        (Sint, Uint),
        (Dint, Real),
        (Bool, Byte),
        (Lreal, Real),
    ] {
        assert!(!widens(from, to, dialect), "{} to {}", from.name(), to.name());
    }
    for (from, to) in [
        (Real, Lint),
        (Int, Word),
        (String, Wstring),
        (Char, String),
        (Date, Dt),
        (Udint, Time),
    ] {
        assert!(!widens(from, to, dialect), "{} to {}", from.name(), to.name());
    }
    assert!(widens(Time, Ltime, dialect) && widens(Ldt, Dt, dialect));
}

#[test]
fn a_bit_string_becomes_a_wider_integer_only_with_the_flag() {
    assert!(widens(Byte, Int, DialectName::IRONPLC_RUSTY));
    assert!(!widens(Byte, Usint, DialectName::IRONPLC_RUSTY));
    assert!(!widens(Lword, Lint, DialectName::IRONPLC_RUSTY));
    assert!(!widens(Int, Dword, DialectName::IRONPLC_RUSTY));
    assert!(!widens(Byte, Int, DialectName::IRONPLC_ED3));
}

#[test]
fn plcnext_takes_the_rule_literally() {
    let dialect = DialectName::PLCNEXT;
    for (from, to) in [
        (Bool, Lword),
        (Udint, Time),
        (Time, Udint),
        (Time, Ltime),
        (Dint, Lreal),
        (Real, Lreal),
    ] {
        assert!(widens(from, to, dialect), "{} to {}", from.name(), to.name());
    }
    for (from, to) in [
        (Lint, Lreal),
        (Ltime, Time),
        (Udint, Ltime),
        (Byte, Bool),
        (Byte, Int),
        (Dint, Real),
    ] {
        assert!(!widens(from, to, dialect), "{} to {}", from.name(), to.name());
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
        assert_eq!(
            wider_operand(one, other),
            common,
            "{} and {}",
            one.name(),
            other.name()
        );
        assert_eq!(
            wider_operand(other, one),
            common,
            "{} and {}",
            other.name(),
            one.name()
        );
    }
    assert_eq!(wider_operand(Int, Uint), Int);
}

#[test]
fn what_widens_keeps_its_value() {
    let plcnext = Dialect::of(DialectName::PLCNEXT);
    let apply = |from, to, raw| implicit(from, to, plcnext).map(|conversion| conversion.apply(raw));
    assert_eq!(apply(Sint, Lint, (-1_i64).cast_unsigned()), Some(u64::MAX));
    assert_eq!(apply(Udint, Lint, 4_000_000_000), Some(4_000_000_000));
    assert_eq!(apply(Uint, Real, 65_535), Some(65_535.0_f32.to_bits().into()));
    assert_eq!(apply(Udint, Time, 1_500), Some(1_500_000_000));
    assert_eq!(apply(Time, Udint, 1_500_999_999), Some(1_500));
    assert_eq!(apply(Bool, Word, 1), Some(1));
}
