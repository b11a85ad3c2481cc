//! The statements by which a page takes a value apart into numbers: see [`encoding`](crate::encoding) for what the numbers mean.
//!
//! One stretch of statements a type, once on a page. The value stands in a variable of the page that has the type, the numbers go
//! into `results` behind the two elements that every observation has. Every loop is a FOR loop: however wrong a compiler's
//! arithmetic is, the page comes to its end.

use crate::encoding::{INFINITE_EXPONENT, NAN_EXPONENT, REST_SIGN};
use std::fmt::Display;
use stickler_types::{ElementaryType, Family};

/// Returns the variable of a page in which the value of a type is taken apart.
pub(crate) fn variable(ty: ElementaryType) -> String {
    format!("stickler_{}", ty.name())
}

/// Returns the declarations that taking values of a type apart needs.
pub(crate) fn declarations(ty: ElementaryType) -> String {
    let (variable, name) = (variable(ty), ty.name());
    match ty.family() {
        Family::Duration => {
            format!(
                "{variable} : {name};\n    {variable}_parts : ARRAY[0..{}] OF {name};",
                top(ty)
            )
        }
        _ => format!("{variable} : {name};"),
    }
}

/// Returns the statements that take a value of a type apart, indented by `margin`. They use `stickler_place`, `stickler_sum`,
/// `stickler_count`, `stickler_sign`.
pub(crate) fn statements(ty: ElementaryType, margin: &str) -> String {
    let lines = match ty.family() {
        Family::Boolean => filled(include_str!("encode/boolean.st"), &[("x", &variable(ty))]),
        Family::Signed | Family::Unsigned => integer(ty),
        Family::BitString => bit_string(ty),
        Family::Real => real(ty),
        Family::Duration => duration(ty),
        _ => String::new(),
    };
    let mut text = String::with_capacity(lines.len() * 2);
    for line in lines.lines() {
        text += &format!("{margin}{line}\n");
    }
    text
}

/// Returns the statements for an integer type: bit by bit from the highest, where a bit is set if the rest is at least as great.
fn integer(ty: ElementaryType) -> String {
    let (variable, name, bits) = (variable(ty), ty.name(), ty.bits());
    if ty == ElementaryType::Dint {
        return format!("results[stickler_place + 2] := {variable};");
    }
    let mut text = "stickler_sum := 0;\n".to_owned();
    let mut highest = bits;
    if ty.is_signed() {
        highest -= 1;
        // The value without its sign bit: what is added is one half twice, since the whole has no literal of the type.
        let half = 1_u64 << (bits - 2);
        let sign = -(1_i64 << ((bits - 1) - lowest_of_piece(bits - 1, bits)));
        text += &filled(
            include_str!("encode/sign.st"),
            &[("x", &variable), ("t", &name), ("half", &half), ("sign", &sign)],
        );
    }
    for bit in (0..highest).rev() {
        let weight = 1_u64 << bit;
        let lowest = lowest_of_piece(bit, bits);
        let place = 1_u64 << (bit - lowest);
        text += &format!(
            "IF {variable} >= {name}#{weight} THEN {variable} := {variable} - {name}#{weight}; stickler_sum := stickler_sum + \
             {place}; END_IF;\n"
        );
        write_piece(&mut text, bit, bits);
    }
    text
}

/// Returns the lowest bit of the piece that contains a bit.
fn lowest_of_piece(bit: u32, bits: u32) -> u32 {
    if bits <= 16 { 0 } else { bit / 24 * 24 }
}

/// Writes the number of a piece into the array, where the piece is complete with this bit.
fn write_piece(text: &mut String, bit: u32, bits: u32) {
    if bit != lowest_of_piece(bit, bits) {
        return;
    }
    let pieces = if bits <= 16 { 1 } else { bits.div_ceil(24) };
    let number = pieces - bit / 24 - 1;
    *text += &format!("results[stickler_place + {}] := stickler_sum;\n", 2 + number);
    if bit > 0 {
        text.push_str("stickler_sum := 0;\n");
    }
}

/// Returns the statements for a bit-string type: bit by bit, by masks.
fn bit_string(ty: ElementaryType) -> String {
    let (variable, name, bits) = (variable(ty), ty.name(), ty.bits());
    let width = bits as usize / 4;
    let mut text = "stickler_sum := 0;\n".to_owned();
    for bit in (0..bits).rev() {
        let place = 1_u64 << (bit - lowest_of_piece(bit, bits));
        text += &format!(
            "IF ({variable} AND {name}#16#{:0width$X}) <> {name}#16#{:0width$X} THEN stickler_sum := stickler_sum + {place}; END_IF;\n",
            1_u64 << bit,
            0
        );
        write_piece(&mut text, bit, bits);
    }
    text
}

/// Fills the places `{name}` of a template.
pub(crate) fn filled(template: &str, values: &[(&str, &dyn Display)]) -> String {
    let fill = |text: String, (name, value): &(&str, &dyn Display)| {
        text.replace(&format!("{{{name}}}"), &value.to_string())
    };
    values.iter().fold(template.to_owned(), fill)
}

/// Returns the statements for a real type: doubling and halving, which are exact, give a number from 1 up to 2, which is then taken
/// apart by binary digits.
fn real(ty: ElementaryType) -> String {
    let (x, t) = (variable(ty), ty.name());
    // The number of divisions by 2^16 for the largest finite value, and of multiplications for the smallest; the digits of each
    // piece.
    let (down, up, pieces): (u32, u32, &[u32]) = match ty {
        ElementaryType::Real => (8, 10, &[24]),
        _ => (64, 68, &[29, 24]),
    };
    let digits = pieces.iter().enumerate().map(|(number, count)| {
        let signed = match number {
            0 => "stickler_sign * stickler_sum",
            _ => "stickler_sum",
        };
        let digits = include_str!("encode/real_digits.st");
        filled(
            digits,
            &[("count", count), ("place", &(3 + number)), ("signed", &signed)],
        )
    });
    filled(
        include_str!("encode/real.st"),
        &[
            ("digits", &digits.collect::<String>()),
            ("down", &down),
            ("up", &up),
            ("nan", &NAN_EXPONENT),
            ("infinite", &INFINITE_EXPONENT),
            ("x", &x),
            ("t", &t),
        ],
    )
}

/// Returns the exponent of the highest power of two, in units of the type, by which a duration is taken apart.
///
/// Basis: iec-61131-3: Table 10 leaves the range of `TIME` open; 32 bits of milliseconds are the least that compilers have, 64
/// bits of nanoseconds the most.
fn top(ty: ElementaryType) -> u32 {
    if ty == ElementaryType::Time { 43 } else { 62 }
}

/// Returns the statements for a duration type: by powers of two of its unit, which the page doubles up to the last that is not
/// greater than the value. No difference is negative, since some compilers' durations have no sign.
fn duration(ty: ElementaryType) -> String {
    let (x, t, top) = (variable(ty), ty.name(), top(ty));
    let unit = if ty == ElementaryType::Time { "1ms" } else { "1ns" };
    let piece = |number: u32| {
        let (lowest, place) = (48 - number * 24, 3 + number);
        let highest = (lowest + 23).min(top);
        match lowest > top {
            true => format!("results[stickler_place + {place}] := 0;\n"),
            false => filled(
                include_str!("encode/duration_piece.st"),
                &[("highest", &highest), ("lowest", &lowest), ("place", &place)],
            ),
        }
    };
    filled(
        include_str!("encode/duration.st"),
        &[
            ("pieces", &(0..3).map(piece).collect::<String>()),
            ("unit", &unit),
            ("top", &top),
            ("rest", &REST_SIGN),
            ("x", &x),
            ("t", &t),
        ],
    )
}
