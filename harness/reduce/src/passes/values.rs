//! Passes that replace variables by values that they have.
//!
//! They cut a program off from the computation of a value. The value of a variable at the place of a read is unknown here;
//! its first and last values are good guesses.

use crate::TextView;
use stickler_syntax::Edits;
use stickler_syntax::tree::{Argument, ExpressionKind, StatementKind};

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

/// Replaces calls by assignments of the values that their arguments have in the end, since a call may only change a variable that it is given.
pub(crate) fn call_to_value(view: &TextView<'_>) -> Vec<Edits> {
    let values = view.draft.rules().values(view.text(), view.draft.dialect(), 1);
    let mut changes = Vec::new();
    for statement in view.statements() {
        let StatementKind::Call(call) = statement.kind else {
            continue;
        };
        let Some(ExpressionKind::Call { arguments, .. }) = view.unit.expression(call).map(|call| &call.kind)
        else {
            continue;
        };
        for argument in arguments {
            let (Argument::Positional(given)
            | Argument::Named { value: given, .. }
            | Argument::Output { target: given, .. }) = argument;
            let given = &view.text()[view.range_of_expression(*given)];
            if let Some(value) = values.get(&given.to_ascii_lowercase()) {
                changes.push(Edits::replacing(statement.span, format!("{given} := {value}")));
            }
        }
    }
    view.only_allowed(changes)
}
