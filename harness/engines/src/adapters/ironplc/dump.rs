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

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType as E;

    /// The output of `ironplcvm run --scans 1 --dump-vars` 0.239; `big` is a variable of the program and of a function.
    const RECORDED: &str = "big: 100000\nsmall: 8\nstr: 0\nr: 1.5\nt: T#1500ms\nd: 1709164800\ntd: 45296000\nw: 16#00AB\n\
                            b: TRUE\narr: 260\nx: 1\nbig: 7\nF: 8\n";

    #[test]
    fn a_name_is_found_in_any_case_and_one_of_several_is_not_guessed() {
        let dump = Dump::read(RECORDED);
        assert_eq!(dump.find("SMALL"), Shown::Value("8"));
        assert_eq!(dump.find("big"), Shown::Ambiguous);
        assert_eq!(dump.find("y"), Shown::Missing);
        assert_eq!(Dump::read("").find("y"), Shown::Missing);
    }

    #[test]
    fn values_are_read_by_their_types() {
        for (ty, shown, literal) in [
            (E::Int, "8", "INT#8"),
            (E::Lint, "-9223372036854775808", "LINT#-9223372036854775808"),
            (E::Bool, "TRUE", "BOOL#TRUE"),
            (E::Word, "16#00AB", "WORD#16#00AB"),
            (E::Real, "1.5", "REAL#1.5"),
            (
                E::Real,
                "340282350000000000000000000000000000000",
                "REAL#3.4028235E38",
            ),
            (E::Lreal, "-0", "LREAL#-0.0"),
            (E::Lreal, "inf", "LREAL#Infinity"),
            (E::Real, "NaN", "REAL#NaN"),
            (E::Time, "T#1500ms", "TIME#1500ms"),
            (E::Time, "T#-5ms", "TIME#-5ms"),
            (E::Ltime, "LTIME#7ms", "LTIME#7ms"),
            (E::Date, "1709164800", "DATE#2024-02-29"),
            (E::Date, "-23296", "DATE#2106-02-07"),
            (E::Tod, "45296789", "TOD#12:34:56.789"),
            (E::Dt, "1709164801", "DT#2024-02-29-00:00:01"),
        ] {
            assert_eq!(value(ty, shown), Ok(Value::parse(literal).unwrap()), "{shown}");
        }
        for (ty, shown) in [
            (E::Int, "x"),
            (E::Int, "32768"),
            (E::Bool, "2"),
            (E::Real, "x"),
            (E::Date, ""),
        ] {
            assert!(value(ty, shown).is_err(), "{shown}");
        }
    }
}
