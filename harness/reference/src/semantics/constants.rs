//! Constant expressions: their operands and their values.
//!
//! Limits of arrays and subranges, lengths of texts, numbers of enumerated values and repetitions take numbers of
//! any size, so there operators compute with exact numbers. Where types count, in an initial value and in the
//! arguments of a conversion function, a constant expression is lowered as any other, and is constant where no more
//! is left of its code than the push of a value.

use super::calls::Callee;
use super::constant::{Constant, ConstantValue};
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::lowering::{LoweredValue, Lowering};
use super::types::TypeId;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Argument, BinaryOperator, ExpressionId, ExpressionKind, Literal, LiteralKind, Name, UnaryOperator,
};
use stickler_types::{Code, ElementaryType, literal};

impl<'m> Lowering<'m> {
    /// Returns the exact number that an expression stands for; where it stands for none, reports why. The left spine of
    /// a chain of operators is walked without recursion.
    pub(super) fn constant_number(&mut self, id: ExpressionId) -> Option<i128> {
        let mut spine = Vec::new();
        let mut at = id;
        while let Some((operator, left, right)) = self.expression(at).binary() {
            spine.push((at, operator, right));
            at = left;
        }
        let mut value = self.constant_operand(at)?;
        for (node, operator, right) in spine.into_iter().rev() {
            let right = self.constant_number(right)?;
            match combine(operator, value, right) {
                Ok(result) => value = result,
                Err((code, message)) => {
                    return self.no_number(SpannedDiagnostic::new(code, self.span(node), message));
                }
            }
        }
        Some(value)
    }

    fn constant_operand(&mut self, id: ExpressionId) -> Option<i128> {
        let expression = self.expression(id);
        match &expression.kind {
            ExpressionKind::Literal(literal) => self.integer_literal(literal, expression.span),
            ExpressionKind::Name(name) => {
                let constant = self.constant_of(*name);
                let number = match &constant {
                    Constant::Known(value) => value.number(),
                    _ => None,
                };
                number.or_else(|| self.no_number(constant.refusal(*name)?))
            }
            ExpressionKind::Parenthesized(inner)
            | ExpressionKind::Unary {
                operator: UnaryOperator::Plus,
                operand: inner,
            } => self.constant_number(*inner),
            ExpressionKind::Unary {
                operator: UnaryOperator::Negate,
                operand,
            } => {
                let negative = self.constant_number(*operand)?.checked_neg();
                negative.or_else(|| self.no_number(too_large(expression.span)))
            }
            ExpressionKind::Call { .. } => self.constant_call(id),
            ExpressionKind::Error => None,
            _ => self.no_number(self.no_constant(id)),
        }
    }

    fn integer_literal(&mut self, literal: &Literal<'_>, span: Span) -> Option<i128> {
        let typed = literal.prefix();
        let integer = matches!(literal.kind, LiteralKind::Integer | LiteralKind::BasedInteger)
            && typed.is_none_or(|prefix| {
                ElementaryType::from_name(prefix.text).is_some_and(ElementaryType::is_integer)
            });
        if !integer {
            return self.no_number(no_integer(span));
        }
        let number = literal::integer(literal.text()).ok();
        number.or_else(|| self.no_number(too_large(span)))
    }

    /// Returns the number that a call of a conversion function gives.
    fn constant_call(&mut self, id: ExpressionId) -> Option<i128> {
        let span = self.span(id);
        let parts = match self.constant_parts(id) {
            Ok(parts) => parts,
            Err(reason) => return self.no_number(reason?),
        };
        match self.fold(&parts, |lowering| lowering.value(id, None)) {
            Constant::Known(value) => value.number().or_else(|| self.no_number(no_integer(span))),
            Constant::Computed => {
                let message = "in a constant expression operators compute with integers only, which must fit their types";
                self.no_number(SpannedDiagnostic::new(Code::VariableMustBeConst, span, message))
            }
            _ => None,
        }
    }

    fn no_number(&mut self, reason: SpannedDiagnostic) -> Option<i128> {
        self.reporter.push(reason);
        None
    }

    /// Returns what an initial value of a constant of a type stands for; where something is wrong with it,
    /// [`Constant::Silent`].
    pub(super) fn constant_initializer(&mut self, id: ExpressionId, ty: ElementaryType) -> Constant {
        match self.constant_parts(id) {
            Ok(parts) => self.fold(&parts, |lowering| {
                lowering.coerce(id, TypeId::of(ty), ValueContext::Initializer)
            }),
            // This may well be an initial value, if not one that is known here.
            Err(Some(reason)) if is_computed(reason.code) => Constant::Computed,
            Err(_) => Constant::Silent,
        }
    }

    /// Lowers an expression that consists of these parts, and takes the value that is all that is left of it.
    fn fold(&mut self, parts: &[ExpressionId], lower: impl FnOnce(&mut Self) -> LoweredValue) -> Constant {
        self.inferred
            .resize(self.model.source.unit.expressions.len(), Inferred::Pending);
        let (start, errors) = (self.emitter.position(), self.reporter.errors());
        let value = lower(self);
        let constant = match value.ty.elementary() {
            _ if self.reporter.errors() > errors => Constant::Silent,
            None => Constant::Silent,
            Some(ty) => self.pushed(ty, start).map_or(Constant::Computed, Constant::Known),
        };
        self.emitter.truncate(start);
        // Not everything is declared yet, so that the same names may have other types later.
        for part in parts {
            self.inferred[part.0 as usize] = Inferred::Pending;
        }
        constant
    }

    fn pushed(&self, ty: ElementaryType, start: u32) -> Option<ConstantValue> {
        if ty.is_text() {
            let units = self.emitter.text_pushed_since(start)?;
            Some(ConstantValue::Text(ty, units.into()))
        } else {
            Some(ConstantValue::Plain(ty, self.emitter.pushed_since(start)?))
        }
    }

    /// Returns all parts of an expression, itself the first, if they are literals, constants whose values are known,
    /// operators and calls of conversion functions. Otherwise returns what is wrong, or nothing where that has been
    /// reported.
    pub(super) fn constant_parts(
        &mut self,
        id: ExpressionId,
    ) -> Result<Vec<ExpressionId>, Option<SpannedDiagnostic>> {
        let (mut parts, mut waiting) = (Vec::new(), vec![id]);
        while let Some(id) = waiting.pop() {
            parts.push(id);
            let expression = self.expression(id);
            match &expression.kind {
                ExpressionKind::Literal(_) => {}
                ExpressionKind::Name(name) => match self.constant_of(*name) {
                    Constant::Known(_) => {}
                    constant => return Err(constant.refusal(*name)),
                },
                ExpressionKind::Parenthesized(inner) | ExpressionKind::Unary { operand: inner, .. } => {
                    waiting.push(*inner);
                }
                ExpressionKind::Binary { left, right, .. } => waiting.extend([*right, *left]),
                ExpressionKind::Call { callee, arguments } => {
                    self.constant_callee(*callee, expression.span)?;
                    waiting.extend(arguments.iter().rev().map(|argument| match argument {
                        Argument::Positional(value)
                        | Argument::Named { value, .. }
                        | Argument::Output { target: value, .. } => *value,
                    }));
                }
                ExpressionKind::Error => return Err(None),
                _ => return Err(Some(self.no_constant(id))),
            }
        }
        Ok(parts)
    }

    /// Refuses a callee that is no conversion function: an undeclared one, or one that computes only as the program runs.
    fn constant_callee(&mut self, callee: ExpressionId, call: Span) -> Result<(), Option<SpannedDiagnostic>> {
        match self.callee(callee) {
            Callee::Conversion(_) | Callee::Concatenation(_) => Ok(()),
            Callee::Nothing(code @ Code::FunctionCallUndeclared, reason) => {
                let name = self.model.source.text_of(callee);
                let hint = self.similar_function(callee);
                let message = format!("`{name}` {reason}{hint}");
                Err(Some(SpannedDiagnostic::new(code, self.span(callee), message)))
            }
            _ => Err(Some(not_constant(call))),
        }
    }

    /// Says that an expression is no constant, or that nothing is declared under the name with which it begins.
    fn no_constant(&self, id: ExpressionId) -> SpannedDiagnostic {
        let refused = not_constant(self.span(id));
        let ExpressionKind::Field { base, .. } = self.expression(id).kind else {
            return refused;
        };
        let ExpressionKind::Name(name) = self.expression(base).kind else {
            return refused;
        };
        let is_known = self.variable(name.text).is_some() || self.model.definition(name).is_some();
        let undeclared = Constant::Unknown.refusal(name).filter(|_| !is_known);
        undeclared.unwrap_or(refused)
    }

    fn constant_of(&self, name: Name<'_>) -> Constant {
        let variable = self.variable(name.text);
        variable.map_or(Constant::Unknown, |(_, variable)| variable.value.clone())
    }
}

/// Returns whether what is no constant for this reason is perhaps a value that the running program computes.
const fn is_computed(code: Code) -> bool {
    matches!(code, Code::VariableMustBeConst | Code::ConstantNotIntegerType)
}

fn not_constant(span: Span) -> SpannedDiagnostic {
    let message = "only literals, constants, operators and conversion functions may stand here";
    SpannedDiagnostic::new(Code::VariableMustBeConst, span, message)
}

fn no_integer(span: Span) -> SpannedDiagnostic {
    SpannedDiagnostic::new(Code::ConstantNotIntegerType, span, "an integer is needed here")
}

fn too_large(span: Span) -> SpannedDiagnostic {
    SpannedDiagnostic::new(Code::ConstantOverflow, span, "the number is too large")
}

/// Returns the exact result of an operator.
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
