//! Parses the values that a described compiler prints.

use super::pattern::ValuePattern;
use crate::adapters::source::enumeration;
use crate::adapters::values::real;
use crate::{Observation, RunRequest};
use std::collections::BTreeMap;
use stickler_types::{ElementaryType, Value};

/// The printed text of each variable, by its name in lower case; `None` where two different values were printed, as for two
/// variables of one name.
pub(super) struct Printed<'t>(BTreeMap<String, Option<&'t str>>);

impl<'t> Printed<'t> {
    /// Parses the output of a program.
    pub(super) fn read(pattern: &ValuePattern, text: &'t str) -> Printed<'t> {
        let mut printed = BTreeMap::new();
        for (name, value) in pattern.values(text) {
            let value = value.trim();
            let entry = printed.entry(name.trim().to_lowercase()).or_insert(Some(value));
            if *entry != Some(value) {
                *entry = None;
            }
        }
        Printed(printed)
    }

    /// Returns the value of an observed variable, which the output calls `variable`.
    ///
    /// # Errors
    /// A fragment that says why the value is not known.
    pub(super) fn value(
        &self,
        variable: &str,
        asked: &Observation,
        request: &RunRequest<'_>,
    ) -> Result<Value, String> {
        match self.0.get(&variable.to_lowercase()) {
            None => Err(format!("it does not show {}", asked.name)),
            Some(None) => Err(format!("it shows several values of {}", asked.name)),
            Some(Some(shown)) => value(shown, &asked.type_name, request)
                .ok_or_else(|| format!("it shows `{shown}` as {} {}", asked.type_name, asked.name)),
        }
    }
}

/// Parses a value of a type: a typed literal, or one without its type.
fn value(shown: &str, type_name: &str, request: &RunRequest<'_>) -> Option<Value> {
    let Some(ty) = ElementaryType::from_name(type_name) else {
        let (_, bare) = shown.rsplit_once('#').unwrap_or(("", shown));
        let values = enumeration(request, type_name)?;
        let name = values.iter().find(|name| name.eq_ignore_ascii_case(bare))?;
        return Some(Value::enumerated(type_name, name));
    };
    if let Ok(value) = Value::parse_observed(shown)
        && ElementaryType::from_name(value.type_name()) == Some(ty)
    {
        return Some(value);
    }
    if ty.is_real() {
        return real(ty, shown);
    }
    if ty == ElementaryType::Bool {
        let truth = match shown.to_ascii_lowercase().as_str() {
            "true" | "1" => 1,
            "false" | "0" => 0,
            _ => return None,
        };
        return Some(Value::plain(ty, truth));
    }
    Value::parse_observed(&format!("{ty}#{shown}")).ok()
}
