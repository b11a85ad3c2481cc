//! Whether the calls that read texts back work in a version of IronPLC, found out before they are relied on.

use super::readback::RunHints;
use super::run_with;
use crate::adapters::recipe::Workplace;
use crate::{Observation, Outcome, RunRequest};
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use stickler_types::{DialectName, ElementaryType, Value};

/// Remembers for each dialect and type whether texts can be read, and the reason where they cannot.
#[derive(Default)]
pub(super) struct ReadableTexts {
    known: Mutex<BTreeMap<(DialectName, ElementaryType), Option<String>>>,
}

impl ReadableTexts {
    /// Returns the types of text among the observed values which cannot be read, each with the reason.
    pub(super) fn unreadable(
        &self,
        workplace: &Workplace<'_>,
        request: &RunRequest<'_>,
    ) -> BTreeMap<ElementaryType, String> {
        let types = [ElementaryType::String, ElementaryType::Wstring].into_iter();
        let observed = |ty: &ElementaryType| {
            let mut observed = request.observe.iter();
            observed.any(|asked| ElementaryType::from_name(&asked.type_name) == Some(*ty))
        };
        types
            .filter(observed)
            .filter_map(|ty| Some((ty, self.reason(workplace, request.dialect, ty)?)))
            .collect()
    }

    fn reason(&self, workplace: &Workplace<'_>, dialect: DialectName, ty: ElementaryType) -> Option<String> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        known
            .entry((dialect, ty))
            .or_insert_with(|| tried(workplace, dialect, ty))
            .clone()
    }
}

/// The text by which reading is tried; it is the same in both types.
const TRIED: &str = "a~1";

/// Reads a short text. Returns the reason why that does not work; `None` where it does.
fn tried(workplace: &Workplace<'_>, dialect: DialectName, ty: ElementaryType) -> Option<String> {
    let quote = if ty == ElementaryType::Wstring { '"' } else { '\'' };
    let source = format!(
        "PROGRAM main\nVAR\n  tried : {ty} := {quote}{TRIED}{quote};\n  ran : BOOL;\nEND_VAR\n  ran := TRUE;\nEND_PROGRAM\n"
    );
    let observe = [Observation::last("tried", ty.name())];
    let request = RunRequest::once(dialect, &source, &observe);
    let outcome = run_with(workplace, &request, RunHints::default()).unwrap_or_else(|outcome| outcome);
    let expected = Value::text(ty, TRIED.encode_utf16().collect());
    match &outcome {
        Outcome::Executed { values, .. } if values.iter().all(|(_, value)| *value == expected) => None,
        _ => Some(format!(
            "values of {ty} are not shown, and LEN, MID and FIND do not read `{TRIED}` back: {outcome}"
        )),
    }
}
