//! Constant expressions of integers, with exact numbers: limits of arrays and subranges, lengths of texts,
//! numbers of enumerated values, repetitions. Where types count, [`super::folding`] goes on.

use super::folding::{Known, not_constant};
use super::model::{Definition, Source};
use super::scope::Scope;
use super::types::TypeTable;
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::syntax::tree::{BinaryOperator, ExpressionId, ExpressionKind, LiteralKind, Name, UnaryOperator};
use stickler_types::{Code, ElementaryType, literal};

/// What a name means in a constant expression.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Constant {
    /// A number, and the integer type that the constant has, which holds it.
    Value(i128, ElementaryType),
    /// A constant of another elementary type; of a text a short one, lest each use of a long one cost much.
    Typed(Known),
    /// A constant whose own value was not understood, which has been said.
    Silent,
    /// A variable.
    Variable,
    /// A constant that is no integer, or whose value only the running program knows.
    NotInteger,
    /// A constant without a value.
    Missing,
    /// Nothing has this name.
    Unknown,
}

impl Constant {
    /// Whether the value is known.
    pub(super) const fn is_known(&self) -> bool {
        matches!(self, Constant::Value(..) | Constant::Typed(_))
    }
}

/// Why an expression has no constant value; `None` where that has been said already.
pub(super) type NotConstant = Option<Diagnostic>;

/// Evaluates constant expressions.
pub(super) struct Evaluator<'a, 'u> {
    /// The tree.
    pub(super) source: Source<'u>,
    /// The types of the text.
    pub(super) types: &'a TypeTable,
    /// What is declared at the top level.
    pub(super) definitions: &'a Scope<'u, Definition>,
    /// What names mean.
    pub(super) lookup: &'a dyn Fn(Name<'u>) -> Constant,
}

impl<'u> Evaluator<'_, 'u> {
    /// The exact value of an expression. The left spine of a chain of operators is walked without recursion.
    pub(super) fn evaluate(&self, id: ExpressionId) -> Result<i128, NotConstant> {
        let mut spine = Vec::new();
        let mut at = id;
        while let ExpressionKind::Binary {
            operator,
            left,
            right,
        } = self.source.expression(at).kind
        {
            spine.push((at, operator, right));
            at = left;
        }
        let mut value = self.leaf(at)?;
        for (node, operator, right) in spine.into_iter().rev() {
            let right = self.evaluate(right)?;
            value = combine(operator, value, right).map_err(|(code, message)| {
                Some(Diagnostic::new(code, self.source.expression(node).span, message))
            })?;
        }
        Ok(value)
    }

    fn leaf(&self, id: ExpressionId) -> Result<i128, NotConstant> {
        let expression = self.source.expression(id);
        match &expression.kind {
            ExpressionKind::Literal(literal)
                if matches!(literal.kind, LiteralKind::Integer | LiteralKind::BasedInteger) =>
            {
                self.integer(id, literal.prefix(), literal.text())
            }
            ExpressionKind::Name(name) => self.name(*name),
            ExpressionKind::Parenthesized(inner) => self.evaluate(*inner),
            ExpressionKind::Unary {
                operator: UnaryOperator::Plus,
                operand,
            } => self.evaluate(*operand),
            ExpressionKind::Unary {
                operator: UnaryOperator::Negate,
                operand,
            } => {
                let value = self.evaluate(*operand)?;
                value.checked_neg().ok_or_else(|| Some(self.overflow(id)))
            }
            ExpressionKind::Error => Err(None),
            ExpressionKind::Call { .. } => {
                let known = self.call(id, None)?;
                known.number().ok_or_else(|| no_integer(expression.span))
            }
            ExpressionKind::Literal(_) => Err(no_integer(expression.span)),
            _ => Err(not_constant(expression.span)),
        }
    }

    fn integer(&self, id: ExpressionId, prefix: Option<Name<'_>>, text: &str) -> Result<i128, NotConstant> {
        let counts = prefix.is_none_or(|prefix| {
            ElementaryType::from_name(prefix.text).is_some_and(ElementaryType::is_integer)
        });
        if !counts {
            return Err(no_integer(self.source.expression(id).span));
        }
        literal::integer(text).map_err(|_| Some(self.overflow(id)))
    }

    fn overflow(&self, id: ExpressionId) -> Diagnostic {
        Diagnostic::new(
            Code::ConstantOverflow,
            self.source.expression(id).span,
            "the number is too large",
        )
    }

    fn name(&self, name: Name<'u>) -> Result<i128, NotConstant> {
        match (self.lookup)(name) {
            Constant::Value(value, _) => Ok(value),
            other => Err(self.refuse(name, &other)),
        }
    }

    /// Why a name that means no value has none.
    pub(super) fn refuse(&self, name: Name<'u>, meaning: &Constant) -> NotConstant {
        let (code, message) = match meaning {
            Constant::Value(..) | Constant::Silent => return None,
            Constant::Variable => (
                Code::VariableMustBeConst,
                "is a variable; a constant is needed here",
            ),
            Constant::Typed(_) | Constant::NotInteger => (
                Code::ConstantNotIntegerType,
                "is no constant of an integer type with a value that is known here",
            ),
            Constant::Missing => (Code::ConstantMissingInitializer, "is a constant without a value"),
            Constant::Unknown => (Code::UndefinedConstantReference, "is not declared"),
        };
        Some(Diagnostic::new(
            code,
            name.span,
            format!("`{}` {message}", name.text),
        ))
    }
}

fn no_integer(span: Span) -> NotConstant {
    Some(Diagnostic::new(
        Code::ConstantNotIntegerType,
        span,
        "an integer is needed here",
    ))
}

/// The exact result of an operator.
pub(super) fn combine(
    operator: BinaryOperator,
    left: i128,
    right: i128,
) -> Result<i128, (Code, &'static str)> {
    const TOO_LARGE: (Code, &str) = (
        Code::ConstantExpressionOverflow,
        "the constant expression is too large",
    );
    const BY_ZERO: (Code, &str) = (
        Code::ConstantExpressionDivisionByZero,
        "division by the constant zero",
    );
    match operator {
        BinaryOperator::Divide | BinaryOperator::Modulo if right == 0 => return Err(BY_ZERO),
        BinaryOperator::Add => left.checked_add(right),
        BinaryOperator::Subtract => left.checked_sub(right),
        BinaryOperator::Multiply => left.checked_mul(right),
        BinaryOperator::Divide => left.checked_div(right),
        BinaryOperator::Modulo => left.checked_rem(right),
        BinaryOperator::Power => match u32::try_from(right) {
            Ok(exponent) => left.checked_pow(exponent),
            // 0, 1 and -1 have every power; of others no integer is left, or none that fits.
            Err(_) => match (left, right < 0, right % 2 == 0) {
                (1, ..) => Some(1),
                (-1, _, even) => Some(if even { 1 } else { -1 }),
                (0, false, _) => Some(0),
                (_, true, _) => Some(0),
                _ => None,
            },
        },
        _ => return Err((Code::ConstantNotIntegerType, "an integer is needed here")),
    }
    .ok_or(TOO_LARGE)
}

#[cfg(test)]
mod tests {
    use super::combine;
    use crate::syntax::tree::BinaryOperator;
    use stickler_types::Code;

    #[test]
    fn division_goes_toward_zero_and_zero_divides_nothing() {
        assert_eq!(combine(BinaryOperator::Divide, -7, 2), Ok(-3));
        assert_eq!(combine(BinaryOperator::Modulo, -7, 2), Ok(-1));
        let error = combine(BinaryOperator::Modulo, 1, 0).map_err(|(code, _)| code);
        assert_eq!(error, Err(Code::ConstantExpressionDivisionByZero));
    }

    #[test]
    fn what_does_not_fit_is_said_to_be_too_large() {
        let error = combine(BinaryOperator::Multiply, i128::MAX, 2).map_err(|(code, _)| code);
        assert_eq!(error, Err(Code::ConstantExpressionOverflow));
        assert_eq!(combine(BinaryOperator::Power, 2, 64), Ok(1 << 64));
    }
}
