//! Tests of values as typed literals: parsing, writing and equality.

use stickler_types::boundaries::{BoundaryDetail, neighbourhoods};
use stickler_types::{ElementaryType as E, Family, Value, literal};

fn parsed(literal: &str) -> Value {
    Value::parse(literal).unwrap_or_else(|error| panic!("{literal}: {error}"))
}

/// Returns the boundaries of a type and their neighbours; of real numbers also those about which the canonical spelling changes, of durations,
/// dates and times also powers of two, and of characters all.
fn boundaries(ty: E) -> Vec<u64> {
    const DAY: i64 = 86_400_000_000_000;
    let powers = (0..64).flat_map(|bit| [-1, 0, 1].map(|by| (1_i64 << bit).wrapping_add(by)));
    let others: Vec<i64> = match ty.family() {
        Family::Character => (0..1 << ty.bits()).collect(),
        Family::Real => [0.1, 1e16, 9.999e15, 1e-4, 9.999e-5]
            .into_iter()
            .flat_map(|number| [number, -number])
            .map(|number| ty.real_bits(number).cast_signed())
            .collect(),
        _ => powers.flat_map(|bits| [bits, bits.wrapping_neg()]).collect(),
    };
    let fitting = |bits: i64| match ty.family() {
        Family::Date => (bits / DAY * DAY).cast_unsigned(),
        Family::TimeOfDay => bits.rem_euclid(DAY).cast_unsigned(),
        _ => ty.wrap(bits.into()),
    };
    let near = neighbourhoods(ty, BoundaryDetail::Fine);
    near.into_iter().chain(others.into_iter().map(fitting)).collect()
}

#[test]
fn every_boundary_value_reads_back_from_its_canonical_spelling() {
    for ty in E::ALL.into_iter().filter(|ty| !ty.is_text()) {
        for raw in boundaries(ty) {
            let value = Value::plain(ty, raw);
            let literal = value.to_string();
            assert_eq!(parsed(&literal), value, "{literal}");
            assert_eq!(parsed(&literal).to_string(), literal);
            assert!(literal.is_ascii(), "{literal}");
        }
    }
    for (ty, units) in [
        (E::String, vec![0, 0x24, 0x27, 0x22, 0xFF]),
        (E::Wstring, vec![0, 0x24, 0x27, 0x22, 0xFFFF]),
    ] {
        let value = Value::text(ty, units);
        assert_eq!(parsed(&value.to_string()), value);
    }
}

#[test]
fn an_overflow_names_what_does_not_hold_the_value() {
    let nines = "9".repeat(1000);
    for (error, at, range) in [
        (Value::parse(&format!("INT#{nines}")).err(), 4, "INT"),
        (literal::real("1.0E39", E::Real).err(), 0, "REAL"),
        (literal::real("-1.8E308", E::Lreal).err(), 0, "LREAL"),
        (literal::duration("106752d").err(), 0, "a duration"),
        (literal::unsigned_integer(&nines).err(), 0, "128 bits"),
        (literal::integer(&nines).err(), 0, "128 bits"),
    ] {
        let message = format!("the value at byte {at} is outside the range of {range}");
        assert_eq!(error.expect("an overflow").to_string(), message);
    }
}

#[test]
fn values_are_equal_only_with_the_same_type_and_bits() {
    assert_ne!(parsed("INT#5"), parsed("DINT#5"));
    assert_ne!(parsed("REAL#0.0"), parsed("REAL#-0.0"));
    assert_ne!(parsed("STRING#'a'"), parsed("WSTRING#\"a\""));
    assert_ne!(parsed("COLOR#RED"), parsed("COLOR#GREEN"));
    assert_ne!(parsed("COLOR#RED"), parsed("PAINT#RED"));
    assert_eq!(parsed("COLOR#RED"), parsed("Color#Red"));
}

#[test]
fn a_nan_equals_every_nan_of_its_type_and_nothing_else() {
    let quiet = Value::plain(E::Lreal, f64::NAN.to_bits());
    let other = Value::plain(E::Lreal, f64::NAN.to_bits() ^ 0x8000_0000_0000_0001);
    assert_eq!(quiet, other);
    assert_ne!(quiet, Value::plain(E::Real, f32::NAN.to_bits().into()));
    assert_ne!(quiet, parsed("LREAL#Infinity"));
    assert_ne!(
        Value::plain(E::Ulint, f64::NAN.to_bits()),
        Value::plain(E::Ulint, f64::NAN.to_bits() ^ 1)
    );
}

#[test]
fn a_value_names_its_type() {
    assert_eq!(parsed("time_of_day#00:00:00").type_name(), "TOD");
    assert_eq!(parsed("Color#Red").type_name(), "Color");
    assert_eq!(parsed("STRING#''").type_name(), "STRING");
}

#[test]
fn dates_and_times_of_day_that_no_literal_stands_for_keep_their_nanoseconds() {
    const DAY: i64 = 86_400_000_000_000;
    for (ty, nanoseconds, spelled) in [
        (E::Date, DAY + DAY / 2, "DATE#1970-01-02-12:00:00"),
        (E::Date, -1, "DATE#1969-12-31-23:59:59.999999999"),
        (E::Tod, DAY, "TOD#86400000000000ns"),
        (E::Ltod, -1, "LTOD#-1ns"),
    ] {
        assert_eq!(parsed(spelled), Value::plain(ty, nanoseconds.cast_unsigned()));
    }
}
