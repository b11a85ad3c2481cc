//! Rules beyond types that a candidate must keep.
//!
//! The meaning of an untyped literal or an implicit conversion depends on its neighbours, and a compiler evaluates
//! constants: so a well-typed model can be spelled as a text that means something else, or is rejected. The generator makes
//! no such programs; the passes may, and then the search refuses the candidate.
//!
//! Basis: rule: literal-as-operand (a literal takes the type of the other operand); rule: mixed-operands (no third type is sought);
//! ironplc-problem-codes: P4039, P4040, P2027.

use super::usage::{variable_of, variable_type};
use crate::model::visit::{Visitor, walk_expression, walk_place, walk_program, walk_statement};
use crate::model::{
    BinaryOperator, Expression, ExpressionKind, InitialValue, LiteralForm, Place, PlaceSelector, Program,
    Statement, StatementKind, Type, UnaryOperator, Unit, VariableId, VariableSection,
};
use stickler_types::{Family, Value};

/// Counts how often a program breaks these rules; 0 for programs of the generator.
pub(super) fn breaches(program: &Program) -> usize {
    let mut counter = BreachCounter {
        program,
        unit: Unit::Main,
        breaches: 0,
    };
    walk_program(&mut counter, program);
    counter.breaches
}

struct BreachCounter<'p> {
    program: &'p Program,
    unit: Unit,
    breaches: usize,
}

impl BreachCounter<'_> {
    fn count(&mut self, breach: bool) {
        self.breaches += usize::from(breach);
    }

    /// Returns the value of an integer expression that a compiler can compute.
    fn constant(&self, expression: &Expression) -> Option<i128> {
        let Type::Elementary(ty) = &expression.ty else {
            return None;
        };
        match &expression.kind {
            ExpressionKind::Literal(Value::Plain { ty, raw }, _) if ty.integer_range().is_some() => {
                Some(ty.integer_value(*raw))
            }
            ExpressionKind::Widen(operand) => self.constant(operand),
            ExpressionKind::Read(place) if place.path.is_empty() => self.named_constant(place.variable),
            ExpressionKind::Unary(UnaryOperator::Negate, operand) => Some(-self.constant(operand)?),
            ExpressionKind::Binary(operator, left, right) => {
                let (left, right) = (self.constant(left)?, self.constant(right)?);
                let number = match operator {
                    BinaryOperator::Add => left.checked_add(right),
                    BinaryOperator::Subtract => left.checked_sub(right),
                    BinaryOperator::Multiply => left.checked_mul(right),
                    BinaryOperator::Divide => left.checked_div(right),
                    BinaryOperator::Modulo => left.checked_rem(right),
                    _ => None,
                };
                number.filter(|number| fits(*number, expression))
            }
            _ => None,
        }
        .filter(|_| ty.integer_range().is_some())
    }

    fn named_constant(&self, variable: VariableId) -> Option<i128> {
        let variable = variable_of(self.program, self.unit, variable)?;
        match &variable.initial {
            Some(InitialValue::Expression(value)) if variable.section == VariableSection::Constant => {
                self.constant(value)
            }
            _ => None,
        }
    }

    /// Returns whether a compiler that computes constants rejects an expression.
    fn is_rejected(&self, expression: &Expression) -> bool {
        match &expression.kind {
            ExpressionKind::Unary(UnaryOperator::Negate, operand) => self
                .constant(operand)
                .is_some_and(|number| !fits(-number, expression)),
            ExpressionKind::Binary(BinaryOperator::Divide | BinaryOperator::Modulo, _, right)
                if is_zero(right) =>
            {
                true
            }
            ExpressionKind::Binary(operator, left, right)
                if !is_comparison(*operator)
                    && self.constant(left).is_some()
                    && self.constant(right).is_some() =>
            {
                is_arithmetic(*operator) && self.constant(expression).is_none()
            }
            _ => false,
        }
    }
}

fn fits(number: i128, expression: &Expression) -> bool {
    match &expression.ty {
        Type::Elementary(ty) => ty
            .integer_range()
            .is_none_or(|(least, greatest)| (least..=greatest).contains(&number)),
        _ => true,
    }
}

fn is_zero(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Literal(Value::Plain { ty, raw }, _) => {
            *raw == 0 || ty.is_real() && Value::plain(*ty, *raw).to_string().ends_with("#-0.0")
        }
        ExpressionKind::Widen(operand) => is_zero(operand),
        _ => false,
    }
}

const fn is_arithmetic(operator: BinaryOperator) -> bool {
    use BinaryOperator as B;
    matches!(
        operator,
        B::Add | B::Subtract | B::Multiply | B::Divide | B::Modulo
    )
}

const fn is_comparison(operator: BinaryOperator) -> bool {
    use BinaryOperator as B;
    matches!(
        operator,
        B::Equal | B::NotEqual | B::Less | B::LessOrEqual | B::Greater | B::GreaterOrEqual
    )
}

/// Returns whether the text of an expression determines its type without its context.
fn has_own_type(expression: &Expression) -> bool {
    !matches!(expression.kind, ExpressionKind::Widen(_)) && !is_bare(expression)
}

/// Returns whether an expression is a number without the prefix of its type.
fn is_bare(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Literal(Value::Plain { ty, .. }, LiteralForm::Untyped) => matches!(
            ty.family(),
            Family::Signed | Family::Unsigned | Family::BitString | Family::Real
        ),
        _ => false,
    }
}

impl Visitor for BreachCounter<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Case(selector, ..) => self.count(!has_own_type(selector)),
            StatementKind::If(branches, _) => {
                for (condition, _) in branches {
                    self.count(!has_own_type(condition));
                }
            }
            _ => {}
        }
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &Expression) {
        match &expression.kind {
            ExpressionKind::Unary(_, operand) | ExpressionKind::Widen(operand) => {
                self.count(!has_own_type(operand))
            }
            ExpressionKind::Convert(_, operand) => self.count(is_bare(operand)),
            // A call with empty parentheses is positional, and so must have all arguments.
            ExpressionKind::Call(function, arguments) if arguments.is_empty() => {
                let called = self.program.functions.get(*function);
                self.count(called.is_some_and(|called| called.inputs().next().is_some()));
            }
            ExpressionKind::Binary(_, left, right) => self.count(!has_own_type(left) && !has_own_type(right)),
            ExpressionKind::Standard(_, arguments) => {
                let breaches = arguments
                    .iter()
                    .filter(|argument| !has_own_type(argument))
                    .count();
                self.breaches += breaches;
            }
            _ => {}
        }
        self.count(self.is_rejected(expression));
        walk_expression(self, expression);
    }

    fn place(&mut self, place: &Place) {
        let mut ty = variable_type(self.program, self.unit, place.variable);
        for selector in &place.path {
            let Some(outer) = ty else { break };
            if let (PlaceSelector::Index(subscripts), Type::Array(array)) =
                (selector, self.program.unaliased(outer))
            {
                for (subscript, (low, high)) in subscripts.iter().zip(&array.dimensions) {
                    let outside = self
                        .constant(subscript)
                        .is_some_and(|number| !(i128::from(*low)..=i128::from(*high)).contains(&number));
                    self.count(outside || !has_own_type(subscript) && !is_bare(subscript));
                }
            }
            ty = self.program.selected_type(outer, selector);
        }
        walk_place(self, place);
    }
}
