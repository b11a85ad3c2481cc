//! The features of the language that a program uses: for telling findings apart, for leaving features out of a campaign, and
//! for measuring the generator.

use crate::model::visit::{
    Visitor, walk_declaration, walk_expression, walk_place, walk_program, walk_statement, walk_type,
    walk_variable,
};
use crate::model::{
    AssignmentTarget, CaseLabel, DeclaredKind, Expression, ExpressionKind, InitialValue, LiteralForm, Place,
    PlaceSelector, Program, Statement, StatementKind, Type, TypeDeclaration, UnaryOperator, Unit, Variable,
    VariableId, VariableSection,
};
use crate::writer::{function_name, operator_text};
use std::collections::BTreeMap;
use std::fmt::Display;
use stickler_types::{ElementaryType, Family};

/// The level of detail of extracted features; each level includes those before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum FeatureDetail {
    /// Features that not every program has: functions, operators, kinds of statements, less common types.
    Distinctive,
    /// Every feature that a compiler may lack: also the common elementary types, and the types in front of literals (`INT#`,
    /// and `#-` where a minus follows).
    Complete,
    /// Finer counts for measuring the generator: `+ of INT`, `read INT`, `variable INT`, `ELSIF`.
    Measured,
}

/// The names of the [`FeatureDetail::Complete`] features that stand for one thing each; besides them there are elementary types, their
/// literals, conversion functions and implicit conversions.
pub const NAMES: &[&str] = &[
    "#-",
    "$",
    "ABS",
    "alias",
    "AND",
    "ARRAY",
    "ARRAY[n..n]",
    "bit read",
    "bit written",
    "call",
    "CASE",
    "CASE ..",
    "CONCAT",
    "CONSTANT",
    "enumerated value",
    "enumeration",
    "EXIT",
    ".field",
    "FOR",
    "FUNCTION",
    "FUNCTION_BLOCK",
    "IF",
    "initial array",
    "initial structure",
    "input left out",
    "invocation",
    "LEN",
    "LIMIT",
    "MAX",
    "MIN",
    "MOD",
    "MUX",
    "negation",
    "NOT",
    "OR",
    ".output",
    "REPEAT",
    "result",
    "RETURN",
    "ROL",
    "ROR",
    "SEL",
    "SHL",
    "SHR",
    "STRUCT",
    "VAR_IN_OUT",
    "VAR_OUTPUT",
    "WHILE",
    "XOR",
    "[]",
    "+",
    "-",
    "*",
    "/",
    "=",
    "<>",
    "<",
    "<=",
    ">",
    ">=",
    "=>",
];

/// Counts how often each feature occurs in a program, by its name.
#[must_use]
pub fn features(program: &Program, detail: FeatureDetail) -> BTreeMap<String, u64> {
    let mut counter = FeatureCounter {
        program,
        unit: Unit::Main,
        detail,
        counted: BTreeMap::new(),
    };
    walk_program(&mut counter, program);
    counter.counted
}

/// Returns the names of the distinctive features of a program, sorted.
///
/// Two findings with the same symptom are taken for the same if their programs need the same features. What most programs have
/// is left out: assignments, reads, literals, and variables of numbers, bit strings and truth values.
#[must_use]
pub fn distinctive(program: &Program) -> Vec<String> {
    features(program, FeatureDetail::Distinctive)
        .into_keys()
        .collect()
}

struct FeatureCounter<'p> {
    program: &'p Program,
    unit: Unit,
    detail: FeatureDetail,
    counted: BTreeMap<String, u64>,
}

impl FeatureCounter<'_> {
    fn count(&mut self, detail: FeatureDetail, name: impl Display) {
        if detail <= self.detail {
            *self.counted.entry(name.to_string()).or_default() += 1;
        }
    }

    fn distinctive(&mut self, name: impl Display) {
        self.count(FeatureDetail::Distinctive, name);
    }

    fn measured(&mut self, name: impl Display) {
        self.count(FeatureDetail::Measured, name);
    }

    /// Returns how many inputs the function block of an instance has, including VAR_IN_OUT.
    fn inputs_of(&self, instance: VariableId) -> usize {
        let declared = self.unit.variables(self.program).get(instance.0);
        let Some(Type::Block(block)) = declared.map(|variable| &variable.ty) else {
            return 0;
        };
        let variables = Unit::Block(*block).variables(self.program).iter();
        let inputs = variables
            .filter(|variable| matches!(variable.section, VariableSection::Input | VariableSection::InOut));
        inputs.count()
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

    fn literal_features(
        &mut self,
        expression: &Expression,
        value: &stickler_types::Value,
        form: LiteralForm,
    ) {
        let text = value.to_string();
        // Only literals of texts and characters have an escape.
        if text.contains('$') {
            self.distinctive("$");
            return;
        }
        let name = value.type_name();
        let is_typed = form == LiteralForm::Typed;
        if is_typed {
            self.count(FeatureDetail::Complete, format_args!("{name}#"));
        } else {
            self.measured(format_args!("{name} literal without its type"));
        }
        // A duration has its prefix in either form.
        let is_duration = matches!(expression.ty, Type::Elementary(ty) if ty.family() == Family::Duration);
        if (is_typed || is_duration) && text.starts_with(&format!("{name}#-")) {
            self.count(FeatureDetail::Complete, "#-");
        }
    }
}

impl Visitor for FeatureCounter<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
        match unit {
            Unit::Function(_) => self.distinctive("FUNCTION"),
            Unit::Block(_) => self.distinctive("FUNCTION_BLOCK"),
            Unit::Main | Unit::Types => {}
        }
    }

    fn declaration(&mut self, declaration: &TypeDeclaration) {
        match &declaration.kind {
            DeclaredKind::Structure(fields) => {
                self.distinctive("STRUCT");
                for (_, ty, initial) in fields {
                    self.measured(format_args!("field {}", self.shape(ty)));
                    if initial.is_some() {
                        self.measured("initial value of a field");
                    }
                }
            }
            DeclaredKind::Enumeration(_) => self.distinctive("enumeration"),
            DeclaredKind::Alias(_) => self.distinctive("alias"),
        }
        walk_declaration(self, declaration);
    }

    fn variable(&mut self, variable: &Variable) {
        self.measured(format_args!("variable {}", self.shape(&variable.ty)));
        match variable.section {
            VariableSection::Constant => self.distinctive("CONSTANT"),
            VariableSection::InOut => self.distinctive("VAR_IN_OUT"),
            VariableSection::Output => self.distinctive("VAR_OUTPUT"),
            VariableSection::Input => self.measured("VAR_INPUT"),
            VariableSection::Local => self.measured("VAR"),
        }
        match variable.initial {
            Some(InitialValue::Array(_)) => self.distinctive("initial array"),
            Some(InitialValue::Structure(_)) => self.distinctive("initial structure"),
            Some(InitialValue::Expression(_)) => self.measured("initial value"),
            None => {}
        }
        walk_variable(self, variable);
    }

    fn ty(&mut self, ty: &Type) {
        match ty {
            Type::Array(array) => {
                self.distinctive("ARRAY");
                if array.dimensions.iter().any(|(low, high)| low == high) {
                    self.distinctive("ARRAY[n..n]");
                }
                self.measured(format_args!("element {}", self.shape(&array.element)));
            }
            Type::Elementary(elementary) if is_less_common(*elementary) => self.distinctive(elementary),
            Type::Elementary(elementary) => self.count(FeatureDetail::Complete, elementary),
            Type::Declared(_) | Type::Block(_) => {}
        }
        walk_type(self, ty);
    }

    fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Assign(AssignmentTarget::Place(_), _) => self.measured("assignment"),
            StatementKind::Assign(AssignmentTarget::Bit(..), _) => self.distinctive("bit written"),
            StatementKind::Assign(AssignmentTarget::Result, _) => self.distinctive("result"),
            StatementKind::If(branches, otherwise) => {
                self.distinctive("IF");
                if branches.len() > 1 {
                    self.measured("ELSIF");
                }
                if otherwise.is_some() {
                    self.measured("ELSE of IF");
                }
            }
            StatementKind::Case(_, branches, otherwise) => {
                self.distinctive("CASE");
                for label in branches.iter().flat_map(|branch| &branch.labels) {
                    match label {
                        CaseLabel::One(_) => self.measured("label"),
                        CaseLabel::Range(..) => self.distinctive("CASE .."),
                    }
                }
                if otherwise.is_some() {
                    self.measured("ELSE of CASE");
                }
            }
            StatementKind::For { by, .. } => {
                self.distinctive("FOR");
                if by.is_some() {
                    self.measured("BY");
                }
            }
            StatementKind::While(..) => self.distinctive("WHILE"),
            StatementKind::Repeat(..) => self.distinctive("REPEAT"),
            StatementKind::Invoke {
                instance,
                inputs,
                outputs,
            } => {
                self.distinctive("invocation");
                if inputs.len() < self.inputs_of(*instance) {
                    self.distinctive("input left out");
                }
                if !inputs.is_empty() {
                    self.measured("argument of an invocation");
                }
                if !outputs.is_empty() {
                    self.distinctive("=>");
                }
            }
            StatementKind::Exit => self.distinctive("EXIT"),
            StatementKind::Return => self.distinctive("RETURN"),
            StatementKind::Raw(_) => self.distinctive("text"),
        }
        walk_statement(self, statement);
    }

    fn place(&mut self, place: &Place) {
        for selector in &place.path {
            self.distinctive(match selector {
                PlaceSelector::Index(_) => "[]",
                PlaceSelector::Field(_) => ".field",
                PlaceSelector::Output(_) => ".output",
            });
        }
        walk_place(self, place);
    }

    fn expression(&mut self, expression: &Expression) {
        let shape = self.shape(&expression.ty);
        match &expression.kind {
            ExpressionKind::Literal(value, form) => self.literal_features(expression, value, *form),
            ExpressionKind::Read(_) => self.measured(format_args!("read {shape}")),
            ExpressionKind::Enumerated(_) => self.distinctive("enumerated value"),
            ExpressionKind::Bit(..) => self.distinctive("bit read"),
            ExpressionKind::Unary(operator, _) => {
                let name = match operator {
                    UnaryOperator::Negate => "negation",
                    UnaryOperator::Not => "NOT",
                };
                self.distinctive(name);
                self.measured(format_args!("{name} of {shape}"));
            }
            ExpressionKind::Binary(operator, left, _) => {
                let name = operator_text(*operator);
                self.distinctive(name);
                self.measured(format_args!("{name} of {}", self.shape(&left.ty)));
            }
            ExpressionKind::Widen(operand) => {
                self.distinctive(format_args!(
                    "{} to {}",
                    type_name(&operand.ty),
                    type_name(&expression.ty)
                ));
            }
            ExpressionKind::Convert(signature, _) => self.distinctive(&signature.function),
            ExpressionKind::Call(function, arguments) => {
                self.distinctive("call");
                let called = self.program.functions.get(*function);
                if called.is_some_and(|called| arguments.len() < called.inputs().count()) {
                    self.distinctive("input left out");
                    self.measured("call that leaves inputs out");
                }
            }
            ExpressionKind::Standard(function, _) => self.distinctive(function_name(*function)),
            ExpressionKind::Raw(_) => self.distinctive("text"),
        }
        walk_expression(self, expression);
    }

    fn literal(&mut self, expression: &Expression) {
        self.expression(expression);
    }
}

/// Returns whether a compiler may well lack the type.
const fn is_less_common(ty: ElementaryType) -> bool {
    !matches!(
        ty.family(),
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Real
    )
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
    use arbitrary::Unstructured;

    #[test]
    fn an_input_is_left_out_once_a_call_gives_one_less() {
        const NAME: &str = "input left out";
        let has_name = |program: &Program| features(program, FeatureDetail::Distinctive).contains_key(NAME);
        let made = |seed| {
            program(
                &mut Unstructured::new(&bytes(seed, 2000)),
                &GeneratorSettings::default(),
            )
        };
        let (with, without): (Vec<Program>, Vec<Program>) = (0..300).map(made).partition(has_name);
        assert!(!with.is_empty());
        let mut shortened = 0;
        for mut program in without {
            let given = program
                .main
                .body
                .iter_mut()
                .find_map(|statement| match &mut statement.kind {
                    StatementKind::Invoke { inputs, .. } if !inputs.is_empty() => Some(inputs),
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
            let program = program(
                &mut Unstructured::new(&bytes(seed, 2000)),
                &GeneratorSettings::default(),
            );
            let [least, middle, most] = [
                FeatureDetail::Distinctive,
                FeatureDetail::Complete,
                FeatureDetail::Measured,
            ]
            .map(|detail| features(&program, detail));
            assert!(least.iter().all(|(name, count)| middle.get(name) == Some(count)));
            assert!(middle.iter().all(|(name, count)| most.get(name) == Some(count)));
            assert!(least.len() < middle.len() && middle.len() < most.len());
        }
    }
}
