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

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    fn asked(name: &str, type_name: &str) -> Observation {
        Observation::last(name, type_name)
    }

    #[test]
    fn values_are_read_with_their_type_and_without() {
        let source = "TYPE COLOR : (RED, GREEN); END_TYPE";
        let request = RunRequest::once(DialectName::MATIEC, source, &[]);
        for (type_name, shown, literal) in [
            ("INT", "-5", "INT#-5"),
            ("INT", "INT#-5", "INT#-5"),
            ("BOOL", "1", "BOOL#TRUE"),
            ("BOOL", "false", "BOOL#FALSE"),
            ("WORD", "16#00AB", "WORD#16#00AB"),
            ("WORD", "171", "WORD#16#00AB"),
            ("REAL", "0.1", "REAL#0.1"),
            ("REAL", "1e-3", "REAL#0.001"),
            ("LREAL", "-inf", "LREAL#-Infinity"),
            ("TIME", "T#1500ms", "TIME#1500ms"),
            ("DATE", "D#2024-02-29", "DATE#2024-02-29"),
            ("STRING", "'a'", "STRING#'a'"),
            ("COLOR", "green", "COLOR#GREEN"),
            ("COLOR", "COLOR#RED", "COLOR#RED"),
        ] {
            let read = value(shown, type_name, &request).map(|value| value.to_string());
            assert_eq!(read.as_deref(), Some(literal), "{shown}");
        }
        for (type_name, shown) in [
            ("INT", "32768"),
            ("INT", "DINT#5"),
            ("BOOL", "2"),
            ("COLOR", "blue"),
            ("X", "1"),
        ] {
            assert_eq!(value(shown, type_name, &request), None, "{shown}");
        }
    }

    #[test]
    fn one_of_several_values_is_not_guessed() {
        let request = RunRequest::once(DialectName::MATIEC, "", &[]);
        let pattern = r"^(?<name>\w+): (?<value>.*)$".parse().unwrap();
        let printed = Printed::read(&pattern, "X: 1\ny: 2\nx: 3\ny: 2\n");
        assert_eq!(
            printed.value("Y", &asked("Y", "INT"), &request),
            Ok(Value::parse("INT#2").unwrap())
        );
        let error = |name| printed.value(name, &asked(name, "INT"), &request).unwrap_err();
        assert_eq!(error("x"), "it shows several values of x");
        assert_eq!(error("z"), "it does not show z");
    }
}
