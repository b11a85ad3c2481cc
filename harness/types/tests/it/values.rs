//! Tests of values as typed literals: parsing, writing and equality.

use stickler_types::{ElementaryType as E, Family, LiteralError, Value};

fn parsed(literal: &str) -> Value {
    Value::parse(literal).unwrap_or_else(|error| panic!("{literal}: {error}"))
}

/// Returns raw forms at and around the limits of a type.
fn boundaries(ty: E) -> Vec<u64> {
    const DAY: i64 = 86_400_000_000_000;
    let signed = |values: &[i64]| values.iter().map(|value| value.cast_unsigned()).collect();
    match ty.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString => {
            let (least, greatest) = ty.integer_range().unwrap();
            let limits = [least, least + 1, greatest - 1, greatest];
            let powers = (0..ty.bits()).flat_map(|bit| [(1 << bit) - 1, 1 << bit, -(1 << bit)]);
            limits
                .into_iter()
                .chain(powers)
                .map(|value| ty.wrap(value))
                .collect()
        }
        Family::Real if ty == E::Real => {
            let values = [
                0.0,
                -0.0,
                0.1,
                1.0,
                16_777_216.0,
                f32::MIN_POSITIVE,
                1e-45,
                f32::MAX,
                f32::MIN,
            ];
            let limits = [
                f32::INFINITY,
                f32::NEG_INFINITY,
                f32::NAN,
                1e16,
                9.999e15,
                1e-4,
                9.999e-5,
            ];
            values
                .into_iter()
                .chain(limits)
                .map(|value| u64::from(value.to_bits()))
                .collect()
        }
        Family::Real => {
            let values = [
                0.0,
                -0.0,
                0.1,
                1.0,
                9_007_199_254_740_992.0,
                f64::MIN_POSITIVE,
                5e-324,
                f64::MAX,
                f64::MIN,
            ];
            let limits = [
                f64::INFINITY,
                f64::NEG_INFINITY,
                f64::NAN,
                1e16,
                9.999e15,
                1e-4,
                9.999e-5,
            ];
            values.into_iter().chain(limits).map(f64::to_bits).collect()
        }
        Family::Duration | Family::DateAndTime => signed(&[
            i64::MIN,
            i64::MIN + 1,
            -1_000_000,
            -1,
            0,
            1,
            999_999,
            1_000_000,
            i64::MAX - 1,
            i64::MAX,
        ]),
        Family::Date => signed(&[-106_751 * DAY, -DAY, 0, DAY, 106_751 * DAY]),
        Family::TimeOfDay => signed(&[0, 1, 500_000_000, DAY / 2, DAY - 1]),
        Family::Text => Vec::new(),
        Family::Character => (0..1 << ty.bits()).collect(),
    }
}

#[test]
fn every_boundary_value_reads_back_from_its_canonical_spelling() {
    for ty in E::ALL {
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
fn canonical_spellings_are_those_of_the_protocol() {
    for literal in [
        "INT#-5",
        "UINT#5",
        "BOOL#TRUE",
        "BOOL#FALSE",
        "BYTE#16#0A",
        "WORD#16#00FF",
        "LWORD#16#FFFFFFFFFFFFFFFF",
        "REAL#0.1",
        "REAL#1.0E16",
        "REAL#NaN",
        "LREAL#-Infinity",
        "REAL#-0.0",
        "TIME#1500ms",
        "TIME#-1.5ms",
        "LTIME#1500000000ns",
        "DATE#2024-02-29",
        "LDATE#1677-09-22",
        "TOD#12:34:56.789",
        "LTOD#00:00:00",
        "DT#2024-02-29-12:34:56",
        "LDT#1677-09-21-00:12:43.145224192",
        "STRING#'it$'s \"it\"'",
        "WSTRING#\"'$\"$20AC\"",
        "CHAR#'a'",
        "WCHAR#\"$D83D\"",
        "COLOR#RED",
    ] {
        assert_eq!(parsed(literal).to_string(), literal);
    }
}

#[test]
fn every_spelling_of_a_value_is_read() {
    for (literal, canonical) in [
        ("int#+5", "INT#5"),
        ("UINT#-0", "UINT#0"),
        ("INT#16#7f_ff", "INT#32767"),
        ("SINT#2#0111_1111", "SINT#127"),
        ("Word#255", "WORD#16#00FF"),
        ("DWORD#8#17", "DWORD#16#0000000F"),
        ("BOOL#1", "BOOL#TRUE"),
        ("BOOL#0", "BOOL#FALSE"),
        ("bool#true", "BOOL#TRUE"),
        ("REAL#+1_0.0e+1", "REAL#100.0"),
        ("LREAL#nan", "LREAL#NaN"),
        ("REAL#infinity", "REAL#Infinity"),
        ("T#1d2h", "TIME#93600000ms"),
        ("LT#1.5us", "LTIME#1500ns"),
        ("D#2024-2-9", "DATE#2024-02-09"),
        ("LD#1970-01-01", "LDATE#1970-01-01"),
        ("TIME_OF_DAY#1:2:3.50", "TOD#01:02:03.5"),
        ("ltime_of_day#00:00:00.0", "LTOD#00:00:00"),
        ("DATE_AND_TIME#2024-02-29-1:2:3", "DT#2024-02-29-01:02:03"),
        ("LDATE_AND_TIME#1970-01-01-00:00:00", "LDT#1970-01-01-00:00:00"),
        ("STRING#'$41$n'", "STRING#'A$0A'"),
        ("WSTRING#\"€\"", "WSTRING#\"$20AC\""),
        ("CHAR#'$''", "CHAR#'$''"),
    ] {
        assert_eq!(parsed(literal).to_string(), canonical, "{literal}");
    }
}

#[test]
fn a_value_outside_the_range_of_its_type_overflows() {
    for literal in [
        "SINT#128",
        "SINT#-129",
        "UINT#-1",
        "INT#16#FFFF",
        "ULINT#18446744073709551616",
        "BYTE#16#100",
        "LWORD#340282366920938463463374607431768211455",
        "BOOL#2",
        "REAL#3.5E38",
        "TIME#300000d",
        "DATE#2023-02-29",
        "TOD#24:00:00",
        "DT#2300-01-01-00:00:00",
    ] {
        let error = Value::parse(literal).unwrap_err();
        assert!(
            matches!(error, LiteralError::Overflow { .. }),
            "{literal}: {error}"
        );
        assert!(error.offset() > literal.find('#').unwrap(), "{literal}: {error}");
    }
    let digits = "9".repeat(1000);
    let error = Value::parse(&format!("INT#{digits}")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the value at byte 4 is outside the range of INT"
    );
}

#[test]
fn what_is_no_typed_literal_is_rejected_where_it_goes_wrong() {
    for (literal, at) in [
        ("", 0),
        ("5", 0),
        ("TRUE", 0),
        ("#5", 0),
        ("16#FF", 0),
        ("INT#", 4),
        ("INT#-16#5", 7),
        ("INT# 5", 4),
        ("INT#5 ", 5),
        ("INT#INT#5", 4),
        ("WORD#-1", 5),
        ("BOOL#yes", 5),
        ("BOOL#2#1x", 5),
        ("REAL#5", 6),
        ("REAL#+NaN", 6),
        ("STRING#\"a\"", 7),
        ("WSTRING#'a'", 8),
        ("STRING#a", 7),
        ("CHAR#''", 6),
        ("CHAR#'ab'", 6),
        ("COLOR#", 6),
        ("COLOR#5", 6),
        ("COLOR#RED GREEN", 6),
        ("FARBE#GRÜN", 6),
        ("5TH#A", 0),
    ] {
        let error = Value::parse(literal).unwrap_err();
        assert!(
            matches!(error, LiteralError::Malformed { .. }),
            "{literal}: {error}"
        );
        assert_eq!(error.offset(), at, "{literal}: {error}");
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
fn dates_and_times_of_day_that_no_literal_stands_for_look_like_no_other_value() {
    const DAY: i64 = 86_400_000_000_000;
    for (ty, nanoseconds, spelled) in [
        (E::Date, DAY, "DATE#1970-01-02"),
        (E::Date, DAY + DAY / 2, "DATE#1970-01-02-12:00:00"),
        (E::Date, -1, "DATE#1969-12-31-23:59:59.999999999"),
        (E::Ldate, 1, "LDATE#1970-01-01-00:00:00.000000001"),
        (E::Tod, DAY - 1, "TOD#23:59:59.999999999"),
        (E::Tod, DAY, "TOD#86400000000000ns"),
        (E::Ltod, -1, "LTOD#-1ns"),
    ] {
        let value = Value::plain(ty, nanoseconds.cast_unsigned());
        assert_eq!(value.to_string(), spelled);
        assert_eq!(parsed(spelled), value);
    }
    for literal in ["DATE#1970-01-02-00:00:00", "TOD#5ns", "TOD#24:00:00"] {
        assert!(Value::parse(literal).is_err(), "{literal}");
    }
}
