//! Texts that are numbers, texts that are none, and texts on which systems differ.

use crate::operand::Operand;
use stickler_types::ElementaryType;

/// Texts around integers: empty, blanks, signs, zeros in front, underscores, bases, typed literals, fractions, exponents, trailing
/// text, too long, and digits that are none.
pub const AROUND_INTEGERS: [&str; 46] = [
    "''",
    "'  '",
    "' 42'",
    "'42 '",
    "' -7 '",
    "'$T42'",
    "'42$N'",
    "'+7'",
    "'+ 7'",
    "'- 7'",
    "'--1'",
    "'+-1'",
    "'-0'",
    "'007'",
    "'-007'",
    "'00000000000000000000000000000001'",
    "'1_000'",
    "'_1'",
    "'1_'",
    "'1__0'",
    "'16#FF'",
    "'16#ff'",
    "'16#1_F'",
    "'16#'",
    "'16#G'",
    "'2#101'",
    "'8#17'",
    "'10#5'",
    "'-16#1'",
    "'0x10'",
    "'INT#5'",
    "'DINT#-5'",
    "'1.0'",
    "'1.'",
    "'.5'",
    "'1E3'",
    "'1e0'",
    "'12abc'",
    "'1 2'",
    "'1,000'",
    "'$B2'",
    "'TRUE'",
    "'99999999999999999999'",
    "'-99999999999999999999'",
    "'340282366920938463463374607431768211457'",
    "'5$00'",
];

/// Texts around real numbers.
pub const AROUND_REALS: [&str; 42] = [
    "'42'",
    "'-7'",
    "'1.'",
    "'.5'",
    "'-.5'",
    "'01.5'",
    "'1.50'",
    "'+1.5'",
    "'--1.5'",
    "' 1.5'",
    "'1.5 '",
    "'1.5E3'",
    "'1.5e3'",
    "'1.5E+3'",
    "'1.5E-3'",
    "'1E3'",
    "'1.5E'",
    "'1.5E3.0'",
    "'1_0.5'",
    "'1.5_0'",
    "'1,5'",
    "'1.5abc'",
    "'1.5.5'",
    "'-0.0'",
    "'-0'",
    "'16777217.0'",
    "'16777217.5'",
    "'1.00000005960464477539062500001'",
    "'0.1'",
    "'1.0E-45'",
    "'0.7E-45'",
    "'1.0E38'",
    "'1.0E39'",
    "'1.0E309'",
    "'-1.0E309'",
    "'1.0E-400'",
    "'NaN'",
    "'inf'",
    "'Infinity'",
    "'-Infinity'",
    "'16#FF'",
    "'REAL#1.5'",
];

/// Texts that are no number to anybody.
pub const NO_NUMBERS: [&str; 8] = [
    "'-'",
    "'+'",
    "'abc'",
    "'x1'",
    "'.'",
    "'hello world'",
    "'e5'",
    "'$N'",
];

/// Decimal numbers with a fraction that everybody reads, with few digits.
pub const PLAIN_REALS: [&str; 14] = [
    "'0.1'",
    "'-0.1'",
    "'0.25'",
    "'1.0'",
    "'-1.0'",
    "'2.5'",
    "'3.14159'",
    "'99.99'",
    "'1000.0'",
    "'-1000.25'",
    "'123456.0'",
    "'0.000001'",
    "'100.00'",
    "'65536.5'",
];

/// Texts around the words of BOOL.
pub const AROUND_BOOL: [&str; 12] = [
    "'TRUE'",
    "'true'",
    "'FALSE'",
    "'0'",
    "'1'",
    "'2'",
    "'-1'",
    "'BOOL#TRUE'",
    "'yes'",
    "''",
    "' TRUE '",
    "'1.0'",
];

/// Texts around the literals of a duration, date or time of day.
#[must_use]
pub fn around_moments(ty: ElementaryType) -> &'static [&'static str] {
    use ElementaryType::{Date, Dt, Ldate, Ldt, Ltime, Ltod, Time, Tod};
    match ty {
        Time | Ltime => &[
            "'T#1500ms'",
            "'TIME#1s500ms'",
            "'LTIME#1500ms'",
            "'1s500ms'",
            "'1.5s'",
            "'-1.5ms'",
            "'1500'",
            "'1d2h3m4s5ms6us7ns'",
            "''",
            "'106752d'",
        ],
        Date | Ldate => &[
            "'D#2024-02-29'",
            "'DATE#2024-02-29'",
            "'LDATE#2024-02-29'",
            "'2024-02-29'",
            "'2023-02-29'",
            "'29.2.2024'",
            "''",
        ],
        Tod | Ltod => &[
            "'TOD#12:34:56.789'",
            "'LTOD#12:34:56.789'",
            "'12:34:56.789'",
            "'23:59:59'",
            "'24:00:00'",
            "'12:34'",
            "''",
        ],
        Dt | Ldt => &[
            "'DT#2024-02-29-12:34:56'",
            "'LDT#2024-02-29-12:34:56'",
            "'2024-02-29-12:34:56'",
            "'2024-02-29 12:34:56'",
            "'1969-12-31-23:59:59'",
            "''",
        ],
        _ => &[],
    }
}

/// A literal between single quotes as one of the other text type: `'a'` becomes `"a"`, and `$B2` becomes `$00B2`.
#[must_use]
pub fn widened(literal: &str) -> String {
    let mut wide = String::from("\"");
    let mut rest = literal.trim_matches('\'').chars().peekable();
    while let Some(character) = rest.next() {
        wide.push(character);
        let in_hexadecimal = rest
            .peek()
            .is_some_and(|next| next.is_ascii_digit() || *next == 'B');
        if character == '$' && in_hexadecimal {
            wide.push_str("00");
        }
    }
    wide.push('"');
    wide
}

/// An operand of a text type from a literal between single quotes, written as it stands.
#[must_use]
pub fn operand(ty: ElementaryType, literal: &str) -> Operand {
    if ty == ElementaryType::Wstring {
        Operand::written(ty, &widened(literal))
    } else {
        Operand::written(ty, literal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_has_the_same_characters_in_both_types() {
        let all = AROUND_INTEGERS.into_iter().chain(AROUND_REALS).chain(NO_NUMBERS);
        for literal in all {
            let units = |ty| match operand(ty, literal).value {
                stickler_types::Value::Text { units, .. } => units,
                other => panic!("{other} is no text"),
            };
            assert_eq!(
                units(ElementaryType::String),
                units(ElementaryType::Wstring),
                "{literal}"
            );
        }
        assert_eq!(widened("'5$00'"), "\"5$0000\"");
        assert_eq!(widened("'$N'"), "\"$N\"");
    }
}
