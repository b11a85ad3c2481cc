//! Statements.

use super::visitor::{Visitor, id, list, option, range};
use stickler_reference::syntax::tree::{CaseBranch, CaseLabel, Statement, StatementKind};

fn statements<V: Visitor>(body: &[Statement], visitor: &mut V) {
    list(body, visitor, statement);
}

pub(super) fn statement<V: Visitor>(of: &Statement, visitor: &mut V) {
    let Statement { kind, span } = of;
    visitor.enter(*span);
    match kind {
        StatementKind::Assignment { target, value } => {
            visitor.number(1);
            visitor.expression(*target);
            visitor.expression(*value);
        }
        StatementKind::Call(call) => {
            visitor.number(2);
            visitor.expression(*call);
        }
        StatementKind::If { branches, otherwise } => {
            visitor.number(3);
            list(branches, visitor, |(condition, body), visitor| {
                visitor.expression(*condition);
                statements(body, visitor);
            });
            option(otherwise.as_deref(), visitor, statements);
        }
        StatementKind::Case {
            selector,
            branches,
            otherwise,
        } => {
            visitor.number(4);
            visitor.expression(*selector);
            list(branches, visitor, case_branch);
            option(otherwise.as_deref(), visitor, statements);
        }
        StatementKind::For {
            control,
            from,
            to,
            by,
            body,
        } => {
            visitor.number(5);
            visitor.expression(*control);
            range(&(*from, *to), visitor);
            option(by.as_ref(), visitor, id);
            statements(body, visitor);
        }
        StatementKind::While { condition, body } => {
            visitor.number(6);
            visitor.expression(*condition);
            statements(body, visitor);
        }
        StatementKind::Repeat { body, until } => {
            visitor.number(7);
            statements(body, visitor);
            visitor.expression(*until);
        }
        StatementKind::Exit => visitor.number(8),
        StatementKind::Continue => visitor.number(9),
        StatementKind::Return => visitor.number(10),
        StatementKind::Empty => visitor.number(11),
    }
    visitor.leave();
}

fn case_branch<V: Visitor>(CaseBranch { labels, body }: &CaseBranch, visitor: &mut V) {
    list(labels, visitor, |label, visitor| match label {
        CaseLabel::Value(value) => {
            visitor.number(1);
            visitor.expression(*value);
        }
        CaseLabel::Range(low, high) => {
            visitor.number(2);
            range(&(*low, *high), visitor);
        }
    });
    statements(body, visitor);
}
