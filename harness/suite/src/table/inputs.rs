//! The values that a row of a matrix takes in a probe, by the key `values`; and the values beside one that must arrive.

use std::borrow::Cow;

use toml::Spanned;

use crate::error::Mistake;
use crate::frame::FileContext;
use crate::table::probe::Probe;
use crate::table::types::{RowInput, TypeInfo};
use crate::toml_text::{Scalar, TextOr};
use stickler_types::{ElementaryType, Value};

/// Returns the values of a row whose line in the file is `line`.
pub(crate) fn of_row<'t>(
    probe: &Probe<'_>,
    row: &'t TypeInfo,
    line: u32,
    context: &FileContext<'_>,
    mistakes: &mut Vec<Mistake>,
) -> Cow<'t, [RowInput]> {
    let boundaries = || Cow::Borrowed(&*row.boundaries);
    let ordinary = || Cow::Borrowed(row.ordinary.as_slice());
    let inputs = match &probe.key.values {
        None if probe.takes_values() => boundaries(),
        None => ordinary(),
        Some(values) => match values.get_ref() {
            TextOr::Text(word) if word == "boundaries" => boundaries(),
            TextOr::Text(word) if word == "one" => ordinary(),
            TextOr::Text(word) if word == "telling" => Cow::Borrowed(row.telling.as_slice()),
            TextOr::Text(word) => {
                let message =
                    format!("`{word}` is no set of values; there are boundaries, one and telling, and lists");
                mistakes.push(context.lines.mistake(values, "probe.values", message));
                return Cow::default();
            }
            TextOr::List(list) if !list.is_empty() => return listed(list, row, context, mistakes).into(),
            TextOr::List(_) => Cow::default(),
        },
    };
    if inputs.is_empty() && probe.takes_values() {
        let message = format!("{} has no values for the probe `{}`", row.name, probe.name);
        mistakes.push(Mistake::new(line, message).hint(format!("give [types.{}] `values`", row.name)));
    }
    inputs
}

fn listed(
    list: &[Spanned<Scalar>],
    row: &TypeInfo,
    context: &FileContext<'_>,
    mistakes: &mut Vec<Mistake>,
) -> Vec<RowInput> {
    let mut inputs = Vec::new();
    for item in list {
        let literal = context.spelling(item);
        match row.input(&literal) {
            Some(input) => inputs.push(input),
            None => {
                let message = format!("`{literal}` is no literal of {}", row.name);
                mistakes.push(context.lines.mistake(item, "probe.values", message));
            }
        }
    }
    inputs
}

/// The placeholders of a smaller value and of a greater one.
pub(crate) const BESIDE: [&str; 2] = ["below", "above"];

/// Returns a value of the same type that is less and one that is greater, as untyped literals; the value itself where the type
/// has none, or no order.
pub(crate) fn beside(value: &Value) -> [String; 2] {
    let Value::Plain { ty, raw } = *value else {
        return [value.literal(), value.literal()];
    };
    let neighbours = match ty.integer_range() {
        Some(range) if ty.is_integer() || ty.is_bit_string() => Some(whole(ty, raw, range)),
        _ if ty.is_real() => real(ty, value),
        _ => None,
    };
    neighbours.unwrap_or_else(|| [value.literal(), value.literal()])
}

/// Returns the numbers before and behind a number, as far as the type has them.
fn whole(ty: ElementaryType, raw: u64, (least, greatest): (i128, i128)) -> [String; 2] {
    [-1, 1].map(|step| {
        let number = (ty.integer_value(raw) + step).clamp(least, greatest);
        Value::plain(ty, ty.wrap(number)).literal()
    })
}

/// Returns zero on the one side of a real number, and a number twice as far from zero on the other.
fn real(ty: ElementaryType, value: &Value) -> Option<[String; 2]> {
    let number: f64 = value
        .without_type()
        .parse()
        .ok()
        .filter(|number: &f64| number.is_finite())?;
    let literal = |number: f64| {
        Value::parse(&format!("{ty}#{number:?}"))
            .ok()
            .map(|found| found.literal())
    };
    Some([
        literal(if number > 0.0 { 0.0 } else { 2.0 * number - 1.0 })?,
        literal(if number < 0.0 { 0.0 } else { 2.0 * number + 1.0 })?,
    ])
}
