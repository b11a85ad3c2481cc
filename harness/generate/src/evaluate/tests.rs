//! Tests of the evaluator on models made by hand, each with the values that documents give; this file holds the
//! constructors.

mod calls;
mod flow;
mod values;

use super::*;
use crate::model::*;
use stickler_exact::signatures;
use stickler_types::ElementaryType::{
    self, Bool, Byte, Date, Dint, Int, Lreal, Ltime, Real, Sint, Time, Udint, Usint,
};
use stickler_types::{DialectName, Fault, Value};

pub(crate) fn of(ty: ElementaryType, kind: ExpressionKind) -> Expression {
    Expression {
        ty: Type::Elementary(ty),
        kind,
    }
}

pub(crate) fn literal(text: &str) -> Expression {
    let value = Value::parse(text).unwrap();
    let ty = ElementaryType::from_name(value.type_name()).unwrap();
    of(ty, ExpressionKind::Literal(value, LiteralForm::Typed))
}

pub(crate) fn place(variable: usize, path: Vec<PlaceSelector>, ty: ElementaryType) -> Place {
    Place {
        variable: VariableId(variable),
        path,
        ty: Type::Elementary(ty),
    }
}

pub(crate) fn read(variable: usize, ty: ElementaryType) -> Expression {
    of(ty, ExpressionKind::Read(place(variable, Vec::new(), ty)))
}

pub(crate) fn binary(operator: BinaryOperator, left: Expression, right: Expression) -> Expression {
    Expression {
        ty: left.ty.clone(),
        kind: ExpressionKind::Binary(operator, Box::new(left), Box::new(right)),
    }
}

pub(crate) fn variable(
    name: &str,
    ty: Type,
    section: VariableSection,
    initial: Option<Expression>,
) -> Variable {
    Variable {
        name: name.to_owned(),
        ty,
        section,
        initial: initial.map(InitialValue::Expression),
    }
}

pub(crate) fn local(name: &str, ty: ElementaryType, initial: &str) -> Variable {
    let initial = (!initial.is_empty()).then(|| literal(initial));
    variable(name, Type::Elementary(ty), VariableSection::Local, initial)
}

pub(crate) fn statement(kind: StatementKind) -> Statement {
    Statement { kind }
}

pub(crate) fn assign(target: Place, value: Expression) -> Statement {
    statement(StatementKind::Assign(AssignmentTarget::Place(target), value))
}

pub(crate) fn set(variable: usize, ty: ElementaryType, value: Expression) -> Statement {
    assign(place(variable, Vec::new(), ty), value)
}

pub(crate) fn program(variables: Vec<Variable>, body: Vec<Statement>) -> Program {
    Program {
        dialect: DialectName::IRONPLC_ED3,
        types: Vec::new(),
        functions: Vec::new(),
        blocks: Vec::new(),
        main: MainPou { variables, body },
    }
}

/// Returns the values as text: `a = INT#5`.
fn values(program: &Program) -> Vec<String> {
    values_after(program, 1)
}

fn values_after(program: &Program, scans: u32) -> Vec<String> {
    let evaluation = evaluate(program, scans).unwrap();
    let observed: Vec<String> = program.observed().into_iter().map(|(path, _)| path).collect();
    let named: Vec<&String> = evaluation.values.iter().map(|(path, _)| path).collect();
    assert!(
        named.into_iter().eq(&observed),
        "the values are those that are observed"
    );
    evaluation
        .values
        .iter()
        .map(|(path, value)| format!("{path} = {value}"))
        .collect()
}

fn questions(program: &Program) -> Vec<OpenQuestion> {
    let opened = evaluate(program, 1).unwrap().opened;
    opened.into_iter().map(|opened| opened.question).collect()
}
