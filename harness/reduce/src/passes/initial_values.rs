//! Passes over initial values: those of arrays and structures, and those that a statement can assign.

use crate::TextView;
use stickler_syntax::Edits;
use stickler_syntax::tree::{
    ExpressionId, ExpressionKind, Initializer, InitializerKind, Name, StatementKind, TypeSpecificationKind,
};
use stickler_syntax::visitor::Place;

/// Drops a field of a structure with its initial values.
pub(crate) fn forget_fields(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for declared in view.unit.types() {
        let TypeSpecificationKind::Structure(fields) = &declared.specification.kind else {
            continue;
        };
        for group in fields.iter().filter(|_| fields.len() > 1) {
            let ([name], Some(declaration)) = (&group.names[..], view.range_of_declaration(group)) else {
                continue;
            };
            let mut edits = Edits::removing(declaration);
            for initializer in initializers(view) {
                let InitializerKind::Structure(values) = &initializer.kind else {
                    continue;
                };
                let ends: Vec<usize> = values.iter().map(|(_, value)| value.span.end as usize).collect();
                let items = view.list_items(
                    initializer.span.start as usize,
                    &ends,
                    initializer.span.end as usize,
                );
                let of_field = values
                    .iter()
                    .zip(items)
                    .filter(|((field, _), _)| field.is(name.text));
                edits.extend(of_field.map(|(_, item)| item));
            }
            changes.push(edits);
        }
    }
    view.only_allowed(changes)
}

/// Assigns an initial value by the statement that assigns its variable to itself, which is there only because a body needs a statement.
pub(crate) fn assign_initials(view: &TextView<'_>) -> Vec<Edits> {
    let name_of = |id: ExpressionId| match &view.unit.expression(id)?.kind {
        ExpressionKind::Name(name) => Some(*name),
        _ => None,
    };
    let mut changes = Vec::new();
    for (pou, group) in view.variables() {
        let ([name], Some(initializer)) = (&group.names[..], &group.initializer) else {
            continue;
        };
        let is_own = |used: Option<Name<'_>>| used.is_some_and(|used| used.is(name.text));
        let assigned = view.uses(pou, *name).into_iter().find_map(|used| {
            let StatementKind::Assignment { target, value } = used.statement?.kind else {
                return None;
            };
            (used.place == Place::Target && is_own(name_of(target)) && is_own(name_of(value)))
                .then_some(value)
        });
        if let (InitializerKind::Expression(_), Some(value)) = (&initializer.kind, assigned) {
            let given = initializer.span.text(view.text());
            let mut edits = Edits::replacing(view.range_of_expression(value), given);
            edits.remove(group.specification.span.end as usize..initializer.span.end as usize);
            changes.push(edits);
        }
    }
    view.only_allowed(changes)
}

/// Leaves an array of one dimension its first element, with the value that this begins with.
pub(crate) fn shorten_arrays(view: &TextView<'_>) -> Vec<Edits> {
    let fields = view
        .unit
        .types()
        .filter_map(|declared| match &declared.specification.kind {
            TypeSpecificationKind::Structure(fields) => Some(fields),
            _ => None,
        });
    let of_field = |field: &Name<'_>| {
        let mut found = Vec::new();
        for initializer in initializers(view) {
            if let InitializerKind::Structure(values) = &initializer.kind {
                let values = values.iter().filter(|(name, _)| name.is(field.text));
                found.extend(values.map(|(_, value)| value));
            }
        }
        found
    };
    let fields = fields.flatten().filter_map(|group| match &group.names[..] {
        [name] => Some((&group.specification, of_field(name))),
        _ => None,
    });
    let variables = view.specifications().into_iter();
    let variables = variables.map(|(specification, own)| (specification, own.into_iter().collect()));
    let mut changes = Vec::new();
    for (specification, lists) in variables.chain(fields) {
        let TypeSpecificationKind::Array { dimensions, .. } = &specification.kind else {
            continue;
        };
        let [(low, high)] = dimensions[..] else { continue };
        let least = &view.text()[view.range_of_expression(low)];
        let mut edits = Edits::replacing(view.range_of_expression(high), least);
        let lists: Vec<&Initializer<'_>> = lists;
        for list in lists {
            let InitializerKind::Array(elements) = &list.kind else {
                continue;
            };
            let single = elements.iter().map(|element| match &element.values[..] {
                [value] if element.repetition.is_none() => Some(value.span.end as usize),
                _ => None,
            });
            let ends: Option<Vec<usize>> = single.collect();
            if let Some([first, .., last]) = ends.as_deref() {
                edits.remove(*first..*last);
            }
        }
        changes.push(edits);
    }
    view.only_allowed(changes)
}

/// Writes the values of an array that are repeated once, without the number.
pub(crate) fn drop_repetitions(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for initializer in initializers(view) {
        let InitializerKind::Array(elements) = &initializer.kind else {
            continue;
        };
        for element in elements {
            if let (Some(number), values @ [first, ..]) = (element.repetition, &element.values[..])
                && let Some(close) = values.last().and_then(|last| view.next(last.span.end as usize))
            {
                let mut edits =
                    Edits::removing(view.range_of_expression(number).start..first.span.start as usize);
                edits.remove(close.span);
                changes.push(edits);
            }
        }
    }
    view.only_allowed(changes)
}

/// Returns every initial value, outer ones before those inside them.
fn initializers<'t>(view: &TextView<'t>) -> Vec<&'t Initializer<'t>> {
    let of_declarations = view.specifications().into_iter();
    let mut open: Vec<&Initializer<'_>> = of_declarations
        .filter_map(|(_, initializer)| initializer)
        .collect();
    let mut found = Vec::new();
    while let Some(initializer) = open.pop() {
        found.push(initializer);
        match &initializer.kind {
            InitializerKind::Array(elements) => {
                open.extend(elements.iter().flat_map(|element| &element.values))
            }
            InitializerKind::Structure(values) => open.extend(values.iter().map(|(_, value)| value)),
            InitializerKind::Expression(_) => {}
        }
    }
    found
}
