//! Writing of the literals of the model as source text, in their canonical spelling or in other notations: bases, underscores, exponents, composed
//! durations, long prefixes, character codes.

use super::source_writer::SourceWriter;
use crate::model::LiteralForm;
use std::fmt::Write as _;
use stickler_types::{Dialect, DialectName, ElementaryType, Family, Value};

impl SourceWriter<'_> {
    /// Writes a literal in its canonical spelling, or in the notation of the style, with or without the prefix of its type.
    ///
    /// Without the prefix, bit strings are written in base 16, and durations and dates keep the short prefix that the
    /// standard demands: `T#5ms`, `D#2024-02-29`.
    pub fn literal(&mut self, value: &Value, form: LiteralForm) {
        let start = self.text.len();
        // Writing to a String does not fail.
        let _ = write!(self.text, "{value}");
        let Some(ty) = value.elementary() else {
            return;
        };
        let Some(sign) = self.text[start..].find('#').map(|offset| start + offset) else {
            return;
        };
        let mut spelled = self.text.split_off(sign);
        self.text.truncate(start);
        let varied = self.style.varied_notation;
        if varied && let Some(other) = self.other_notation(value, form) {
            spelled = format!("#{other}");
        }
        match form {
            LiteralForm::Typed => {
                self.word(if varied { long_prefix(ty) } else { ty.name() });
                self.put(&spelled);
            }
            LiteralForm::Untyped => self.without_prefix(ty, &spelled),
        }
    }

    /// Writes the digits after a `#`, which is the first byte of `spelled`.
    fn without_prefix(&mut self, ty: ElementaryType, spelled: &str) {
        match ty.family() {
            Family::Boolean => self.word(&spelled[1..]),
            Family::Duration | Family::Date | Family::TimeOfDay | Family::DateAndTime => {
                self.word(match ty {
                    ElementaryType::Time => "T",
                    ElementaryType::Ltime => "LT",
                    ElementaryType::Date => "D",
                    ElementaryType::Ldate => "LD",
                    _ => ty.name(),
                });
                self.put(spelled);
            }
            _ => self.put(&spelled[1..]),
        }
    }
}

/// Returns whether the untyped spelling begins with a minus, which has a lower precedence than some operators beside it.
pub(super) fn begins_with_minus(value: &Value) -> bool {
    let &Value::Plain { ty, raw } = value else {
        return false;
    };
    match ty.family() {
        Family::Signed => ty.integer_value(raw) < 0,
        Family::Real => {
            let sign_bit = if ty == ElementaryType::Real { 31 } else { 63 };
            raw >> sign_bit & 1 == 1
        }
        _ => false,
    }
}

impl SourceWriter<'_> {
    /// Returns the text of a literal after its prefix in another notation; `None` if there is only the canonical one.
    ///
    /// Basis: iec-61131-3: Tables 5 to 9.
    pub fn other_notation(&mut self, value: &Value, form: LiteralForm) -> Option<String> {
        let choice = self.next_random() as usize;
        match value {
            Value::Plain { ty, raw } => match ty.family() {
                Family::Signed | Family::Unsigned | Family::BitString => Some(other_integer(
                    ty.integer_value(*raw),
                    choice,
                    self.program.dialect,
                )),
                Family::Real => self.other_real(*ty, *raw, form, choice),
                Family::Duration => other_duration(raw.cast_signed()),
                _ => None,
            },
            Value::Text { units, ty } => other_text(units, *ty, choice),
            Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => None,
        }
    }

    /// Spells a real with an exponent; or without a point, where the dialect takes a bare integer literal for a real.
    fn other_real(&self, ty: ElementaryType, raw: u64, form: LiteralForm, choice: usize) -> Option<String> {
        let number = ty.real_value(raw)?;
        // Integers up to here are numbers of either type, and no document states the value of longer ones.
        let is_whole = number.fract() == 0.0 && number.abs() < 16_777_216.0 && number.is_sign_positive();
        if choice.is_multiple_of(2) && is_whole && form == LiteralForm::Untyped && self.takes_whole_reals() {
            return Some(format!("{number}"));
        }
        let mut text = if ty == ElementaryType::Real {
            format!("{:E}", number as f32)
        } else {
            format!("{number:E}")
        };
        if !text.contains('.') {
            text.insert_str(text.find('E')?, ".0");
        }
        Some(text)
    }

    /// Returns whether the dialect takes a bare integer literal for a real.
    ///
    /// Basis: ironplc-type-conversions: Integer and Real Types ("bare integer literals"); no in matiec, open in PLCnext.
    fn takes_whole_reals(&self) -> bool {
        let dialect = self.program.dialect;
        dialect.rules().documents.untyped_literals && Dialect::of(dialect).integer_literal_as_real
    }
}

/// Returns the long prefix of a date, a time of day, or both.
pub(super) const fn long_prefix(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Tod => "TIME_OF_DAY",
        ElementaryType::Dt => "DATE_AND_TIME",
        ElementaryType::Ltod => "LTIME_OF_DAY",
        ElementaryType::Ldt => "LDATE_AND_TIME",
        ty => ty.name(),
    }
}

/// Spells an integer in another base that the dialect has and negative numbers do not have, or with underscores.
fn other_integer(number: i128, choice: usize, dialect: DialectName) -> String {
    match (number >= 0, choice % 4) {
        (true, 0) => format!("2#{}", grouped(&format!("{number:b}"), 4)),
        (true, 1) if !dialect.rules().lacks("octal-literal") => format!("8#{number:o}"),
        (true, 2) => format!("16#{}", grouped(&format!("{number:X}"), 2)),
        _ if number < 0 => format!("-{}", grouped(&number.unsigned_abs().to_string(), 3)),
        _ => grouped(&number.to_string(), 3),
    }
}

/// Inserts underscores between groups of digits, counted from the last digit.
fn grouped(digits: &str, size: usize) -> String {
    let mut grouped = String::with_capacity(digits.len() + digits.len() / size);
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(size) {
            grouped.push('_');
        }
        grouped.push(digit);
    }
    grouped
}

/// Spells a duration of whole milliseconds as `1d2h3m4s5ms`.
fn other_duration(nanoseconds: i64) -> Option<String> {
    const MILLISECOND: u64 = 1_000_000;
    let length = nanoseconds.unsigned_abs();
    if !length.is_multiple_of(MILLISECOND) {
        return None;
    }
    let mut left = length / MILLISECOND;
    let mut text = if nanoseconds < 0 {
        "-".to_owned()
    } else {
        String::new()
    };
    for (unit, milliseconds) in [
        ("d", 86_400_000),
        ("h", 3_600_000),
        ("m", 60_000),
        ("s", 1000),
        ("ms", 1),
    ] {
        let count = left / milliseconds;
        left %= milliseconds;
        if count > 0 || (unit == "ms" && length == 0) {
            text += &format!("{count}{unit}");
        }
    }
    Some(text)
}

/// Spells every other character by its code.
fn other_text(units: &[u16], ty: ElementaryType, choice: usize) -> Option<String> {
    let is_wide = ty == ElementaryType::Wstring;
    let quote = if is_wide { '"' } else { '\'' };
    let mut text = String::from(quote);
    for (place, &unit) in units.iter().enumerate() {
        let is_special = unit == u16::from(b'$') || unit == quote as u16;
        if is_special || (place + choice).is_multiple_of(2) {
            text += &if is_wide {
                format!("${unit:04X}")
            } else {
                format!("${unit:02X}")
            };
        } else {
            text.push(char::from_u32(u32::from(unit)).filter(char::is_ascii)?);
        }
    }
    text.push(quote);
    Some(text)
}
