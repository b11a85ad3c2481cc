//! The features of the language that a generated program uses, for telling findings apart, for leaving features out of a
//! campaign, and for measuring the generator.
//!
//! The features are those of `conformance-cases/features.toml`, which `stickler_syntax` finds in the text of a program. The
//! model knows besides what no text says: which values convert implicitly, and of which type an operand is.

use crate::model::visit::{
    Visitor, walk_declaration, walk_expression, walk_program, walk_statement, walk_type, walk_variable,
};
use crate::model::{
    AssignmentTarget, DeclaredKind, Expression, ExpressionKind, LiteralForm, Program, Statement, Type,
    TypeDeclaration, UnaryOperator, Variable,
};
use crate::writer::{Style, write};
use std::collections::BTreeMap;
use std::fmt::Display;
use stickler_syntax::features::feature_uses;
use stickler_types::{Dialect, ElementaryType};

/// Returns what a program uses that a compiler may lack: the keys of features, elementary types, conversion functions by their
/// names, literals with a type (`INT#`), and implicit conversions (`INT to DINT`).
#[must_use]
pub fn features(program: &Program) -> BTreeMap<String, u64> {
    let mut counter = FeatureCounter {
        program,
        used: of_text(program),
        measured: BTreeMap::new(),
    };
    walk_program(&mut counter, program);
    counter.used
}

/// Returns the names of the distinctive features of a program, sorted.
///
/// Two findings with the same symptom are taken for the same if their programs need the same features. What most programs have
/// is left out: numbers, bit strings and truth values, their literals, and what variables begin with.
#[must_use]
pub fn distinctive(program: &Program) -> Vec<String> {
    let is_common = |name: &String| {
        let ty = ElementaryType::from_name(name.trim_end_matches('#'));
        ty.is_some_and(|ty| {
            ty == ElementaryType::Bool || ty.is_integer() || ty.is_bit_string() || ty.is_real()
        }) || name.ends_with('#')
            || COMMON.lines().any(|common| common == name)
    };
    let names = features(program).into_keys();
    names.filter(|name| !is_common(name)).collect()
}

/// The features that most generated programs have, one a line.
const COMMON: &str = include_str!("features/common.txt");

/// Counts how often each feature occurs in a program, and each operator, literal and variable of a type: `+ of INT`, `read INT`.
#[must_use]
pub fn measured(program: &Program) -> BTreeMap<String, u64> {
    let mut counter = FeatureCounter {
        program,
        used: of_text(program),
        measured: BTreeMap::new(),
    };
    walk_program(&mut counter, program);
    counter.used.append(&mut counter.measured);
    counter.used
}

/// Counts the features that the text of a program uses.
fn of_text(program: &Program) -> BTreeMap<String, u64> {
    let text = write(program, &Style::default()).text;
    let mut counted = BTreeMap::new();
    for used in feature_uses(&text, Dialect::of(program.dialect)) {
        *counted.entry(used.key.into_owned()).or_default() += 1;
    }
    counted
}

struct FeatureCounter<'p> {
    program: &'p Program,
    used: BTreeMap<String, u64>,
    measured: BTreeMap<String, u64>,
}

impl FeatureCounter<'_> {
    fn note(&mut self, name: impl Display) {
        *self.used.entry(name.to_string()).or_default() += 1;
    }

    fn measure(&mut self, name: impl Display) {
        *self.measured.entry(name.to_string()).or_default() += 1;
    }

    /// Names a type by its form, and elementary types by their names.
    fn shape(&self, ty: &Type) -> &'static str {
        match ty {
            Type::Elementary(elementary) => elementary.name(),
            Type::Array(array) => match array.dimensions.len() {
                1 => "ARRAY of 1 dimension",
                2 => "ARRAY of 2 dimensions",
                _ => "ARRAY of 3 or more dimensions",
            },
            Type::Declared(_) if self.program.fields(ty).is_some() => "structure",
            Type::Declared(_) if self.program.enumerated_values(ty).is_some() => "enumeration",
            Type::Declared(_) => "alias",
            Type::Block(_) => "instance",
        }
    }
}

impl Visitor for FeatureCounter<'_> {
    fn declaration(&mut self, declaration: &TypeDeclaration) {
        if let DeclaredKind::Structure(fields) = &declaration.kind {
            for (_, ty, _) in fields {
                self.measure(format_args!("field {}", self.shape(ty)));
            }
        }
        walk_declaration(self, declaration);
    }

    fn variable(&mut self, variable: &Variable) {
        self.measure(format_args!("variable {}", self.shape(&variable.ty)));
        walk_variable(self, variable);
    }

    fn ty(&mut self, ty: &Type) {
        match ty {
            Type::Array(array) => self.measure(format_args!("element {}", self.shape(&array.element))),
            // The text has the others.
            Type::Elementary(ty @ (ElementaryType::Int | ElementaryType::Bool)) => {
                self.note(ty.name().to_ascii_lowercase());
            }
            Type::Elementary(_) | Type::Declared(_) | Type::Block(_) => {}
        }
        walk_type(self, ty);
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Assign(AssignmentTarget::Bit(..), _) => self.measure("bit written"),
            Statement::Assign(AssignmentTarget::Result, _) => self.measure("result"),
            Statement::Assign(AssignmentTarget::Place(_), _) => self.measure("assignment"),
            _ => {}
        }
        walk_statement(self, statement);
    }

    fn expression(&mut self, expression: &Expression) {
        let shape = self.shape(&expression.ty);
        match &expression.kind {
            ExpressionKind::Literal(value, LiteralForm::Typed) => {
                self.note(format_args!("{}#", value.type_name()))
            }
            ExpressionKind::Literal(value, _) => {
                self.measure(format_args!("{} literal without its type", value.type_name()));
            }
            ExpressionKind::Read(_) => self.measure(format_args!("read {shape}")),
            ExpressionKind::Bit(..) => self.measure("bit read"),
            ExpressionKind::Unary(operator, _) => {
                let name = match operator {
                    UnaryOperator::Negate => "negation",
                    UnaryOperator::Not => "NOT",
                };
                self.measure(format_args!("{name} of {shape}"));
            }
            ExpressionKind::Binary(operator, left, _) => {
                let name = operator.as_str();
                self.measure(format_args!("{name} of {}", self.shape(&left.ty)));
            }
            ExpressionKind::Widen(operand) => {
                self.note(format_args!(
                    "{} to {}",
                    type_name(&operand.ty),
                    type_name(&expression.ty)
                ));
            }
            ExpressionKind::Convert(signature, _) => self.note(&signature.function),
            ExpressionKind::Call(function, arguments) => {
                let called = self.program.functions.get(*function);
                if called.is_some_and(|called| arguments.len() < called.inputs().count()) {
                    self.measure("call that leaves inputs out");
                }
            }
            ExpressionKind::Enumerated(_) | ExpressionKind::Standard(..) | ExpressionKind::Raw(_) => {}
        }
        walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &Expression) {
        self.expression(expression);
    }
}

/// Returns the name of a type in the name of an implicit conversion.
const fn type_name(ty: &Type) -> &'static str {
    match ty {
        Type::Elementary(elementary) => elementary.name(),
        Type::Array(_) => "ARRAY",
        Type::Declared(_) => "declared",
        Type::Block(_) => "instance",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generator::{GeneratorSettings, program};
    use crate::random::bytes;

    #[test]
    fn an_input_is_left_out_once_a_call_gives_one_less() {
        let has_name = |program: &Program| features(program).contains_key("input-left-out");
        let made = |seed| program(&bytes(seed, 2000), &GeneratorSettings::default());
        let (with, without): (Vec<Program>, Vec<Program>) = (0..300).map(made).partition(has_name);
        assert!(!with.is_empty());
        let mut shortened = 0;
        for mut program in without {
            let given = program
                .main
                .body
                .iter_mut()
                .find_map(|statement| match statement {
                    Statement::Invoke { inputs, .. } if !inputs.is_empty() => Some(inputs),
                    _ => None,
                });
            if let Some(inputs) = given {
                inputs.pop();
                shortened += 1;
                assert!(has_name(&program));
            }
        }
        assert!(shortened > 10, "{shortened}");
    }

    #[test]
    fn each_level_of_detail_includes_the_one_before() {
        for seed in 0..50 {
            let program = program(&bytes(seed, 2000), &GeneratorSettings::default());
            let (least, middle, most) = (distinctive(&program), features(&program), measured(&program));
            assert!(least.iter().all(|name| middle.contains_key(name)));
            assert!(middle.iter().all(|(name, count)| most.get(name) == Some(count)));
            assert!(least.len() < middle.len() && middle.len() < most.len());
        }
    }
}
