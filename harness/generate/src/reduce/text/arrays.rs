//! Passes that make arrays smaller: to their elements, and to fewer dimensions.

use super::draft::{TextChange, TextDraft, TextEdit};
use super::tree::{bytes, place, pous};
use crate::reduce::Sites;
use std::ops::Range;
use stickler_syntax::tree::{
    Expression, ExpressionId, ExpressionKind, Pou, SourceUnit, TypeSpecificationKind, VariableGroup,
};

/// Gives the element type to array variables whose every use has subscripts.
pub(super) fn unwrap_arrays(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("unwrap arrays", sites, |draft| {
        let unit = draft.tree();
        let changes = declarations(&unit).filter_map(|(pou, group)| {
            let TypeSpecificationKind::Array { element, .. } = &group.specification.kind else {
                return None;
            };
            let end = group
                .initializer
                .as_ref()
                .map_or(group.specification.span.end, |one| one.span.end);
            let declared = group.specification.span.start as usize..end as usize;
            let mut edits = vec![TextEdit::new(declared, element.span.text(&draft.text))];
            for (base, _, whole) in uses(draft, &unit, pou, group) {
                edits.push(TextEdit::new(base.end..whole.span.end as usize, ""));
            }
            Some(TextChange(edits))
        });
        draft.only_allowed(changes.collect())
    });
}

/// Drops the last dimension of array variables, with the last subscript of their every use.
pub(super) fn drop_dimensions(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop dimensions", sites, |draft| {
        let unit = draft.tree();
        let without = |before, last| TextEdit::new(place(&unit, before).end..place(&unit, last).end, "");
        let changes = declarations(&unit).filter_map(|(pou, group)| {
            let TypeSpecificationKind::Array { dimensions, .. } = &group.specification.kind else {
                return None;
            };
            let [.., (_, before), (_, last)] = dimensions.as_slice() else {
                return None;
            };
            let mut edits = vec![without(*before, *last)];
            for (_, subscripts, _) in uses(draft, &unit, pou, group) {
                if let [.., before, last] = subscripts {
                    edits.push(without(*before, *last));
                }
            }
            Some(TextChange(edits))
        });
        draft.only_allowed(changes.collect())
    });
}

/// Returns the declarations of a single variable, each with its unit.
fn declarations<'t, 's>(
    unit: &'t SourceUnit<'s>,
) -> impl Iterator<Item = (&'t Pou<'s>, &'t VariableGroup<'s>)> {
    let groups = |pou: &'t Pou<'s>| {
        let groups = pou.blocks.iter().flat_map(|block| &block.groups);
        groups.map(move |group| (pou, group))
    };
    pous(unit)
        .flat_map(groups)
        .filter(|(_, group)| group.names.len() == 1)
}

/// Returns the places at which a unit uses the variable of a declaration with subscripts: that of the variable, the subscripts, and the whole
/// expression.
fn uses<'t, 's>(
    draft: &TextDraft,
    unit: &'t SourceUnit<'s>,
    pou: &Pou<'_>,
    group: &VariableGroup<'_>,
) -> Vec<(Range<usize>, &'t [ExpressionId], &'t Expression<'s>)> {
    let inside = bytes(pou.span);
    let names = |base: &Range<usize>| {
        let text = &draft.text[base.clone()];
        inside.contains(&base.start)
            && group
                .names
                .iter()
                .any(|name| text.eq_ignore_ascii_case(name.text))
    };
    let used = |whole: &'t Expression<'s>| match &whole.kind {
        ExpressionKind::Index { base, subscripts } => {
            Some((place(unit, *base), subscripts.as_slice(), whole)).filter(|(base, ..)| names(base))
        }
        _ => None,
    };
    unit.expressions.iter().filter_map(used).collect()
}
