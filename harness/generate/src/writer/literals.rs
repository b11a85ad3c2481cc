//! Writing of the literals of the model as source text.

use super::notation::long_prefix;
use super::source_writer::SourceWriter;
use crate::model::LiteralForm;
use std::fmt::Write as _;
use stickler_types::{ElementaryType, Family, Value};

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
