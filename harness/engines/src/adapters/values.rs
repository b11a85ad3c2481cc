//! Statements by which a driver prints observed values for a person, and the reading back of what it printed.

use super::source::enumeration;
use crate::{NamedValue, Observation, RunRequest};
use std::collections::BTreeMap;
use stickler_types::{ElementaryType, Value, join};

/// The kind of an observed value.
#[derive(Clone, Debug)]
pub(super) enum ObservedKind<'r> {
    /// A value of an elementary type.
    Elementary(ElementaryType),
    /// A position in the enumeration of this name, whose values are listed.
    Enumerated(&'r str, Vec<String>),
}

/// Returns the kinds of the values that a request observes, for a compiler that has values of the types of which `has` is true.
///
/// # Errors
/// A fragment that says what cannot be printed.
pub(super) fn kinds<'r>(
    request: &RunRequest<'r>,
    has: fn(ElementaryType) -> bool,
) -> Result<Vec<ObservedKind<'r>>, String> {
    let kind = |asked: &'r Observation| match ElementaryType::from_name(&asked.type_name) {
        Some(ty) if has(ty) => Ok(ObservedKind::Elementary(ty)),
        Some(ty) => Err(format!("it has no values of {ty}")),
        None => match enumeration(request, &asked.type_name) {
            Some(values) => Ok(ObservedKind::Enumerated(&asked.type_name, values)),
            None if asked.type_name.is_empty() => Err(format!("the type of {} was not given", asked.name)),
            None => Err(format!("values of {} cannot be shown", asked.type_name)),
        },
    };
    request.observe.iter().map(kind).collect()
}

/// The C or C++ expression for an observed value.
pub(super) enum ValueExpression {
    /// A number.
    Number(String),
    /// A structure of seconds and nanoseconds.
    Timespec(String),
    /// A number of nanoseconds.
    Nanoseconds(String),
    /// A number of days.
    Days(String),
    /// A text: the condition under which it has a unit `at`, and that unit.
    Text { condition: String, unit: String },
}

/// The functions that print the characters of a text and a date, by their names. The numbers behind a date keep apart what the
/// date shows alike.
const FUNCTIONS: [(&str, &str); 4] = [
    ("print_character(", include_str!("driver/print_character.c")),
    (
        "print_wide_character(",
        include_str!("driver/print_wide_character.c"),
    ),
    ("print_date(", include_str!("driver/print_date.c")),
    ("print_days(", include_str!("driver/print_days.c")),
];

/// Returns the functions that statements call.
pub(super) fn functions(statements: &str) -> String {
    let called = FUNCTIONS.iter().filter(|(call, _)| statements.contains(call));
    called.map(|(_, text)| *text).collect()
}

/// Returns the statement that prints an observed value.
pub(super) fn statement(asked: &Observation, kind: &ObservedKind<'_>, value: &ValueExpression) -> String {
    let name = asked.key().to_string().replace('\\', "\\\\").replace('"', "\\\"");
    let format = name.replace('%', "%%");
    let ty = match kind {
        ObservedKind::Elementary(ty) => *ty,
        ObservedKind::Enumerated(..) => ElementaryType::Int,
    };
    let date =
        |seconds: &str, rest: &str| format!("print_date(\"{name}\", \"{}\", {seconds}, {rest});", date(ty));
    match (kind, value) {
        (_, ValueExpression::Text { condition, unit }) => {
            let print = match ty {
                ElementaryType::Wstring => "print_wide_character",
                _ => "print_character",
            };
            format!(
                "printf(\"{format} = '\"); for (int at = 0; {condition}; at++) {print}({unit}); printf(\"'\\n\");"
            )
        }
        (_, ValueExpression::Timespec(value)) if ty.is_duration() => format!(
            "printf(\"{format} = %lld s + %lld ns\\n\", (long long){value}.tv_sec, (long long){value}.tv_nsec);"
        ),
        (_, ValueExpression::Nanoseconds(value)) if ty.is_duration() => {
            format!("printf(\"{format} = %lld ns\\n\", (long long){value});")
        }
        (_, ValueExpression::Timespec(value)) => {
            date(&format!("{value}.tv_sec"), &format!("{value}.tv_nsec"))
        }
        (_, ValueExpression::Nanoseconds(value)) => {
            date(&format!("{value} / 1000000000"), &format!("{value} % 1000000000"))
        }
        (_, ValueExpression::Days(value)) => format!("print_days(\"{name}\", {value});"),
        (ObservedKind::Enumerated(_, values), ValueExpression::Number(value)) => {
            let numbered = values.iter().enumerate();
            let numbered = join(numbered.map(|(number, name)| format!("{number} {name}")), ", ");
            format!("printf(\"{format} = %d (of {numbered})\\n\", (int){value});")
        }
        (ObservedKind::Elementary(_), ValueExpression::Number(value)) => {
            let (form, cast) = number(ty);
            format!("printf(\"{format} = {form}\\n\", ({cast}){value});")
        }
    }
}

/// Returns the form in which C prints a value of a type, and the C type which that takes. Real numbers have as many digits as
/// tell them apart.
fn number(ty: ElementaryType) -> (&'static str, &'static str) {
    match ty {
        ElementaryType::Lint => ("%lld", "long long"),
        ElementaryType::Ulint => ("%llu", "unsigned long long"),
        ElementaryType::Usint | ElementaryType::Uint | ElementaryType::Udint => ("%u", "unsigned"),
        ElementaryType::Byte | ElementaryType::Char => ("16#%02X", "unsigned"),
        ElementaryType::Word | ElementaryType::Wchar => ("16#%04X", "unsigned"),
        ElementaryType::Dword => ("16#%08X", "unsigned"),
        ElementaryType::Lword => ("16#%016llX", "unsigned long long"),
        ElementaryType::Real => ("%.9g", "double"),
        ElementaryType::Lreal => ("%.17g", "double"),
        _ => ("%d", "int"),
    }
}

/// Returns the format of a date for `strftime`.
fn date(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Date | ElementaryType::Ldate => "%Y-%m-%d",
        ElementaryType::Tod | ElementaryType::Ltod => "%H:%M:%S",
        _ => "%Y-%m-%d %H:%M:%S",
    }
}

/// The nanoseconds of a day.
const NANOSECONDS_A_DAY: i128 = 86_400_000_000_000;

/// Reads the values that a driver printed of a program, in the order asked for.
///
/// # Errors
/// A fragment that says what is wrong with the output.
pub(super) fn values(
    printed: &str,
    request: &RunRequest<'_>,
    kinds: &[ObservedKind<'_>],
) -> Result<Vec<NamedValue>, String> {
    let mut shown: BTreeMap<&str, &str> = BTreeMap::new();
    for line in printed.lines() {
        let (key, value) = line
            .split_once(" = ")
            .ok_or_else(|| format!("its driver printed `{line}`"))?;
        shown.insert(key, value);
    }
    let named = |(asked, kind): (&Observation, &ObservedKind<'_>)| {
        let key = asked.key().to_string();
        let shown = shown
            .get(&*key)
            .ok_or_else(|| format!("its driver did not print {key}"))?;
        // A compiler's variable may hold what its type does not have, such as the position behind an enumeration.
        let value = value(kind, shown)
            .ok_or_else(|| format!("{key} is `{shown}`, which is no value of {}", asked.type_name))?;
        Ok((key, value))
    };
    request.observe.iter().zip(kinds).map(named).collect()
}

/// Reads a printed value; `None` where the text is no such value.
pub(super) fn value(kind: &ObservedKind<'_>, shown: &str) -> Option<Value> {
    let ty = match kind {
        ObservedKind::Enumerated(type_name, values) => {
            let (place, _) = shown.split_once(" (of ")?;
            let name = values.get(place.parse::<usize>().ok()?)?;
            return Some(Value::enumerated(*type_name, name));
        }
        ObservedKind::Elementary(ty) => *ty,
    };
    if ty.is_text() {
        let inside = shown.strip_prefix('\'')?.strip_suffix('\'')?;
        return Some(Value::text(ty, units(ty, inside)?));
    }
    if ty.is_moment() {
        return Some(Value::of_nanoseconds(ty, nanoseconds(shown)?));
    }
    if ty.is_real() {
        return real(ty, shown);
    }
    let number = match shown.strip_prefix("16#") {
        Some(digits) => i128::from(u64::from_str_radix(digits, 16).ok()?),
        None => shown.parse().ok()?,
    };
    // A BOOL that holds more than one bit is TRUE, as it is to every C condition.
    let raw = match ty {
        ElementaryType::Bool => u64::from(number != 0),
        _ => ty.wrap(number),
    };
    Some(Value::plain(ty, raw))
}

/// Reads a real number. Decimal digits are rounded to the type once; `inf` and `nan` are what C and Rust write.
pub(super) fn real(ty: ElementaryType, shown: &str) -> Option<Value> {
    let raw = match ty {
        ElementaryType::Real => u64::from(shown.parse::<f32>().ok()?.to_bits()),
        _ => shown.parse::<f64>().ok()?.to_bits(),
    };
    Some(Value::plain(ty, raw))
}

/// Reads the units of a text, which are printed as themselves, or in hexadecimal digits behind a `$`.
fn units(ty: ElementaryType, mut shown: &str) -> Option<Vec<u16>> {
    let digits = if ty == ElementaryType::Wstring { 4 } else { 2 };
    let mut units = Vec::with_capacity(shown.len());
    while let Some(first) = shown.chars().next() {
        let length = match first {
            '$' => {
                units.push(u16::from_str_radix(shown.get(1..=digits)?, 16).ok()?);
                1 + digits
            }
            _ => {
                units.push(u16::try_from(u32::from(first)).ok()?);
                first.len_utf8()
            }
        };
        shown = &shown[length..];
    }
    Some(units)
}

/// Reads a duration or a moment: `5 ns`, `1 s + 5 ns`, or the latter or `5 d` in parentheses behind a date.
fn nanoseconds(shown: &str) -> Option<i128> {
    let shown = match shown.rsplit_once('(') {
        Some((_, inside)) => inside.strip_suffix(')')?,
        None => shown,
    };
    if let Some(days) = shown.strip_suffix(" d") {
        return Some(i128::from(days.parse::<i64>().ok()?) * NANOSECONDS_A_DAY);
    }
    let (seconds, rest) = shown.split_once(" s + ").unwrap_or(("0", shown));
    let (seconds, rest): (i64, i64) = (seconds.parse().ok()?, rest.strip_suffix(" ns")?.parse().ok()?);
    Some(i128::from(seconds) * 1_000_000_000 + i128::from(rest))
}
