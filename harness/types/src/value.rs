//! Typed values: how they are parsed, written and compared.

use crate::elementary::{ElementaryType, Family};
use crate::literal::{self, LiteralError};
use std::fmt;

/// What stands between a real number and the units in the last place by which another may differ from it.
pub(crate) const WITHIN: &str = " within ";

/// A value together with its type.
///
/// Two values are equal only if their types are the same and so are their bits. That makes -0.0 differ from 0.0, and it makes a
/// NaN equal to every NaN of its type: no literal can tell one from another. The names of enumerations compare without case.
///
/// `Display` gives the one canonical spelling, a typed literal such as `INT#-5`, which [`Value::parse`] reads back.
#[derive(Clone, Debug)]
pub enum Value {
    /// A value of any elementary type except the texts.
    Plain {
        /// The type, which is neither `STRING` nor `WSTRING`.
        ty: ElementaryType,
        /// The raw form of the value: see [`ElementaryType`].
        raw: u64,
    },
    /// A character string.
    Text {
        /// `STRING` or `WSTRING`.
        ty: ElementaryType,
        /// The code units; those of a `STRING` are at most 16#FF.
        units: Vec<u16>,
    },
    /// A duration, date or time of day that a compiler's variable holds and that its type does not have. No program and no
    /// expectation has such a value.
    OutOfRange {
        /// The type: a duration, a date or a time of day.
        ty: ElementaryType,
        /// The nanoseconds, which 64 bits with sign do not hold.
        nanoseconds: i128,
    },
    /// A finite real number to which another is near: that of an expectation, and of nothing else. Its spelling is `REAL#1.4142135 within 2`.
    Near {
        /// `REAL` or `LREAL`.
        ty: ElementaryType,
        /// The raw form of the number.
        raw: u64,
        /// The number of units in the last place by which the other may differ.
        units: u32,
    },
    /// A value of an enumeration.
    Enumerated {
        /// The name of the enumeration.
        type_name: String,
        /// The name of the value.
        value_name: String,
    },
}

impl Value {
    /// Returns a value of any elementary type except the texts, from its raw form.
    pub const fn plain(ty: ElementaryType, raw: u64) -> Value {
        Value::Plain { ty, raw }
    }

    /// Returns a character string, from `STRING` or `WSTRING` and its code units.
    pub const fn text(ty: ElementaryType, units: Vec<u16>) -> Value {
        Value::Text { ty, units }
    }

    /// Returns a value of an enumeration, from the names of both.
    pub fn enumerated(type_name: impl Into<String>, value_name: impl Into<String>) -> Value {
        Value::Enumerated {
            type_name: type_name.into(),
            value_name: value_name.into(),
        }
    }

    /// Returns the keyword of the type, or the name of the enumeration.
    pub fn type_name(&self) -> &str {
        match self {
            Value::Plain { ty, .. }
            | Value::Text { ty, .. }
            | Value::OutOfRange { ty, .. }
            | Value::Near { ty, .. } => ty.name(),
            Value::Enumerated { type_name, .. } => type_name,
        }
    }

    /// Returns the elementary type of a value that its type has; `None` for a value of an enumeration, and for one that no program has.
    pub const fn elementary(&self) -> Option<ElementaryType> {
        match self {
            Value::Plain { ty, .. } | Value::Text { ty, .. } => Some(*ty),
            Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => None,
        }
    }

    /// Returns the canonical literal without its type: `-5`, `16#00FF`, `'a$'b'`, `RED`. For types whose literals must have
    /// a prefix (durations, dates) the result is not a literal of the language.
    pub fn without_type(&self) -> String {
        let typed = self.to_string();
        // The canonical spelling always has a type, and no name of a type has a `#`.
        let start = typed.find('#').map_or(0, |sign| sign + 1);
        typed[start..].to_owned()
    }

    /// Returns a number as a value of `REAL`, to which it is rounded, or else of `LREAL`.
    pub fn of_real(ty: ElementaryType, number: f64) -> Value {
        Value::plain(ty, ty.real_bits(number))
    }

    /// Returns whether a BOOL is TRUE; `None` for other values.
    pub fn truth(&self) -> Option<bool> {
        match *self {
            Value::Plain { ty, raw } => (ty == ElementaryType::Bool).then_some(raw != 0),
            _ => None,
        }
    }

    /// Returns the number of a `REAL` or `LREAL`, exactly; `None` for values of other types.
    pub fn real(&self) -> Option<f64> {
        match *self {
            Value::Plain { ty, raw } => ty.real_value(raw),
            _ => None,
        }
    }

    /// Returns the literal that a program writes for the value where its type is expected: without the type, or with it for
    /// durations, dates and enumerations.
    pub fn literal(&self) -> String {
        match self {
            Value::Plain { ty, .. } if ty.is_moment() => self.to_string(),
            Value::Plain { .. } | Value::Text { .. } => self.without_type(),
            Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => self.to_string(),
        }
    }

    /// Parses a typed literal in any spelling that the standard allows: `INT#-5`, `word#16#ff`, `T#1d2h`, `BOOL#TRUE`,
    /// `STRING#'a$'b'`, `COLOR#RED`.
    ///
    /// A prefix that names no elementary type names an enumeration. `REAL` and `LREAL` also have `NaN`, `Infinity` and
    /// `-Infinity`, in any case. What a variable holds that should not is spelled so that no two values look alike: a date with
    /// a time of that day, `DATE#2024-02-29-12:00:00`, and a time of day outside the day as a duration, `TOD#86400000000000ns`.
    /// The text must contain nothing but the literal, not even blanks.
    ///
    /// # Errors
    /// A [`LiteralError`] with its offset in `literal`; `Overflow` where the type has no such value.
    ///
    /// Basis: iec-61131-3: Tables 5 to 9; harness/engines/README.md (how values are written) for what is not finite.
    pub fn parse(literal: &str) -> Result<Value, LiteralError> {
        let Some((prefix, rest)) = literal.split_once('#') else {
            return Err(LiteralError::malformed(0, "a typed literal such as `INT#5`"));
        };
        let behind = prefix.len() + 1;
        let Some(ty) = ElementaryType::from_literal_prefix(prefix) else {
            return enumerated(prefix, rest, behind);
        };
        let value = match ty.is_text() {
            true => text_of_type(rest, ty).map(|units| Value::text(ty, units)),
            false => plain_of_type(rest, ty).map(|raw| Value::plain(ty, raw)),
        };
        value.map_err(|error| error.shifted(behind))
    }
}

/// Returns the raw form of a plain literal without its prefix.
fn plain_of_type(rest: &str, ty: ElementaryType) -> Result<u64, LiteralError> {
    match ty.family() {
        Family::Boolean => boolean(rest),
        Family::Signed | Family::Unsigned => ranged(literal::integer(rest), ty),
        Family::BitString => {
            // No type holds the greatest number.
            let value = i128::try_from(literal::unsigned_integer(rest)?);
            ranged(Ok(value.unwrap_or(i128::MAX)), ty)
        }
        Family::Real => not_finite(rest, ty).map_or_else(|| literal::real(rest, ty), Ok),
        Family::Duration => literal::duration(rest).map(i64::cast_unsigned),
        Family::Date => otherwise(literal::date(rest), || literal::date_and_time(rest), is_whole_day),
        Family::TimeOfDay => otherwise(
            literal::time_of_day(rest),
            || literal::duration(rest),
            is_within_a_day,
        ),
        Family::DateAndTime => literal::date_and_time(rest).map(i64::cast_unsigned),
        Family::Text | Family::Character => match text_of_type(rest, ty)?[..] {
            [unit] => Ok(u64::from(unit)),
            _ => Err(LiteralError::malformed(1, "exactly one character")),
        },
    }
}

/// Nanoseconds in a day.
const DAY: i64 = 86_400_000_000_000;

fn is_whole_day(nanoseconds: i64) -> bool {
    nanoseconds.rem_euclid(DAY) == 0
}

fn is_within_a_day(nanoseconds: i64) -> bool {
    (0..DAY).contains(&nanoseconds)
}

/// Returns the raw form of a literal, or of a value that no literal of its type stands for, in the spelling of another type. Such
/// a spelling of a value that has a literal is an error.
fn otherwise(
    read: Result<i64, LiteralError>,
    of_other: impl FnOnce() -> Result<i64, LiteralError>,
    has_a_literal: fn(i64) -> bool,
) -> Result<u64, LiteralError> {
    let read = read.or_else(|error| {
        of_other()
            .ok()
            .filter(|value| !has_a_literal(*value))
            .ok_or(error)
    });
    read.map(i64::cast_unsigned)
}

/// Parses `0`, `1`, `FALSE` or `TRUE`.
fn boolean(rest: &str) -> Result<u64, LiteralError> {
    if rest.eq_ignore_ascii_case("TRUE") || rest == "1" {
        Ok(1)
    } else if rest.eq_ignore_ascii_case("FALSE") || rest == "0" {
        Ok(0)
    } else if literal::integer(rest).is_ok() {
        Err(LiteralError::overflow(0, "BOOL"))
    } else {
        Err(LiteralError::malformed(0, "`TRUE`, `FALSE`, `1` or `0`"))
    }
}

/// Returns the raw form of a number, if it is within the range of the type.
fn ranged(value: Result<i128, LiteralError>, ty: ElementaryType) -> Result<u64, LiteralError> {
    let out_of_range = LiteralError::overflow(0, ty.name());
    match value {
        Ok(value) if ty.holds(value) => Ok(ty.wrap(value)),
        Ok(_) | Err(LiteralError::Overflow { .. }) => Err(out_of_range),
        Err(error) => Err(error),
    }
}

/// Returns the raw form of a NaN or an infinity, if the text is one of Stickler's words for them.
fn not_finite(rest: &str, ty: ElementaryType) -> Option<u64> {
    let words = [
        ("NaN", f64::NAN),
        ("Infinity", f64::INFINITY),
        ("-Infinity", f64::NEG_INFINITY),
    ];
    let (_, number) = words
        .into_iter()
        .find(|(word, _)| rest.eq_ignore_ascii_case(word))?;
    Some(ty.real_bits(number))
}

/// Returns the code units of a text or character, whose quotes must be those of the type.
fn text_of_type(rest: &str, ty: ElementaryType) -> Result<Vec<u16>, LiteralError> {
    let (quote, expected) = if is_wide(ty) {
        ('"', "a double quote")
    } else {
        ('\'', "a single quote")
    };
    if !rest.starts_with(quote) {
        return Err(LiteralError::malformed(0, expected));
    }
    literal::text(rest)
}

const fn is_wide(ty: ElementaryType) -> bool {
    matches!(ty, ElementaryType::Wstring | ElementaryType::Wchar)
}

/// Parses a value of an enumeration, where `behind` is the offset of `value_name`.
fn enumerated(type_name: &str, value_name: &str, behind: usize) -> Result<Value, LiteralError> {
    if !is_identifier(type_name) {
        return Err(LiteralError::malformed(0, "the name of a type"));
    }
    if !is_identifier(value_name) {
        return Err(LiteralError::malformed(behind, "the name of an enumerated value"));
    }
    Ok(Value::enumerated(type_name, value_name))
}

fn is_identifier(name: &str) -> bool {
    name.bytes()
        .all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
        && name.bytes().next().is_some_and(|byte| !byte.is_ascii_digit())
}

impl fmt::Display for Value {
    /// Writes the canonical spelling.
    ///
    /// Basis: harness/engines/README.md (how values are written).
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}#", self.type_name())?;
        match self {
            Value::Plain { ty, raw } => write_plain(f, *ty, *raw),
            Value::Text { ty, units } => literal::write_text(f, units, is_wide(*ty)),
            Value::OutOfRange { nanoseconds, .. } => literal::write_nanoseconds(f, *nanoseconds),
            Value::Near { ty, raw, units } => {
                write_plain(f, *ty, *raw)?;
                write!(f, "{WITHIN}{units}")
            }
            Value::Enumerated { value_name, .. } => f.write_str(value_name),
        }
    }
}

fn write_plain(f: &mut fmt::Formatter<'_>, ty: ElementaryType, raw: u64) -> fmt::Result {
    match ty.family() {
        Family::Boolean => f.write_str(if raw == 0 { "FALSE" } else { "TRUE" }),
        Family::Signed | Family::Unsigned => write!(f, "{}", ty.integer_value(raw)),
        Family::BitString => write!(f, "16#{raw:0width$X}", width = ty.bits() as usize / 4),
        Family::Real => literal::write_real(f, raw, ty),
        Family::Duration if ty == ElementaryType::Time => literal::write_milliseconds(f, raw.cast_signed()),
        Family::Duration => literal::write_nanoseconds(f, raw.cast_signed().into()),
        Family::Date if !is_whole_day(raw.cast_signed()) => {
            literal::write_date_and_time(f, raw.cast_signed())
        }
        Family::Date => literal::write_date(f, raw.cast_signed()),
        Family::TimeOfDay if !is_within_a_day(raw.cast_signed()) => {
            literal::write_nanoseconds(f, raw.cast_signed().into())
        }
        Family::TimeOfDay => literal::write_time_of_day(f, raw.cast_signed()),
        Family::DateAndTime => literal::write_date_and_time(f, raw.cast_signed()),
        Family::Text | Family::Character => literal::write_text(f, &[raw as u16], is_wide(ty)),
    }
}

impl PartialEq for Value {
    fn eq(&self, other: &Value) -> bool {
        match (self, other) {
            (
                Value::Enumerated {
                    type_name,
                    value_name,
                },
                Value::Enumerated {
                    type_name: other_type,
                    value_name: other_value,
                },
            ) => type_name.eq_ignore_ascii_case(other_type) && value_name.eq_ignore_ascii_case(other_value),
            _ if self.type_name() != other.type_name() => false,
            (&Value::Plain { ty, raw }, &Value::Plain { raw: other, .. }) => {
                raw == other || (is_nan(ty, raw) && is_nan(ty, other))
            }
            (Value::Text { units, .. }, Value::Text { units: other, .. }) => units == other,
            (Value::OutOfRange { nanoseconds: a, .. }, Value::OutOfRange { nanoseconds: b, .. }) => a == b,
            (&Value::Near { raw, units, .. }, &Value::Near { raw: a, units: b, .. }) => {
                (raw, units) == (a, b)
            }
            _ => false,
        }
    }
}

impl Eq for Value {}

fn is_nan(ty: ElementaryType, raw: u64) -> bool {
    ty.real_value(raw).is_some_and(f64::is_nan)
}
