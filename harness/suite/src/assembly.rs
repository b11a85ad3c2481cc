//! The claims of all marks that apply to one expansion, and the check that they do not contradict each other.

use std::sync::Arc;

use stickler_types::{Acceptance, ClockSetting, ElementaryType, Observation, Setting, Value};

use crate::model::Expectation;

/// The claims that all marks of a case make together.
#[derive(Clone, Debug)]
pub(crate) struct Assembly {
    pub(crate) expectation: Arc<Expectation>,
    pub(crate) observe: Arc<[Observation]>,
    pub(crate) set: Arc<[Setting]>,
    pub(crate) clock: Arc<[ClockSetting]>,
    /// The number of scans that the program runs.
    pub(crate) scans: u32,
}

impl Assembly {
    /// The warning of lint for a case without a claim, and the hint that goes with it.
    pub(crate) const NOTHING: &str = "claims nothing but that the program is accepted";
    pub(crate) const SAY_OK: &str = "if that is the claim, say `(*! ok *)` on the line that matters";

    /// Returns whether no mark claims anything. A value that is only recorded counts as a claim, because the author wants
    /// no more.
    pub(crate) fn claims_nothing(&self) -> bool {
        let expectation = &self.expectation;
        expectation.accepted == Acceptance::Required
            && expectation.values.is_empty()
            && expectation.warnings.is_empty()
            && expectation.clean_lines.is_empty()
            && expectation.fault.is_none()
            && expectation.rendered.is_none()
            && self.observe.is_empty()
    }
}

/// Returns a message if two claims cannot both be met. The lists of the expectation must be ordered by line.
pub(crate) fn contradiction(expectation: &Expectation) -> Option<&'static str> {
    let Expectation {
        diagnostics,
        warnings,
        clean_lines,
        values,
        fault,
        rendered,
        accepted,
    } = expectation;
    let observed = *accepted == Acceptance::Observed;
    let has_clean_line = |line| clean_lines.binary_search(&line).is_ok();
    if warnings.iter().any(|warning| has_clean_line(warning.line)) {
        return Some("`ok` and `warning` apply to the same line");
    }
    if diagnostics.is_empty() {
        return match observed {
            false => None,
            true if !warnings.is_empty() => Some("`observe acceptance` asserts nothing, but `warning` does"),
            true if !values.is_empty() => {
                Some("`observe acceptance` asserts nothing, but values are asserted")
            }
            true if fault.is_some() => Some("`observe acceptance` asserts nothing, but a fault is asserted"),
            true if rendered.is_some() => {
                Some("`observe acceptance` asserts nothing, but a rendered text is asserted")
            }
            true if !clean_lines.is_empty() => Some("`observe acceptance` asserts nothing, but `ok` does"),
            true => None,
        };
    }
    if observed {
        Some("an `error` mark and `observe acceptance` apply at once")
    } else if !warnings.is_empty() {
        Some(
            "an `error` mark applies, and the warnings of a rejected program are not compared, but one is asserted",
        )
    } else if !values.is_empty() {
        Some("an `error` mark applies, so the program does not run, but values are asserted")
    } else if fault.is_some() {
        Some("an `error` mark applies, so the program does not run, but a fault is asserted")
    } else if rendered.is_some() {
        Some("an `error` mark applies, but what the renderer gives back is asserted")
    } else if diagnostics.iter().any(|error| has_clean_line(error.line)) {
        Some("`ok` and `error` apply to the same line")
    } else {
        None
    }
}

/// The names of the elementary types, allocated once for all cases that use them.
#[derive(Debug)]
pub(crate) struct TypeNames(Vec<Arc<str>>);

impl Default for TypeNames {
    fn default() -> Self {
        TypeNames(
            ElementaryType::ALL
                .iter()
                .map(|ty| Arc::from(ty.name()))
                .collect(),
        )
    }
}

impl TypeNames {
    /// Returns the name of a value's type.
    pub(crate) fn of(&self, value: &Value) -> Arc<str> {
        match value {
            Value::Plain { ty, .. }
            | Value::Text { ty, .. }
            | Value::OutOfRange { ty, .. }
            | Value::Near { ty, .. } => self.elementary(*ty),
            Value::Enumerated { type_name, .. } => type_name.as_str().into(),
        }
    }

    /// Returns the name of an elementary type.
    pub(crate) fn elementary(&self, ty: ElementaryType) -> Arc<str> {
        match self.0.get(ty as usize) {
            // The variants stand in the order of `ALL`; a test holds that.
            Some(name) => Arc::clone(name),
            None => ty.name().into(),
        }
    }
}

/// Converts a list to one that cases share; all empty lists share one allocation, because most are empty.
pub(crate) fn shared<T>(list: Vec<T>) -> Arc<[T]> {
    if list.is_empty() {
        Arc::default()
    } else {
        list.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_type_has_its_own_name() {
        let names = TypeNames::default();
        for ty in ElementaryType::ALL {
            assert_eq!(&*names.elementary(ty), ty.name());
        }
        assert_eq!(&*names.of(&Value::enumerated("COLOR", "RED")), "COLOR");
    }
}
