//! Calls of type conversion functions.

use super::calls::Callee;
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::literals::untyped_integer;
use super::lowering::{LoweredValue, Lowering};
use super::parameters::{ParameterList, single_argument};
use super::suggestion::misfit_of_any;
use super::trace::UseKind;
use super::types::TypeId;
use crate::conversion::{Concatenation, ConversionFunction, PARAMETERS, Parameter, ResultType};
use crate::instruction::Instruction;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionId, ExpressionKind, LiteralKind};
use stickler_types::ElementaryType;

/// The inputs of TO_STRING where it has a format.
const FORMATTED: ParameterList = ParameterList::exactly(&["IN", "FORMAT"]);

impl Lowering<'_> {
    /// The type of most results depends on nothing else, so it is known whatever is wrong with the argument.
    pub(super) fn infer_conversion(
        &mut self,
        conversion: &ConversionFunction,
        arguments: &[Argument<'_>],
    ) -> Inferred {
        let argument = single_argument(arguments, Span::default()).ok();
        let argument = argument.and_then(|argument| self.converted(conversion, argument));
        match (conversion.result, argument) {
            (ResultType::Exactly(ty), _) => Inferred::from(ty),
            (_, Some(argument)) => Inferred::from(conversion.result_type(argument, None)),
            (_, None) => Inferred::Error,
        }
    }

    /// Returns the type, among those that it may have, that the result of a conversion function takes from its target.
    ///
    /// Basis: forgeiec-conversion-functions: BCD encoding (the result of BCD_TO_INT and INT_TO_BCD takes the type of its target).
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
        let argument = single_argument(arguments, Span::default()).ok()?;
        let argument = self.converted(&conversion, argument)?;
        Some(conversion.result_type(argument, target.elementary()))
    }

    /// Returns the type that the one argument of a conversion function has or takes; `None` where it does not fit.
    fn converted(
        &mut self,
        conversion: &ConversionFunction,
        argument: ExpressionId,
    ) -> Option<ElementaryType> {
        let inferred = self.infer(argument);
        let takes =
            |ty: &ElementaryType| self.model.source.dialect.based_literals_as_bits && conversion.accepts(*ty);
        let bits = self.based_literal(conversion.result, argument).filter(takes);
        bits.or_else(|| parameter_type(conversion, inferred))
    }

    /// Returns the type of bit string that an untyped literal in another base is as an argument, where the dialect takes it for one.
    fn based_literal(&self, to: ResultType, argument: ExpressionId) -> Option<ElementaryType> {
        use ElementaryType::{Dword, Lword, Word};
        let ExpressionKind::Literal(literal) = &self.expression(self.model.source.bare(argument)).kind else {
            return None;
        };
        let is_based = literal.kind == LiteralKind::BasedInteger && literal.prefix().is_none();
        let takes = matches!(to, ResultType::Exactly(to) if to.is_integer()) && is_based;
        let number = untyped_integer(literal.text(), false).filter(|_| takes)?;
        [Word, Dword, Lword]
            .into_iter()
            .find(|ty| number >> ty.bits() == 0)
    }

    /// Lowers a call of a conversion function of one argument, and leaves its result on the stack.
    pub(super) fn call_conversion(
        &mut self,
        span: Span,
        conversion: &ConversionFunction,
        arguments: &[Argument<'_>],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let value = match conversion.result {
            ResultType::Exactly(ty) => LoweredValue::of(ty),
            _ => LoweredValue::ERROR,
        };
        let is_fallible = self.fallible.take() == Some(span);
        let is_text = matches!(conversion.result, ResultType::Exactly(to) if to.is_text());
        let is_formatted = is_text && arguments.len() == 2 && self.model.source.dialect.format_strings;
        let given = match is_formatted {
            true => FORMATTED.ordered(arguments, span),
            false => single_argument(arguments, span).map(|argument| vec![argument]),
        };
        let values = match given {
            Ok(values) => values,
            Err(reason) => {
                self.refuse(reason, arguments);
                return value;
            }
        };
        let argument = values[0];
        let Some(from) = self.converted(conversion, argument) else {
            self.refuse_converted(conversion, argument);
            return value;
        };
        let given = self.coerce(argument, TypeId::of(from), ValueContext::Argument);
        let to = conversion.result_type(from, wanted.and_then(TypeId::elementary));
        let conversion = conversion.conversion(from, to);
        if let Some(&format) = values.get(1) {
            self.coerce(format, TypeId::of(to), ValueContext::Argument);
            self.emit(match from.is_text() {
                true => Instruction::DropText,
                false => Instruction::Format(from),
            });
        } else if is_fallible && from.is_text() && !to.is_text() {
            self.emit(Instruction::TryConvert(conversion));
            self.failed = Some(self.emitter.jump_if_false());
        } else {
            self.emitter.convert(conversion);
        }
        self.emitter.record(argument, UseKind::Converted { from, to });
        if given.ty == TypeId::ERROR {
            value
        } else {
            LoweredValue::of(to)
        }
    }

    /// Says that an argument is of no type that a conversion function takes.
    fn refuse_converted(&mut self, conversion: &ConversionFunction, argument: ExpressionId) {
        let inferred = self.infer(argument);
        let value = self.value(argument, None);
        if value.ty != TypeId::ERROR || inferred == Inferred::Nothing {
            match conversion.parameter {
                Parameter::Exactly(ty) => {
                    self.report_misfit(argument, inferred, TypeId::of(ty), ValueContext::Argument);
                }
                Parameter::AnyOf { allowed, default } => {
                    let message = misfit_of_any(&self.model.types, inferred, allowed);
                    let (to, context) = (TypeId::of(default), ValueContext::Argument);
                    self.report_misfit_as(argument, inferred, to, context, message);
                }
            }
        }
    }

    /// Joins a date and a time of day.
    pub(super) fn call_concatenation(
        &mut self,
        span: Span,
        concatenation: Concatenation,
        arguments: &[Argument<'_>],
    ) -> LoweredValue {
        const LIST: ParameterList = ParameterList::exactly(&PARAMETERS);
        let result = LoweredValue::of(concatenation.result);
        let values = match LIST.ordered(arguments, span) {
            Ok(values) => values,
            Err(reason) => {
                self.refuse(reason, arguments);
                return result;
            }
        };
        for (value, ty) in values.into_iter().zip(concatenation.operands) {
            self.coerce(value, TypeId::of(ty), ValueContext::Argument);
        }
        self.emitter.concatenate(concatenation);
        result
    }
}

/// Returns the type that the argument of a conversion function has or takes; `None` where it does not fit.
pub(super) fn parameter_type(conversion: &ConversionFunction, argument: Inferred) -> Option<ElementaryType> {
    let Parameter::AnyOf { allowed, default } = conversion.parameter else {
        return Some(conversion.parameter.expected());
    };
    match argument {
        Inferred::Known(ty) => ty.elementary().filter(|ty| allowed.contains(ty)),
        Inferred::Integer(magnitude) => [default, magnitude.ty()]
            .into_iter()
            .find(|ty| allowed.contains(ty) && (ty.is_whole() || ty.is_real())),
        Inferred::Real => [default, ElementaryType::Lreal]
            .into_iter()
            .find(|ty| allowed.contains(ty) && ty.is_real()),
        Inferred::Text { wide, .. } => {
            Some(super::literals::text_type(wide)).filter(|ty| allowed.contains(ty))
        }
        Inferred::Nothing | Inferred::Enumerated | Inferred::Error | Inferred::Pending => None,
    }
}
