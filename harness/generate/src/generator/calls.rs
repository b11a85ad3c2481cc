//! Calls of conversion functions and of functions of the program.

use super::TypeContext;
use super::builder::{ProgramBuilder, is_in};
use super::constructs::Construct;
use super::profile::{ConversionOffer, ResultCoverage};
use crate::model::{
    Argument, Expression, ExpressionKind, LiteralForm, StandardFunction, Type, VariableId, instance_of,
};
use stickler_exact::{Operation, Signature, expected};
use stickler_types::{ElementaryType, Family, Value};

impl ProgramBuilder<'_, '_> {
    /// Generates a conversion whose result documents settle; with
    /// [`GeneratorSettings::open`](super::GeneratorSettings::open), any conversion.
    pub fn conversion(
        &mut self,
        ty: ElementaryType,
        context: TypeContext,
        depth: usize,
    ) -> Option<Expression> {
        let offer = self.offer(ty, context)?;
        let settled = offer.settled == ResultCoverage::Always || (self.open && self.random.chance(1, 2));
        let operand = if settled {
            self.operand(offer, depth)
        } else {
            self.settled_operand(offer, depth)?
        };
        Some(convert(&offer.signature, operand))
    }

    /// Picks a conversion function that gives a type, preferably from a type that variables have.
    fn offer(&mut self, ty: ElementaryType, context: TypeContext) -> Option<&'static ConversionOffer> {
        let seen_only = self.random.chance(3, 4);
        let (open, pou, lacking) = (self.open, &self.pou, &self.lacking);
        let suits = |offer: &ConversionOffer| {
            (open || offer.settled != ResultCoverage::Never)
                && (!offer.ambiguous || context == TypeContext::Assigned)
                && (!seen_only || pou.varies(offer.from))
                && !is_in(lacking, &offer.signature.function)
        };
        self.random.pick_where(self.profile.offers(ty), suits)
    }

    /// Generates the argument of a conversion function; sometimes one that has to widen first, if the name of the function
    /// states the type.
    fn operand(&mut self, offer: &ConversionOffer, depth: usize) -> Expression {
        let widened = if offer.plain && self.has(Construct::Widening) && self.random.chance(1, 8) {
            self.widened(offer.from, TypeContext::Argument, depth)
        } else {
            None
        };
        widened.unwrap_or_else(|| self.value(offer.from, TypeContext::Exact, depth))
    }

    /// Generates a variable converted to a type by a function whose results are settled for all values.
    pub fn converted_variable(&mut self, ty: ElementaryType) -> Option<Expression> {
        let (pou, lacking) = (&self.pou, &self.lacking);
        let suits = |offer: &ConversionOffer| {
            offer.settled == ResultCoverage::Always
                && !offer.ambiguous
                && pou.varies(offer.from)
                && !is_in(lacking, &offer.signature.function)
        };
        let offer = self.random.pick_where(self.profile.offers(ty), suits)?;
        let operand = self.read(&Type::Elementary(offer.from), true)?;
        Some(convert(&offer.signature, operand))
    }

    /// Generates an operand for which documents state the result of the function.
    fn settled_operand(&mut self, offer: &ConversionOffer, depth: usize) -> Option<Expression> {
        let (from, to) = (offer.from, offer.signature.result);
        let variable = match (offer.signature.operation, from.family(), to.family()) {
            // Only NaN is not settled, which the evaluator detects.
            (_, Family::Real, Family::Boolean) => return Some(self.value(from, TypeContext::Exact, depth)),
            (Operation::ToBcd, ..) => {
                self.limited_number(from, 0, if to == ElementaryType::Byte { 99 } else { 9999 })
            }
            (Operation::Convert | Operation::Truncate, Family::Real, Family::Signed | Family::Unsigned) => {
                self.limited_real(from, to)
            }
            (Operation::Convert, Family::Signed | Family::Unsigned, Family::Duration) => {
                self.limited_number(from, 0, 86_400_000)
            }
            (Operation::Convert, Family::Text, _) => self.written_number(from, to),
            _ => None,
        };
        variable.or_else(|| self.settled_literal(offer))
    }

    /// Generates `LIMIT(low, x, high)`, clamped to the range of the type.
    fn limited_number(&mut self, ty: ElementaryType, low: i64, high: i64) -> Option<Expression> {
        let (least, greatest) = ty.integer_range()?;
        let fitting =
            |number: i64| i64::try_from(i128::from(number).clamp(least, greatest)).unwrap_or(number);
        self.limited(ty, fitting(low), fitting(high))
    }

    /// Generates a real within the range of an integer type, whichever way its fraction is rounded.
    fn limited_real(&mut self, from: ElementaryType, to: ElementaryType) -> Option<Expression> {
        let operand = self.varying(from, 1)?;
        // Powers of two are numbers of both real types; of the short integers the greatest value is one, too.
        let (low, high) = match (to.is_signed(), to.bits()) {
            (true, bits @ ..=16) => (-power(bits - 1), power(bits - 1) - 1.0),
            (true, bits) => (-power(bits - 1), power(bits - 2)),
            (false, bits @ ..=16) => (0.0, power(bits) - 1.0),
            (false, bits) => (0.0, power(bits - 1)),
        };
        let limit = |number| Expression::literal(from, Value::of_real(from, number), LiteralForm::Typed);
        let arguments = vec![limit(low), operand, limit(high)];
        Some(Expression::standard(StandardFunction::Limit, arguments, from))
    }

    /// Generates the text of a number.
    fn written_number(&mut self, text: ElementaryType, number: ElementaryType) -> Option<Expression> {
        let signature = self.profile.settled(number, text)?;
        let operand = self.read(&Type::Elementary(number), true)?;
        Some(convert(signature, operand))
    }

    /// Generates a literal for which documents state the result of the function, if one is found quickly.
    fn settled_literal(&mut self, offer: &ConversionOffer) -> Option<Expression> {
        const MAX_TRIES: usize = 4;
        let dialect = self.profile.dialect;
        for _ in 0..MAX_TRIES {
            let value = self.drawn(offer.from);
            if expected(&offer.signature, std::slice::from_ref(&value), dialect)
                .basis
                .is_some()
            {
                return Some(Expression::literal(offer.from, value, LiteralForm::Typed));
            }
        }
        None
    }

    /// Generates a call of a function of the program with this result type.
    pub fn call(&mut self, ty: &Type, depth: usize) -> Option<Expression> {
        let functions = self.program.functions.iter().enumerate();
        let has_instance = |block| instance_of(&self.pou.variables, block).is_some();
        let suits: Vec<usize> = functions
            .filter(|&(place, function)| {
                function.result.as_ref() == Some(ty)
                    && self.affords(self.function_costs[place])
                    && function.owner.is_none_or(has_instance)
            })
            .map(|(place, _)| place)
            .collect();
        let &called = self.random.pick(&suits)?;
        let mut parameters: Vec<(VariableId, Type)> = self.program.functions[called]
            .inputs()
            .map(|(parameter, variable)| (parameter, variable.ty.clone()))
            .collect();
        // One stays, because a call without arguments has none by name.
        if parameters.len() > 1 && self.profile.leaves_inputs_out(self.open) && self.random.chance(1, 3) {
            parameters.remove(self.random.below(parameters.len()));
        }
        self.spend(self.function_costs[called]);
        let arguments = parameters.into_iter().map(|(parameter, ty)| Argument {
            parameter,
            value: self.argument(&ty, depth),
        });
        let arguments = arguments.collect();
        Some(Expression::new(
            ty.clone(),
            ExpressionKind::Call(called, arguments),
        ))
    }

    /// Generates an argument for a parameter of an elementary type or an enumeration.
    pub fn argument(&mut self, ty: &Type, depth: usize) -> Expression {
        match ty {
            Type::Elementary(ty) => self.value(*ty, TypeContext::Argument, depth),
            ty => self.enumerated(ty),
        }
    }
}

/// Creates a call of a conversion function.
pub(super) fn convert(signature: &Signature, operand: Expression) -> Expression {
    Expression::elementary(
        signature.result,
        ExpressionKind::Convert(signature.clone(), Box::new(operand)),
    )
}

fn power(exponent: u32) -> f64 {
    2.0_f64.powi(exponent.cast_signed())
}
