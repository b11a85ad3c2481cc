//! Passes that drop statements and branches, or replace statements by those inside them.

use super::draft::{TextChange, TextDraft};
use super::tree::{behind_blanks, bodies, bytes, extent, label, lists, place, statements, with_semicolon};
use crate::reduce::Sites;
use std::ops::Range;
use stickler_syntax::tree::{Statement, StatementKind};

/// Drops statements with the statements inside them; those of the last program first.
pub(super) fn drop_statements(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop statements", sites, |draft| {
        let unit = draft.tree();
        let places = statements(&unit)
            .into_iter()
            .map(|statement| whole(&draft.text, statement));
        places.map(|place| TextChange::of(place, ";")).collect()
    });
}

/// Drops the semicolons of former statements; the last one of a list stays, because the standard demands a statement there,
/// and a compiler may do so too.
pub(super) fn drop_empty_statements(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop empty statements", sites, |draft| {
        let unit = draft.tree();
        let is_empty = |statement: &&Statement| matches!(statement.kind, StatementKind::Empty);
        let mut changes = Vec::new();
        for list in lists(&unit) {
            let empty: Vec<&Statement> = list.iter().filter(is_empty).collect();
            let stays = usize::from(empty.len() == list.len());
            let go = empty.into_iter().skip(stays);
            changes.extend(go.map(|statement| TextChange::drop(whole(&draft.text, statement))));
        }
        draft.only_allowed(changes)
    });
}

/// Returns the range of a statement with its semicolon.
fn whole(text: &str, statement: &Statement) -> Range<usize> {
    let place = bytes(statement.span);
    match statement.kind {
        // The span of a lone semicolon may be the semicolon.
        StatementKind::Empty if text[place.clone()].ends_with(';') => place,
        _ => place.start..with_semicolon(text, place.end),
    }
}

/// Replaces a statement by one of its bodies.
pub(super) fn splice(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("splice", sites, |draft| {
        let unit = draft.tree();
        let mut changes = Vec::new();
        for statement in statements(&unit) {
            for body in bodies(statement) {
                if let Some(inner) = extent(&draft.text, body) {
                    changes.push(TextChange::of(whole(&draft.text, statement), &draft.text[inner]));
                }
            }
        }
        draft.only_allowed(changes)
    });
}

/// Drops branches of IF and CASE, ELSE, labels of CASE, and BY.
pub(super) fn drop_branches(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop branches", sites, |draft| {
        let unit = draft.tree();
        let text = draft.text.as_str();
        let mut changes = Vec::new();
        for statement in statements(&unit) {
            match &statement.kind {
                StatementKind::If { branches, otherwise } => {
                    // From a condition to the next: what remains is one keyword, one condition, one body.
                    for pair in branches.windows(2) {
                        let (from, to) = (place(&unit, pair[0].0).start, place(&unit, pair[1].0).start);
                        changes.push(TextChange::drop(from..to));
                    }
                    if let [.., (_, before), (_, last)] = branches.as_slice() {
                        changes.extend(between_bodies(text, before, last));
                    }
                    if let (Some((_, before)), Some(otherwise)) = (branches.last(), otherwise) {
                        changes.extend(between_bodies(text, before, otherwise));
                    }
                }
                StatementKind::Case {
                    branches, otherwise, ..
                } => {
                    for branch in branches {
                        let first = branch.labels.first().map(|first| label(&unit, first).start);
                        let end = extent(text, &branch.body).map(|body| body.end);
                        changes.extend(first.zip(end).map(|(from, to)| TextChange::drop(from..to)));
                        for pair in branch.labels.windows(2) {
                            let (one, next) = (label(&unit, &pair[0]), label(&unit, &pair[1]));
                            changes.push(TextChange::drop(one.start..next.start));
                            changes.push(TextChange::drop(one.end..next.end));
                        }
                    }
                    if let (Some(before), Some(otherwise)) = (branches.last(), otherwise) {
                        changes.extend(between_bodies(text, &before.body, otherwise));
                    }
                }
                StatementKind::For { to, by: Some(by), .. } => {
                    changes.push(TextChange::drop(place(&unit, *to).end..place(&unit, *by).end));
                }
                _ => {}
            }
        }
        draft.only_allowed(changes)
    });
}

/// Drops the text from the end of one body to the end of the next: `ELSIF … THEN` or `ELSE` with its statements.
fn between_bodies(text: &str, before: &[Statement], next: &[Statement]) -> Option<TextChange> {
    let from = extent(text, before)?.end;
    let to = match extent(text, next) {
        Some(next) => next.end,
        // An empty ELSE: up to the end of the word.
        None => behind_blanks(text, from) + "ELSE".len(),
    };
    Some(TextChange::drop(from..to))
}
