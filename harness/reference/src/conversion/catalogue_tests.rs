//! The catalogue, name by name.

use super::catalogue::*;
use ElementaryType::{
    Byte, Date, Dint, Dt, Dword, Int, Lint, Lreal, Ltime, Real, Sint, Tod, Udint, Uint, Usint, Word,
};
use stickler_types::Dialect;
use stickler_types::ElementaryType;
use stickler_types::dialect::COMMON_CHOICES;
use stickler_types::{
    BitStringText, ConversionChoices, DialectName, OutOfRange, RealText, Rounding, TextReading,
};

fn named(name: &str) -> Option<ConversionFunction> {
    function(name, Dialect::of(DialectName::IRONPLC_ED3))
}

fn exactly(name: &str) -> Option<(ElementaryType, ElementaryType)> {
    match named(name)? {
        ConversionFunction {
            parameter: Parameter::Exactly(from),
            result: ResultType::Exactly(to),
            ..
        } => Some((from, to)),
        _ => None,
    }
}

#[test]
fn a_pair_of_types_names_its_function_in_any_case() {
    assert_eq!(exactly("INT_TO_DINT"), Some((Int, Dint)));
    assert_eq!(exactly("lreal_to_real"), Some((Lreal, Real)));
    assert_eq!(exactly("DATE_AND_TIME_TO_TIME_OF_DAY"), Some((Dt, Tod)));
    assert_eq!(exactly("Date_To_Dt"), Some((Date, Dt)));
}

#[test]
fn what_has_no_meaning_has_no_name() {
    for name in [
        "",
        "_TO_",
        "TO_",
        "INT_TO_INT",
        "INT_TO_",
        "_TO_INT",
        "TIME_TO_DATE",
        "DATE_TO_TOD",
        "CHAR_TO_REAL",
        "FOO_TO_INT",
        "INT_TO_FOO",
        "TRUNC_REAL",
        "TRUNC_WORD",
        "INT_TRUNC_INT",
        "REAL_TRUNC_WORD",
        "BCD_TO_REAL",
        "REAL_TO_BCD",
        "INT_TO_DINT_TO_LINT",
        "WORD_BCD_TO_INT",
        "INT_TO_BCD_WORD",
        "é_TO_INT",
        "ROUNDS",
    ] {
        assert_eq!(named(name), None, "{name}");
    }
    assert_eq!(named(&"X".repeat(100_000)), None);
}

#[test]
fn truncations_take_either_real_and_give_the_integer_they_name() {
    for (name, to) in [
        ("TRUNC", Dint),
        ("TRUNC_INT", Int),
        ("TRUNC_DINT", Dint),
        ("TRUNC_LINT", Lint),
    ] {
        let found = named(name).expect(name);
        assert!(
            found.accepts(Real) && found.accepts(Lreal) && !found.accepts(Int),
            "{name}"
        );
        assert_eq!(found.result_type(Lreal, Some(Sint)), to, "{name}");
    }
    assert_eq!(exactly("LREAL_TRUNC_USINT"), Some((Lreal, Usint)));
    let truncate = named("TRUNC").expect("TRUNC").conversion(Lreal, Dint);
    assert_eq!(truncate.apply((-2.9_f64).to_bits()), (-2_i64).cast_unsigned());
}

#[test]
fn an_overloaded_name_takes_whatever_converts() {
    let to_int = named("TO_INT").expect("TO_INT");
    assert!(to_int.accepts(Int) && to_int.accepts(Lreal) && to_int.accepts(Ltime));
    assert_eq!(to_int.conversion(Dint, Int).apply(70_000), 4_464);
    let to_date = named("TO_DATE").expect("TO_DATE");
    assert!(to_date.accepts(Dt) && !to_date.accepts(Tod));
}

#[test]
fn bcd_functions_take_the_type_of_their_target() {
    let from_bcd = named("BCD_TO_INT").expect("BCD_TO_INT");
    assert!(from_bcd.accepts(Byte) && from_bcd.accepts(Word) && !from_bcd.accepts(Dword));
    assert_eq!(from_bcd.result_type(Byte, Some(Dint)), Dint);
    assert_eq!(from_bcd.result_type(Byte, Some(Lint)), Int);
    assert_eq!(from_bcd.result_type(Byte, None), Int);
    assert_eq!(from_bcd.conversion(Word, Int).apply(0x1234), 1234);
    let to_bcd = named("INT_TO_BCD").expect("INT_TO_BCD");
    assert_eq!(to_bcd.result_type(Int, Some(Byte)), Byte);
    assert_eq!(to_bcd.result_type(Int, Some(Real)), Word);
    assert_eq!(to_bcd.conversion(Int, Byte).apply(1234), 0x34);
    assert_eq!(exactly("DWORD_BCD_TO_UDINT"), Some((Dword, Udint)));
    assert_eq!(exactly("UINT_TO_BCD_WORD"), Some((Uint, Word)));
    assert!(named("TO_BCD_DWORD").is_some_and(|found| found.accepts(Uint)));
}

#[test]
fn rounding_functions_are_unknown_where_only_trunc_is_standard() {
    for name in ["ROUND", "CEIL", "CEILING", "FLOOR"] {
        assert_eq!(function(name, Dialect::of(DialectName::MATIEC)), None, "{name}");
        let found = named(name).expect(name);
        assert_eq!(
            (found.result_type(Real, None), found.result_type(Lreal, Some(Int))),
            (Dint, Lint)
        );
    }
    let apply = |name, value: f64| {
        let found = named(name).expect(name);
        found.conversion(Lreal, Lint).apply(value.to_bits()).cast_signed()
    };
    assert_eq!(
        ["ROUND", "CEIL", "FLOOR"].map(|name| apply(name, -2.5)),
        [-2, -2, -3]
    );
}

#[test]
fn the_third_edition_s_types_bring_their_functions() {
    let ed2 = Dialect::of(DialectName::IRONPLC_ED2);
    assert_eq!(function("LTIME_TO_TIME", ed2), None);
    assert_eq!(conversion_function_name(Ltime, Lint, ed2), None);
    assert!(named("LTIME_TO_TIME").is_some());
}

#[test]
fn a_real_becomes_an_integer_as_the_dialect_has_it() {
    let convert = |dialect| {
        let found = function("REAL_TO_INT", Dialect::of(dialect)).expect("REAL_TO_INT");
        found.conversion(Real, Int).apply(2.7_f32.to_bits().into())
    };
    assert_eq!(
        DialectName::ALL.map(convert),
        [2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3]
    );
}

#[test]
fn a_suggested_name_is_a_function_from_and_to_these_types() {
    for name in DialectName::ALL {
        let dialect = Dialect::of(name);
        for from in ElementaryType::ALL {
            for to in ElementaryType::ALL {
                let Some(suggested) = conversion_function_name(from, to, dialect) else {
                    continue;
                };
                let found = function(&suggested, dialect).expect("a suggestion exists");
                assert_eq!(found.parameter, Parameter::Exactly(from), "{suggested}");
                assert_eq!(found.result_type(from, None), to, "{suggested}");
            }
        }
    }
    let ed2 = Dialect::of(DialectName::IRONPLC_ED2);
    assert_eq!(
        conversion_function_name(Dint, Int, ed2).as_deref(),
        Some("DINT_TO_INT")
    );
    assert_eq!(conversion_function_name(Int, Int, ed2), None);
}

/// matiec with other choices.
fn chosen(conversions: ConversionChoices) -> Dialect {
    Dialect {
        conversions,
        ..Dialect::of(DialectName::MATIEC).clone()
    }
}

fn applied(name: &str, dialect: &Dialect, from: ElementaryType, raw: u64) -> i64 {
    let function = function(name, dialect).expect(name);
    let conversion = function.conversion(from, function.result_type(from, None));
    conversion.apply(raw).cast_signed()
}

#[test]
fn each_choice_of_rounding_reaches_the_functions_that_it_is_for() {
    let convert = |name, rounding, value: f64| {
        let dialect = chosen(COMMON_CHOICES.with_rounding(rounding));
        applied(name, &dialect, Lreal, value.to_bits())
    };
    for (rounding, expected) in [
        (Rounding::Truncate, [1, 2, -2, 0]),
        (Rounding::HalfToEven, [2, 2, -2, 0]),
        (Rounding::HalfAwayFromZero, [2, 3, -3, 0]),
        (Rounding::Up, [2, 3, -2, 1]),
        (Rounding::Down, [1, 2, -3, 0]),
    ] {
        let values = [1.5, 2.5, -2.5, 0.499_999_999_999_999_94];
        assert_eq!(
            values.map(|value| convert("LREAL_TO_DINT", rounding, value)),
            expected
        );
        assert_eq!(
            values.map(|value| convert("TRUNC", rounding, value)),
            [1, 2, -2, 0]
        );
        assert_eq!(
            values.map(|value| convert("TO_WORD", rounding, value)),
            expected.map(|value| value & 0xFFFF)
        );
    }
}

#[test]
fn each_choice_for_what_lies_outside_reaches_the_functions_from_reals() {
    let saturating = chosen(ConversionChoices {
        out_of_range: OutOfRange::Saturate,
        truncation_out_of_range: OutOfRange::Saturate,
        ..COMMON_CHOICES
    });
    for (name, value, wrapped, nearest) in [
        ("LREAL_TO_INT", 40_000.0, -25_536, 32_767),
        ("LREAL_TO_INT", -1e30, 0, -32_768),
        ("LREAL_TO_USINT", -1.0, 255, 0),
        ("LREAL_TO_USINT", -0.9, 0, 0),
        ("LREAL_TO_BYTE", 256.0, 0, 255),
        ("TRUNC_INT", f64::INFINITY, 0, 32_767),
        ("LREAL_TRUNC_LINT", 1e19, -8_446_744_073_709_551_616, i64::MAX),
        ("TO_ULINT", f64::INFINITY, 0, -1),
        ("TRUNC", f64::NAN, 0, 0),
    ] {
        let wrapping = chosen(COMMON_CHOICES);
        let got = [&wrapping, &saturating].map(|dialect| applied(name, dialect, Lreal, value.to_bits()));
        assert_eq!(got, [wrapped, nearest], "{name}({value})");
    }
    let integer = |dialect| applied("DINT_TO_INT", dialect, Dint, 100_000);
    assert_eq!(integer(&saturating), -31_072, "integers wrap all the same");
}

#[test]
fn each_choice_of_texts_reaches_the_functions_from_and_to_texts() {
    let units = |text: &str| text.encode_utf16().collect::<Vec<_>>();
    let read = |name, reading| {
        let dialect = chosen(ConversionChoices {
            text_reading: reading,
            ..COMMON_CHOICES
        });
        let function = function(name, &dialect).expect(name);
        let conversion = function.conversion(
            ElementaryType::String,
            function.result_type(ElementaryType::String, None),
        );
        conversion.apply_from_text(&units("12.5 bar"))
    };
    assert_eq!(read("STRING_TO_INT", TextReading::WholeText), 0);
    assert_eq!(read("STRING_TO_INT", TextReading::LeadingNumber), 12);
    assert_eq!(
        read("STRING_TO_LREAL", TextReading::LeadingNumber),
        12.5_f64.to_bits()
    );
    let written = |name, from, raw, conversions| {
        let function = function(name, &chosen(conversions)).expect(name);
        let conversion = function.conversion(from, ElementaryType::String);
        String::from_utf16_lossy(&conversion.apply_to_text(raw))
    };
    let common = COMMON_CHOICES;
    let three_digits = ConversionChoices {
        real_text: RealText::SignificantDigits(3),
        ..common
    };
    let third = (1.0_f64 / 3.0).to_bits();
    assert_eq!(
        [common, three_digits].map(|choices| written("LREAL_TO_STRING", Lreal, third, choices)),
        ["0.3333333333333333", "0.333"]
    );
    let short = ConversionChoices {
        bit_string_text: BitStringText::Shortest,
        ..common
    };
    assert_eq!(
        [common, short].map(|choices| written("WORD_TO_STRING", Word, 0xAB, choices)),
        ["16#00AB", "16#ab"]
    );
}

#[test]
fn results_are_all_that_a_target_may_ask_for() {
    let results = |name: &str, from| named(name).expect(name).results(from).collect::<Vec<_>>();
    assert_eq!(results("BCD_TO_INT", Byte), [Int, Dint]);
    assert_eq!(results("INT_TO_BCD", Int), [Byte, Word]);
    assert_eq!(results("ROUND", Lreal), [Lint]);
    assert_eq!(results("TO_INT", Dint), [Int]);
}

#[test]
fn durations_and_times_of_day_have_functions_both_ways() {
    for name in [
        "TIME_TO_TOD",
        "TOD_TO_TIME",
        "LTIME_TO_LTOD",
        "LTOD_TO_TIME",
        "TIME_TO_LTOD",
    ] {
        assert!(named(name).is_some(), "{name}");
    }
    assert_eq!(exactly("TIME_OF_DAY_TO_TIME"), Some((Tod, ElementaryType::Time)));
}
