//! Parses the variables that `ironplcvm run --dump-vars` prints, one `NAME: VALUE` a line.
//!
//! Basis: ironplc: measured on version 0.239. `TRUE`, `-5`, `16#00AB`, `T#1500ms`, reals in decimal digits without an
//! exponent, `inf`, `NaN`; dates in seconds since 1970 and times of day in milliseconds, both as the signed number of their
//! 32 bits.

use crate::adapters::values::real;
use stickler_types::{ElementaryType, Value};

/// The printed variables of a program and of all that it calls.
pub(super) struct Dump<'d> {
    lines: Vec<(&'d str, &'d str)>,
}

/// The entry of a dump for a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Shown<'d> {
    /// The value of the variable.
    Value(&'d str),
    /// Several variables have the name, in different parts of the program.
    Ambiguous,
    /// The dump does not have the name.
    Missing,
}

impl<'d> Dump<'d> {
    /// Parses the output of the virtual machine.
    pub(super) fn read(text: &'d str) -> Dump<'d> {
        Dump {
            lines: text.lines().filter_map(|line| line.split_once(": ")).collect(),
        }
    }

    /// Returns the entry of a variable, in any case of its name.
    pub(super) fn find(&self, name: &str) -> Shown<'d> {
        let mut found = self
            .lines
            .iter()
            .filter(|(other, _)| other.eq_ignore_ascii_case(name));
        match (found.next(), found.next()) {
            (Some((_, value)), None) => Shown::Value(value),
            (Some(_), Some(_)) => Shown::Ambiguous,
            (None, _) => Shown::Missing,
        }
    }
}

/// Parses the value of an elementary type.
///
/// # Errors
/// A fragment that says what is wrong with the value.
pub(super) fn value(ty: ElementaryType, shown: &str) -> Result<Value, String> {
    let shown = shown.trim();
    let wrong = || format!("it shows `{shown}` as {ty}");
    if ty.is_real() {
        return real(ty, shown).ok_or_else(wrong);
    }
    match ty {
        ElementaryType::Date | ElementaryType::Dt => of_32_bits(ty, shown, 1_000_000_000).ok_or_else(wrong),
        ElementaryType::Tod => of_32_bits(ty, shown, 1_000_000).ok_or_else(wrong),
        _ => {
            // A duration has a prefix of its own.
            let bare = shown.strip_prefix("T#").or(shown.strip_prefix("LTIME#"));
            let literal = format!("{ty}#{}", bare.unwrap_or(shown));
            Value::parse_observed(&literal).map_err(|_| wrong())
        }
    }
}

/// Converts a count of units of `nanoseconds` each, of which the virtual machine keeps 32 bits without a sign.
fn of_32_bits(ty: ElementaryType, shown: &str, nanoseconds: i64) -> Option<Value> {
    let count = shown.parse::<i32>().ok()?.cast_unsigned();
    let nanoseconds = i64::from(count).checked_mul(nanoseconds)?;
    Some(Value::plain(ty, nanoseconds.cast_unsigned()))
}
