//! Operators that are called as functions: `ADD(a, b, c)`.
//!
//! Two arguments meet as the operands of the operator do. More take the type that they have in common, as those of any other function.
//!
//! Basis: iec-61131-3: Tables 29, 31 and 33.

use super::chains::Link;
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::lowering::{LoweredValue, Lowering};
use super::operators::{Action, OperatorSignature, TypedOperation};
use super::types::TypeId;
use crate::instruction::{ComparisonOperator, StandardFunction};
use stickler_syntax::tree::{BinaryOperator, ExpressionId};
use stickler_types::{Code, ElementaryType};

impl Lowering<'_> {
    /// Infers the type of such a call by itself.
    pub(super) fn infer_operator(&mut self, operator: BinaryOperator, values: &[ExpressionId]) -> Inferred {
        let operands = self.meeting_operands(values);
        let mut left = operands[0];
        for &right in &operands[1..] {
            left = match self.rules().signature(operator, left, right) {
                OperatorSignature::Defined(operation) if compared(operation).is_some() => {
                    return Inferred::Known(operation.result);
                }
                OperatorSignature::Defined(operation) => Inferred::Known(operation.result),
                OperatorSignature::Untyped(inferred) => inferred,
                OperatorSignature::Undefined | OperatorSignature::Silent => return Inferred::Error,
            };
        }
        left
    }

    /// Returns the types in which arguments meet: two their own, more the one that they have in common.
    fn meeting_operands(&mut self, values: &[ExpressionId]) -> Vec<Inferred> {
        let inferred: Vec<_> = values.iter().map(|&value| self.infer(value)).collect();
        if inferred.len() < 3 || inferred.contains(&Inferred::Error) {
            return inferred;
        }
        let rules = self.rules();
        let common = match rules.common_of_all(&inferred) {
            Inferred::Known(ty) if !inferred.iter().all(|&one| rules.goes_with(one, ty)) => Inferred::Error,
            common => common,
        };
        vec![common; inferred.len()]
    }

    /// Calls an operator as a function.
    pub(super) fn call_operator(
        &mut self,
        call: ExpressionId,
        operator: BinaryOperator,
        values: &[ExpressionId],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let Some(operations) = self.operations(call, operator, values, wanted) else {
            return LoweredValue::ERROR;
        };
        let start = self.emitter.position();
        let first = operations[0];
        let mut value = self.value(values[0], Some(first.left));
        if let (Some((comparison, of)), 3..) = (compared(first), values.len()) {
            let mut is_sound = self.operand(values[0], value, first.left).ty != TypeId::ERROR;
            for &id in &values[1..] {
                let value = self.value(id, Some(first.left));
                is_sound &= self.operand(id, value, first.left).ty != TypeId::ERROR;
            }
            self.emit_standard(call, StandardFunction::InOrder(comparison), of, (values.len(), 0));
            return if is_sound {
                LoweredValue::of(ElementaryType::Bool)
            } else {
                LoweredValue::ERROR
            };
        }
        let mut left = values[0];
        for (&right, operation) in values[1..].iter().zip(operations) {
            let link = Link {
                node: call,
                operator,
                left,
                right,
                operation: Some(operation),
            };
            value = self.link(&link, value, start);
            left = call;
        }
        value
    }

    /// Returns the operations between the arguments, one fewer than these; `None` where one is not defined, which is reported.
    fn operations(
        &mut self,
        call: ExpressionId,
        operator: BinaryOperator,
        values: &[ExpressionId],
        wanted: Option<TypeId>,
    ) -> Option<Vec<TypedOperation>> {
        let operands = self.meeting_operands(values);
        let mut operations = Vec::with_capacity(values.len() - 1);
        let mut left = operands[0];
        for &right in &operands[1..] {
            match self.operation(operator, (left, right), wanted) {
                OperatorSignature::Defined(operation) => {
                    if compared(operation).is_none() {
                        left = Inferred::Known(operation.result);
                    }
                    operations.push(operation);
                }
                OperatorSignature::Undefined => {
                    let message = self.undefined(operator.function_name(), (left, right));
                    self.report(Code::FunctionCallArgTypeMismatch, self.span(call), message);
                    self.lower_each(values);
                    return None;
                }
                OperatorSignature::Untyped(_) | OperatorSignature::Silent => {
                    self.refuse_mixture(values);
                    return None;
                }
            }
        }
        Some(operations)
    }

    /// Reports the arguments that do not go with the others; says nothing of those in which something is wrong.
    fn refuse_mixture(&mut self, values: &[ExpressionId]) {
        let inferred: Vec<_> = values.iter().map(|&value| self.infer(value)).collect();
        if values.len() < 3 || inferred.contains(&Inferred::Error) {
            return self.lower_each(values);
        }
        match self.rules().common_of_all(&inferred) {
            Inferred::Known(ty) => {
                for &value in values {
                    self.coerce(value, ty, ValueContext::CommonArgument);
                }
            }
            _ => {
                self.lower_each(values);
                self.report_nothing_in_common(values[0]);
            }
        }
    }

    fn lower_each(&mut self, values: &[ExpressionId]) {
        for &value in values {
            self.value(value, None);
        }
    }
}

/// Returns how an operation compares its operands, and as which type; `None` where it does something else.
fn compared(operation: TypedOperation) -> Option<(ComparisonOperator, ElementaryType)> {
    match operation.action {
        Action::Compare(comparison, ty) => Some((comparison, ty)),
        Action::CompareText(comparison) => Some((comparison, operation.left.elementary()?)),
        _ => None,
    }
}
