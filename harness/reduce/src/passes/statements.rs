//! Passes that drop statements and branches, or replace statements by those inside them.

use crate::TextView;
use stickler_syntax::Edits;
use stickler_syntax::tree::{Statement, StatementKind};
use stickler_syntax::visitor::bodies;

/// Drops statements with the statements inside them; those of the last program first.
pub(crate) fn drop_statements(view: &TextView<'_>) -> Vec<Edits> {
    let statements = view.statements().into_iter();
    statements
        .map(|statement| Edits::replacing(view.range_of_statement(statement), ";"))
        .collect()
}

/// Drops one of several statements without leaving a semicolon, which a compiler may not take where it takes a statement.
pub(crate) fn remove_statements(view: &TextView<'_>) -> Vec<Edits> {
    let lists = view.lists().into_iter().filter(|list| list.len() > 1);
    let removed = lists
        .flatten()
        .map(|statement| Edits::removing(view.range_of_statement(statement)));
    view.only_allowed(removed.collect())
}

/// Drops the semicolons of former statements; the last one of a list stays, because the standard demands a statement there,
/// and a compiler may do so too.
pub(crate) fn drop_empty_statements(view: &TextView<'_>) -> Vec<Edits> {
    let is_empty = |statement: &&Statement| matches!(statement.kind, StatementKind::Empty);
    let mut changes = Vec::new();
    for list in view.lists() {
        let empty: Vec<&Statement> = list.iter().filter(is_empty).collect();
        let stays = usize::from(empty.len() == list.len());
        let go = empty.into_iter().skip(stays);
        changes.extend(go.map(|statement| Edits::removing(view.range_of_statement(statement))));
    }
    view.only_allowed(changes)
}

/// Replaces a statement by one of its bodies.
pub(crate) fn splice(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for statement in view.statements() {
        for inner in bodies(statement)
            .into_iter()
            .filter_map(|body| view.range_of_statements(body))
        {
            changes.push(Edits::replacing(
                view.range_of_statement(statement),
                &view.text()[inner],
            ));
        }
    }
    view.only_allowed(changes)
}

/// Drops branches of IF and CASE, ELSE, labels of CASE, and BY.
pub(crate) fn drop_branches(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = Vec::new();
    for statement in view.statements() {
        match &statement.kind {
            StatementKind::If { branches, otherwise } => {
                // From a condition to the next: what remains is one keyword, one condition, one body.
                for pair in branches.windows(2) {
                    let (from, to) = (
                        view.range_of_expression(pair[0].0).start,
                        view.range_of_expression(pair[1].0).start,
                    );
                    changes.push(Edits::removing(from..to));
                }
                if let [.., (_, before), (_, last)] = branches.as_slice() {
                    changes.extend(between_bodies(view, before, last));
                }
                if let (Some((_, before)), Some(otherwise)) = (branches.last(), otherwise) {
                    changes.extend(between_bodies(view, before, otherwise));
                }
            }
            StatementKind::Case {
                branches, otherwise, ..
            } => {
                for branch in branches {
                    let first = branch
                        .labels
                        .first()
                        .map(|first| view.range_of_label(first).start);
                    let end = view.range_of_statements(&branch.body).map(|body| body.end);
                    changes.extend(first.zip(end).map(|(from, to)| Edits::removing(from..to)));
                    for pair in branch.labels.windows(2) {
                        let (one, next) = (view.range_of_label(&pair[0]), view.range_of_label(&pair[1]));
                        changes.push(Edits::removing(one.start..next.start));
                        changes.push(Edits::removing(one.end..next.end));
                    }
                }
                if let (Some(before), Some(otherwise)) = (branches.last(), otherwise) {
                    changes.extend(between_bodies(view, &before.body, otherwise));
                }
            }
            StatementKind::For { to, by: Some(by), .. } => {
                changes.push(Edits::removing(
                    view.range_of_expression(*to).end..view.range_of_expression(*by).end,
                ));
            }
            _ => {}
        }
    }
    view.only_allowed(changes)
}

/// Drops the text from the end of one body to the end of the next: `ELSIF … THEN` or `ELSE` with its statements.
fn between_bodies(view: &TextView<'_>, before: &[Statement], next: &[Statement]) -> Option<Edits> {
    let from = view.range_of_statements(before)?.end;
    let to = match view.range_of_statements(next) {
        Some(next) => next.end,
        // An empty ELSE: up to the end of the word.
        None => view.next(from)?.span.end as usize,
    };
    Some(Edits::removing(from..to))
}
