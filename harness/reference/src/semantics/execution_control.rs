//! EN and ENO: an input that says whether a call is executed, and an output that says whether it was.
//!
//! A function or function block that declares neither has both all the same. Without EN the call is executed. A function that is not
//! executed gives the zero of its type, since no document says what it gives.
//!
//! Basis: iec-61131-3: second edition, 2.5.1.2 and Table 20; third edition, 6.6.1.4.2.

use super::calls::Callee;
use super::contexts::ValueContext;
use super::emitter::Jump;
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::types::TypeId;
use crate::instruction::Instruction;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, CaseFolded, ExpressionId};
use stickler_types::ElementaryType;

/// A call and the expression that it calls.
type CallNode = (ExpressionId, ExpressionId);

/// The arguments of a call that has EN or ENO.
pub(super) struct ExecutionControl<'m> {
    /// The value of EN.
    enable: Option<ExpressionId>,
    /// The variable that takes ENO, and whether it takes the opposite.
    enabled: Option<(ExpressionId, bool)>,
    /// All other arguments.
    pub(super) arguments: Vec<Argument<'m>>,
}

impl<'m> Lowering<'m> {
    /// Takes EN and ENO out of arguments; `None` where there are none, where the callee declares them itself, and where it gives more
    /// than one value.
    pub(super) fn execution_control(
        &self,
        callee: Callee,
        arguments: &[Argument<'m>],
    ) -> Option<ExecutionControl<'m>> {
        if !arguments.iter().any(|argument| controls(argument)) || !self.can_be_controlled(callee) {
            return None;
        }
        let mut control = ExecutionControl {
            enable: None,
            enabled: None,
            arguments: Vec::with_capacity(arguments.len()),
        };
        for argument in arguments {
            match argument {
                Argument::Named { value, .. } if controls(argument) && control.enable.is_none() => {
                    control.enable = Some(*value);
                }
                Argument::Output { negated, target, .. }
                    if controls(argument) && control.enabled.is_none() =>
                {
                    control.enabled = Some((*target, *negated));
                }
                _ => control.arguments.push(*argument),
            }
        }
        Some(control)
    }

    fn can_be_controlled(&self, callee: Callee) -> bool {
        match callee {
            Callee::Block(pou) | Callee::Function(pou) | Callee::Method(_, pou) => {
                let entry = &self.model.pous[pou as usize];
                let declares = |name| entry.scope.contains_key(&CaseFolded(name));
                let result = entry.result.map(|result| self.model.variable(result).ty);
                let gives_many = result.is_some_and(|ty| self.is_aggregate(ty));
                !declares("EN") && !declares("ENO") && !gives_many
            }
            Callee::Standard(_) | Callee::Conversion(_) | Callee::Concatenation(_) => true,
            Callee::Address(_) | Callee::Nothing(..) | Callee::Silent => false,
        }
    }

    /// Lowers a call with EN or ENO, and leaves its result on the stack.
    pub(super) fn controlled_call(
        &mut self,
        node: CallNode,
        callee: Callee,
        control: &ExecutionControl<'m>,
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let span = self.span(node.0);
        let (executed, skip) = self.begin_execution(control, span);
        let value = self.call_found(node, callee, &control.arguments, wanted);
        if value.ty == TypeId::ERROR {
            return value;
        }
        let location = Location::Absolute(self.temporary_of(value.ty, span));
        let result = VariablePlace::new(location, value.ty);
        self.store(result, span);
        let end = self.emitter.jump();
        self.emitter.land(skip);
        match value.ty.elementary().is_some_and(ElementaryType::is_text) {
            true => self.emitter.push_text(Vec::new()),
            false => self.emit(Instruction::Push(0)),
        }
        self.store(result, span);
        self.emitter.land(end);
        self.finish_execution(control, executed, span);
        self.load(result);
        LoweredValue::computed(value.ty)
    }

    /// Lowers a call with EN or ENO as a statement.
    pub(super) fn controlled_statement(
        &mut self,
        node: CallNode,
        callee: Callee,
        control: &ExecutionControl<'m>,
    ) {
        let span = self.span(node.0);
        let (executed, skip) = self.begin_execution(control, span);
        self.statement_found(node, callee, &control.arguments);
        self.emitter.land(skip);
        self.finish_execution(control, executed, span);
    }

    /// Keeps the value of EN; gives its cell, and the jump that is taken where it is FALSE.
    fn begin_execution(&mut self, control: &ExecutionControl<'m>, span: Span) -> (u32, Jump) {
        match control.enable {
            Some(enable) => {
                self.coerce(enable, TypeId::BOOL, ValueContext::Argument);
            }
            None => self.emit(Instruction::Push(1)),
        }
        let cell = self.temporary(span);
        self.emit(Instruction::Store(cell));
        self.emit(Instruction::Load(cell));
        (cell, self.emitter.jump_if_false())
    }

    /// Gives ENO to its variable.
    fn finish_execution(&mut self, control: &ExecutionControl<'m>, executed: u32, span: Span) {
        let Some((target, negated)) = control.enabled else {
            return;
        };
        let Some(place) = self.place(target) else { return };
        if place.constant {
            return self.refuse_constant(target);
        }
        if self.model.types.value_type(place.content()) != TypeId::BOOL {
            let message = "ENO needs a variable of type BOOL";
            return self.report(ValueContext::Capture.code(), self.span(target), message);
        }
        self.emit(Instruction::Load(executed));
        if negated {
            self.emit(Instruction::Not(ElementaryType::Bool));
        }
        self.store(place, span);
        self.record_written(target, place);
    }
}

/// Returns whether an argument is EN or ENO.
fn controls(argument: &Argument<'_>) -> bool {
    match argument {
        Argument::Positional(_) => false,
        Argument::Named { name, .. } => name.text.eq_ignore_ascii_case("EN"),
        Argument::Output { name, .. } => name.text.eq_ignore_ascii_case("ENO"),
    }
}
