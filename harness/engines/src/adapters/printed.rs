//! Parses the values that a driver prints: a line for each, with the number of the observation and the value.

use super::source::enumeration;
use crate::{NamedValue, Observation, RunRequest};
use stickler_types::{ElementaryType, Family, Value};

/// The kind of a printed value.
pub(super) enum PrintedKind<'r> {
    /// A value of an elementary type.
    Elementary(ElementaryType),
    /// The position of a value in the enumeration of this name, whose values are listed.
    Enumerated(&'r str, Vec<String>),
}

impl PrintedKind<'_> {
    /// Returns the value of an enumeration at this position, if there is one.
    pub(super) fn enumerated(&self, place: u64) -> Option<Value> {
        match self {
            PrintedKind::Enumerated(type_name, values) => {
                let name = values.get(usize::try_from(place).ok()?)?;
                Some(Value::enumerated(*type_name, name))
            }
            PrintedKind::Elementary(_) => None,
        }
    }
}

/// Returns the kinds of the values that a request observes, for a compiler that has values of the types of which `has` is true.
///
/// # Errors
/// A fragment that says what cannot be printed.
pub(super) fn kinds<'r>(
    request: &RunRequest<'r>,
    has: fn(ElementaryType) -> bool,
) -> Result<Vec<PrintedKind<'r>>, String> {
    let kind = |asked: &'r Observation| kind(asked, request, has);
    request.observe.iter().map(kind).collect()
}

fn kind<'r>(
    asked: &'r Observation,
    request: &RunRequest<'_>,
    has: fn(ElementaryType) -> bool,
) -> Result<PrintedKind<'r>, String> {
    match ElementaryType::from_name(&asked.type_name) {
        Some(ty) if has(ty) => Ok(PrintedKind::Elementary(ty)),
        Some(ty) => Err(format!("it has no values of {ty}")),
        None => match enumeration(request, &asked.type_name) {
            Some(values) => Ok(PrintedKind::Enumerated(&asked.type_name, values)),
            None if asked.type_name.is_empty() => Err(format!("the type of {} was not given", asked.name)),
            None => Err(format!("values of {} cannot be shown", asked.type_name)),
        },
    }
}

/// Parses the printed values, in the order asked for; `read` parses one, and returns `None` where it is no such value.
///
/// # Errors
/// A fragment that says what is wrong with the output.
pub(super) fn values(
    printed: &str,
    request: &RunRequest<'_>,
    kinds: &[PrintedKind<'_>],
    read: fn(&PrintedKind<'_>, &str) -> Option<Value>,
) -> Result<Vec<NamedValue>, String> {
    let mut values: Vec<Option<Value>> = kinds.iter().map(|_| None).collect();
    for line in printed.lines() {
        let nonsense = || format!("its driver printed `{line}`");
        let (number, shown) = line.split_once(' ').ok_or_else(nonsense)?;
        let number: usize = number.parse().map_err(|_| nonsense())?;
        let (kind, asked) = kinds
            .get(number)
            .zip(request.observe.get(number))
            .ok_or_else(nonsense)?;
        // A compiler's variable may hold what its type does not have, such as the position behind an enumeration.
        let no_value = || {
            format!(
                "{} is `{shown}`, which is no value of {}",
                asked.key(),
                asked.type_name
            )
        };
        values[number] = Some(read(kind, shown).ok_or_else(no_value)?);
    }
    let named = |(asked, value): (&Observation, Option<Value>)| {
        let missing = || format!("its driver did not print {}", asked.key());
        Ok((asked.key().to_string(), value.ok_or_else(missing)?))
    };
    request.observe.iter().zip(values).map(named).collect()
}

/// Returns the raw form of the bits of a variable. A BOOL that holds more than one bit is TRUE, as it is to every C condition.
pub(super) fn raw(ty: ElementaryType, bits: u64) -> u64 {
    match ty.family() {
        Family::Boolean => u64::from(bits != 0),
        Family::Real => bits,
        _ => ty.wrap(i128::from(bits)),
    }
}

/// Parses the code units of a text that is printed as four hexadecimal digits each; `None` where the digits are invalid.
pub(super) fn units(digits: &str) -> Option<Vec<u16>> {
    let units = digits.as_bytes().chunks(4);
    units
        .map(|unit| u16::from_str_radix(std::str::from_utf8(unit).ok()?, 16).ok())
        .collect()
}
