//! Passes that make arrays smaller: to their elements, and to fewer dimensions.

use crate::TextView;
use stickler_syntax::Edits;
use stickler_syntax::tree::{
    Expression, ExpressionId, ExpressionKind, Pou, TypeSpecificationKind, VariableGroup,
};

/// Gives the element type to array variables whose every use has subscripts.
pub(crate) fn unwrap_arrays(view: &TextView<'_>) -> Vec<Edits> {
    let changes = single(view).filter_map(|(pou, group)| {
        let TypeSpecificationKind::Array { element, .. } = &group.specification.kind else {
            return None;
        };
        let initial = group.initializer.as_ref();
        let end = initial.map_or(group.specification.span.end, |one| one.span.end);
        let declared = group.specification.span.start as usize..end as usize;
        let mut edits = Edits::replacing(declared, element.span.text(view.text()));
        for (base, _, whole) in uses(view, pou, group) {
            edits.remove(base.span.end as usize..whole.span.end as usize);
        }
        Some(edits)
    });
    view.only_allowed(changes.collect())
}

/// Drops the last dimension of array variables, with the last subscript of their every use.
pub(crate) fn drop_dimensions(view: &TextView<'_>) -> Vec<Edits> {
    let last = |before, last| view.range_of_expression(before).end..view.range_of_expression(last).end;
    let changes = single(view).filter_map(|(pou, group)| {
        let TypeSpecificationKind::Array { dimensions, .. } = &group.specification.kind else {
            return None;
        };
        let [.., (_, before), (_, end)] = dimensions.as_slice() else {
            return None;
        };
        let mut edits = Edits::removing(last(*before, *end));
        for (_, subscripts, _) in uses(view, pou, group) {
            if let [.., before, end] = subscripts {
                edits.remove(last(*before, *end));
            }
        }
        Some(edits)
    });
    view.only_allowed(changes.collect())
}

/// Returns the declarations of a single variable, each with its unit.
fn single<'t>(view: &TextView<'t>) -> impl Iterator<Item = (&'t Pou<'t>, &'t VariableGroup<'t>)> {
    view.variables().filter(|(_, group)| group.names.len() == 1)
}

/// Returns the places at which a unit uses the variable of a declaration with subscripts: the variable, the subscripts, and the
/// whole expression.
fn uses<'t>(
    view: &TextView<'t>,
    pou: &Pou<'_>,
    group: &VariableGroup<'_>,
) -> Vec<(&'t Expression<'t>, &'t [ExpressionId], &'t Expression<'t>)> {
    let uses = group.names.iter().flat_map(|name| view.uses(pou, *name));
    let with_subscripts = uses.filter_map(|used| match &used.around?.kind {
        ExpressionKind::Index { base, subscripts }
            if view.unit.expression(*base)?.span == used.expression.span =>
        {
            Some((used.expression, subscripts.as_slice(), used.around?))
        }
        _ => None,
    });
    with_subscripts.collect()
}
