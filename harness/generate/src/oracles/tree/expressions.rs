//! Expressions, literals and arguments.

use super::visitor::{Visitor, id, list, name, option};
use stickler_reference::syntax::tree::{
    Argument, Expression, ExpressionKind, Literal, LiteralKind, PartialAccessForm,
};

pub(super) fn expression<V: Visitor>(expression: &Expression<'_>, visitor: &mut V) {
    let Expression { kind, span } = expression;
    visitor.enter(*span);
    match kind {
        ExpressionKind::Literal(of) => {
            visitor.number(1);
            literal(of, visitor);
        }
        ExpressionKind::Name(of) => {
            visitor.number(2);
            visitor.name(of);
        }
        ExpressionKind::EnumeratedValue(prefixed) => {
            visitor.number(3);
            visitor.name(&prefixed.prefix());
            visitor.name(&prefixed.value());
        }
        ExpressionKind::Field { base, field } => {
            visitor.number(4);
            visitor.expression(*base);
            visitor.name(field);
        }
        ExpressionKind::Index { base, subscripts } => {
            visitor.number(5);
            visitor.expression(*base);
            list(subscripts, visitor, id);
        }
        ExpressionKind::PartialAccess {
            base,
            form,
            index,
            suffix,
        } => {
            visitor.number(6);
            visitor.expression(*base);
            // The renderer writes both forms of a bit as `.n`. Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax.
            visitor.number(match form {
                PartialAccessForm::Bit => PartialAccessForm::Short as u64,
                other => *other as u64,
            });
            visitor.number(*index);
            visitor.enter(*suffix);
            visitor.leave();
        }
        ExpressionKind::Call { callee, arguments } => {
            visitor.number(7);
            visitor.expression(*callee);
            list(arguments, visitor, argument);
        }
        ExpressionKind::Unary { operator, operand } => {
            visitor.number(8);
            visitor.number(*operator as u64);
            visitor.expression(*operand);
        }
        ExpressionKind::Binary {
            operator,
            left,
            right,
        } => {
            visitor.number(9);
            visitor.number(*operator as u64);
            visitor.expression(*left);
            visitor.expression(*right);
        }
        ExpressionKind::Parenthesized(inner) => {
            visitor.number(10);
            visitor.expression(*inner);
        }
        ExpressionKind::Error => visitor.number(11),
    }
    visitor.leave();
}

fn literal<V: Visitor>(literal: &Literal<'_>, visitor: &mut V) {
    visitor.number(literal.kind as u64);
    option(literal.prefix().as_ref(), visitor, name);
    visitor.written(literal.text(), literal.kind == LiteralKind::Boolean);
}

fn argument<V: Visitor>(argument: &Argument<'_>, visitor: &mut V) {
    match argument {
        Argument::Positional(value) => {
            visitor.number(1);
            visitor.expression(*value);
        }
        Argument::Named { name, value } => {
            visitor.number(2);
            visitor.name(name);
            visitor.expression(*value);
        }
        Argument::Output {
            name,
            negated,
            target,
        } => {
            visitor.number(3 + u64::from(*negated));
            visitor.name(name);
            visitor.expression(*target);
        }
    }
}
