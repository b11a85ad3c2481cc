//! Passes that make arrays smaller: to their elements, and to fewer dimensions.

use super::draft::{TextChange, TextDraft, TextEdit};
use super::tree::{bytes, place, pous};
use crate::reduce::Sites;
use stickler_reference::syntax::tree::{ExpressionKind, TypeSpecificationKind};

/// Gives the element type to array variables whose every use has subscripts.
pub(super) fn unwrap_arrays(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("unwrap arrays", sites, |draft| {
        let unit = draft.tree();
        let mut changes = Vec::new();
        for pou in pous(&unit) {
            for group in pou.blocks.iter().flat_map(|block| &block.groups) {
                let ([name], TypeSpecificationKind::Array { element, .. }) =
                    (group.names.as_slice(), &group.specification.kind)
                else {
                    continue;
                };
                let end = group
                    .initializer
                    .as_ref()
                    .map_or(group.specification.span.end, |one| one.span.end);
                let declared = group.specification.span.start as usize..end as usize;
                let mut edits = vec![TextEdit::new(declared, element.span.text(&draft.text))];
                let inside = bytes(pou.span);
                for expression in &unit.expressions {
                    if let ExpressionKind::Index { base, .. } = &expression.kind
                        && let base = place(&unit, *base)
                        && inside.contains(&base.start)
                        && draft.text[base.clone()].eq_ignore_ascii_case(name.text)
                    {
                        edits.push(TextEdit::new(base.end..expression.span.end as usize, ""));
                    }
                }
                changes.push(TextChange(edits));
            }
        }
        draft.only_allowed(changes)
    });
}

/// Drops the last dimension of array variables, with the last subscript of their every use.
pub(super) fn drop_dimensions(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop dimensions", sites, |draft| {
        let unit = draft.tree();
        let mut changes = Vec::new();
        for pou in pous(&unit) {
            for group in pou.blocks.iter().flat_map(|block| &block.groups) {
                let ([name], TypeSpecificationKind::Array { dimensions, .. }) =
                    (group.names.as_slice(), &group.specification.kind)
                else {
                    continue;
                };
                let [.., (_, before), (_, last)] = dimensions.as_slice() else {
                    continue;
                };
                let mut edits = vec![TextEdit::new(
                    place(&unit, *before).end..place(&unit, *last).end,
                    "",
                )];
                let inside = bytes(pou.span);
                for expression in &unit.expressions {
                    if let ExpressionKind::Index { base, subscripts } = &expression.kind
                        && let base = place(&unit, *base)
                        && inside.contains(&base.start)
                        && draft.text[base].eq_ignore_ascii_case(name.text)
                        && let [.., before, last] = subscripts.as_slice()
                    {
                        edits.push(TextEdit::new(
                            place(&unit, *before).end..place(&unit, *last).end,
                            "",
                        ));
                    }
                }
                changes.push(TextChange(edits));
            }
        }
        draft.only_allowed(changes)
    });
}
