//! Passes that replace variables by values that the reference computes for them.
//!
//! They cut a program off from the computation of a value, as the evaluator does for programs of the model. The value of a
//! variable at the place of a read is unknown here; its first and last values are good guesses.

use super::draft::{TextChange, TextDraft};
use super::expressions::outermost_first;
use super::tree::bytes;
use crate::reduce::Sites;
use std::collections::HashMap;
use stickler_reference::{Limits, run, variables};
use stickler_syntax::tree::ExpressionKind;
use stickler_types::{Observation, Outcome, RunRequest, Value};

/// The maximum number of variables that are observed.
const MAX_VARIABLES: usize = 300;

/// Replaces variables by their values at the end.
pub(super) fn to_final_value(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("final values", sites, |draft| to_value(draft, 1));
}

/// Replaces variables by their initial values.
pub(super) fn to_initial_value(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("initial values", sites, |draft| to_value(draft, 0));
}

fn to_value(draft: &TextDraft, scans: u32) -> Vec<TextChange> {
    let values = values(draft, scans);
    let unit = draft.tree();
    let mut changes = Vec::new();
    for expression in outermost_first(&unit) {
        let is_read = matches!(
            expression.kind,
            ExpressionKind::Name(_) | ExpressionKind::Field { .. } | ExpressionKind::Index { .. }
        );
        let name = expression.span.text(&draft.text).to_ascii_lowercase();
        if let (true, Some(value)) = (is_read, values.get(&name)) {
            changes.push(TextChange::of(bytes(expression.span), value.as_str()));
        }
    }
    draft.only_allowed(changes)
}

/// Returns the values of the variables after some scans, as literals, by their names in lower case.
fn values(draft: &TextDraft, scans: u32) -> HashMap<String, String> {
    let names = variables(&draft.text, draft.dialect, MAX_VARIABLES);
    let observe: Vec<Observation> = names.iter().map(|name| Observation::last(name, "")).collect();
    let request = RunRequest {
        scans,
        ..RunRequest::once(draft.dialect, &draft.text, &observe)
    };
    let values = match run(&request, Limits { steps: 100_000 }) {
        Ok(Outcome::Executed { values, .. } | Outcome::Faulted { values, .. }) => values,
        _ => Vec::new(),
    };
    values
        .into_iter()
        .map(|(name, value)| (name.to_ascii_lowercase(), spell(&value)))
        .collect()
}

/// Spells a value; BOOL and texts without the prefix of their type, which not every compiler reads.
fn spell(value: &Value) -> String {
    let canonical = value.to_string();
    let bare = ["BOOL#", "STRING#", "WSTRING#"]
        .into_iter()
        .find_map(|prefix| canonical.strip_prefix(prefix));
    bare.map_or_else(|| canonical.clone(), str::to_owned)
}
