//! Tests of the evaluator: the programs of `tests/programs.toml`, and models that no text has.

use super::*;
use crate::model::*;
use crate::reader::read;
use serde::Deserialize;
use stickler_mdtest::assert_fits;
use stickler_types::ElementaryType::Int;
use stickler_types::{DialectName, ElementaryType, Value};

/// The file of programs, whose head says what each key means.
#[derive(Deserialize)]
struct Programs {
    program: Vec<ExpectedProgram>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ExpectedProgram {
    name: String,
    dialect: Option<String>,
    scans: Option<u32>,
    text: String,
    #[serde(default)]
    values: Vec<String>,
    #[serde(default)]
    open: Vec<String>,
    ends: Option<String>,
}

#[test]
fn each_program_has_the_values_that_documents_give() {
    let programs: Programs = toml::from_str(include_str!("tests/programs.toml")).unwrap();
    for expected in programs.program {
        let name = &expected.name;
        let dialect = expected
            .dialect
            .map_or(DialectName::IRONPLC_ED3, |name| name.parse().unwrap());
        let program = read(&expected.text, dialect).unwrap_or_else(|| panic!("{name}: it is not read"));
        let evaluation = match evaluate(&program, expected.scans.unwrap_or(1)) {
            Ok(evaluation) => evaluation,
            Err(error) => {
                assert_eq!(Some(error.to_string()), expected.ends, "{name}");
                continue;
            }
        };
        assert_eq!(expected.ends, None, "{name}");
        let paths = evaluation.values.iter().map(|(path, _)| path);
        assert!(
            paths.eq(program.observed().iter().map(|(path, _)| path)),
            "{name}: the values are those that are observed"
        );
        let values: Vec<String> = { evaluation.values.iter() }
            .map(|(path, value)| format!("{path} = {value}"))
            .filter(|value| {
                let path = value.split(" = ").next();
                expected.values.iter().any(|one| one.split(" = ").next() == path)
            })
            .collect();
        assert_eq!(values, expected.values, "{name}");
        let open: Vec<&str> = { evaluation.opened.iter() }
            .map(|opened| opened.question.as_str())
            .collect();
        assert_eq!(open, expected.open, "{name}");
    }
}

/// Returns a program with the variable `a`, an INT, and this statement.
fn with(statement: Statement) -> Program {
    let text = "PROGRAM main\nVAR\n    a : INT;\nEND_VAR\n    ;\nEND_PROGRAM\n";
    let mut program = read(text, DialectName::IRONPLC_ED3).unwrap();
    program.main.body.push(statement);
    program
}

fn place(variable: usize, ty: ElementaryType) -> Place {
    Place::whole(VariableId(variable), Type::Elementary(ty))
}

/// Returns `a := …`.
fn set(value: ExpressionKind) -> Statement {
    let target = AssignmentTarget::Place(place(0, Int));
    Statement::Assign(target, Expression::elementary(Int, value))
}

fn one() -> Expression {
    Expression::literal(Int, Value::plain(Int, 1), LiteralForm::Typed)
}

#[test]
fn what_no_document_settles_is_told_with_its_place() {
    let text =
        "PROGRAM main\nVAR\n    a : REAL;\n    d : DATE;\nEND_VAR\n    a := REAL#1.0 / a;\nEND_PROGRAM\n";
    let evaluation = evaluate(&read(text, DialectName::IRONPLC_ED3).unwrap(), 1).unwrap();
    let opened: Vec<String> = evaluation.opened.iter().map(ToString::to_string).collect();
    assert_eq!(
        opened[0],
        "a real divided by zero (main: Divide of REAL; sought in IEC 60559 and real-arithmetic)"
    );
    assert_fits(&opened[1], "the initial value of a date (main: it is read;…");
    assert!(!evaluation.binds_the_reference());
}

#[test]
fn an_implicit_conversion_that_no_document_grants_is_open() {
    let text = "PROGRAM main\nVAR\n    r : LTIME;\nEND_VAR\n    r := LTIME#1ms;\nEND_PROGRAM\n";
    let mut program = read(text, DialectName::IRONPLC_ED3).unwrap();
    let millisecond = ExpressionKind::Literal(Value::parse("TIME#1ms").unwrap(), LiteralForm::Typed);
    let time = Expression::elementary(ElementaryType::Time, millisecond);
    let Statement::Assign(_, value) = &mut program.main.body[0] else {
        unreachable!()
    };
    value.kind = ExpressionKind::Widen(Box::new(time));
    let opened = evaluate(&program, 1).unwrap().opened;
    assert_eq!(opened[0].question, OpenQuestion::ImplicitConversion);
}

#[test]
fn a_model_that_contradicts_itself_is_refused_and_never_a_panic() {
    let call = |function| ExpressionKind::Call(function, Vec::new());
    let assigned = |target| Statement::Assign(target, one());
    let field = Place {
        path: vec![PlaceSelector::Field(0)],
        ..place(0, Int)
    };
    let wrong = [
        assigned(AssignmentTarget::Place(place(9, Int))),
        set(call(3)),
        set(Expression::binary(BinaryOperator::And, one(), one(), Int).kind),
        set(ExpressionKind::Standard(StandardFunction::Len, Vec::new())),
        assigned(AssignmentTarget::Bit(place(0, Int), 16)),
        assigned(AssignmentTarget::Result),
        assigned(AssignmentTarget::Place(field)),
        Statement::Invoke {
            instance: VariableId(0),
            inputs: Vec::new(),
            outputs: Vec::new(),
        },
    ];
    for statement in wrong {
        let answer = evaluate(&with(statement.clone()), 1);
        assert!(
            matches!(answer, Err(EvaluationError::IllFormed(_))),
            "{statement:?}: {answer:?}"
        );
    }
    let raw = set(ExpressionKind::Raw("?".to_owned()));
    assert_eq!(evaluate(&with(raw), 1), Err(EvaluationError::Raw));
    let mut recursive = with(set(call(0)));
    recursive.functions.push(Pou {
        name: "f".to_owned(),
        result: Some(Type::Elementary(Int)),
        body: vec![Statement::Assign(
            AssignmentTarget::Result,
            Expression::elementary(Int, call(0)),
        )],
        ..Pou::default()
    });
    assert!(matches!(
        evaluate(&recursive, 1),
        Err(EvaluationError::IllFormed(_))
    ));
}
