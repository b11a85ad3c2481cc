//! Functions, function blocks, and the sharing of variables.

use super::*;

#[test]
fn a_function_starts_afresh_and_an_input_not_given_has_its_initial_value() {
    let function = Function {
        name: "f".to_owned(),
        result: Type::Elementary(Int),
        variables: vec![
            variable("a", Type::Elementary(Int), VariableSection::Input, None),
            variable(
                "b",
                Type::Elementary(Int),
                VariableSection::Input,
                Some(literal("INT#10")),
            ),
            local("fresh", Int, "INT#1"),
        ],
        body: vec![
            set(2, Int, binary(BinaryOperator::Add, read(2, Int), read(0, Int))),
            statement(StatementKind::Assign(
                AssignmentTarget::Result,
                binary(BinaryOperator::Multiply, read(2, Int), read(1, Int)),
            )),
            statement(StatementKind::Return),
            statement(StatementKind::Assign(AssignmentTarget::Result, literal("INT#0"))),
        ],
    };
    let call = |arguments: Vec<(usize, Expression)>| {
        let arguments = arguments.into_iter().map(|(parameter, value)| Argument {
            parameter: VariableId(parameter),
            value,
        });
        of(Int, ExpressionKind::Call(0, arguments.collect()))
    };
    let inner = call(vec![(0, literal("INT#1"))]);
    let outer = call(vec![(0, inner), (1, literal("INT#100"))]);
    let mut main = program(vec![local("r", Int, "")], vec![set(0, Int, outer)]);
    main.functions.push(function);
    assert_eq!(values(&main), ["r = INT#2100"]);
    assert_eq!(values_after(&main, 3), ["r = INT#2100"]);
}

/// Creates a program with a block that adds an input to its output and to an in-out, and two instances of it.
fn counters(body: Vec<Statement>) -> Program {
    let sum = |to: usize| set(to, Int, binary(BinaryOperator::Add, read(to, Int), read(0, Int)));
    let block = FunctionBlock {
        name: "Counter".to_owned(),
        variables: vec![
            variable(
                "step",
                Type::Elementary(Int),
                VariableSection::Input,
                Some(literal("INT#1")),
            ),
            variable(
                "total",
                Type::Elementary(Int),
                VariableSection::Output,
                Some(literal("INT#100")),
            ),
            variable("all", Type::Elementary(Int), VariableSection::InOut, None),
        ],
        body: vec![sum(1), sum(2)],
    };
    let mut main = program(
        vec![
            variable("a", Type::Block(0), VariableSection::Local, None),
            variable("b", Type::Block(0), VariableSection::Local, None),
            local("all", Int, ""),
            local("captured", Int, ""),
        ],
        body,
    );
    main.blocks.push(block);
    main
}

fn invoke(instance: usize, step: Option<&str>, outputs: Vec<(VariableId, Place)>) -> Statement {
    let mut inputs = vec![Argument {
        parameter: VariableId(2),
        value: read(2, Int),
    }];
    inputs.extend(step.map(|step| Argument {
        parameter: VariableId(0),
        value: literal(step),
    }));
    statement(StatementKind::Invoke {
        instance: VariableId(instance),
        inputs,
        outputs,
    })
}

#[test]
fn an_instance_keeps_its_variables_and_changes_what_stands_behind_its_in_out() {
    let captured = (VariableId(1), place(3, Vec::new(), Int));
    let main = counters(vec![
        invoke(0, Some("INT#5"), vec![captured]),
        invoke(0, None, Vec::new()),
        invoke(1, None, Vec::new()),
    ]);
    let once = [
        "a.total = INT#110",
        "b.total = INT#101",
        "all = INT#11",
        "captured = INT#105",
    ];
    assert_eq!(values(&main), once);
    assert_eq!(values_after(&main, 2)[0], "a.total = INT#120");
    assert_eq!(questions(&main), []);
}
