//! Operators in constant expressions whose type counts: integers are computed in their type.

use super::Known;
use crate::conversion::implicit;
use crate::diagnostic::Diagnostic;
use crate::semantics::chains::folds;
use crate::semantics::common::{Rules, settle};
use crate::semantics::constants::{Evaluator, NotConstant, combine};
use crate::semantics::expressions;
use crate::semantics::inferred::Inferred;
use crate::semantics::operators::{Operation, Signature};
use crate::semantics::types::TypeId;
use crate::source::Span;
use crate::syntax::tree::{BinaryOperator, ExpressionId, ExpressionKind, UnaryOperator};
use stickler_types::{Code, ElementaryType};

/// An operator on the left spine of a constant expression.
pub(super) struct Link {
    node: ExpressionId,
    operator: BinaryOperator,
    right: ExpressionId,
}

impl Evaluator<'_, '_> {
    fn rules(&self) -> Rules<'_> {
        Rules {
            types: self.types,
            dialect: self.source.dialect,
        }
    }

    pub(super) fn unary(
        &self,
        id: ExpressionId,
        operator: UnaryOperator,
        operand: ExpressionId,
        wanted: Option<ElementaryType>,
    ) -> Result<Known, NotConstant> {
        let span = self.source.expression(id).span;
        if let Some(signed) = self.signed_literal(id) {
            return self.literal(signed, wanted);
        }
        let wanted = settle(self.infer(operand), wanted.map(TypeId::of));
        match (operator, self.known(operand, wanted)?) {
            (UnaryOperator::Plus, known @ Known::Plain(ty, _)) if ty.is_integer() || ty.is_real() => {
                Ok(known)
            }
            (UnaryOperator::Negate, Known::Plain(ty, raw)) if ty.is_real() => {
                Ok(Known::Plain(ty, expressions::opposite(ty, raw)))
            }
            (UnaryOperator::Negate, known) => match known.number() {
                Some(number) => fitting(number.checked_neg(), known.ty(), span),
                None => Err(not_computed(span)),
            },
            _ => Err(not_computed(span)),
        }
    }

    /// The operators of the left spine, the last first, and what stands before them all.
    pub(super) fn spine(&self, id: ExpressionId) -> (Vec<Link>, ExpressionId) {
        let (mut links, mut at) = (Vec::new(), id);
        while let ExpressionKind::Binary {
            operator,
            left,
            right,
        } = self.source.expression(at).kind
        {
            links.push(Link {
                node: at,
                operator,
                right,
            });
            at = left;
        }
        (links, at)
    }

    /// Infix operators on integers, each computed in its type.
    pub(super) fn chain(
        &self,
        id: ExpressionId,
        wanted: Option<ElementaryType>,
    ) -> Result<Known, NotConstant> {
        let (links, first) = self.spine(id);
        let types = self.types_along(&links, first);
        let mut wanted = wanted.map(TypeId::of);
        let mut operations = Vec::with_capacity(links.len());
        for (link, &left) in links.iter().zip(types.iter().rev().skip(1)) {
            let operation = self.operation(link, left, wanted)?;
            wanted = Some(operation.left);
            operations.push(operation);
        }
        let mut value = self.known(first, wanted.and_then(TypeId::elementary))?;
        for (link, operation) in links.iter().zip(operations).rev() {
            value = self.computed(link, operation, &value)?;
        }
        Ok(value)
    }

    /// The types of what stands before the operators, and of what each of them gives, in the order of the text.
    pub(super) fn types_along(&self, links: &[Link], first: ExpressionId) -> Vec<Inferred> {
        let mut types = Vec::with_capacity(links.len() + 1);
        let mut left = self.infer(first);
        types.push(left);
        for link in links.iter().rev() {
            let signature = self
                .rules()
                .signature(link.operator, left, self.infer(link.right));
            left = match signature {
                Signature::Defined(operation) => Inferred::Known(operation.result),
                Signature::Untyped(inferred) => inferred,
                Signature::Undefined | Signature::Silent => Inferred::Error,
            };
            types.push(left);
        }
        types
    }

    fn operation(
        &self,
        link: &Link,
        left: Inferred,
        wanted: Option<TypeId>,
    ) -> Result<Operation, NotConstant> {
        let right = self.infer(link.right);
        let operation = match self.rules().signature(link.operator, left, right) {
            Signature::Defined(operation) => Some(operation),
            Signature::Untyped(inferred) => {
                settle(inferred, wanted).and_then(|ty| self.rules().at(link.operator, right, ty))
            }
            Signature::Undefined | Signature::Silent => None,
        };
        operation.ok_or_else(|| not_computed(self.source.expression(link.node).span))
    }

    fn computed(&self, link: &Link, operation: Operation, left: &Known) -> Result<Known, NotConstant> {
        let span = self.source.expression(link.node).span;
        let types = operation.left.elementary().zip(operation.right.elementary());
        let (left_type, right_type) = types.ok_or_else(|| not_computed(span))?;
        let left = match implicit(left.ty(), left_type, self.source.dialect) {
            Some(conversion) => left.converted(conversion),
            None => return Err(None),
        };
        let right = self.adapted(link.right, right_type)?;
        let (Some(left), Some(right)) = (left.number(), right.number()) else {
            return Err(not_computed(span));
        };
        let ty = folds(operation.action, right).ok_or_else(|| not_computed(span))?;
        match combine(link.operator, left, right) {
            Err((code @ Code::ConstantExpressionDivisionByZero, message)) => {
                Err(Some(Diagnostic::new(code, span, message)))
            }
            result => fitting(result.ok(), ty, span),
        }
    }
}

/// A number as the value of a type that holds it.
fn fitting(number: Option<i128>, ty: ElementaryType, span: Span) -> Result<Known, NotConstant> {
    if let Some(raw) = expressions::fitting(ty, number) {
        return Ok(Known::Plain(ty, raw));
    }
    let message = format!("the result does not fit {}", ty.name());
    Err(Some(Diagnostic::new(
        Code::ConstantExpressionOverflow,
        span,
        message,
    )))
}

fn not_computed(span: Span) -> NotConstant {
    let message = "in a constant expression operators compute with integers only";
    Some(Diagnostic::new(Code::VariableMustBeConst, span, message))
}
