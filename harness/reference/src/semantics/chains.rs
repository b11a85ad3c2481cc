//! Lowers infix operators. A chain may be a million operators long, so its left spine is walked without
//! recursion: down, to learn what each operator takes, and up, to emit the code.

use super::common::settle;
use super::constants::combine;
use super::contexts::ValueContext;
use super::emitter::Jump;
use super::expressions::fitting;
use super::inferred::Inferred;
use super::lowering::{LoweredValue, Lowering};
use super::operators::{Action, OperatorSignature, TypedOperation};
use super::trace::UseKind;
use super::types::TypeId;
use crate::conversion::{Conversion, ConversionRule};
use crate::instruction::{ArithmeticOperator, Instruction};
use stickler_syntax::tree::{BinaryOperator, ExpressionId};
use stickler_types::dialect::OperandTypes;
use stickler_types::{Code, ElementaryType, MomentUnits};

/// An operator on the spine, or between two arguments of a function.
pub(super) struct Link {
    /// The expression whose value the operator gives, or the call.
    pub(super) node: ExpressionId,
    pub(super) operator: BinaryOperator,
    pub(super) left: ExpressionId,
    pub(super) right: ExpressionId,
    pub(super) operation: Option<TypedOperation>,
}

impl Lowering<'_> {
    /// Puts the value of an infix operator on the stack.
    pub(super) fn chain(&mut self, id: ExpressionId, wanted: Option<TypeId>) -> LoweredValue {
        self.infer(id);
        let mut links = Vec::new();
        let (mut at, mut wanted) = (id, wanted);
        while let Some((operator, left, right)) = self.expression(at).binary() {
            let operands = (self.infer(left), self.infer(right));
            let operation = match self.operation(operator, operands, wanted) {
                OperatorSignature::Defined(operation) => Some(operation),
                OperatorSignature::Undefined => {
                    let code = self.undefined_code(operator, operands);
                    let mut message = self.undefined(operator.as_str(), operands);
                    if code == Code::NotImplemented {
                        message += ": of an address, only a declared pointer and a number have a sum that is implemented";
                    }
                    self.report(code, self.span(at), message);
                    None
                }
                OperatorSignature::Untyped(_) | OperatorSignature::Silent => None,
            };
            wanted = operation.map(|operation| operation.left);
            links.push(Link {
                node: at,
                operator,
                left,
                right,
                operation,
            });
            at = left;
        }
        let start = self.emitter.position();
        let mut value = self.value(at, wanted);
        for link in links.into_iter().rev() {
            value = self.link(&link, value, start);
        }
        value
    }

    /// Finds the operation of an operator, for untyped operands in the type that is wanted; never [`OperatorSignature::Untyped`].
    pub(super) fn operation(
        &self,
        operator: BinaryOperator,
        (left, right): (Inferred, Inferred),
        wanted: Option<TypeId>,
    ) -> OperatorSignature {
        let rules = self.rules();
        match rules.signature(operator, left, right) {
            OperatorSignature::Untyped(inferred) => {
                let is_real = |ty: &TypeId| ty.elementary().is_some_and(ElementaryType::is_real);
                let is_whole = self.model.source.dialect.operands == OperandTypes::Promoted
                    && matches!(inferred, Inferred::Integer(_));
                let wanted = wanted.filter(|ty| !(is_whole && is_real(ty)));
                let operation = settle(inferred, wanted).and_then(|ty| rules.at(operator, right, ty));
                operation.map_or(OperatorSignature::Undefined, OperatorSignature::Defined)
            }
            signature => signature,
        }
    }

    /// Returns the message about an operator or function that is not defined for its operands.
    pub(super) fn undefined(&self, name: &str, (left, right): (Inferred, Inferred)) -> String {
        let (left, right) = (self.describe(left), self.describe(right));
        format!("`{name}` is not defined for {left} and {right}")
    }

    /// Lowers the right operand and the operator, the left operand being on the stack.
    pub(super) fn link(&mut self, link: &Link, left: LoweredValue, start: u32) -> LoweredValue {
        let Some(operation) = link.operation else {
            self.value(link.right, None);
            return LoweredValue::ERROR;
        };
        self.warn_of_operands(link.operator, (link.left, link.right));
        let left = self.operand(link.left, left, operation.left);
        let decided = match operation.action {
            Action::ShortCircuit { decisive } => Some(self.decide(decisive, link.right)),
            _ => None,
        };
        let right = self.value(link.right, Some(operation.right));
        let right = self.operand(link.right, right, operation.right);
        if let Some((cell, jump)) = decided {
            self.emit(Instruction::Store(cell));
            self.emitter.land(jump);
            self.emit(Instruction::Load(cell));
        }
        if left.ty == TypeId::ERROR || right.ty == TypeId::ERROR {
            // An operation on enumerated values has no elementary type, yet nothing is wrong with it.
            return LoweredValue::ERROR;
        }
        if let (Some(left), Some(right)) = (left.constant, right.constant)
            && let Some(ty) = folds(operation.action, right)
        {
            return match combine(link.operator, left, right) {
                Err((code @ Code::ConstantExpressionDivisionByZero, message)) => {
                    self.report(code, self.span(link.node), message);
                    LoweredValue::ERROR
                }
                result => self.folded(link.node, start, ty, result.ok()),
            };
        }
        if let Some(raw) = self.folded_pair(link.operator, operation.action) {
            self.emitter.replace(2, Instruction::Push(raw));
        } else {
            self.act(link, operation.action);
        }
        LoweredValue::computed(operation.computed)
    }

    /// Converts an operand, which is on the stack, to the type in which its operator computes.
    pub(super) fn operand(&mut self, id: ExpressionId, value: LoweredValue, to: TypeId) -> LoweredValue {
        if self.model.types.is_interface(to) && self.refuses_reference(id, Inferred::Known(value.ty), to) {
            return LoweredValue::ERROR;
        }
        if self.refuses_derived(id, Inferred::Known(value.ty), to) {
            self.report_derived(id, Inferred::Known(value.ty), to, ValueContext::Operand);
            return LoweredValue::ERROR;
        }
        let converted = self.adapt(value, to);
        if let (Some(from), Some(to)) = (value.ty.elementary(), to.elementary()) {
            self.emitter.record(id, UseKind::Operand { from, to });
        }
        converted
    }

    /// Computes integer arithmetic on two constants that have just been pushed, one of them at least the
    /// result of a conversion function. Where it does not fit the type that is no error: the machine does what
    /// it does with variables.
    ///
    /// Basis: conformance-cases/README.md (where acceptance is open the reference accepts).
    fn folded_pair(&self, operator: BinaryOperator, action: Action) -> Option<u64> {
        let Action::Arithmetic(_, ty) = action else {
            return None;
        };
        let (left, right) = self.emitter.pushed_pair().filter(|_| ty.is_integer())?;
        let result = combine(operator, ty.integer_value(left), ty.integer_value(right)).ok();
        fitting(ty, result)
    }

    fn act(&mut self, link: &Link, action: Action) {
        let span = self.span(link.node);
        let dialect = self.model.source.dialect;
        match action {
            Action::Arithmetic(operator, ty) => {
                self.emit_at(span, Instruction::Arithmetic(operator, ty));
                self.wrap_duration(ty);
            }
            Action::Scale {
                operator,
                number,
                swapped,
            } => {
                if swapped {
                    self.emit(Instruction::Swap);
                }
                let scaled = Instruction::ScaleDuration(operator, number, dialect.infinite_products);
                self.emit_at(span, scaled);
                // A scaled LTIME wraps by itself.
                let result = link.operation.map(|operation| operation.result);
                if result == Some(TypeId::of(ElementaryType::Time)) {
                    self.wrap_duration(ElementaryType::Time);
                }
            }
            Action::Power { base, exponent } => {
                let stops = dialect.division_stops;
                self.emit_at(
                    span,
                    Instruction::Power {
                        base,
                        exponent,
                        stops,
                    },
                );
            }
            Action::Move(operator) => {
                let address = link.operation.map_or(TypeId::ADDRESS, |operation| operation.left);
                let target = self.model.types.pointer(address).map(|pointer| pointer.target);
                let size = target.map_or(1, |target| self.sizes(target).0);
                self.emit(Instruction::Push(u64::from(size)));
                let ty = ElementaryType::Lint;
                self.emit_at(span, Instruction::Arithmetic(ArithmeticOperator::Multiply, ty));
                self.emit_at(span, Instruction::Arithmetic(operator, ty));
            }
            Action::Compare(operator, ty) => self.emit(Instruction::Compare(operator, ty)),
            Action::CompareText(operator) => self.emit(Instruction::CompareText(operator)),
            Action::Logic(operator) => self.emit(Instruction::Logic(operator)),
            // The right operand took the place of the left one, which did not decide.
            Action::ShortCircuit { .. } => {}
        }
    }

    /// Keeps the left operand of a short-circuit operator, which is on the stack, in a cell, and jumps where it decides.
    ///
    /// Basis: codesys-pages: _cds_operator_and_then, _cds_operator_or_else.
    fn decide(&mut self, decisive: bool, right: ExpressionId) -> (u32, Jump) {
        let cell = self.temporary(self.span(right));
        self.emit(Instruction::Store(cell));
        self.emit(Instruction::Load(cell));
        let jump = self.emitter.jump_if_false();
        if !decisive {
            return (cell, jump);
        }
        let decided = self.emitter.jump();
        self.emitter.land(jump);
        (cell, decided)
    }

    /// Keeps of the TIME on the stack what its count holds, where a TIME is a count of milliseconds without a sign.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`time_basic`, `date_negative_difference`).
    fn wrap_duration(&mut self, ty: ElementaryType) {
        let choices = &self.model.source.dialect.conversions;
        if ty != ElementaryType::Time || choices.moment_units != MomentUnits::Counts {
            return;
        }
        let count = ElementaryType::Udint;
        for (from, to) in [(ty, count), (count, ty)] {
            if let Some(rule) = ConversionRule::between(from, to, choices) {
                self.emitter.convert(Conversion { from, to, rule });
            }
        }
    }
}

/// Returns the integer type in which an operation on two constants is done right here. A power with a negative exponent
/// is left to the machine.
fn folds(action: Action, right: i128) -> Option<ElementaryType> {
    match action {
        Action::Arithmetic(_, ty) => Some(ty),
        Action::Power { base, exponent } if exponent.is_integer() && right >= 0 => Some(base),
        _ => None,
    }
    .filter(|ty| ty.is_integer())
}
