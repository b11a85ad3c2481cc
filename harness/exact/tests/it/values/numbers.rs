//! Values of the number families, computed by hand from the documents and from the definition of IEC 60559.

use super::common::{check, check_by, literal, taking};
use stickler_exact::{choices_of, expected, value};
use stickler_types::{ConversionChoices, DialectName, ElementaryType, OutOfRange, Rounding, Value};

#[test]
fn the_documents_own_examples() {
    check(
        DialectName::MATIEC,
        &[
            ("DINT_TO_INT", "DINT#100000", "INT#-31072"),
            ("SINT_TO_WORD", "SINT#-1", "WORD#16#FFFF"),
            ("BYTE_TO_INT", "BYTE#16#FF", "INT#255"),
            ("INT_TO_BOOL", "INT#256", "BOOL#TRUE"),
            ("BOOL_TO_BYTE", "BOOL#TRUE", "BYTE#16#01"),
            ("TRUNC", "REAL#-2.9", "DINT#-2"),
            ("TRUNC_INT", "REAL#40000.7", "INT#-25536"),
            ("REAL_TO_INT", "REAL#2.7", "INT#2"),
        ],
    );
}

#[test]
fn what_was_recorded_of_codesys() {
    check(
        DialectName::CODESYS,
        &[
            ("LREAL_TO_DINT", "LREAL#3.0E9", "DINT#-1294967296"),
            ("LREAL_TO_DINT", "LREAL#-3.0E9", "DINT#-2147483648"),
            ("LREAL_TO_DINT", "LREAL#NaN", "DINT#0"),
            ("LREAL_TO_DINT", "LREAL#-Infinity", "DINT#-2147483648"),
            ("LREAL_TO_INT", "LREAL#-3.0E9", "INT#0"),
            ("REAL_TO_SINT", "REAL#-508.0", "SINT#4"),
            ("LREAL_TO_LINT", "LREAL#NaN", "LINT#-9223372036854775808"),
            ("REAL_TO_ULINT", "REAL#Infinity", "ULINT#9223372036854775808"),
            ("TRUNC", "LREAL#3.0E9", "DINT#-2147483648"),
            ("TRUNC_INT", "LREAL#3.0E9", "INT#0"),
            ("TRUNC_INT", "REAL#40000.5", "INT#-25536"),
        ],
    );
}

#[test]
fn what_the_tests_of_rusty_expect() {
    check(
        DialectName::RUSTY,
        &[
            ("LWORD_TO_LREAL", "LWORD#16#4000000000000000", "LREAL#2.0"),
            ("DWORD_TO_REAL", "DWORD#16#40000000", "REAL#2.0"),
            ("LREAL_TO_LWORD", "LREAL#2.0", "LWORD#16#4000000000000000"),
            ("REAL_TO_DWORD", "REAL#2.0", "DWORD#16#40000000"),
            // Of another width, so no copy.
            ("WORD_TO_REAL", "WORD#16#4000", "REAL#16384.0"),
            ("LWORD_TO_REAL", "LWORD#16#2", "REAL#2.0"),
            ("LWORD_TO_BOOL", "LWORD#16#2", "BOOL#FALSE"),
            ("BYTE_TO_BOOL", "BYTE#16#FF", "BOOL#TRUE"),
            ("BOOL_TO_LWORD", "BOOL#TRUE", "LWORD#16#1"),
            ("DWORD_TO_DINT", "DWORD#16#FFFFFFFF", "DINT#-1"),
            ("TO_BOOL", "WORD#16#0005", "BOOL#TRUE"),
            ("LDT_TO_DATE", "LDT#2000-01-01-20:15:11", "DATE#2000-01-01"),
            ("DT_TO_TOD", "DT#2120-02-12-20:15:11.543", "TOD#20:15:11.543"),
        ],
    );
}

#[test]
fn what_the_tests_of_strucpp_expect() {
    check(
        DialectName::STRUCPP,
        &[
            ("TIME_TO_DINT", "TIME#1500ms", "DINT#1500"),
            ("TOD_TO_DINT", "TOD#06:00:00", "DINT#21600000"),
            ("TO_LINT", "DT#1970-01-01-00:00:01", "LINT#1000"),
            ("TO_UINT", "DATE#1970-01-15", "UINT#14"),
            ("DATE_TO_DINT", "DATE#1969-12-31", "DINT#-1"),
            ("DINT_TO_DATE", "DINT#14", "DATE#1970-01-15"),
            ("LREAL_TO_DATE", "LREAL#14.5", "DATE#1970-01-15"),
            ("DATE_TO_LREAL", "DATE#1970-01-15", "LREAL#14.0"),
            ("TO_INT", "STRING#'3.14'", "INT#3"),
            // Another system's choice.
            ("DWORD_TO_REAL", "DWORD#16#40000000", "REAL#1073741824.0"),
            ("BYTE_TO_BOOL", "BYTE#16#02", "BOOL#TRUE"),
        ],
    );
}

#[test]
fn integers_wrap_and_bit_strings_have_no_sign() {
    check(
        DialectName::IRONPLC_ED3,
        &[
            ("LINT_TO_SINT", "LINT#128", "SINT#-128"),
            ("LINT_TO_SINT", "LINT#-129", "SINT#127"),
            ("SINT_TO_ULINT", "SINT#-1", "ULINT#18446744073709551615"),
            (
                "ULINT_TO_LINT",
                "ULINT#9223372036854775808",
                "LINT#-9223372036854775808",
            ),
            ("WORD_TO_SINT", "WORD#16#0080", "SINT#-128"),
            ("BYTE_TO_LINT", "BYTE#16#80", "LINT#128"),
            ("LWORD_TO_BYTE", "LWORD#16#123456789ABCDEF0", "BYTE#16#F0"),
            ("TO_INT", "INT#-5", "INT#-5"),
        ],
    );
}

#[test]
fn integers_become_reals_with_one_rounding_to_even() {
    check(
        DialectName::MATIEC,
        &[
            ("DINT_TO_REAL", "DINT#16777217", "REAL#16777216.0"),
            ("DINT_TO_REAL", "DINT#16777219", "REAL#16777220.0"),
            ("DINT_TO_REAL", "DINT#-16777217", "REAL#-16777216.0"),
            (
                "LINT_TO_LREAL",
                "LINT#9007199254740993",
                "LREAL#9007199254740992.0",
            ),
            (
                "LINT_TO_LREAL",
                "LINT#9007199254740995",
                "LREAL#9007199254740996.0",
            ),
            (
                "ULINT_TO_LREAL",
                "ULINT#18446744073709551615",
                "LREAL#1.8446744073709552E19",
            ),
            // 2^62 + 2^38 + 1: by way of LREAL it would first round to the tie 2^62 + 2^38, and then down to 2^62.
            ("LINT_TO_REAL", "LINT#4611686293305294849", "REAL#4.6116866E18"),
            ("LINT_TO_REAL", "LINT#4611686293305294848", "REAL#4.611686E18"),
        ],
    );
}

#[test]
fn lreal_becomes_real_with_one_rounding_to_even() {
    check(
        DialectName::PLCNEXT,
        &[
            ("LREAL_TO_REAL", "LREAL#0.1", "REAL#0.1"),
            ("LREAL_TO_REAL", "LREAL#16777217.0", "REAL#16777216.0"),
            ("LREAL_TO_REAL", "LREAL#-0.0", "REAL#-0.0"),
            ("LREAL_TO_REAL", "LREAL#NaN", "REAL#NaN"),
            ("LREAL_TO_REAL", "LREAL#-Infinity", "REAL#-Infinity"),
            // 2^128 - 2^103 is the tie between the largest finite number and the next, which there is not.
            ("LREAL_TO_REAL", "LREAL#3.4028235677973366E38", "REAL#Infinity"),
            (
                "LREAL_TO_REAL",
                "LREAL#3.4028235677973362E38",
                "REAL#3.4028235E38",
            ),
            // 2^-150 is half of the least number; what is greater becomes that.
            ("LREAL_TO_REAL", "LREAL#7.006492321624085E-46", "REAL#0.0"),
            ("LREAL_TO_REAL", "LREAL#7.006492321624087E-46", "REAL#1.0E-45"),
            ("LREAL_TO_REAL", "LREAL#-1.0E-60", "REAL#-0.0"),
            ("LREAL_TO_REAL", "LREAL#5.0E-324", "REAL#0.0"),
            ("REAL_TO_LREAL", "REAL#0.1", "LREAL#0.10000000149011612"),
            ("REAL_TO_LREAL", "REAL#1.0E-45", "LREAL#1.401298464324817E-45"),
            ("REAL_TO_LREAL", "REAL#NaN", "LREAL#NaN"),
        ],
    );
}

#[test]
fn a_real_becomes_an_integer_as_its_dialect_rounds() {
    check(
        DialectName::IRONPLC_ED2,
        &[
            ("REAL_TO_INT", "REAL#-0.9", "INT#0"),
            ("LREAL_TO_DINT", "LREAL#2.9999999999999996", "DINT#2"),
            ("LREAL_TO_INT", "LREAL#65536.0", "INT#0"),
            (
                "LREAL_TO_LINT",
                "LREAL#9223372036854775808.0",
                "LINT#-9223372036854775808",
            ),
            ("LREAL_TO_ULINT", "LREAL#-1.0", "ULINT#18446744073709551615"),
            ("LREAL_TO_ULINT", "LREAL#1.0E300", "ULINT#0"),
            ("LREAL_TO_BYTE", "LREAL#257.5", "BYTE#16#01"),
            ("REAL_TO_DINT", "REAL#NaN", "DINT#0"),
            ("LREAL_TO_LINT", "LREAL#NaN", "LINT#0"),
            ("LREAL_TO_LINT", "LREAL#Infinity", "LINT#0"),
            ("LREAL_TO_LWORD", "LREAL#NaN", "LWORD#16#0"),
            ("REAL_TO_DINT", "REAL#-Infinity", "DINT#0"),
        ],
    );
    check(
        DialectName::PLCNEXT,
        &[
            ("REAL_TO_INT", "REAL#0.5", "INT#0"),
            ("REAL_TO_INT", "REAL#1.5", "INT#2"),
            ("REAL_TO_INT", "REAL#-2.5", "INT#-2"),
            ("REAL_TO_INT", "REAL#0.49999997", "INT#0"),
            ("LREAL_TO_INT", "LREAL#32767.5", "INT#-32768"),
            ("ROUND", "REAL#2.5", "DINT#2"),
            ("ROUND", "LREAL#3.5", "LINT#4"),
            ("CEIL", "REAL#-2.5", "DINT#-2"),
            ("CEILING", "LREAL#5.0E-324", "LINT#1"),
            ("FLOOR", "REAL#-2.5", "DINT#-3"),
            ("FLOOR", "LREAL#-5.0E-324", "LINT#-1"),
            ("TRUNC_USINT", "LREAL#255.9", "USINT#255"),
            ("LREAL_TRUNC_SINT", "LREAL#-128.9", "SINT#-128"),
        ],
    );
}

#[test]
fn other_choices_round_away_and_saturate() {
    let choices = ConversionChoices {
        rounding: Rounding::HalfAwayFromZero,
        out_of_range: OutOfRange::Saturate,
        truncation_out_of_range: OutOfRange::Saturate,
        ..choices_of(DialectName::MATIEC)
    };
    check_by(
        choices,
        &[
            ("REAL_TO_INT", "REAL#0.5", "INT#1"),
            ("REAL_TO_INT", "REAL#-2.5", "INT#-3"),
            ("REAL_TO_INT", "REAL#0.49999997", "INT#0"),
            ("REAL_TO_INT", "REAL#40000.0", "INT#32767"),
            ("REAL_TO_INT", "REAL#-40000.0", "INT#-32768"),
            ("REAL_TO_UINT", "REAL#-1.0", "UINT#0"),
            ("REAL_TO_WORD", "REAL#Infinity", "WORD#16#FFFF"),
            ("REAL_TO_SINT", "REAL#-Infinity", "SINT#-128"),
            ("REAL_TO_SINT", "REAL#NaN", "SINT#0"),
            ("LREAL_TO_LINT", "LREAL#1.0E300", "LINT#9223372036854775807"),
            ("TRUNC", "LREAL#1.0E10", "DINT#2147483647"),
            // Saturation is a matter of reals; integers among each other wrap.
            ("DINT_TO_INT", "DINT#40000", "INT#-25536"),
        ],
    );
}

#[test]
fn only_zero_is_false() {
    check(
        DialectName::MATIEC,
        &[
            ("LREAL_TO_BOOL", "LREAL#-0.0", "BOOL#FALSE"),
            ("LREAL_TO_BOOL", "LREAL#5.0E-324", "BOOL#TRUE"),
            ("REAL_TO_BOOL", "REAL#NaN", "BOOL#TRUE"),
            ("LWORD_TO_BOOL", "LWORD#16#8000000000000000", "BOOL#TRUE"),
            ("BOOL_TO_LREAL", "BOOL#TRUE", "LREAL#1.0"),
            ("BOOL_TO_SINT", "BOOL#TRUE", "SINT#1"),
        ],
    );
}

#[test]
fn operands_that_do_not_fit_give_the_default() {
    let integer = literal("INT#5");
    let signature = taking("INT_TO_DINT", &integer, DialectName::MATIEC);
    let zero = Value::plain(ElementaryType::Dint, 0);
    let choices = choices_of(DialectName::MATIEC);
    let real = literal("REAL#5.0");
    for operands in [
        vec![],
        vec![real],
        vec![integer.clone(), integer],
        vec![Value::enumerated("COLOR", "RED")],
    ] {
        assert_eq!(value(&signature, &operands, &choices), zero);
        assert_eq!(expected(&signature, &operands, DialectName::MATIEC).basis, None);
    }
}
