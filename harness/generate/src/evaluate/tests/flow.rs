//! Statements: loops, CASE, EXIT, and the limit of steps.

use super::*;

/// Creates `FOR i := from TO to BY by DO n := n + 1; …`.
fn counting(from: &str, to: &str, by: &str, mut body: Vec<Statement>) -> Program {
    body.push(set(
        1,
        Int,
        binary(BinaryOperator::Add, read(1, Int), literal("INT#1")),
    ));
    program(
        vec![local("i", Usint, ""), local("n", Int, "")],
        vec![statement(StatementKind::For {
            variable: VariableId(0),
            from: literal(from),
            to: literal(to),
            by: (!by.is_empty()).then(|| literal(by)),
            body,
        })],
    )
}

#[test]
fn a_for_loop_counts_to_its_limit_and_leaves_its_variable_open() {
    let up = counting("USINT#250", "USINT#255", "", Vec::new());
    assert_eq!(values(&up)[1], "n = INT#6");
    assert_eq!(questions(&up), [OpenQuestion::LoopVariable]);
    assert_eq!(
        values(&counting("USINT#5", "USINT#1", "SINT#-2", Vec::new()))[1],
        "n = INT#3"
    );
    let never = counting("USINT#5", "USINT#1", "", Vec::new());
    assert_eq!(values(&never)[1], "n = INT#0");
    assert_eq!(questions(&never), [OpenQuestion::LoopVariable]);
}

#[test]
fn a_loop_variable_that_is_assigned_behind_its_loop_is_settled_again() {
    let mut main = counting("USINT#1", "USINT#3", "", Vec::new());
    main.main.body.push(set(0, Usint, literal("USINT#9")));
    assert_eq!(values(&main), ["i = USINT#9", "n = INT#3"]);
    assert_eq!(questions(&main), []);
}

#[test]
fn exit_leaves_the_loop_variable_at_its_turn_and_a_changed_one_is_open() {
    let third = binary(BinaryOperator::Equal, read(0, Usint), literal("USINT#3"));
    let third = Expression {
        ty: Type::Elementary(Bool),
        ..third
    };
    let exit = statement(StatementKind::If(
        vec![(third, vec![statement(StatementKind::Exit)])],
        None,
    ));
    let main = counting("USINT#1", "USINT#9", "", vec![exit]);
    assert_eq!(values(&main), ["i = USINT#3", "n = INT#2"]);
    assert_eq!(questions(&main), []);
    let changing = counting("USINT#1", "USINT#3", "", vec![set(0, Usint, literal("USINT#3"))]);
    assert!(questions(&changing).contains(&OpenQuestion::LoopChanged));
}

#[test]
fn an_endless_loop_ends_by_the_limit_of_steps() {
    let endless = statement(StatementKind::While(literal("BOOL#TRUE"), Vec::new()));
    assert_eq!(
        evaluate(&program(vec![], vec![endless]), 1),
        Err(EvaluationError::StepLimit)
    );
}

#[test]
fn a_case_takes_the_first_branch_that_has_the_value() {
    let branch = |labels, value| CaseBranch {
        labels,
        body: vec![set(1, Int, literal(value))],
    };
    let of_value = |value: &str| {
        let case = statement(StatementKind::Case(
            read(0, Int),
            vec![
                branch(
                    vec![
                        CaseLabel::Range(literal("INT#1"), literal("INT#3")),
                        CaseLabel::One(literal("INT#7")),
                    ],
                    "INT#10",
                ),
                branch(vec![CaseLabel::One(literal("INT#-1"))], "INT#20"),
            ],
            Some(vec![set(1, Int, literal("INT#30"))]),
        ));
        values(&program(
            vec![local("s", Int, value), local("r", Int, "")],
            vec![case],
        ))
        .remove(1)
    };
    assert_eq!(
        ["INT#3", "INT#7", "INT#-1", "INT#0"].map(of_value),
        ["r = INT#10", "r = INT#10", "r = INT#20", "r = INT#30"]
    );
}
