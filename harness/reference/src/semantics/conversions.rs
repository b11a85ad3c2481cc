//! Calls of type conversion functions.

use super::calls::Callee;
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::lowering::{LoweredValue, Lowering};
use super::parameters::{ParameterList, single_argument};
use super::trace::UseKind;
use super::types::TypeId;
use crate::conversion::{Concatenation, ConversionFunction, PARAMETERS, Parameter, ResultType};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionId, ExpressionKind};
use stickler_types::ElementaryType;

impl Lowering<'_> {
    /// The type of most results depends on nothing else, so it is known whatever is wrong with the argument.
    pub(super) fn infer_conversion(
        &mut self,
        conversion: &ConversionFunction,
        arguments: &[Argument<'_>],
    ) -> Inferred {
        match (conversion.result, self.converted(conversion, arguments)) {
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
        let argument = self.converted(&conversion, arguments)?;
        Some(conversion.result_type(argument, target.elementary()))
    }

    /// Returns the type that the one argument of a conversion function has or takes; `None` where it does not fit.
    fn converted(
        &mut self,
        conversion: &ConversionFunction,
        arguments: &[Argument<'_>],
    ) -> Option<ElementaryType> {
        let argument = single_argument(arguments, Span::default()).ok()?;
        let inferred = self.infer(argument);
        parameter_type(conversion, inferred)
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
        let argument = match single_argument(arguments, span) {
            Ok(argument) => argument,
            Err(reason) => {
                self.refuse(reason, arguments);
                return value;
            }
        };
        let Some(from) = self.converted(conversion, arguments) else {
            self.refuse_converted(conversion, argument);
            return value;
        };
        let given = self.coerce(argument, TypeId::of(from), ValueContext::Argument);
        let to = conversion.result_type(from, wanted.and_then(TypeId::elementary));
        self.emitter.convert(conversion.conversion(from, to));
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
                    self.report_misfit_of_any(argument, inferred, allowed, default);
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
            .find(|ty| allowed.contains(ty) && (ty.is_integer() || ty.is_bit_string() || ty.is_real())),
        Inferred::Real => [default, ElementaryType::Lreal]
            .into_iter()
            .find(|ty| allowed.contains(ty) && ty.is_real()),
        Inferred::Text { wide, .. } => {
            Some(super::literals::text_type(wide)).filter(|ty| allowed.contains(ty))
        }
        Inferred::Nothing | Inferred::Enumerated | Inferred::Error | Inferred::Pending => None,
    }
}
