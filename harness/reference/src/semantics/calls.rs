//! Calls: what is called, and what comes of it.

use super::contexts::Context;
use super::inferred::Inferred;
use super::lowering::{Lowering, Value};
use super::model::Definition;
use super::scope::Folded;
use super::standard::{Fault, mixed, standard_function};
use super::types::{Kind, TypeId};
use crate::conversion::{ConversionFunction, Parameter, ResultType, function};
use crate::instruction::{Instruction, StandardFunction};
use crate::source::Span;
use crate::syntax::tree::{Argument, ExpressionId, ExpressionKind, Name, PouKind};
use stickler_types::{Code, ElementaryType};

/// What a call calls.
#[derive(Clone, Copy, Debug)]
pub(super) enum Callee {
    /// An instance of a function block.
    Block(u32),
    /// A function of the text.
    Function(u32),
    /// A standard function.
    Standard(StandardFunction),
    /// A type conversion function.
    Conversion(ConversionFunction),
    /// Nothing that can be called: the code and the reason.
    Nothing(Code, &'static str),
    /// Something that is wrong for another reason.
    Silent,
}

impl<'m> Lowering<'m> {
    /// What an expression calls. A function of the text hides a standard one of the same name.
    ///
    /// Basis: stickler-design: §3.1 (where acceptance is open the reference accepts).
    pub(super) fn callee(&mut self, id: ExpressionId) -> Callee {
        let ExpressionKind::Name(name) = self.expression(id).kind else {
            return match self.infer(id) {
                Inferred::Error => Callee::Silent,
                Inferred::Known(ty) => self.block_or_not(ty),
                _ => Callee::Nothing(Code::FunctionBlockNotInScope, "is no function block"),
            };
        };
        let Some((_, variable)) = self.variable(name.text) else {
            return self.named_callee(name);
        };
        // Only a function block is called by a variable's name, so any other variable hides no function, neither
        // a function's result nor `max` in `max := MAX(max, n)`.
        match (self.block_or_not(variable.ty), self.named_callee(name)) {
            (block @ Callee::Block(_), _) => block,
            (_, function @ (Callee::Function(_) | Callee::Standard(_) | Callee::Conversion(_))) => function,
            (neither, _) => neither,
        }
    }

    fn block_or_not(&self, ty: TypeId) -> Callee {
        match self.model.types.kind(ty) {
            Kind::FunctionBlock(block) => Callee::Block(block.pou),
            Kind::Error => Callee::Silent,
            _ => Callee::Nothing(
                Code::FunctionBlockNotInScope,
                "is a variable, but no function block",
            ),
        }
    }

    fn named_callee(&self, name: Name<'_>) -> Callee {
        match self.model.definitions.get(&Folded(name.text)) {
            Some(&Definition::Pou(pou)) => match self.model.pous[pou as usize].pou.kind {
                PouKind::Function => return Callee::Function(pou),
                PouKind::FunctionBlock => {
                    return Callee::Nothing(
                        Code::FunctionBlockNotInScope,
                        "is a type of function block; what is called is a variable of that type",
                    );
                }
                PouKind::Program => {
                    return Callee::Nothing(Code::FunctionCallUndeclared, "is a program, no function");
                }
            },
            Some(Definition::Type(_)) => {
                return Callee::Nothing(Code::FunctionCallUndeclared, "is a type, no function");
            }
            None => {}
        }
        if let Some(standard) = standard_function(name.text) {
            return Callee::Standard(standard);
        }
        match function(name.text, self.model.source.dialect) {
            Some(conversion) => Callee::Conversion(conversion),
            None => Callee::Nothing(Code::FunctionCallUndeclared, "is not declared"),
        }
    }

    /// The type of a call by itself.
    pub(super) fn infer_call(&mut self, callee: ExpressionId, arguments: &'m [Argument<'m>]) -> Inferred {
        match self.callee(callee) {
            Callee::Block(_) => Inferred::Nothing,
            Callee::Function(pou) => match self.model.pous[pou as usize].result {
                Some(result) => self.inferred_of(self.model.variable(result).ty),
                None => Inferred::Nothing,
            },
            Callee::Standard(standard) => self.infer_standard(standard, arguments),
            Callee::Conversion(conversion) => self.infer_conversion(&conversion, arguments),
            Callee::Nothing(..) | Callee::Silent => Inferred::Error,
        }
    }

    /// The type of most results depends on nothing else, so it is known whatever is wrong with the argument.
    fn infer_conversion(&mut self, conversion: &ConversionFunction, arguments: &[Argument<'_>]) -> Inferred {
        match (conversion.result, self.converted(conversion, arguments)) {
            (ResultType::Exactly(ty), _) => Inferred::from(ty),
            (_, Some(argument)) => Inferred::from(conversion.result_type(argument, None)),
            (_, None) => Inferred::Error,
        }
    }

    /// The type, among those that it may have, that the result of a conversion function takes from its target.
    ///
    /// Basis: stickler-design: §8 (the result of BCD_TO_INT and INT_TO_BCD takes the type of its target).
    pub(super) fn flexible_result(&mut self, id: ExpressionId, target: TypeId) -> Option<ElementaryType> {
        let ExpressionKind::Call { callee, arguments } = &self.expression(self.model.source.bare(id)).kind
        else {
            return None;
        };
        let Callee::Conversion(conversion) = self.callee(*callee) else {
            return None;
        };
        if !matches!(conversion.result, ResultType::OfTarget { .. }) {
            return None;
        }
        let argument = self.converted(&conversion, arguments)?;
        Some(conversion.result_type(argument, target.elementary()))
    }

    /// The type that the one argument of a conversion function has or takes; `None` where it does not fit.
    fn converted(
        &mut self,
        conversion: &ConversionFunction,
        arguments: &[Argument<'_>],
    ) -> Option<ElementaryType> {
        let argument = single_argument(arguments, Span::default()).ok()?;
        let inferred = self.infer(argument);
        match conversion.parameter {
            Parameter::Exactly(ty) => Some(ty),
            Parameter::AnyOf { allowed, default } => match inferred {
                Inferred::Known(ty) => ty.elementary().filter(|ty| allowed.contains(ty)),
                Inferred::Integer(magnitude) => [default, magnitude.ty()].into_iter().find(|ty| {
                    allowed.contains(ty) && (ty.is_integer() || ty.is_bit_string() || ty.is_real())
                }),
                Inferred::Real => [default, ElementaryType::Lreal]
                    .into_iter()
                    .find(|ty| allowed.contains(ty) && ty.is_real()),
                Inferred::Text { wide, .. } => {
                    Some(super::literals::text_type(wide)).filter(|ty| allowed.contains(ty))
                }
                Inferred::Nothing | Inferred::Enumerated | Inferred::Error | Inferred::Pending => None,
            },
        }
    }

    /// Lowers a call, and leaves its result on the stack.
    pub(super) fn call(
        &mut self,
        id: ExpressionId,
        callee: ExpressionId,
        arguments: &'m [Argument<'m>],
        wanted: Option<TypeId>,
    ) -> Value {
        let span = self.span(id);
        match self.callee(callee) {
            Callee::Block(pou) => {
                self.call_block(span, callee, pou, arguments);
                Value::ERROR
            }
            Callee::Function(pou) => self.call_function(span, pou, arguments, true),
            Callee::Standard(standard) => self.call_standard(span, standard, arguments, wanted),
            Callee::Conversion(conversion) => self.call_conversion(span, &conversion, arguments, wanted),
            Callee::Nothing(code, reason) => self.refuse_callee(code, callee, reason, arguments),
            Callee::Silent => {
                self.value(callee, None);
                self.lower_arguments(arguments);
                Value::ERROR
            }
        }
    }

    /// A call as a statement: what it gives is dropped.
    pub(super) fn call_statement(&mut self, id: ExpressionId) {
        let ExpressionKind::Call { callee, arguments } = &self.expression(id).kind else {
            self.value(id, None);
            return;
        };
        let span = self.span(id);
        match self.callee(*callee) {
            Callee::Block(pou) => self.call_block(span, *callee, pou, arguments),
            Callee::Function(pou) => {
                self.call_function(span, pou, arguments, false);
            }
            _ => {
                let value = self.call(id, *callee, arguments, None);
                let text = value.ty.elementary().is_some_and(ElementaryType::is_text);
                self.emit(if text {
                    Instruction::DropText
                } else {
                    Instruction::Drop
                });
            }
        }
    }

    fn refuse_callee(
        &mut self,
        code: Code,
        callee: ExpressionId,
        reason: &str,
        arguments: &[Argument<'_>],
    ) -> Value {
        let name = self.model.source.text_of(callee);
        let hint = match code {
            Code::FunctionCallUndeclared => self.similar_function(name),
            _ => String::new(),
        };
        self.report(code, self.span(callee), format!("`{name}` {reason}{hint}"));
        self.lower_arguments(arguments);
        Value::ERROR
    }

    /// Says what is wrong with the arguments as a whole, and what is wrong inside them.
    pub(super) fn refuse(&mut self, (code, span, message): Fault, arguments: &[Argument<'_>]) -> Value {
        self.report(code, span, message);
        self.lower_arguments(arguments);
        Value::ERROR
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

    fn call_conversion(
        &mut self,
        span: Span,
        conversion: &ConversionFunction,
        arguments: &[Argument<'_>],
        wanted: Option<TypeId>,
    ) -> Value {
        let value = match conversion.result {
            ResultType::Exactly(ty) => Value::of(ty),
            _ => Value::ERROR,
        };
        let argument = match single_argument(arguments, span) {
            Ok(argument) => argument,
            Err(fault) => {
                self.refuse(fault, arguments);
                return value;
            }
        };
        let Some(from) = self.converted(conversion, arguments) else {
            self.refuse_converted(conversion, argument);
            return value;
        };
        let given = self.coerce(argument, TypeId::of(from), Context::Argument);
        let to = conversion.result_type(from, wanted.and_then(TypeId::elementary));
        self.emit_at(span, Instruction::Convert(conversion.conversion(from, to)));
        if given.ty == TypeId::ERROR {
            value
        } else {
            Value::of(to)
        }
    }

    /// Says that an argument is of no type that a conversion function takes.
    fn refuse_converted(&mut self, conversion: &ConversionFunction, argument: ExpressionId) {
        let inferred = self.infer(argument);
        let value = self.value(argument, None);
        if value.ty != TypeId::ERROR || inferred == Inferred::Nothing {
            let (Parameter::Exactly(expected)
            | Parameter::AnyOf {
                default: expected, ..
            }) = conversion.parameter;
            self.report_misfit(argument, inferred, TypeId::of(expected), Context::Argument);
        }
    }
}

/// The one argument of a conversion function, by position or as `IN`.
fn single_argument(arguments: &[Argument<'_>], call: Span) -> Result<ExpressionId, Fault> {
    match arguments {
        [Argument::Positional(value)] => Ok(*value),
        [Argument::Named { name, value }] if name.text.eq_ignore_ascii_case("IN") => Ok(*value),
        [Argument::Named { name, .. } | Argument::Output { name, .. }] => Err((
            Code::FunctionCallNamedArgUndeclared,
            name.span,
            format!(
                "the function has no parameter `{}` here; its only one is IN",
                name.text
            ),
        )),
        _ if arguments.iter().any(|one| matches!(one, Argument::Positional(_)))
            && arguments.iter().any(|one| matches!(one, Argument::Named { .. })) =>
        {
            Err(mixed(call))
        }
        _ => {
            let message = format!("the function takes 1 argument, not {}", arguments.len());
            Err((Code::FunctionCallWrongArgCount, call, message))
        }
    }
}
