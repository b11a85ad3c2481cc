//! The features of the language that a generated program uses, for telling findings apart, and for leaving features out of a
//! campaign.
//!
//! The features are those of `conformance-cases/features.toml`, which `stickler_syntax` finds in the text of a program. The
//! model knows besides what no text says: which values convert implicitly.

use crate::model::visit::{Visitor, walk_expression, walk_program, walk_type};
use crate::model::{Expression, ExpressionKind, LiteralForm, Program, Type};
use crate::writer::{Style, write};
use std::collections::BTreeMap;
use stickler_syntax::features::feature_uses;
use stickler_types::{Dialect, ElementaryType};

/// Counts what a program uses that a compiler may lack: the keys of features, elementary types, conversion functions by their
/// names, literals with a type (`INT#`), and implicit conversions (`INT to DINT`).
pub fn features(program: &Program) -> BTreeMap<String, u64> {
    let mut counter = FeatureCounter::default();
    let text = write(program, &Style::default()).text;
    for used in feature_uses(&text, Dialect::of(program.dialect)) {
        counter.note(used.key.into_owned());
    }
    walk_program(&mut counter, program);
    counter.used
}

/// Returns the names of the distinctive features of a program, sorted.
///
/// Two findings with the same symptom are taken for the same if their programs need the same features. What most programs have
/// is left out: numbers, bit strings and truth values, their literals, and what variables begin with.
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

#[derive(Default)]
struct FeatureCounter {
    used: BTreeMap<String, u64>,
}

impl FeatureCounter {
    fn note(&mut self, name: String) {
        *self.used.entry(name).or_default() += 1;
    }
}

impl Visitor for FeatureCounter {
    fn ty(&mut self, ty: &Type) {
        // The text has the others.
        if let Type::Elementary(ty @ (ElementaryType::Int | ElementaryType::Bool)) = ty {
            self.note(ty.name().to_ascii_lowercase());
        }
        walk_type(self, ty);
    }

    fn expression(&mut self, expression: &Expression) {
        match &expression.kind {
            ExpressionKind::Literal(value, LiteralForm::Typed) => {
                self.note(format!("{}#", value.type_name()))
            }
            ExpressionKind::Widen(operand) => {
                let [from, to] = [&operand.ty, &expression.ty].map(type_name);
                self.note(format!("{from} to {to}"));
            }
            ExpressionKind::Convert(signature, _) => self.note(signature.function.clone()),
            _ => {}
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
        Type::Reference(_) => "reference",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generator::{GeneratorSettings, program};
    use crate::model::Statement;
    use crate::random::bytes;

    #[test]
    fn an_input_is_left_out_once_a_call_gives_one_less() {
        let has_name = |program: &Program| features(program).contains_key("input-left-out");
        // The inputs of standard function blocks no text declares.
        let standard = ["bistable-blocks", "edge-blocks", "counter-blocks", "timer-blocks"];
        let settings = GeneratorSettings {
            lacking: standard.map(str::to_owned).into(),
            ..GeneratorSettings::default()
        };
        let made = |seed| program(&bytes(seed, 2000), &settings);
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
    fn distinctive_features_are_some_of_all() {
        for seed in 0..50 {
            let program = program(&bytes(seed, 2000), &GeneratorSettings::default());
            let (some, all) = (distinctive(&program), features(&program));
            assert!(some.iter().all(|name| all.contains_key(name)));
            assert!(some.len() < all.len());
        }
    }
}
