//! The claims of all marks that apply to one expansion, and the check that they do not contradict each other.

use std::sync::{Arc, LazyLock};

use stickler_types::{Acceptance, ClockSetting, ElementaryType, Observation, Setting, Value};

use crate::model::{Expectation, ExpectedDiagnostic};

/// The claims that all marks of a case make together.
#[derive(Clone, Debug, Default)]
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
pub(crate) fn contradiction(expectation: &Expectation) -> Option<String> {
    let has_clean_line =
        |told: &ExpectedDiagnostic| expectation.clean_lines.binary_search(&told.line).is_ok();
    for (told, mark) in [
        (&expectation.warnings, "warning"),
        (&expectation.diagnostics, "error"),
    ] {
        if told.iter().any(has_clean_line) {
            return Some(format!("`ok` and `{mark}` apply to the same line"));
        }
    }
    let mut asserted = [
        (!expectation.warnings.is_empty(), "a warning is asserted"),
        (!expectation.values.is_empty(), "values are asserted"),
        (expectation.fault.is_some(), "a fault is asserted"),
        (expectation.rendered.is_some(), "a rendered text is asserted"),
    ]
    .into_iter()
    .filter_map(|(is_asserted, what)| is_asserted.then_some(what));
    match (
        expectation.accepted == Acceptance::Observed,
        !expectation.diagnostics.is_empty(),
    ) {
        (true, true) => Some("an `error` mark and `observe acceptance` apply at once".to_owned()),
        (true, false) => {
            let clean = (!expectation.clean_lines.is_empty()).then_some("`ok` asserts a line");
            let what = asserted.next().or(clean)?;
            Some(format!("`observe acceptance` asserts nothing, but {what}"))
        }
        (false, true) => {
            let what = asserted.next()?;
            Some(format!(
                "an `error` mark applies, so that nothing else of the program is compared, but {what}"
            ))
        }
        (false, false) => None,
    }
}

/// The names of the elementary types in the order of [`ElementaryType::ALL`], allocated once for all cases that use them.
static TYPE_NAMES: LazyLock<[Arc<str>; ElementaryType::ALL.len()]> =
    LazyLock::new(|| ElementaryType::ALL.map(|ty| ty.name().into()));

/// Returns the name of an elementary type.
pub(crate) fn elementary_name(ty: ElementaryType) -> Arc<str> {
    Arc::clone(&TYPE_NAMES[ty as usize])
}

/// Returns the name of a value's type.
pub(crate) fn type_name(value: &Value) -> Arc<str> {
    match value {
        Value::Plain { ty, .. }
        | Value::Text { ty, .. }
        | Value::OutOfRange { ty, .. }
        | Value::Near { ty, .. } => elementary_name(*ty),
        Value::Enumerated { type_name, .. } => type_name.as_str().into(),
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
