//! Constant expressions whose type counts: what conversion functions make of constants.
//!
//! Where a number of any size will do (a limit, a length) [`Evaluator::evaluate`] computes with exact numbers.
//! As soon as a conversion function stands there the types of its arguments count, and they are found as the
//! lowering of the same expression would find them; the values come from [`crate::conversion`], as they do when
//! the program runs.

mod known;
mod operators;

pub(super) use known::Known;

use super::constants::{Constant, Evaluator, NotConstant};
use super::contexts::{Context, Fit, fit};
use super::conversions::{parameter_type, single_argument};
use super::inferred::Inferred;
use super::literals::{Read, Signed, inferred_literal, literal_type, read_literal};
use super::standard::{self, ordered_by};
use super::suggestion::misfit;
use super::types::TypeId;
use crate::conversion::{
    Concatenation, ConversionFunction, PARAMETERS, ResultType, concatenation, conversion_function_name,
    function, implicit,
};
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::syntax::tree::{Argument, ExpressionId, ExpressionKind, Folded, UnaryOperator};
use stickler_types::{Code, ElementaryType};

/// A function that may be called in a constant expression.
pub(super) enum Foldable {
    One(ConversionFunction),
    Two(Concatenation),
}

impl<'u> Evaluator<'_, 'u> {
    /// Whether a name means a conversion function, and which. A function of the text hides one.
    fn foldable(&self, callee: ExpressionId) -> Option<Foldable> {
        let ExpressionKind::Name(name) = self.source.expression(callee).kind else {
            return None;
        };
        if self.definitions.contains_key(&Folded(name.text)) {
            return None;
        }
        let dialect = self.source.dialect;
        let one = function(name.text, dialect).map(Foldable::One);
        one.or_else(|| concatenation(name.text, dialect).map(Foldable::Two))
    }

    /// The value of a call of a conversion function; `wanted` is the type of its target, if it has one.
    pub(super) fn call(
        &self,
        id: ExpressionId,
        wanted: Option<ElementaryType>,
    ) -> Result<Known, NotConstant> {
        let span = self.source.expression(id).span;
        let ExpressionKind::Call { callee, arguments } = &self.source.expression(id).kind else {
            return Err(not_constant(span));
        };
        match self.foldable(*callee) {
            Some(Foldable::One(function)) => self.conversion(&function, arguments, span, wanted),
            Some(Foldable::Two(function)) => self.concatenation(function, arguments, span),
            None => Err(self.refuse_callee(*callee, span)),
        }
    }

    /// A function that nobody declared is told apart from one that computes only as the program runs.
    fn refuse_callee(&self, callee: ExpressionId, call: Span) -> NotConstant {
        let ExpressionKind::Name(name) = self.source.expression(callee).kind else {
            return not_constant(call);
        };
        let declared = self.definitions.contains_key(&Folded(name.text))
            || standard::standard_function(name.text).is_some()
            || (self.lookup)(name) != Constant::Unknown;
        if declared {
            return not_constant(call);
        }
        let message = format!("`{}` is not declared", name.text);
        Some(Diagnostic::new(Code::FunctionCallUndeclared, name.span, message))
    }

    fn conversion(
        &self,
        function: &ConversionFunction,
        arguments: &[Argument<'_>],
        call: Span,
        wanted: Option<ElementaryType>,
    ) -> Result<Known, NotConstant> {
        let argument = single_argument(arguments, call).map_err(fault)?;
        let inferred = self.infer(argument);
        let Some(from) = parameter_type(function, inferred) else {
            // An argument that is no constant is told apart from one of the wrong type.
            self.known(argument, None)?;
            let expected = function.parameter.expected();
            return Err(self.misfit(argument, inferred, expected, Context::Argument));
        };
        let known = self.operand(argument, from, Context::Argument)?;
        let to = function.result_type(from, wanted);
        Ok(known.converted(function.conversion(from, to)))
    }

    fn concatenation(
        &self,
        function: Concatenation,
        arguments: &[Argument<'_>],
        call: Span,
    ) -> Result<Known, NotConstant> {
        const SIGNATURE: standard::Signature = standard::Signature::exactly(&PARAMETERS);
        let values = ordered_by(&SIGNATURE, arguments, call).map_err(fault)?;
        let mut raws = [0; 2];
        for ((raw, value), ty) in raws.iter_mut().zip(values).zip(function.operands) {
            if let Known::Plain(_, operand) = self.operand(value, ty, Context::Argument)? {
                *raw = operand;
            }
        }
        let [date, time] = raws;
        Ok(Known::Plain(function.result, function.apply_two(date, time)))
    }

    /// The value of an expression where a type is expected, converted to it.
    pub(super) fn operand(
        &self,
        id: ExpressionId,
        to: ElementaryType,
        context: Context,
    ) -> Result<Known, NotConstant> {
        let inferred = self.infer(id);
        // The type of a call may be its target's to choose.
        let inferred = self.type_of_call(id, Some(to)).unwrap_or(inferred);
        let dialect = self.source.dialect;
        match fit(inferred, TypeId::of(to), context, self.types, dialect) {
            Fit::Yes => self.adapted(id, to),
            Fit::No => {
                self.known(id, None)?;
                Err(self.misfit(id, inferred, to, context))
            }
            Fit::Silent => self.known(id, None).and(Err(None)),
        }
    }

    /// The value of an expression that converts to a type, in that type.
    fn adapted(&self, id: ExpressionId, to: ElementaryType) -> Result<Known, NotConstant> {
        let known = self.known(id, Some(to))?;
        if known.ty() == to {
            return Ok(known);
        }
        let conversion = implicit(known.ty(), to, self.source.dialect);
        conversion
            .map(|conversion| known.converted(conversion))
            .ok_or(None)
    }

    fn misfit(
        &self,
        id: ExpressionId,
        inferred: Inferred,
        to: ElementaryType,
        context: Context,
    ) -> NotConstant {
        let span = self.source.expression(id).span;
        let name = inferred.elementary().and_then(|from| {
            conversion_function_name(from, to, self.source.dialect)
                .filter(|name| !self.definitions.contains_key(&Folded(name)))
        });
        let message = misfit(self.types, inferred, TypeId::of(to), context);
        Some(Diagnostic {
            suggestion: name.map(|name| format!("{name}({})", self.source.text_of(id))),
            ..Diagnostic::new(context.code(), span, message)
        })
    }

    /// The value of an expression in its own type, or where it is untyped in the type that is wanted.
    fn known(&self, id: ExpressionId, wanted: Option<ElementaryType>) -> Result<Known, NotConstant> {
        let expression = self.source.expression(id);
        match &expression.kind {
            ExpressionKind::Literal(literal) => self.literal(
                Signed {
                    literal,
                    negative: false,
                    span: expression.span,
                },
                wanted,
            ),
            ExpressionKind::Name(name) => match (self.lookup)(*name) {
                Constant::Value(number, ty) => Ok(Known::Plain(ty, ty.wrap(number))),
                Constant::Typed(known) => Ok(known),
                other => Err(self.refuse(*name, &other)),
            },
            ExpressionKind::Parenthesized(inner) => self.known(*inner, wanted),
            ExpressionKind::Unary { operator, operand } => self.unary(id, *operator, *operand, wanted),
            ExpressionKind::Binary { .. } => self.chain(id, wanted),
            ExpressionKind::Call { .. } => self.call(id, wanted),
            ExpressionKind::Error => Err(None),
            _ => Err(not_constant(expression.span)),
        }
    }

    fn literal(&self, signed: Signed<'u>, wanted: Option<ElementaryType>) -> Result<Known, NotConstant> {
        let dialect = self.source.dialect;
        let ty = literal_type(signed, wanted, dialect).map_err(Some)?;
        Ok(match read_literal(signed, ty, self.source.text).map_err(Some)? {
            Read::Plain(raw) => Known::Plain(ty, raw),
            Read::Text(units) => Known::Text(ty, units.into()),
        })
    }

    /// An untyped literal with a minus directly before it.
    fn signed_literal(&self, id: ExpressionId) -> Option<Signed<'u>> {
        let expression = self.source.expression(id);
        let ExpressionKind::Unary {
            operator: UnaryOperator::Negate,
            operand,
        } = expression.kind
        else {
            return None;
        };
        let ExpressionKind::Literal(literal) = &self.source.expression(operand).kind else {
            return None;
        };
        let untyped = literal.prefix().is_none()
            && inferred_literal(literal, true, self.source.dialect).is_untyped_number();
        untyped.then_some(Signed {
            literal,
            negative: true,
            span: expression.span,
        })
    }

    /// The type of an expression by itself, where it is made of constants.
    fn infer(&self, id: ExpressionId) -> Inferred {
        if let Some(signed) = self.signed_literal(id) {
            return inferred_literal(signed.literal, true, self.source.dialect);
        }
        match &self.source.expression(id).kind {
            ExpressionKind::Literal(literal) => inferred_literal(literal, false, self.source.dialect),
            ExpressionKind::Name(name) => match (self.lookup)(*name) {
                Constant::Value(_, ty) => Inferred::from(ty),
                Constant::Typed(known) => Inferred::from(known.ty()),
                _ => Inferred::Error,
            },
            ExpressionKind::Parenthesized(inner) => self.infer(*inner),
            ExpressionKind::Unary { operand, .. } => self.infer(*operand),
            ExpressionKind::Binary { .. } => {
                let (links, first) = self.spine(id);
                self.types_along(&links, first).pop().unwrap_or(Inferred::Error)
            }
            ExpressionKind::Call { .. } => self.type_of_call(id, None).unwrap_or(Inferred::Error),
            _ => Inferred::Error,
        }
    }

    /// The type of a call of a conversion function, whatever parentheses there are around it.
    fn type_of_call(&self, id: ExpressionId, target: Option<ElementaryType>) -> Option<Inferred> {
        let bare = self.source.expression(self.source.bare(id));
        let ExpressionKind::Call { callee, arguments } = &bare.kind else {
            return None;
        };
        match self.foldable(*callee)? {
            Foldable::Two(function) => Some(Inferred::from(function.result)),
            Foldable::One(function) => match function.result {
                ResultType::Exactly(ty) => Some(Inferred::from(ty)),
                _ => {
                    let argument = single_argument(arguments, bare.span).ok()?;
                    let from = parameter_type(&function, self.infer(argument))?;
                    Some(Inferred::from(function.result_type(from, target)))
                }
            },
        }
    }

    /// Whether a function is called anywhere in an expression.
    pub(super) fn calls(&self, id: ExpressionId) -> bool {
        let mut waiting = vec![id];
        while let Some(id) = waiting.pop() {
            match self.source.expression(id).kind {
                ExpressionKind::Call { .. } => return true,
                ExpressionKind::Parenthesized(inner) => waiting.push(inner),
                ExpressionKind::Unary { operand, .. } => waiting.push(operand),
                ExpressionKind::Binary { left, right, .. } => waiting.extend([left, right]),
                _ => {}
            }
        }
        false
    }
}

/// What stands here is known only as the program runs.
pub(super) fn not_constant(span: Span) -> NotConstant {
    let message = "only literals, constants, operators and conversion functions may stand here";
    Some(Diagnostic::new(Code::VariableMustBeConst, span, message))
}

fn fault((code, span, message): standard::Fault) -> NotConstant {
    Some(Diagnostic::new(code, span, message))
}
