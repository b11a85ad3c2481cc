//! Passes that replace variables by values that they have.
//!
//! They cut a program off from the computation of a value. The value of a variable at the place of a read is unknown here;
//! its first and last values are good guesses.

use crate::TextView;
use stickler_syntax::Edits;
use stickler_syntax::tree::ExpressionKind;

/// Replaces variables by their values after some scans; after none, these are the initial ones.
pub(crate) fn to_value(view: &TextView<'_>, scans: u32) -> Vec<Edits> {
    let values = view
        .draft
        .rules()
        .values(view.text(), view.draft.dialect(), scans);
    let mut changes = Vec::new();
    for (_, expression) in view.expressions() {
        let is_read = matches!(
            expression.kind,
            ExpressionKind::Name(_) | ExpressionKind::Field { .. } | ExpressionKind::Index { .. }
        );
        let name = expression.span.text(view.text()).to_ascii_lowercase();
        if let (true, Some(value)) = (is_read, values.get(&name)) {
            changes.push(Edits::replacing(expression.span, value.as_str()));
        }
    }
    view.only_allowed(changes)
}
