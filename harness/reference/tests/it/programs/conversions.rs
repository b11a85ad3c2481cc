//! Values that change their type, implicitly and by functions, in every dialect.

use super::support::{assert_body, assert_diagnostics_in, assert_values_in, program};
use stickler_types::{Code, DialectName};

#[test]
fn an_implicit_conversion_converts() {
    assert_body(
        "i : INT := 5; r : REAL; u : UDINT := 4000000000; l : LINT; b : BYTE := 16#80; d : DWORD; x : LREAL := i;",
        "r := i; l := u; d := b;",
        &[
            "r = REAL#5.0",
            "l = LINT#4000000000",
            "d = DWORD#16#00000080",
            "x = LREAL#5.0",
        ],
    );
}

#[test]
fn a_lint_into_an_lreal_is_rounded_once() {
    assert_body(
        "l : LINT := 9007199254740993; u : ULINT := 18446744073709551615; x : LREAL; y : LREAL;",
        "x := l; y := u;",
        &["x = LREAL#9007199254740992.0", "y = LREAL#1.8446744073709552E19"],
    );
}

#[test]
fn conversion_functions_wrap() {
    assert_body(
        "i : INT; w : WORD; b : BYTE; s : SINT := -1; r : REAL := -2.7; d : DINT;",
        "i := DINT_TO_INT(100000); w := SINT_TO_WORD(s); b := INT_TO_BYTE(-1); d := REAL_TO_DINT(r);",
        &[
            "i = INT#-31072",
            "w = WORD#16#FFFF",
            "b = BYTE#16#FF",
            "d = DINT#-2",
        ],
    );
}

#[test]
fn a_real_is_cut_or_rounded_as_the_dialect_has_it() {
    let source = program(
        "r : REAL := 2.5; q : REAL := 3.5; a : INT; b : INT;",
        "a := REAL_TO_INT(r); b := REAL_TO_INT(q);",
    );
    for dialect in [
        DialectName::IRONPLC_ED2,
        DialectName::IRONPLC_RUSTY,
        DialectName::MATIEC,
    ] {
        assert_values_in(dialect, &source, &["a = INT#2", "b = INT#3"]);
    }
    assert_values_in(DialectName::PLCNEXT, &source, &["a = INT#2", "b = INT#4"]);
}

#[test]
fn plcnext_takes_an_unsigned_integer_for_milliseconds() {
    let source = program("u : UDINT := 1500; t : TIME; v : UDINT;", "t := u; v := t;");
    assert_values_in(
        DialectName::PLCNEXT,
        &source,
        &["t = TIME#1500ms", "v = UDINT#1500"],
    );
    let p4035 = Code::AssignmentTypeMismatch;
    assert_diagnostics_in(DialectName::IRONPLC_ED2, &source, &[(p4035, 5), (p4035, 5)]);
}

#[test]
fn matiec_converts_nothing_on_its_own() {
    let source = program("i : INT := 5; d : DINT;", "d := i;\nd := INT_TO_DINT(i);");
    assert_diagnostics_in(DialectName::MATIEC, &source, &[(Code::AssignmentTypeMismatch, 5)]);
}

#[test]
fn bcd_functions_take_the_type_of_their_target() {
    let source = program(
        "w : WORD := 16#1234; i : INT; d : DINT; b : BYTE; v : WORD; n : INT := 56;",
        "i := BCD_TO_INT(w); d := BCD_TO_INT(w); b := INT_TO_BCD(n); v := INT_TO_BCD(n);",
    );
    let expected = [
        "i = INT#1234",
        "d = DINT#1234",
        "b = BYTE#16#56",
        "v = WORD#16#0056",
    ];
    assert_values_in(DialectName::MATIEC, &source, &expected);
}

#[test]
fn the_rounding_idioms_of_the_forgeiec_page_work() {
    let source = program(
        "rValue : REAL := -2.5; iRounded : DINT; iCeiling : DINT; iFloor : DINT;",
        "iRounded := REAL_TO_DINT(rValue + SEL(rValue < 0.0, 0.5, -0.5));
         iCeiling := TRUNC_DINT(rValue + 0.999999);
         iFloor := TRUNC_DINT(rValue);
         IF rValue < 0.0 AND (DINT_TO_REAL(REAL_TO_DINT(rValue)) <> rValue) THEN iFloor := iFloor - 1; END_IF;",
    );
    let expected = ["iRounded = DINT#-3", "iCeiling = DINT#-1", "iFloor = DINT#-3"];
    assert_values_in(DialectName::MATIEC, &source, &expected);
}

#[test]
fn texts_become_numbers_and_back() {
    assert_body(
        "i : INT; bad : INT := 7; s : STRING[20]; t : STRING[20]; r : REAL; cut : STRING[2];",
        "i := STRING_TO_INT('-42'); bad := STRING_TO_INT('12abc'); s := INT_TO_STRING(i);
         t := REAL_TO_STRING(0.1); r := STRING_TO_REAL('1.5'); cut := DINT_TO_STRING(12345);",
        &[
            "i = INT#-42",
            "bad = INT#0",
            "s = STRING#'-42'",
            "t = STRING#'0.1'",
            "r = REAL#1.5",
            "cut = STRING#'12'",
        ],
    );
}

#[test]
fn dates_are_taken_apart() {
    assert_body(
        "m : DT := DT#1969-12-31-23:59:59; d : DATE; t : TOD; n : DT;",
        "d := DT_TO_DATE(m); t := DT_TO_TOD(m); n := DATE_TO_DT(d);",
        &[
            "d = DATE#1969-12-31",
            "t = TOD#23:59:59",
            "n = DT#1969-12-31-00:00:00",
        ],
    );
}

#[test]
fn dates_and_times_of_day_are_joined() {
    assert_body(
        "d : DATE := D#2024-02-29; t : TOD := TOD#12:34:56.5; l : LTOD := LTOD#0:0:0.000000001; x : DT; y : LDT;
         n : DT;",
        "x := CONCAT_DATE_TOD(d, t); y := CONCAT_DATE_LTOD(IN2 := l, IN1 := d);
         n := CONCAT_DATE_TOD(DT_TO_DATE(x), DT_TO_TOD(x));",
        &[
            "x = DT#2024-02-29-12:34:56.5",
            "y = LDT#2024-02-29-00:00:00.000000001",
            "n = DT#2024-02-29-12:34:56.5",
        ],
    );
    let source = program(
        "d : DATE; t : TOD; x : DT;",
        "x := CONCAT_DATE_TOD(d);\nx := CONCAT_DATE_TOD(t, d);\nx := CONCAT_DATE_TOD(IN1 := d, IN3 := t);
d := CONCAT_DATE_TOD(d, t);\nx := CONCAT_DATE_LTOD(d, t);",
    );
    let expected = [
        (Code::FunctionCallWrongArgCount, 5),
        (Code::FunctionCallArgTypeMismatch, 6),
        (Code::FunctionCallArgTypeMismatch, 6),
        (Code::FunctionCallNamedArgUndeclared, 7),
        (Code::FunctionCallReturnTypeMismatch, 8),
        (Code::FunctionCallUndeclared, 9),
    ];
    assert_diagnostics_in(DialectName::MATIEC, &source, &expected);
}

#[test]
fn a_duration_is_a_time_of_day_modulo_a_day() {
    assert_body(
        "a : TOD; b : TIME; c : LTOD;",
        "a := TIME_TO_TOD(T#25h1ms); b := TOD_TO_TIME(TOD#23:59:59.999); c := LTIME_TO_LTOD(LTIME#-1ns);",
        &[
            "a = TOD#01:00:00.001",
            "b = TIME#86399999ms",
            "c = LTOD#23:59:59.999999999",
        ],
    );
}

#[test]
fn matiec_writes_reals_and_bit_strings_in_its_own_way() {
    let source = program(
        "r : REAL := 0.1; b : WORD := 16#FF; s : STRING; t : STRING; u : STRING;",
        "s := REAL_TO_STRING(r); t := WORD_TO_STRING(b); u := LREAL_TO_STRING(1.0E20);",
    );
    let expected = [
        "s = STRING#'0.1000000015'",
        "t = STRING#'16#ff'",
        "u = STRING#'1e+20'",
    ];
    assert_values_in(DialectName::MATIEC, &source, &expected);
}
