//! A pass that drops parameters together with the arguments that are given to them.

use crate::TextView;
use stickler_reference::place_of_input;
use stickler_syntax::Edits;
use stickler_syntax::tree::{
    Argument, Expression, ExpressionId, ExpressionKind, Pou, VariableBlock, VariableGroup, VariableKind,
};
use stickler_syntax::visitor::operands;
use stickler_types::join;

/// Drops a parameter of a function or a function block, with the statements of the unit that name it and with its argument in each call.
pub(crate) fn forget_parameters(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for unit in view.unit.pous() {
        let calls = calls(view, unit);
        for (section, group, at) in parameters(unit) {
            let [name] = &group.names[..] else { continue };
            let mut edits = Edits::new();
            for used in view.uses(unit, *name) {
                edits.extend(used.statement.map(|statement| Edits::removing(statement.span)));
            }
            match (&section.groups[..], view.range_of_declaration(group)) {
                ([_], _) => edits.remove(section.span),
                (_, Some(declaration)) => edits.remove(declaration),
                (_, None) => continue,
            }
            for call in &calls {
                edits.extend(without_argument(view, call, (name.text, at)));
            }
            changes.push(edits);
        }
    }
    view.only_allowed(changes)
}

/// Gives the inputs of standard functions their arguments by position, in the place of their names.
pub(crate) fn forget_names(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for (_, call) in view.expressions() {
        let ExpressionKind::Call { callee, arguments } = &call.kind else {
            continue;
        };
        let function = &view.text()[view.range_of_expression(*callee)];
        let named = arguments.iter().map(|argument| match argument {
            Argument::Named { name, value } => Some((place_of_input(function, name.text)?, *value)),
            Argument::Positional(_) | Argument::Output { .. } => None,
        });
        let Some(mut inputs) = named.collect::<Option<Vec<_>>>() else {
            continue;
        };
        inputs.sort_by_key(|(place, _)| *place);
        let values = inputs
            .iter()
            .map(|(_, value)| &view.text()[view.range_of_expression(*value)]);
        let call_by_position = format!("{function}({})", join(values, ", "));
        changes.push(Edits::replacing(call.span, call_by_position));
    }
    view.only_allowed(changes)
}

/// Returns the declarations of the parameters of a unit, each with its section and with the number of parameters before it.
pub(crate) fn parameters<'t, 's>(
    unit: &'t Pou<'s>,
) -> impl Iterator<Item = (&'t VariableBlock<'s>, &'t VariableGroup<'s>, usize)> {
    let is_of_parameters = |section: &&VariableBlock<'_>| {
        matches!(
            section.kind,
            VariableKind::Input | VariableKind::Output | VariableKind::InOut
        )
    };
    let sections = unit.blocks.iter().filter(is_of_parameters);
    let groups = sections.flat_map(|section| section.groups.iter().map(move |group| (section, group)));
    groups.scan(0, |before, (section, group)| {
        let at = *before;
        *before += group.names.len();
        Some((section, group, at))
    })
}

/// Returns the calls of a unit: of a function by its name, of a function block by that of a variable.
pub(crate) fn calls<'t>(view: &TextView<'t>, unit: &Pou<'_>) -> Vec<&'t Expression<'t>> {
    let is_of_unit = |written: &str| written.eq_ignore_ascii_case(unit.name.text);
    let of_type = view
        .variables()
        .filter(|(_, group)| is_of_unit(group.specification.span.text(view.text())));
    let instances: Vec<&str> = of_type
        .flat_map(|(_, group)| &group.names)
        .map(|name| name.text)
        .collect();
    let expressions = view.expressions().into_iter().map(|(_, expression)| expression);
    let calls = expressions.filter(|expression| match &expression.kind {
        ExpressionKind::Call { callee, .. } => {
            let callee = &view.text()[view.range_of_expression(*callee)];
            is_of_unit(callee) || instances.iter().any(|one| one.eq_ignore_ascii_case(callee))
        }
        _ => false,
    });
    calls.collect()
}

/// Returns the edit that removes the argument for a parameter from a call; `None` where the call has none for it.
fn without_argument(view: &TextView<'_>, call: &Expression<'_>, (name, at): (&str, usize)) -> Option<Edits> {
    let ExpressionKind::Call { callee, arguments } = &call.kind else {
        return None;
    };
    let number = place(arguments, (name, at))?;
    let ends: Vec<usize> = operands(call)
        .into_iter()
        .skip(1)
        .map(|(value, _)| view.range_of_expression(value).end)
        .collect();
    let open = view.range_of_expression(*callee).end;
    view.list_items(open, &ends, call.span.end as usize)
        .into_iter()
        .nth(number)
}

/// Returns the value that a call gives a parameter, by its name or its place; `None` where it gives it none.
pub(crate) fn argument(call: &Expression<'_>, parameter: (&str, usize)) -> Option<ExpressionId> {
    let ExpressionKind::Call { arguments, .. } = &call.kind else {
        return None;
    };
    match &arguments[place(arguments, parameter)?] {
        Argument::Positional(value) | Argument::Named { value, .. } => Some(*value),
        Argument::Output { .. } => None,
    }
}

/// Returns the place of the argument for a parameter.
fn place(arguments: &[Argument<'_>], (name, at): (&str, usize)) -> Option<usize> {
    let is_given = |(number, argument): (usize, &Argument<'_>)| match argument {
        Argument::Positional(_) => number == at,
        Argument::Named { name: named, .. } | Argument::Output { name: named, .. } => named.is(name),
    };
    arguments.iter().enumerate().position(is_given)
}
