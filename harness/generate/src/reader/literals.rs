//! Reading of literals back into the model.

use super::Reader;
use crate::generator::TypeContext;
use crate::model::{Expression, LiteralForm};
use stickler_syntax::tree::{self, ExpressionId, Literal, LiteralKind, UnaryOperator};
use stickler_types::{ElementaryType, Family, Value};

impl Reader<'_> {
    /// Reads a number without the prefix of its type as one of the type `ty`.
    pub(super) fn number(
        &self,
        id: ExpressionId,
        ty: ElementaryType,
        context: TypeContext,
    ) -> Option<Expression> {
        let (sign, literal) = self.bare_number(id)?;
        let suits = match ty.family() {
            Family::Signed | Family::Unsigned | Family::BitString => literal.kind != LiteralKind::Real,
            Family::Real => literal.kind == LiteralKind::Real,
            _ => false,
        };
        if !suits || !self.profile.takes_untyped(ty, context) {
            return None;
        }
        let value = Value::parse(&format!("{ty}#{sign}{}", literal.text())).ok()?;
        Some(Expression::literal(ty, value, LiteralForm::Untyped))
    }

    /// Reads a whole number without a prefix.
    pub(super) fn integer(&self, id: ExpressionId) -> Option<i128> {
        let (sign, literal) = self.bare_number(id)?;
        format!("{sign}{}", literal.text()).parse().ok()
    }

    /// Returns a number that has no prefix, and its sign.
    fn bare_number(&self, id: ExpressionId) -> Option<(&'static str, &Literal<'_>)> {
        match &self.unit.expression(id)?.kind {
            tree::ExpressionKind::Parenthesized(inner) => self.bare_number(*inner),
            tree::ExpressionKind::Unary {
                operator: UnaryOperator::Negate,
                operand,
            } => match self.bare_number(*operand)? {
                ("", literal) => Some(("-", literal)),
                _ => None,
            },
            tree::ExpressionKind::Literal(literal) if literal.prefix().is_none() => match literal.kind {
                LiteralKind::Integer | LiteralKind::BasedInteger | LiteralKind::Real => Some(("", literal)),
                _ => None,
            },
            _ => None,
        }
    }
}

/// Reads a literal that says its type: by a prefix, or by its form.
pub(super) fn typed(literal: &Literal<'_>) -> Option<Expression> {
    let prefix = literal.prefix().map_or("", |prefix| prefix.text);
    let ty = match literal.kind {
        LiteralKind::Boolean if prefix.is_empty() => ElementaryType::Bool,
        LiteralKind::SingleByteText if prefix.is_empty() => ElementaryType::String,
        LiteralKind::DoubleByteText if prefix.is_empty() => ElementaryType::Wstring,
        _ => ElementaryType::from_literal_prefix(prefix)?,
    };
    let value = Value::parse(&format!("{ty}#{}", literal.text())).ok()?;
    // T#, LT#, D# and LD# are what a duration or a date has without the prefix of its type.
    let form = match ElementaryType::from_name(prefix) {
        Some(_) => LiteralForm::Typed,
        None => LiteralForm::Untyped,
    };
    Some(Expression::literal(ty, value, form))
}
