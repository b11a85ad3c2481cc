//! The values that a row of a matrix takes in a probe: the key `values`.

use std::borrow::Cow;

use toml::Spanned;

use crate::error::Mistake;
use crate::frame::FileContext;
use crate::table::probe::Probe;
use crate::table::types::{RowInput, TypeInfo};
use crate::toml_text::{Scalar, TextOr};

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
