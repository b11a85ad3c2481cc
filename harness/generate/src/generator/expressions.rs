//! Expressions of a wanted type.

use super::literals;
use super::maker::Maker;
use crate::model::{BinaryOperator, Expression, ExpressionKind, LiteralForm, Place, Type, VariableId};
use stickler_types::ElementaryType;

/// What the place of an expression asks of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Wanted {
    /// An expression whose text has the type by itself.
    Exact,
    /// One that may convert implicitly, or be an untyped literal, because something else gives the type.
    Fitting,
}

impl Maker<'_, '_> {
    /// An expression of an elementary type, at most `depth` operators deep.
    pub fn value(&mut self, ty: ElementaryType, wanted: Wanted, depth: usize) -> Expression {
        if depth > 0 && self.has_variable(ty) && self.random.chance(1, 2) {
            let operators = [
                BinaryOperator::Add,
                BinaryOperator::Subtract,
                BinaryOperator::Multiply,
            ];
            let operator = self
                .random
                .pick(&operators)
                .copied()
                .unwrap_or(BinaryOperator::Add);
            return self.binary(operator, ty, ty, depth);
        }
        let sources = self.language.sources(ty);
        if wanted == Wanted::Fitting && !sources.is_empty() && self.random.chance(1, 4) {
            let from = self.random.pick(sources).copied().unwrap_or(ty);
            if from.is_integer() {
                let operand = self.value(from, Wanted::Exact, depth.saturating_sub(1));
                return elementary(ty, ExpressionKind::Widen(Box::new(operand)));
            }
        }
        self.leaf(ty, wanted)
    }

    fn has_variable(&self, ty: ElementaryType) -> bool {
        self.variables
            .iter()
            .any(|variable| variable.ty == Type::Elementary(ty))
    }

    fn leaf(&mut self, ty: ElementaryType, wanted: Wanted) -> Expression {
        let of_type: Vec<usize> = (0..self.variables.len())
            .filter(|&variable| self.variables[variable].ty == Type::Elementary(ty))
            .collect();
        if self.random.chance(1, 3) || of_type.is_empty() {
            let form = if wanted == Wanted::Fitting && self.random.chance(1, 2) {
                LiteralForm::Untyped
            } else {
                LiteralForm::Typed
            };
            let value = literals::value(ty, &mut self.random);
            return elementary(ty, ExpressionKind::Literal(value, form));
        }
        let variable = VariableId(of_type[self.random.below(of_type.len())]);
        read(variable, ty)
    }

    /// An expression that no compiler can compute, where there is a variable of the type: a constant that overflows is an error.
    fn varying(&mut self, ty: ElementaryType, depth: usize) -> Expression {
        if depth > 0 && self.has_variable(ty) && self.random.chance(1, 2) {
            let operators = [
                BinaryOperator::Add,
                BinaryOperator::Subtract,
                BinaryOperator::Multiply,
            ];
            let operator = self
                .random
                .pick(&operators)
                .copied()
                .unwrap_or(BinaryOperator::Add);
            return self.binary(operator, ty, ty, depth);
        }
        let of_type: Vec<usize> = (0..self.variables.len())
            .filter(|&variable| self.variables[variable].ty == Type::Elementary(ty))
            .collect();
        match self.random.pick(&of_type) {
            Some(&variable) => read(VariableId(variable), ty),
            None => self.leaf(ty, Wanted::Exact),
        }
    }

    /// Two operands of one type under an operator; one of them says the type, so the other may be anything that fits it.
    pub fn binary(
        &mut self,
        operator: BinaryOperator,
        operands: ElementaryType,
        result: ElementaryType,
        depth: usize,
    ) -> Expression {
        let left = self.varying(operands, depth.saturating_sub(1));
        let right = self.value(operands, Wanted::Fitting, depth.saturating_sub(1));
        elementary(
            result,
            ExpressionKind::Binary(operator, Box::new(left), Box::new(right)),
        )
    }

    /// A condition.
    pub fn condition(&mut self, depth: usize) -> Expression {
        let comparisons = [
            BinaryOperator::Less,
            BinaryOperator::Equal,
            BinaryOperator::GreaterOrEqual,
        ];
        let operator = self
            .random
            .pick(&comparisons)
            .copied()
            .unwrap_or(BinaryOperator::Less);
        let operands = match self.random.pick(&self.variables).map(|variable| &variable.ty) {
            Some(Type::Elementary(ty)) => *ty,
            _ => ElementaryType::Int,
        };
        self.binary(operator, operands, ElementaryType::Bool, depth)
    }
}

/// An expression of an elementary type.
pub(super) fn elementary(ty: ElementaryType, kind: ExpressionKind) -> Expression {
    Expression {
        ty: Type::Elementary(ty),
        kind,
    }
}

/// The whole of a variable.
pub(super) fn whole(variable: VariableId, ty: Type) -> Place {
    Place {
        variable,
        path: Vec::new(),
        ty,
    }
}

/// The value of a variable.
pub(super) fn read(variable: VariableId, ty: ElementaryType) -> Expression {
    elementary(ty, ExpressionKind::Read(whole(variable, Type::Elementary(ty))))
}
