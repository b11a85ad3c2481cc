//! Calls: what is called, and what comes of it.

use super::inferred::Inferred;
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::methods::Receiver;
use super::model::{SEVERAL_NAMESPACES, TopLevelName};
use super::pointers::{AddressFunction, NOT_IN_DIALECT};
use super::standard_signatures::{StandardSignature, standard_function};
use super::types::{TypeId, TypeKind};
use crate::conversion::{Concatenation, ConversionFunction, concatenation, function};
use crate::instruction::Instruction;
use crate::library::{has_block, is_not_implemented};
use stickler_syntax::Meaning;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::tree::{Argument, ExpressionId, ExpressionKind, Name, PouKind};
use stickler_types::{Code, Dialect, ElementaryType};

/// Returns whether a name is that of a standard function for one type of a dialect, such as `SQRT_LREAL`.
fn is_typed(name: &str, dialect: &Dialect) -> bool {
    name.rsplit_once('_').is_some_and(|(function, ty)| {
        let ty = ElementaryType::from_name(&ty.to_ascii_uppercase());
        // What is written in Structured Text is not declared before it is asked for.
        standard_function(function).is_some() && ty.is_some_and(|ty| dialect.has(ty)) && !has_block(name)
    })
}

/// Why the program of a name cannot be called.
const NO_PROGRAM_IN_FUNCTION: &str = "is a program, which no function may call";

/// The callee of a call.
#[derive(Clone, Copy, Debug)]
pub(super) enum Callee {
    /// An instance of a function block.
    Block(u32),
    /// A function of the text.
    Function(u32),
    /// A method and the instance of which it is called.
    Method(Receiver, u32),
    /// A standard function.
    Standard(&'static StandardSignature),
    /// A type conversion function.
    Conversion(ConversionFunction),
    /// A type conversion function of two arguments.
    Concatenation(Concatenation),
    /// An operator on variables and types that is written as a function.
    Address(AddressFunction),
    /// A name that cannot be called: the code and the reason.
    Nothing(Code, &'static str),
    /// An expression whose mistake is reported elsewhere.
    Silent,
}

/// Returns whether a standard function or a type conversion function of the dialect has a name.
pub fn is_standard_function(name: &str, dialect: &Dialect) -> bool {
    standard_function(name).is_some()
        || function(name, dialect).is_some()
        || concatenation(name, dialect).is_some()
}

impl<'m> Lowering<'m> {
    /// Finds what an expression calls. A function of the text hides a standard one of the same name.
    ///
    /// Basis: conformance-cases/README.md (where acceptance is open the reference accepts).
    pub(super) fn callee(&mut self, id: ExpressionId) -> Callee {
        let ExpressionKind::Name(name) = self.expression(id).kind else {
            if let Some(method) = self.called_method(id) {
                return method;
            }
            return match self.infer(id) {
                Inferred::Error if self.lacks_method(id) => {
                    Callee::Nothing(Code::MethodNotFound, "is no method that can be called")
                }
                Inferred::Error => Callee::Silent,
                Inferred::Known(ty) => self.block_or_not(ty),
                _ => Callee::Nothing(Code::FunctionBlockNotInScope, "is no function block"),
            };
        };
        let Some((_, variable)) = self.variable(name.text) else {
            if let Some(own) = self.own_instance_of(id) {
                return self.block_or_not(self.model.pous[own.pou as usize].ty);
            }
            return self.called_method(id).unwrap_or_else(|| self.named_callee(name));
        };
        // Only a function block is called by a variable's name, so any other variable hides no function, neither
        // a function's result nor `max` in `max := MAX(max, n)`.
        let ty = self.model.types.named_type(variable.ty);
        match (self.block_or_not(ty), self.named_callee(name)) {
            (block @ Callee::Block(_), _) => block,
            (neither, Callee::Nothing(..) | Callee::Silent) => neither,
            (_, function) => function,
        }
    }

    /// Returns the variables of the program that a name means, where programs are called by their names.
    pub(super) fn called_program(&self, name: Name<'_>) -> Option<VariablePlace> {
        let Some(TopLevelName::Pou(pou)) = self.model.definition(name) else {
            return None;
        };
        let index = self.model.called_programs.get(&pou)?;
        let place = Location::Absolute(self.model.instances[*index].base);
        let is_hidden = self.variable(name.text).is_some();
        (!is_hidden).then(|| VariablePlace::new(place, self.model.pous[pou as usize].ty))
    }

    fn block_or_not(&self, ty: TypeId) -> Callee {
        match self.model.types.kind(ty) {
            TypeKind::FunctionBlock(block) => match self.model.pous[block.pou as usize].pou.kind {
                PouKind::Class => Callee::Nothing(
                    Code::FunctionBlockNotInScope,
                    "is an instance of a class, which has methods, but no body that could be called",
                ),
                _ => Callee::Block(block.pou),
            },
            TypeKind::Error => Callee::Silent,
            _ => Callee::Nothing(
                Code::FunctionBlockNotInScope,
                "is a variable, but no function block",
            ),
        }
    }

    /// Returns whether an expression names a method that a function block, class or interface does not have.
    fn lacks_method(&mut self, id: ExpressionId) -> bool {
        let ExpressionKind::Field { base, .. } = self.expression(id).kind else {
            return false;
        };
        let ty = self.known_type(base);
        ty.is_some_and(|ty| self.model.types.object(ty).is_some())
    }

    fn named_callee(&self, name: Name<'_>) -> Callee {
        match self.model.meaning(name) {
            Meaning::One(TopLevelName::Pou(pou)) => {
                return match self.model.pous[pou as usize].pou.kind {
                    PouKind::Function => Callee::Function(pou),
                    PouKind::Program if self.called_program(name).is_some() => match self.entry() {
                        Some(entry)
                            if entry.pou.kind == PouKind::Function
                                && !self.model.source.dialect.programs_in_functions =>
                        {
                            Callee::Nothing(Code::FunctionCallUndeclared, NO_PROGRAM_IN_FUNCTION)
                        }
                        _ => Callee::Block(pou),
                    },
                    PouKind::FunctionBlock | PouKind::Class | PouKind::Interface => Callee::Nothing(
                        Code::FunctionBlockNotInScope,
                        "is a type of function block; what is called is a variable of that type",
                    ),
                    _ => Callee::Nothing(Code::FunctionCallUndeclared, "is a program, no function"),
                };
            }
            Meaning::One(TopLevelName::Type(_)) => {
                return Callee::Nothing(Code::FunctionCallUndeclared, "is a type, no function");
            }
            Meaning::Several => return Callee::Nothing(Code::FunctionCallUndeclared, SEVERAL_NAMESPACES),
            Meaning::None => {}
        }
        let dialect = self.model.source.dialect;
        let name = dialect.standard_name(name.text);
        if let Some((function, feature)) = AddressFunction::of(name) {
            return match dialect.lacks(feature) {
                true => Callee::Nothing(Code::FunctionCallUndeclared, NOT_IN_DIALECT),
                false => Callee::Address(function),
            };
        }
        if let Some(standard) = standard_function(name) {
            return Callee::Standard(standard);
        }
        if let (true, Some(TopLevelName::Pou(pou))) = (dialect.system_time, self.model.clock_function(name)) {
            return Callee::Function(pou);
        }
        if let Some(conversion) = function(name, dialect) {
            return Callee::Conversion(conversion);
        }
        match concatenation(name, dialect) {
            Some(concatenation) => Callee::Concatenation(concatenation),
            // Basis: iec-61131-3: Table 21 (typed functions, such as `ADD_INT`).
            None if is_not_implemented(name) || is_typed(name, dialect) => {
                Callee::Nothing(Code::NotImplemented, "is known, and not implemented")
            }
            None => Callee::Nothing(Code::FunctionCallUndeclared, "is not declared"),
        }
    }

    /// Infers the type of a call by itself.
    pub(super) fn infer_call(&mut self, callee: ExpressionId, arguments: &[Argument<'m>]) -> Inferred {
        let found = self.callee(callee);
        let controlled = self.execution_control(found, arguments);
        let arguments = controlled
            .as_ref()
            .map_or(arguments, |control| &control.arguments);
        match found {
            Callee::Block(_) => Inferred::Nothing,
            Callee::Function(pou) => self
                .result_type(pou)
                .map_or(Inferred::Nothing, |ty| self.inferred_of(ty)),
            Callee::Method(_, method) => self
                .result_type(method)
                .map_or(Inferred::Error, |ty| self.inferred_of(ty)),
            Callee::Standard(standard) => self.infer_standard(standard, arguments),
            Callee::Conversion(conversion) => self.infer_conversion(&conversion, arguments),
            Callee::Concatenation(concatenation) => Inferred::from(concatenation.result),
            Callee::Address(function) => self.infer_address(function, arguments),
            Callee::Nothing(..) | Callee::Silent => Inferred::Error,
        }
    }

    pub(super) fn result_type(&self, pou: u32) -> Option<TypeId> {
        let result = self.model.pous[pou as usize].result?;
        Some(self.model.variable(result).ty)
    }

    /// Lowers a call, and leaves its result on the stack.
    pub(super) fn call(
        &mut self,
        id: ExpressionId,
        callee: ExpressionId,
        arguments: &[Argument<'m>],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let found = self.callee(callee);
        if let Some(control) = self.execution_control(found, arguments) {
            return self.controlled_call((id, callee), found, &control, wanted);
        }
        self.call_found((id, callee), found, arguments, wanted)
    }

    /// Lowers a call of what is known, and leaves its result on the stack.
    pub(super) fn call_found(
        &mut self,
        (id, callee): (ExpressionId, ExpressionId),
        found: Callee,
        arguments: &[Argument<'m>],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let span = self.span(id);
        match found {
            Callee::Block(pou) => {
                self.call_block(span, callee, pou, arguments);
                LoweredValue::ERROR
            }
            Callee::Function(pou) => self.call_function(span, pou, arguments, true),
            Callee::Method(receiver, method) => self.call_member(span, receiver, method, arguments, true),
            Callee::Standard(standard) => self.call_standard(id, standard, arguments, wanted),
            Callee::Conversion(conversion) => self.call_conversion(span, &conversion, arguments, wanted),
            Callee::Concatenation(concatenation) => self.call_concatenation(span, concatenation, arguments),
            Callee::Address(function) => self.call_address(id, function, arguments, wanted),
            Callee::Nothing(code, reason) => self.refuse_callee(code, callee, reason, arguments),
            Callee::Silent => {
                self.value(callee, None);
                self.lower_arguments(arguments);
                LoweredValue::ERROR
            }
        }
    }

    /// Lowers a call as a statement: what it gives is dropped.
    pub(super) fn call_statement(&mut self, id: ExpressionId) {
        let ExpressionKind::Call { callee, arguments } = &self.expression(id).kind else {
            let value = self.value(id, None);
            return self.drop_value(value);
        };
        let found = self.callee(*callee);
        match self.execution_control(found, arguments) {
            Some(control) => self.controlled_statement((id, *callee), found, &control),
            None => self.statement_found((id, *callee), found, arguments),
        }
    }

    /// Lowers a call of what is known as a statement.
    pub(super) fn statement_found(
        &mut self,
        (id, callee): (ExpressionId, ExpressionId),
        found: Callee,
        arguments: &[Argument<'m>],
    ) {
        let span = self.span(id);
        match found {
            Callee::Block(pou) => self.call_block(span, callee, pou, arguments),
            Callee::Function(pou) => {
                self.call_function(span, pou, arguments, false);
            }
            Callee::Method(receiver, method) => {
                self.call_member(span, receiver, method, arguments, false);
            }
            _ => {
                let value = self.call_found((id, callee), found, arguments, None);
                self.drop_value(value);
            }
        }
    }

    fn drop_value(&mut self, value: LoweredValue) {
        let text = value.ty.elementary().is_some_and(ElementaryType::is_text);
        self.emit(match text {
            true => Instruction::DropText,
            false => Instruction::Drop,
        });
    }

    fn refuse_callee(
        &mut self,
        code: Code,
        callee: ExpressionId,
        reason: &str,
        arguments: &[Argument<'_>],
    ) -> LoweredValue {
        let name = self.model.source.text_of(callee);
        let hint = match code {
            Code::FunctionCallUndeclared
                if ![NOT_IN_DIALECT, SEVERAL_NAMESPACES, NO_PROGRAM_IN_FUNCTION].contains(&reason) =>
            {
                self.similar_function(callee)
            }
            _ => String::new(),
        };
        self.report(code, self.span(callee), format!("`{name}` {reason}{hint}"));
        // What is not implemented may take types as arguments: `__NEW(INT, 10)`.
        if code != Code::NotImplemented {
            self.lower_arguments(arguments);
        }
        LoweredValue::ERROR
    }

    /// Says what is wrong with the arguments as a whole, and what is wrong inside them.
    pub(super) fn refuse(&mut self, reason: SpannedDiagnostic, arguments: &[Argument<'_>]) -> LoweredValue {
        self.reporter.push(reason);
        self.lower_arguments(arguments);
        LoweredValue::ERROR
    }

    /// Lowers arguments for what is wrong inside them only.
    pub(super) fn lower_arguments(&mut self, arguments: &[Argument<'_>]) {
        for argument in arguments {
            match argument {
                Argument::Positional(value) | Argument::Named { value, .. } => {
                    self.value(*value, None);
                }
                Argument::Output { target, .. } => {
                    self.place(*target);
                }
            }
        }
    }
}
