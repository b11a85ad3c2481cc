//! What is being made: the program so far, the POU in hand, and what is left of the budget.

use super::language::Language;
use super::literals;
use super::settings::Settings;
use crate::model::{
    Expression, ExpressionKind, Initial, LiteralForm, Main, Program, Section, Type, Variable, VariableId,
};
use crate::random::Random;
use arbitrary::Unstructured;
use stickler_types::{DialectName, ElementaryType};

/// Makes a program from bytes. It never fails: when the bytes run out, it ends quickly with the simplest choices.
///
/// What it makes is well-typed in its dialect, ends, and uses nothing that documents leave open, as far as that can be known
/// without running it; [`Settings::open`] lifts the last.
#[must_use]
pub fn program(input: &mut Unstructured<'_>, settings: &Settings) -> Program {
    let mut random = Random::new(input);
    let dialect = settings.dialect.unwrap_or_else(|| {
        let chosen = random.pick(&DialectName::ALL).copied();
        chosen.unwrap_or(DialectName::IronplcEd2)
    });
    let mut maker = Maker {
        random,
        language: Language::of(dialect),
        statements_left: settings.statements,
        variables: Vec::new(),
    };
    maker.main_variables();
    let mut body = maker.statements(0);
    maker.add_checksums(&mut body);
    Program {
        dialect,
        types: Vec::new(),
        functions: Vec::new(),
        blocks: Vec::new(),
        main: Main {
            variables: maker.variables,
            body,
        },
    }
}

/// Everything that is known while a program is being made.
pub(super) struct Maker<'r, 'u> {
    pub random: Random<'r, 'u>,
    pub language: &'static Language,
    /// How many statements may still be made.
    pub statements_left: usize,
    /// The variables of the POU in hand.
    pub variables: Vec<Variable>,
}

impl Maker<'_, '_> {
    fn main_variables(&mut self) {
        let integers: Vec<ElementaryType> = self
            .language
            .types
            .iter()
            .copied()
            .filter(|ty| ty.is_integer())
            .collect();
        for number in 0..2 + self.random.below(6) {
            let ty = self
                .random
                .pick(&integers)
                .copied()
                .unwrap_or(ElementaryType::Int);
            let initial = self.random.chance(1, 2).then(|| {
                let value = literals::value(ty, &mut self.random);
                Initial::Expression(Expression {
                    ty: Type::Elementary(ty),
                    kind: ExpressionKind::Literal(value, LiteralForm::Typed),
                })
            });
            self.add_variable(format!("v{number}"), Type::Elementary(ty), initial);
        }
    }

    /// Adds a variable to the POU in hand.
    pub fn add_variable(&mut self, name: String, ty: Type, initial: Option<Initial>) -> VariableId {
        self.variables.push(Variable {
            name,
            ty,
            section: Section::Local,
            initial,
        });
        VariableId(self.variables.len() - 1)
    }
}
