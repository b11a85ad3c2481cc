//! The weight of a program, and the identity of programs.

use super::lift::is_true;
use crate::model::visit::{
    Visitor, walk_expression, walk_place, walk_program, walk_statement, walk_type, walk_variable,
};
use crate::model::{
    DeclaredKind, Expression, ExpressionKind, LiteralForm, Place, PlaceSelector, Program, Statement,
    StatementKind, Type, Variable, VariableSection,
};
use std::hash::{DefaultHasher, Hash, Hasher};
use stickler_types::Value;

/// Returns the weight of a program: first the number of its parts, each with a weight, then the size of its literals.
///
/// A line weighs more than everything that can replace it within a line, and a read of a variable more than any literal.
pub(super) fn of(program: &Program) -> (u64, u128) {
    let mut scales = Scales { parts: 0, size: 0 };
    scales.parts += 30 * (program.functions.len() + program.blocks.len() + program.types.len()) as u64;
    for declaration in &program.types {
        scales.parts += match &declaration.kind {
            DeclaredKind::Structure(fields) => 10 * fields.len() as u64,
            DeclaredKind::Enumeration(values) => values.len() as u64,
            DeclaredKind::Alias(_) => 1,
        };
    }
    walk_program(&mut scales, program);
    (scales.parts, scales.size)
}

/// Returns a key that is equal for programs with the same text.
pub(super) fn key(program: &Program) -> u64 {
    let mut hasher = DefaultHasher::new();
    crate::writer::write(program, &crate::writer::Style::default())
        .text
        .hash(&mut hasher);
    hasher.finish()
}

struct Scales {
    parts: u64,
    size: u128,
}

impl Visitor for Scales {
    fn statement(&mut self, statement: &Statement) {
        self.parts += match &statement.kind {
            StatementKind::If(branches, otherwise) => {
                20 * (branches.len() + usize::from(otherwise.is_some())) as u64
            }
            StatementKind::Case(_, branches, otherwise) => {
                let labels: usize = branches.iter().map(|branch| branch.labels.len()).sum();
                20 + (20 * (branches.len() + usize::from(otherwise.is_some())) + labels) as u64
            }
            StatementKind::For { by, .. } => 30 + u64::from(by.is_some()),
            StatementKind::While(..) | StatementKind::Repeat(..) => 25,
            _ => 10,
        };
        if let StatementKind::Repeat(_, until) = &statement.kind
            && !is_true(until)
        {
            // TRUE ends the loop, and FALSE is not plainer.
            self.size += 4;
        }
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &Expression) {
        self.parts += match &expression.kind {
            ExpressionKind::Literal(value, form) => {
                self.size += 2 * magnitude(value) + u128::from(*form == LiteralForm::Typed);
                1
            }
            ExpressionKind::Enumerated(which) => {
                self.size += *which as u128;
                1
            }
            ExpressionKind::Read(_) => 2,
            ExpressionKind::Bit(_, bit) => {
                self.size += u128::from(*bit);
                3
            }
            _ => 3,
        };
        walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &Expression) {
        self.expression(expression);
    }

    fn place(&mut self, place: &Place) {
        self.parts += place.path.len() as u64;
        self.parts += place
            .path
            .iter()
            .filter(|selector| matches!(selector, PlaceSelector::Index(_)))
            .count() as u64;
        walk_place(self, place);
    }

    fn variable(&mut self, variable: &Variable) {
        // Each section other than VAR adds two lines.
        self.parts += if variable.section == VariableSection::Local {
            10
        } else {
            12
        };
        self.parts += 2 * u64::from(variable.initial.is_some());
        walk_variable(self, variable);
    }

    fn ty(&mut self, ty: &Type) {
        match ty {
            Type::Array(array) => {
                self.parts += 3 * array.dimensions.len() as u64;
                for (low, high) in &array.dimensions {
                    self.size += u128::from(low.unsigned_abs()) + u128::from(high.abs_diff(*low));
                }
            }
            Type::Declared(_) => self.parts += 2,
            Type::Elementary(_) | Type::Block(_) => {}
        }
        walk_type(self, ty);
    }
}

/// Returns the distance of a value from the plainest one of its type: of a number by its size, its sign and the length of
/// its spelling, of a text by its characters.
pub(super) fn magnitude(value: &Value) -> u128 {
    match value {
        Value::Plain { ty, .. } if ty.is_real() => value.to_string().len() as u128,
        Value::Plain { ty, raw } => {
            let number = ty.integer_value(*raw);
            2 * number.unsigned_abs() + u128::from(number < 0)
        }
        Value::Text { units, .. } => units.iter().map(|unit| 1 << 16 | u128::from(*unit)).sum(),
        Value::Enumerated { .. } | Value::OutOfRange { .. } => 0,
    }
}
