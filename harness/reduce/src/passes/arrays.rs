//! Passes that make variables of several parts smaller: arrays, structures and bit strings to one of their elements, and arrays to fewer
//! dimensions.

use crate::TextView;
use stickler_syntax::Edits;
use stickler_syntax::tree::{
    Expression, ExpressionId, ExpressionKind, Name, Pou, TypeSpecificationKind, VariableGroup,
};

/// Gives the element type to array variables whose every use has subscripts.
pub(crate) fn unwrap_arrays(view: &TextView<'_>) -> Vec<Edits> {
    let changes = single(view).filter_map(|(pou, group)| {
        let TypeSpecificationKind::Array { element, .. } = &group.specification.kind else {
            return None;
        };
        let uses = uses(view, pou, group);
        let uses = uses.into_iter().map(|(base, _, whole)| (base, whole));
        Some(with_type_of_element(group, element.span.text(view.text()), uses))
    });
    view.only_allowed(changes.collect())
}

/// Gives the type of an element to variables of a structure whose every use is that element.
pub(crate) fn unwrap_structures(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for (pou, group) in single(view) {
        let structure = match &group.specification.kind {
            TypeSpecificationKind::Named(name) => view
                .unit
                .types()
                .find(|declared| declared.name.text.eq_ignore_ascii_case(name.text))
                .map(|declared| &declared.specification.kind),
            kind => Some(kind),
        };
        let Some(TypeSpecificationKind::Structure(elements)) = structure else {
            continue;
        };
        let uses: Vec<_> = group
            .names
            .iter()
            .flat_map(|name| view.uses(pou, *name))
            .collect();
        for element in elements {
            let is_element = |field: &Name<'_>| {
                let mut names = element.names.iter();
                names.any(|name| name.text.eq_ignore_ascii_case(field.text))
            };
            let with_field = uses.iter().filter_map(|used| match &view.around(used)?.kind {
                ExpressionKind::Field { base, field }
                    if is_element(field) && view.unit.expression(*base)?.span == used.expression.span =>
                {
                    Some((used.expression, view.around(used)?))
                }
                _ => None,
            });
            changes.push(with_type_of_element(
                group,
                element.specification.span.text(view.text()),
                with_field,
            ));
        }
    }
    view.only_allowed(changes)
}

/// Gives the type BOOL to variables whose every use is a bit.
pub(crate) fn unwrap_bits(view: &TextView<'_>) -> Vec<Edits> {
    let changes = single(view).map(|(pou, group)| {
        let uses = group.names.iter().flat_map(|name| view.uses(pou, *name));
        let bits = uses.filter_map(|used| match &view.around(&used)?.kind {
            ExpressionKind::Bit { base, .. } if view.unit.expression(*base)?.span == used.expression.span => {
                Some((used.expression, view.around(&used)?))
            }
            _ => None,
        });
        let bits: Vec<_> = bits.collect();
        (!bits.is_empty()).then(|| with_type_of_element(group, "BOOL", bits.into_iter()))
    });
    view.only_allowed(changes.flatten().collect())
}

/// Returns the change that declares a variable with the type of its element, and leaves of its uses, each with the whole expression, the
/// variable.
fn with_type_of_element<'t>(
    group: &VariableGroup<'_>,
    element: &str,
    uses: impl Iterator<Item = (&'t Expression<'t>, &'t Expression<'t>)>,
) -> Edits {
    let initial = group.initializer.as_ref();
    let end = initial.map_or(group.specification.span.end, |one| one.span.end);
    let declared = group.specification.span.start as usize..end as usize;
    let mut edits = Edits::replacing(declared, element);
    for (variable, whole) in uses {
        edits.remove(variable.span.end as usize..whole.span.end as usize);
    }
    edits
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
    let with_subscripts = uses.filter_map(|used| match &view.around(&used)?.kind {
        ExpressionKind::Index { base, subscripts }
            if view.unit.expression(*base)?.span == used.expression.span =>
        {
            Some((used.expression, subscripts.as_slice(), view.around(&used)?))
        }
        _ => None,
    });
    with_subscripts.collect()
}
