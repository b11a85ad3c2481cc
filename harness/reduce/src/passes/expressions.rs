//! Passes that replace expressions by their operands, by literals, and by values that variables have.

use crate::TextView;
use crate::rules::TextState;
use stickler_syntax::Edits;
use stickler_syntax::tree::{Argument, Expression, ExpressionKind, Pou, StatementKind};
use stickler_syntax::visitor::{Place, operands};

/// The literals that are tried in the place of an expression of unknown type; the rules decide which are valid there. A real
/// number comes before an integer, which may stand for one.
const PLAIN: [&str; 7] = ["FALSE", "0.0", "0", "''", "T#0s", "TRUE", "1"];

/// A literal of each type that could be part of a type mismatch.
const TYPED: [&str; 8] = [
    "DINT#0",
    "INT#0",
    "LINT#0",
    "UINT#0",
    "LREAL#0.0",
    "WORD#16#0",
    "BOOL#FALSE",
    "T#0s",
];

/// Replaces expressions by the first plain literal that is valid in their place, outermost first.
pub(crate) fn to_literal(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for expression in replaceable(view) {
        let replacing = |plain: &&str| {
            let change = Edits::replacing(expression.span, *plain);
            view.only_allowed(vec![change]).pop()
        };
        changes.extend(PLAIN.iter().filter_map(replacing).next());
    }
    changes
}

/// Replaces truth values by TRUE, which ends REPEAT and enters a branch.
pub(crate) fn to_true(view: &TextView<'_>) -> Vec<Edits> {
    let changes = replaceable(view).map(|expression| Edits::replacing(expression.span, "TRUE"));
    view.only_allowed(changes.collect())
}

/// Replaces expressions of a rejected text by typed literals.
///
/// In a type mismatch an untyped literal fits too well: it takes the expected type.
pub(crate) fn to_typed_literal(view: &TextView<'_>) -> Vec<Edits> {
    if view.draft.rules().start() == TextState::Accepted {
        return Vec::new();
    }
    let mut changes = Vec::new();
    for expression in replaceable(view) {
        let typed = TYPED.iter();
        changes.extend(typed.map(|typed| Edits::replacing(expression.span, *typed)));
    }
    view.only_allowed(changes)
}

/// Replaces calls and operations by a variable of their unit, outermost first.
pub(crate) fn to_variable(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for expression in replaceable(view) {
        let is_part = matches!(
            expression.kind,
            ExpressionKind::Name(_) | ExpressionKind::Field { .. } | ExpressionKind::Index { .. }
        );
        let inside =
            |pou: &Pou<'_>| pou.span.start <= expression.span.start && expression.span.end <= pou.span.end;
        let variables = view.variables().filter(|(pou, _)| !is_part && inside(pou));
        let names = variables.filter_map(|(_, group)| group.names.first());
        changes.extend(names.map(|name| Edits::replacing(expression.span, name.text)));
    }
    view.only_allowed(changes)
}

/// Returns the expressions that a literal may take the place of, outermost first.
fn replaceable<'t>(view: &TextView<'t>) -> impl Iterator<Item = &'t Expression<'t>> {
    let expressions = view.expressions().into_iter();
    expressions
        .filter(|(place, expression)| {
            !matches!(place, Place::Statement | Place::Callee)
                && !matches!(expression.kind, ExpressionKind::Literal(_))
        })
        .map(|(_, expression)| expression)
}

/// Replaces expressions by one of their operands or arguments.
pub(crate) fn to_operand(view: &TextView<'_>, which: usize) -> Vec<Edits> {
    let mut changes = Vec::new();
    for (_, whole) in view.expressions() {
        let mut operands = operands(whole)
            .into_iter()
            .filter(|(_, place)| *place != Place::Callee);
        if let Some((operand, _)) = operands.nth(which) {
            changes.push(Edits::replacing(
                whole.span,
                &view.text()[view.range_of_expression(operand)],
            ));
        }
        // A value of an enumeration may need no name before it.
        if let (ExpressionKind::Field { field, .. }, 1) = (&whole.kind, which) {
            changes.push(Edits::replacing(whole.span, field.text));
        }
    }
    view.only_allowed(changes)
}

/// Drops arguments of calls.
pub(crate) fn drop_arguments(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for (_, call) in view.expressions() {
        if let ExpressionKind::Call { callee, .. } = &call.kind {
            let arguments = operands(call).into_iter().skip(1);
            let ends: Vec<usize> = arguments
                .map(|(value, _)| view.range_of_expression(value).end)
                .collect();
            changes.extend(view.list_items(
                view.range_of_expression(*callee).end,
                &ends,
                call.span.end as usize,
            ));
        }
    }
    view.only_allowed(changes)
}

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
