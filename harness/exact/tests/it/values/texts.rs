//! Conversions of values to texts and of texts to values, computed by hand.

use super::common::{check, check_by};
use stickler_exact::choices_of;
use stickler_types::{BitStringText, ConversionChoices, DialectName, RealText, TextReading};

const ED3: DialectName = DialectName::IRONPLC_ED3;

#[test]
fn values_are_written_as_their_literals() {
    check(
        ED3,
        &[
            ("INT_TO_STRING", "INT#-5", "STRING#'-5'"),
            (
                "ULINT_TO_WSTRING",
                "ULINT#18446744073709551615",
                "WSTRING#\"18446744073709551615\"",
            ),
            ("WORD_TO_STRING", "WORD#16#00FF", "STRING#'16#00FF'"),
            ("BOOL_TO_STRING", "BOOL#TRUE", "STRING#'TRUE'"),
            ("TIME_TO_STRING", "TIME#-1.5ms", "STRING#'T#-1.5ms'"),
            ("TIME_TO_STRING", "TIME#1ns", "STRING#'T#0.000001ms'"),
            ("LTIME_TO_STRING", "LTIME#1.5s", "STRING#'LTIME#1500000000ns'"),
            ("DATE_TO_STRING", "DATE#2024-02-29", "STRING#'D#2024-02-29'"),
            ("LDATE_TO_STRING", "LDATE#1969-12-31", "STRING#'LDATE#1969-12-31'"),
            ("TOD_TO_STRING", "TOD#12:34:56.780", "STRING#'TOD#12:34:56.78'"),
            (
                "LTOD_TO_STRING",
                "LTOD#0:0:0.000000001",
                "STRING#'LTOD#00:00:00.000000001'",
            ),
            (
                "DT_TO_STRING",
                "DT#1969-12-31-23:59:59.5",
                "STRING#'DT#1969-12-31-23:59:59.5'",
            ),
            (
                "LDT_TO_STRING",
                "LDT#2000-03-01-00:00:00",
                "STRING#'LDT#2000-03-01-00:00:00'",
            ),
            ("REAL_TO_STRING", "REAL#0.1", "STRING#'0.1'"),
            ("REAL_TO_STRING", "REAL#-0.0", "STRING#'-0.0'"),
            ("REAL_TO_STRING", "REAL#16777216.0", "STRING#'16777216.0'"),
            ("REAL_TO_STRING", "REAL#1.0E-45", "STRING#'1.0E-45'"),
            ("LREAL_TO_STRING", "LREAL#5.0E-324", "STRING#'5.0E-324'"),
            (
                "LREAL_TO_STRING",
                "LREAL#1.7976931348623157E308",
                "STRING#'1.7976931348623157E308'",
            ),
            ("LREAL_TO_STRING", "LREAL#0.0001", "STRING#'0.0001'"),
            ("LREAL_TO_STRING", "LREAL#0.00001", "STRING#'1.0E-5'"),
            (
                "LREAL_TO_STRING",
                "LREAL#9999999999999998.0",
                "STRING#'9999999999999998.0'",
            ),
            ("LREAL_TO_STRING", "LREAL#1.0E16", "STRING#'1.0E16'"),
            ("LREAL_TO_STRING", "LREAL#NaN", "STRING#'NaN'"),
            ("LREAL_TO_STRING", "LREAL#-Infinity", "STRING#'-Infinity'"),
        ],
    );
}

#[test]
fn matiec_writes_ten_digits_and_short_bit_strings() {
    check(
        DialectName::MATIEC,
        &[
            ("REAL_TO_STRING", "REAL#0.1", "STRING#'0.1000000015'"),
            ("LREAL_TO_STRING", "LREAL#0.1", "STRING#'0.1'"),
            ("LREAL_TO_STRING", "LREAL#1.0E20", "STRING#'1e+20'"),
            ("LREAL_TO_STRING", "LREAL#1.0E10", "STRING#'1e+10'"),
            ("LREAL_TO_STRING", "LREAL#9999999999.0", "STRING#'9999999999'"),
            ("LREAL_TO_STRING", "LREAL#9999999999.6", "STRING#'1e+10'"),
            ("LREAL_TO_STRING", "LREAL#-1.5E-300", "STRING#'-1.5e-300'"),
            ("LREAL_TO_STRING", "LREAL#0.0001", "STRING#'0.0001'"),
            ("LREAL_TO_STRING", "LREAL#0.00001", "STRING#'1e-05'"),
            ("LREAL_TO_STRING", "LREAL#0.0", "STRING#'0'"),
            ("LREAL_TO_STRING", "LREAL#-0.0", "STRING#'-0'"),
            ("LREAL_TO_STRING", "LREAL#100.0", "STRING#'100'"),
            ("LREAL_TO_STRING", "LREAL#NaN", "STRING#'NaN'"),
            ("WORD_TO_STRING", "WORD#16#00FF", "STRING#'16#ff'"),
            ("LWORD_TO_STRING", "LWORD#16#0", "STRING#'16#0'"),
        ],
    );
}

#[test]
fn a_given_number_of_digits_is_rounded_half_to_even() {
    let digits = |count| ConversionChoices {
        real_text: RealText::SignificantDigits(count),
        bit_string_text: BitStringText::Shortest,
        ..choices_of(ED3)
    };
    let one = [
        ("LREAL_TO_STRING", "LREAL#2.5", "STRING#'2'"),
        ("LREAL_TO_STRING", "LREAL#3.5", "STRING#'4'"),
        ("LREAL_TO_STRING", "LREAL#9.5", "STRING#'1e+01'"),
        ("LREAL_TO_STRING", "LREAL#0.25", "STRING#'0.2'"),
    ];
    check_by(digits(1), &one);
    check_by(digits(0), &one);
    // 2^-1074, exactly, as far as its digits go.
    check_by(
        digits(30),
        &[(
            "LREAL_TO_STRING",
            "LREAL#5.0E-324",
            "STRING#'4.94065645841246544176568792868e-324'",
        )],
    );
    check_by(
        digits(255),
        &[(
            "LREAL_TO_STRING",
            "LREAL#1.0E22",
            "STRING#'10000000000000000000000'",
        )],
    );
}

#[test]
fn whole_texts_are_read_as_numbers() {
    check(
        ED3,
        &[
            ("STRING_TO_INT", "STRING#'  -1_000 '", "INT#-1000"),
            ("STRING_TO_INT", "STRING#'+5'", "INT#5"),
            ("STRING_TO_INT", "STRING#'007'", "INT#7"),
            ("STRING_TO_INT", "STRING#'40000'", "INT#-25536"),
            ("STRING_TO_INT", "STRING#'16#fF'", "INT#255"),
            ("STRING_TO_INT", "STRING#'-16#5'", "INT#0"),
            ("STRING_TO_INT", "STRING#'INT#5'", "INT#0"),
            ("STRING_TO_INT", "STRING#'1.5'", "INT#0"),
            ("STRING_TO_INT", "STRING#'12abc'", "INT#0"),
            ("STRING_TO_INT", "STRING#'1__0'", "INT#0"),
            ("STRING_TO_INT", "STRING#'_1'", "INT#0"),
            ("STRING_TO_INT", "STRING#'$T1'", "INT#0"),
            ("STRING_TO_INT", "STRING#'1$00'", "INT#0"),
            ("STRING_TO_INT", "STRING#''", "INT#0"),
            ("WSTRING_TO_INT", "WSTRING#\"42\"", "INT#42"),
            ("WSTRING_TO_INT", "WSTRING#\"４２\"", "INT#0"),
            ("STRING_TO_BYTE", "STRING#'2#1_0000_0001'", "BYTE#16#01"),
            ("STRING_TO_UDINT", "STRING#'-1'", "UDINT#4294967295"),
            // However long it is, it wraps.
            (
                "STRING_TO_ULINT",
                "STRING#'340282366920938463463374607431768211457'",
                "ULINT#1",
            ),
            ("STRING_TO_BOOL", "STRING#' true '", "BOOL#TRUE"),
            ("STRING_TO_BOOL", "STRING#'FALSE'", "BOOL#FALSE"),
            ("STRING_TO_BOOL", "STRING#'0'", "BOOL#FALSE"),
            ("STRING_TO_BOOL", "STRING#'-2'", "BOOL#TRUE"),
            ("STRING_TO_BOOL", "STRING#'TRUEs'", "BOOL#FALSE"),
        ],
    );
}

#[test]
fn whole_texts_are_read_as_reals_rounded_once() {
    check(
        ED3,
        &[
            ("STRING_TO_REAL", "STRING#'0.1'", "REAL#0.1"),
            ("STRING_TO_REAL", "STRING#'5'", "REAL#5.0"),
            ("STRING_TO_REAL", "STRING#'-5e3'", "REAL#-5000.0"),
            ("STRING_TO_REAL", "STRING#'1_0.2_5E+0_1'", "REAL#102.5"),
            ("STRING_TO_REAL", "STRING#'-0.0'", "REAL#-0.0"),
            ("STRING_TO_REAL", "STRING#'1.'", "REAL#0.0"),
            ("STRING_TO_REAL", "STRING#'.5'", "REAL#0.0"),
            ("STRING_TO_REAL", "STRING#'1.5e'", "REAL#0.0"),
            ("STRING_TO_REAL", "STRING#'abc'", "REAL#0.0"),
            ("STRING_TO_REAL", "STRING#'nan'", "REAL#NaN"),
            ("STRING_TO_REAL", "STRING#'-INFINITY'", "REAL#-Infinity"),
            ("STRING_TO_REAL", "STRING#'1e39'", "REAL#Infinity"),
            (
                "STRING_TO_REAL",
                "STRING#'-1e999999999999999999999'",
                "REAL#-Infinity",
            ),
            ("STRING_TO_REAL", "STRING#'1e-999999999999999999999'", "REAL#0.0"),
            ("STRING_TO_REAL", "STRING#'0e999999999999999999999'", "REAL#0.0"),
            // The middle between 1 and its successor, and a little more: by way of LREAL it would become 1.
            (
                "STRING_TO_REAL",
                "STRING#'1.000000059604644775390625'",
                "REAL#1.0",
            ),
            (
                "STRING_TO_REAL",
                "STRING#'1.0000000596046447753906250000001'",
                "REAL#1.0000001",
            ),
            (
                "STRING_TO_LREAL",
                "STRING#'9007199254740993'",
                "LREAL#9007199254740992.0",
            ),
            (
                "STRING_TO_LREAL",
                "STRING#'9007199254740993.00000000000000000001'",
                "LREAL#9007199254740994.0",
            ),
            (
                "STRING_TO_LREAL",
                "STRING#'2.4703282292062328e-324'",
                "LREAL#5.0E-324",
            ),
            ("STRING_TO_LREAL", "STRING#'2.4703282292062327e-324'", "LREAL#0.0"),
        ],
    );
}

#[test]
fn whole_texts_are_read_as_durations_and_dates() {
    check(
        ED3,
        &[
            (
                "STRING_TO_TIME",
                "STRING#'T#1d2h3m4s5ms6us7ns'",
                "TIME#93784005.006007ms",
            ),
            ("STRING_TO_TIME", "STRING#' time#-25h_15m '", "TIME#-90900000ms"),
            ("STRING_TO_TIME", "STRING#'1.5s'", "TIME#1500ms"),
            ("STRING_TO_TIME", "STRING#'0.0000019ms'", "TIME#0.000001ms"),
            ("STRING_TO_TIME", "STRING#'1s2m'", "TIME#0ms"),
            ("STRING_TO_TIME", "STRING#'1.5h30m'", "TIME#0ms"),
            ("STRING_TO_TIME", "STRING#'1s_'", "TIME#0ms"),
            ("STRING_TO_TIME", "STRING#'5'", "TIME#0ms"),
            ("STRING_TO_TIME", "STRING#'LTIME#5ms'", "TIME#0ms"),
            ("STRING_TO_TIME", "STRING#'T#T#5ms'", "TIME#0ms"),
            (
                "STRING_TO_TIME",
                "STRING#'9223372036854775807ns'",
                "TIME#9223372036854.775807ms",
            ),
            ("STRING_TO_TIME", "STRING#'9223372036854775808ns'", "TIME#0ms"),
            (
                "STRING_TO_LTIME",
                "STRING#'LT#-9223372036854775808ns'",
                "LTIME#-9223372036854775808ns",
            ),
            ("STRING_TO_DATE", "STRING#'D#2024-02-29'", "DATE#2024-02-29"),
            ("STRING_TO_DATE", "STRING#'2023-02-29'", "DATE#1970-01-01"),
            ("STRING_TO_DATE", "STRING#'2000-2-29'", "DATE#2000-02-29"),
            ("STRING_TO_DATE", "STRING#'2024-13-01'", "DATE#1970-01-01"),
            ("STRING_TO_DATE", "STRING#'1600-01-01'", "DATE#1970-01-01"),
            (
                "STRING_TO_TOD",
                "STRING#'TIME_OF_DAY#23:59:59.9999999999'",
                "TOD#23:59:59.999999999",
            ),
            ("STRING_TO_TOD", "STRING#'24:00:00'", "TOD#00:00:00"),
            (
                "STRING_TO_DT",
                "STRING#'DT#1969-12-31-23:59:59.5'",
                "DT#1969-12-31-23:59:59.5",
            ),
            (
                "STRING_TO_LDT",
                "STRING#'2262-04-11-23:47:16.854775807'",
                "LDT#2262-04-11-23:47:16.854775807",
            ),
            (
                "STRING_TO_LDT",
                "STRING#'2262-04-11-23:47:16.854775808'",
                "LDT#1970-01-01-00:00:00",
            ),
        ],
    );
}

#[test]
fn the_beginning_of_a_text_is_read_where_that_is_chosen() {
    let choices = ConversionChoices {
        text_reading: TextReading::LeadingNumber,
        ..choices_of(ED3)
    };
    check_by(
        choices,
        &[
            ("STRING_TO_INT", "STRING#'12abc'", "INT#12"),
            ("STRING_TO_INT", "STRING#' -12.9'", "INT#-12"),
            ("STRING_TO_INT", "STRING#'16#FG'", "INT#15"),
            ("STRING_TO_INT", "STRING#'16#G'", "INT#16"),
            ("STRING_TO_INT", "STRING#'1__0'", "INT#1"),
            ("STRING_TO_INT", "STRING#'é5'", "INT#0"),
            ("STRING_TO_INT", "STRING#'5é'", "INT#5"),
            ("STRING_TO_INT", "STRING#'x1'", "INT#0"),
            ("STRING_TO_REAL", "STRING#'1.5e+x'", "REAL#1.5"),
            ("STRING_TO_REAL", "STRING#'1.e5'", "REAL#1.0"),
            ("STRING_TO_REAL", "STRING#'2e1 m'", "REAL#20.0"),
            ("STRING_TO_REAL", "STRING#'Infinity and beyond'", "REAL#Infinity"),
            ("STRING_TO_BOOL", "STRING#'1abc'", "BOOL#FALSE"),
            ("STRING_TO_TIME", "STRING#'5ms later'", "TIME#0ms"),
        ],
    );
}

#[test]
fn characters_and_texts_of_either_width() {
    check(
        ED3,
        &[
            ("CHAR_TO_WCHAR", "CHAR#'$E9'", "WCHAR#\"$00E9\""),
            ("WCHAR_TO_CHAR", "WCHAR#\"$20AC\"", "CHAR#'?'"),
            ("WCHAR_TO_CHAR", "WCHAR#\"$00FF\"", "CHAR#'$FF'"),
            ("CHAR_TO_INT", "CHAR#'A'", "INT#65"),
            ("WCHAR_TO_BYTE", "WCHAR#\"$20AC\"", "BYTE#16#AC"),
            ("CHAR_TO_SINT", "CHAR#'$FF'", "SINT#-1"),
            ("INT_TO_CHAR", "INT#321", "CHAR#'A'"),
            ("LINT_TO_WCHAR", "LINT#-1", "WCHAR#\"$FFFF\""),
            ("CHAR_TO_STRING", "CHAR#'$''", "STRING#'$''"),
            ("WCHAR_TO_STRING", "WCHAR#\"$20AC\"", "STRING#'?'"),
            ("WCHAR_TO_WSTRING", "WCHAR#\"$20AC\"", "WSTRING#\"$20AC\""),
            ("STRING_TO_CHAR", "STRING#'abc'", "CHAR#'a'"),
            ("STRING_TO_CHAR", "STRING#''", "CHAR#'$00'"),
            ("WSTRING_TO_CHAR", "WSTRING#\"€\"", "CHAR#'?'"),
            ("WSTRING_TO_STRING", "WSTRING#\"aé€\"", "STRING#'aé?'"),
            ("STRING_TO_WSTRING", "STRING#'aé'", "WSTRING#\"aé\""),
            ("TO_STRING", "STRING#'a'", "STRING#'a'"),
        ],
    );
}

#[test]
fn what_was_recorded_of_texts_in_codesys() {
    check(
        DialectName::CODESYS,
        &[
            ("REAL_TO_STRING", "REAL#123456792.0", "STRING#'1.2345679E08'"),
            ("REAL_TO_STRING", "REAL#0.33333334", "STRING#'0.3333334'"),
            ("REAL_TO_STRING", "REAL#1.0E-5", "STRING#'1E-05'"),
            ("LREAL_TO_STRING", "LREAL#0.1", "STRING#'1.0e-1'"),
            ("LREAL_TO_STRING", "LREAL#1.0E14", "STRING#'1.0e14'"),
            ("TIME_TO_STRING", "TIME#0ms", "STRING#'T#0ms'"),
            ("TOD_TO_STRING", "TOD#07:05:03.25", "STRING#'TOD#07:05:03.250'"),
            (
                "LTOD_TO_STRING",
                "LTOD#01:02:03.5",
                "STRING#'LTOD#01:02:03.500000000'",
            ),
            ("STRING_TO_INT", "STRING#'999999999999'", "INT#4095"),
            ("STRING_TO_REAL", "STRING#'$T.5x'", "REAL#0.5"),
            ("STRING_TO_BOOL", "STRING#'TRUEX'", "BOOL#TRUE"),
            ("STRING_TO_BOOL", "STRING#'True'", "BOOL#FALSE"),
        ],
    );
}
