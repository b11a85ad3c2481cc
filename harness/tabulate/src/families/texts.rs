//! Texts that are read as numbers, and numbers that are written as texts: the tables of what a document says, and the oldest
//! of what none does.

use super::words::{ALL, CONFORMANCE, DESIGN, ELSEWHERE, MATIEC, NAMING, OPEN_PAIR, PAIR};
use crate::call::Call;
use crate::column::Column;
use crate::inputs::integers::{INTEGERS, ascending, limits};
use crate::inputs::reals::REALS;
use crate::operand::Operand;
use crate::program::{PAIR_OF_CONSTANT, PAIR_OF_VARIABLE};
use crate::sheet::{CallProbe, Sheet};
use stickler_types::ElementaryType;
use stickler_types::ElementaryType::{
    Bool, Byte, Date, Dint, Dt, Dword, Int, Lint, Lreal, Lword, Real, String as Text, Time, Tod, Udint, Uint,
    Usint, Word,
};

/// The tables of this family.
pub fn sheets() -> Vec<Sheet> {
    vec![
        string_to_integer(),
        string_not_parseable(),
        string_borderline(),
        string_to_real(),
        integer_to_string(),
        to_string_text(),
    ]
}

/// A table of what only the ForgeIEC page says.
fn asserted(
    name: &'static str,
    title: &'static str,
    basis: &'static str,
    summary: &str,
    calls: Vec<Call>,
) -> Sheet {
    Sheet {
        name,
        title,
        basis,
        dialects: ALL.to_vec(),
        summary: summary.to_owned(),
        columns: PAIR,
        calls,
        probes: CallProbe::variable_and_constant(MATIEC, ELSEWHERE, PAIR_OF_VARIABLE, PAIR_OF_CONSTANT),
    }
}

/// A table of what no document says.
fn open(
    name: &'static str,
    title: &'static str,
    summary: &str,
    columns: &'static [Column],
    calls: Vec<Call>,
) -> Sheet {
    Sheet {
        name,
        title,
        basis: DESIGN,
        dialects: ALL.to_vec(),
        summary: summary.to_owned(),
        columns,
        calls,
        probes: vec![CallProbe::recorded(&[], PAIR_OF_VARIABLE)],
    }
}

/// Some numbers of each integer type.
fn numbers() -> Vec<(ElementaryType, Operand)> {
    let numbers = INTEGERS.into_iter().flat_map(|ty| {
        let (least, greatest) = limits(ty);
        let operands = ascending(ty, [0, 1, 42, greatest, least.max(-1), least]).into_iter();
        operands.map(move |operand| (ty, operand))
    });
    numbers.collect()
}

fn string_to_integer() -> Sheet {
    let calls = numbers().into_iter().map(|(ty, number)| {
        let text = Operand::written(Text, &format!("'{}'", number.literal));
        Call::convert(Text, ty, text)
    });
    asserted(
        "string-to-integer",
        "STRING_TO_INT and its kin read a decimal number",
        NAMING,
        "",
        calls.collect(),
    )
}

fn string_not_parseable() -> Sheet {
    let integers = [Int, Dint, Lint, Usint, Udint].into_iter().flat_map(|ty| {
        let texts = [
            "''",
            "'abc'",
            "'-'",
            "'+'",
            "'x1'",
            "' '",
            "'$N'",
            "'.'",
            "'hello world'",
        ];
        texts.map(|text| Call::convert(Text, ty, Operand::written(Text, text)))
    });
    let reals = REALS.into_iter().flat_map(|ty| {
        let texts = ["''", "'abc'", "'-'", "' '", "'x1.5'", "'hello'"];
        texts.map(|text| Call::convert(Text, ty, Operand::written(Text, text)))
    });
    asserted(
        "string-not-parseable",
        "A string that is no number converts to 0, silently",
        CONFORMANCE,
        "\"String parsing (STRING_TO_INT, STRING_TO_REAL) returns 0 on parse failure rather than raising.\" Elsewhere recorded.",
        integers.chain(reals).collect(),
    )
}

fn string_borderline() -> Sheet {
    const TEXTS: [&str; 15] = [
        "'12abc'",
        "' 42'",
        "'42 '",
        "'+7'",
        "'007'",
        "'1_000'",
        "'16#FF'",
        "'2#101'",
        "'INT#5'",
        "'1.5'",
        "'1E3'",
        "'--1'",
        "'99999999999999999999'",
        "'-32769'",
        "'65536'",
    ];
    let calls = [Int, Dint, Uint, Real, Lreal].into_iter().flat_map(|ty| {
        let texts = TEXTS
            .into_iter()
            .filter(move |text| !(ty.is_real() && *text == "'1.5'"));
        texts.map(move |text| Call::convert(Text, ty, Operand::written(Text, text)))
    });
    let mut sheet = open(
        "string-borderline",
        "A string that some systems read as a number and others do not",
        "Trailing text, spaces, signs, leading zeros, underscores, bases, fractions, numbers outside the type: no document says; recorded.",
        OPEN_PAIR,
        calls.collect(),
    );
    // '-32769' and '65536' are outside some of the types only.
    sheet.probes = sheet.probes.into_iter().map(CallProbe::also_where_said).collect();
    sheet
}

fn string_to_real() -> Sheet {
    let calls = ["0.0", "1.5", "-2.25", "100.0", "0.5"]
        .into_iter()
        .flat_map(|number| {
            REALS.map(|ty| Call::convert(Text, ty, Operand::written(Text, &format!("'{number}'"))))
        });
    asserted(
        "string-to-real",
        "STRING_TO_REAL reads a decimal number with a fraction",
        NAMING,
        "",
        calls.collect(),
    )
}

fn integer_to_string() -> Sheet {
    let calls = numbers()
        .into_iter()
        .map(|(ty, number)| Call::convert(ty, Text, number));
    asserted(
        "integer-to-string",
        "INT_TO_STRING and its kin write the decimal number",
        NAMING,
        "",
        calls.collect(),
    )
}

fn to_string_text() -> Sheet {
    let reals = REALS.into_iter().flat_map(|ty| {
        let numbers = [
            "0.0",
            "1.0",
            "1.5",
            "-2.25",
            "0.1",
            "1.0E10",
            "1.0E-10",
            "16777216.0",
            "3.1415927",
        ];
        numbers.map(|number| (ty, number))
    });
    let others = [
        (Bool, "TRUE"),
        (Bool, "FALSE"),
        (Byte, "16#FF"),
        (Word, "16#00FF"),
        (Dword, "16#DEADBEEF"),
        (Lword, "16#1"),
        (Time, "TIME#1500ms"),
        (Time, "TIME#1d2h3m4s5ms"),
        (Date, "DATE#2024-02-29"),
        (Tod, "TOD#12:34:56.789"),
        (Dt, "DT#2024-02-29-12:34:56"),
    ];
    let calls = reals
        .chain(others)
        .map(|(ty, literal)| Call::convert(ty, Text, Operand::written(ty, literal)));
    open(
        "to-string-text",
        "What other types look like as text",
        "The page lists REAL_TO_STRING without saying which digits; the text is recorded.",
        OPEN_PAIR,
        calls.collect(),
    )
}
