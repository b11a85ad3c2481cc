//! Generation of operators and of accesses to bits.

use super::TypeContext;
use super::builder::ProgramBuilder;
use super::constructs::Construct;
use super::literals;
use super::scope::{HeldValue, VisiblePlace};
use crate::model::{
    BinaryOperator as Operator, Expression, ExpressionKind, LiteralForm, StandardFunction as Function, Type,
    UnaryOperator,
};
use stickler_types::{ElementaryType, Family, Value};

impl ProgramBuilder<'_, '_> {
    /// Generates `+`, `-` or `*`.
    pub fn arithmetic(&mut self, ty: ElementaryType, depth: usize) -> Option<Expression> {
        if ty.is_duration() {
            return self.sum_of_durations(ty);
        }
        let operators = [Operator::Add, Operator::Subtract, Operator::Multiply];
        let operator = operators[self.random.below(operators.len())];
        let left = self.varying(ty, depth)?;
        // Products of reals soon overflow, so mostly a variable is multiplied by a literal.
        let right = if ty.is_real() && operator == Operator::Multiply && !self.random.chance(1, 4) {
            self.factor(ty)
        } else {
            self.value(ty, TypeContext::Operand, depth)
        };
        Some(self.in_some_order(operator, left, right, ty))
    }

    /// Generates the factor of a real: often a tiny one, which makes products subnormal.
    fn factor(&mut self, ty: ElementaryType) -> Expression {
        if !self.random.chance(1, 3) {
            return self.literal(ty, TypeContext::Operand);
        }
        let tiny = literals::tiny(ty);
        let raw = tiny[self.random.below(tiny.len())];
        let form = self.form(ty, TypeContext::Operand);
        Expression::literal(ty, Value::plain(ty, raw), form)
    }

    /// Generates a sum of durations, which grow by literals only, so that none leaves the range of every system.
    fn sum_of_durations(&mut self, ty: ElementaryType) -> Option<Expression> {
        let operator = [Operator::Add, Operator::Subtract][self.random.below(2)];
        let left = self.read(&Type::Elementary(ty), true)?;
        let right = self.literal(ty, TypeContext::Operand);
        Some(Expression::binary(operator, left, right, ty))
    }

    /// Combines two operands, sometimes in reverse order where that makes no difference to the types.
    fn in_some_order(
        &mut self,
        operator: Operator,
        left: Expression,
        right: Expression,
        result: ElementaryType,
    ) -> Expression {
        if self.random.chance(1, 4) {
            Expression::binary(operator, right, left, result)
        } else {
            Expression::binary(operator, left, right, result)
        }
    }

    /// Generates `/` or MOD by a divisor that is neither 0 nor -1 nor tiny.
    pub fn division(&mut self, ty: ElementaryType, depth: usize) -> Option<Expression> {
        let modulo = !ty.is_real() && self.random.chance(1, 2);
        let operator = if modulo {
            Operator::Modulo
        } else {
            Operator::Divide
        };
        let left = self.varying(ty, depth)?;
        let right = self.divisor(ty);
        Some(Expression::binary(operator, left, right, ty))
    }

    fn divisor(&mut self, ty: ElementaryType) -> Expression {
        if self.random.chance(1, 3)
            && let Some(operand) = self.read(&Type::Elementary(ty), true)
        {
            let one = Expression::literal(ty, one(ty), LiteralForm::Typed);
            return Expression::standard(Function::Max, vec![operand, one], ty);
        }
        let value = literals::value(ty, &mut self.random);
        let value = if divides(&value) { value } else { one(ty) };
        let form = self.form(ty, TypeContext::Operand);
        Expression::literal(ty, value, form)
    }

    /// Generates a minus before a value that contains a variable.
    pub fn negation(&mut self, ty: ElementaryType, depth: usize) -> Option<Expression> {
        let operand = self.varying(ty, depth)?;
        Some(Expression::unary(UnaryOperator::Negate, operand))
    }

    /// Generates AND, OR or XOR.
    pub fn logic(&mut self, ty: ElementaryType, depth: usize) -> Expression {
        let operators = [Operator::And, Operator::Or, Operator::Xor];
        let operator = operators[self.random.below(operators.len())];
        let left = self.value(ty, TypeContext::Exact, depth);
        let right = self.value(ty, TypeContext::Operand, depth);
        self.in_some_order(operator, left, right, ty)
    }

    /// Generates NOT.
    pub fn complement(&mut self, ty: ElementaryType, depth: usize) -> Expression {
        let operand = self.value(ty, TypeContext::Exact, depth);
        Expression::unary(UnaryOperator::Not, operand)
    }

    /// Generates a comparison of two operands of any type of the program.
    pub fn comparison(&mut self, depth: usize) -> Expression {
        if self.has(Construct::Enumerations)
            && self.random.chance(1, 6)
            && let Some(compared) = self.compared_enumeration()
        {
            return compared;
        }
        let ty = self.seen_type();
        let operator = self.comparison_operator(ty);
        let left = self
            .varying(ty, depth)
            .unwrap_or_else(|| self.value(ty, TypeContext::Exact, depth));
        let right = self.compared(&left, ty, depth);
        self.in_some_order(operator, left, right, ElementaryType::Bool)
    }

    /// Generates the value that an operand is compared with: for a variable often a value that it holds at some time, which
    /// tells `<` from `<=`.
    pub fn compared(&mut self, with: &Expression, ty: ElementaryType, depth: usize) -> Expression {
        let held = if let ExpressionKind::Read(place) = &with.kind
            && self.random.chance(1, 2)
        {
            let pou = &self.pou;
            let suits = |held: &HeldValue| held.variable == place.variable && held.ty == ty;
            self.random.pick_where(&pou.held, suits).cloned()
        } else {
            None
        };
        match held {
            Some(held) => {
                let form = self.form(ty, TypeContext::Operand);
                Expression::literal(ty, held.value, form)
            }
            None => self.value(ty, TypeContext::Operand, depth),
        }
    }

    /// Picks a comparison operator; only `=` and `<>` where no document defines an order.
    pub fn comparison_operator(&mut self, ty: ElementaryType) -> Operator {
        const ALL: [Operator; 6] = [
            Operator::Equal,
            Operator::NotEqual,
            Operator::Less,
            Operator::LessOrEqual,
            Operator::Greater,
            Operator::GreaterOrEqual,
        ];
        let count = match ty.family() {
            Family::Boolean | Family::Text | Family::Character => 2,
            _ => ALL.len(),
        };
        ALL[self.random.below(count)]
    }

    fn compared_enumeration(&mut self) -> Option<Expression> {
        let program = &self.program;
        let is_enumeration = |seen: &VisiblePlace| program.enumerated_values(&seen.ty).is_some();
        let seen = self.random.pick_where(&self.pou.places, is_enumeration)?.clone();
        let operator = [Operator::Equal, Operator::NotEqual][self.random.below(2)];
        let left = Expression::read(self.place(&seen, false));
        let right = self.enumerated(&seen.ty);
        Some(Expression::binary(operator, left, right, ElementaryType::Bool))
    }

    /// Generates a value of an enumeration: a variable or a name.
    pub fn enumerated(&mut self, ty: &Type) -> Expression {
        if self.random.chance(1, 3)
            && let Some(read) = self.read(ty, false)
        {
            return read;
        }
        let count = self.program.enumerated_values(ty).map_or(0, <[String]>::len);
        Expression::enumerated(ty, self.random.below(count))
    }

    /// Generates a bit of a readable integer or bit string.
    pub fn bit(&mut self) -> Option<Expression> {
        let seen = self.choose(has_bits)?;
        let bit = self.bit_number(&seen.ty);
        let place = self.place(&seen, false);
        Some(Expression::elementary(
            ElementaryType::Bool,
            ExpressionKind::Bit(place, bit),
        ))
    }

    /// Picks a bit number, the first and the last bit more often than others.
    pub fn bit_number(&mut self, ty: &Type) -> u32 {
        let bits = match ty {
            Type::Elementary(ty) => ty.bits(),
            _ => 1,
        };
        match self.random.below(4) {
            0 => 0,
            1 => bits - 1,
            _ => self.random.below(bits as usize) as u32,
        }
    }
}

/// Returns whether a place is an integer or bit string, whose bits have names.
pub(super) fn has_bits(seen: &VisiblePlace) -> bool {
    matches!(&seen.ty, Type::Elementary(ty) if ty.is_whole())
}

fn one(ty: ElementaryType) -> Value {
    Value::plain(ty, if ty.is_real() { ty.real_bits(1.0) } else { 1 })
}

/// Returns whether a value is safe as a divisor: a real neither zero nor tiny, an integer neither 0 nor -1 (which overflows
/// the least number).
fn divides(value: &Value) -> bool {
    let &Value::Plain { ty, raw } = value else {
        return false;
    };
    match ty.real_value(raw) {
        // A quotient by a tiny number soon overflows.
        Some(number) => number.abs() >= 0.001,
        None => !(-1..=0).contains(&ty.integer_value(raw)),
    }
}
