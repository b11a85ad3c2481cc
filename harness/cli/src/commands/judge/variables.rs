//! The elementary variables of a program that is judged, and the values that a trace gives for them.

use super::caller::Judged;
use anyhow::{Context, bail, ensure};
use serde_json::Value as Json;
use std::sync::Arc;
use stickler_types::dialect_file::nearest;
use stickler_types::{ElementaryType, Value};

/// The maximum number of elementary variables of a program that is judged.
pub(super) const MAX_VARIABLES: usize = 100_000;

/// The number of variables that a message lists.
const LISTED: usize = 12;

/// The elementary variables of a program, with the values at its start, which tell their types.
pub(super) struct Variables {
    /// The path of each, as the program names it, and the value.
    list: Vec<(Arc<str>, Value)>,
}

impl Variables {
    /// Takes the variables with their values.
    pub(super) fn new(values: Vec<(String, Value)>) -> Variables {
        let list = values.into_iter().map(|(name, value)| (name.into(), value));
        Variables { list: list.collect() }
    }

    /// Returns the elementary variables with the values that a trace gives for a variable by the name that it has there.
    ///
    /// # Errors
    /// A name that the program does not have; a value that is none of the variable's type, or has more parts.
    pub(super) fn spread(
        &self,
        judged: &Judged,
        name: &str,
        given: &Json,
    ) -> anyhow::Result<Vec<(Arc<str>, Value)>> {
        let of_program = judged.path(name);
        let paths = judged
            .prefixes
            .iter()
            .map(|prefix| format!("{prefix}{of_program}"));
        let Some(path) = paths.into_iter().find(|path| self.has(path)) else {
            let known: Vec<String> = self.list.iter().map(|(known, _)| judged.shown(known)).collect();
            if let Some(meant) = nearest(name, known.iter().map(String::as_str)) {
                bail!("there is no variable `{name}`; did you mean `{meant}`?");
            }
            let more = if known.len() > LISTED { ", …" } else { "" };
            let shown = &known[..known.len().min(LISTED)];
            bail!(
                "there is no variable `{name}`; there are {}{more}",
                shown.join(", ")
            );
        };
        let mut found = Vec::new();
        self.of_path(&path, given, &mut found)
            .with_context(|| format!("`{name}`"))?;
        Ok(found)
    }

    /// Returns whether a path names an elementary variable, or one with elements or fields.
    fn has(&self, path: &str) -> bool {
        self.list.iter().any(|(known, _)| {
            let rest = start_of(known, path);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['[', '.']))
        })
    }

    fn of_path(&self, path: &str, given: &Json, found: &mut Vec<(Arc<str>, Value)>) -> anyhow::Result<()> {
        let elementary = self
            .list
            .iter()
            .find(|(known, _)| known.eq_ignore_ascii_case(path));
        match (elementary, given) {
            (Some((known, like)), _) => {
                let value = value(given, like).with_context(|| {
                    let hint = match like {
                        Value::Plain { ty, .. } if ty.is_duration() => "; write a duration as \"T#10ms\"",
                        _ => "",
                    };
                    format!("{given} is no value of {}{hint}", like.type_name())
                })?;
                found.push((Arc::clone(known), value));
                Ok(())
            }
            (None, Json::Object(fields)) => fields.iter().try_for_each(|(field, given)| {
                let path = format!("{path}.{field}");
                ensure!(self.has(&path), "there is no field `{field}`");
                self.of_path(&path, given, found)
            }),
            (None, Json::Array(values)) => {
                let elements = self.elements(path);
                let is_table = elements
                    .first()
                    .is_some_and(|element| element[path.len()..].contains(','));
                let mut rows = Vec::new();
                if is_table {
                    flatten(values, &mut rows);
                } else {
                    rows.extend(values);
                }
                ensure!(
                    rows.len() <= elements.len(),
                    "it has {} elements, and the trace {} values for them",
                    elements.len(),
                    rows.len()
                );
                let mut pairs = elements.iter().zip(rows).filter(|(_, given)| !given.is_null());
                pairs.try_for_each(|(element, given)| self.of_path(element, given, found))
            }
            (None, _) => bail!("it is an array or a structure; write a list or an object"),
        }
    }

    /// Returns the paths of the elements of an array, in order.
    fn elements(&self, path: &str) -> Vec<&str> {
        let mut elements: Vec<&str> = self
            .list
            .iter()
            .filter_map(|(known, _)| {
                let rest = start_of(known, path).filter(|rest| rest.starts_with('['))?;
                Some(&known[..path.len() + rest.find(']')? + 1])
            })
            .collect();
        elements.dedup();
        elements
    }
}

/// Returns the rest of a name behind its start, which may be written with other capitals.
fn start_of<'n>(name: &'n str, start: &str) -> Option<&'n str> {
    let head = name.get(..start.len())?;
    head.eq_ignore_ascii_case(start).then(|| &name[start.len()..])
}

fn flatten<'j>(values: &'j [Json], into: &mut Vec<&'j Json>) {
    for value in values {
        match value {
            Json::Array(row) => flatten(row, into),
            other => into.push(other),
        }
    }
}

/// Returns the value of the type of `like` that is given in JSON: truth values and numbers, texts as they are, and every type by a
/// literal with or without its type.
fn value(given: &Json, like: &Value) -> Option<Value> {
    let text = match given {
        Json::Bool(truth) => truth.to_string(),
        Json::Number(number) => number.to_string(),
        Json::String(text) => text.clone(),
        Json::Null | Json::Array(_) | Json::Object(_) => return None,
    };
    match like {
        Value::Text { ty, .. } => {
            let units: Vec<u16> = given.as_str()?.encode_utf16().collect();
            Some(Value::text(*ty, units))
        }
        Value::Enumerated { type_name, .. } => {
            let name = text.rsplit('#').next()?;
            Some(Value::enumerated(type_name.as_str(), name))
        }
        Value::Plain { ty, .. } | Value::OutOfRange { ty, .. } | Value::Near { ty, .. } => {
            let typed = Value::parse(&text)
                .ok()
                .filter(|value| value.type_name() == ty.name());
            let number = match ty {
                ElementaryType::Real => text.parse::<f32>().map(f64::from),
                _ => text.parse::<f64>(),
            };
            let is_real = |number: &f64| ty.is_real() && number.is_finite();
            let real = || Some(Value::of_real(*ty, number.ok().filter(is_real)?));
            let untyped = || Value::parse(&format!("{}#{text}", ty.name())).ok();
            typed.or_else(real).or_else(untyped)
        }
    }
}

/// Returns whether a value is the expected one, or as a real number at most `tolerance` away from it.
pub(super) fn agrees(found: &Value, expected: &Value, tolerance: f64) -> bool {
    match (found.real(), expected.real()) {
        (Some(found), Some(expected)) if !expected.is_nan() => {
            found == expected || (found - expected).abs() <= tolerance
        }
        _ => found.to_string().eq_ignore_ascii_case(&expected.to_string()),
    }
}
