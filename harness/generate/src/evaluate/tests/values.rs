//! Values: operators, conversions, parts of variables, standard functions, faults.

use super::*;

#[test]
fn a_sum_wraps_and_what_is_not_assigned_keeps_its_initial_value() {
    let sum = binary(BinaryOperator::Add, read(0, Sint), literal("SINT#1"));
    let main = program(
        vec![
            local("a", Sint, "SINT#127"),
            local("b", Sint, ""),
            local("c", ElementaryType::String, "STRING#'x'"),
        ],
        vec![set(1, Sint, sum)],
    );
    assert_eq!(values(&main), ["a = SINT#127", "b = SINT#-128", "c = STRING#'x'"]);
    assert_eq!(values_after(&main, 0)[1], "b = SINT#0");
    assert_eq!(questions(&main), []);
}

#[test]
fn a_conversion_is_that_of_exact_arithmetic_and_open_where_no_document_says() {
    let convert = |function: &str, operand: Expression, to: ElementaryType, dialect| {
        let signature = signatures(function, dialect)
            .into_iter()
            .find(|s| s.result == to)
            .unwrap();
        let call = of(to, ExpressionKind::Convert(signature, Box::new(operand)));
        let mut main = program(vec![local("r", to, "")], vec![set(0, to, call)]);
        main.dialect = dialect;
        (values(&main).remove(0), questions(&main))
    };
    assert_eq!(
        convert("DINT_TO_INT", literal("DINT#100000"), Int, DialectName::MATIEC),
        ("r = INT#-31072".to_owned(), vec![])
    );
    assert_eq!(
        convert("REAL_TO_INT", literal("REAL#2.5"), Int, DialectName::PLCNEXT),
        ("r = INT#2".to_owned(), vec![OpenQuestion::Conversion])
    );
}

#[test]
fn an_implicit_conversion_keeps_the_value() {
    let widen = |from: &str, to: ElementaryType, dialect| {
        let widened = of(to, ExpressionKind::Widen(Box::new(literal(from))));
        let mut main = program(vec![local("r", to, "")], vec![set(0, to, widened)]);
        main.dialect = dialect;
        (values(&main).remove(0), questions(&main))
    };
    let ed3 = DialectName::IRONPLC_ED3;
    assert_eq!(widen("INT#-5", Dint, ed3), ("r = DINT#-5".to_owned(), vec![]));
    assert_eq!(
        widen("LINT#9007199254740993", Lreal, ed3),
        ("r = LREAL#9007199254740992.0".to_owned(), vec![])
    );
    assert_eq!(
        widen("BYTE#16#80", Int, DialectName::IRONPLC_RUSTY),
        ("r = INT#128".to_owned(), vec![])
    );
    let plcnext = DialectName::PLCNEXT;
    assert_eq!(
        widen("UDINT#1500", Time, plcnext),
        ("r = TIME#1500ms".to_owned(), vec![])
    );
    assert_eq!(
        widen("TIME#1.5ms", Udint, plcnext).1,
        [OpenQuestion::ImplicitConversion]
    );
    assert_eq!(
        widen("TIME#1ms", Ltime, ed3).1,
        [OpenQuestion::ImplicitConversion]
    );
}

#[test]
fn elements_fields_and_bits_are_read_and_written_where_they_are() {
    let pair = TypeDeclaration {
        name: "Pair".to_owned(),
        kind: DeclaredKind::Structure(vec![
            ("x".to_owned(), Type::Elementary(Int), Some(literal("INT#7"))),
            ("y".to_owned(), Type::Elementary(Byte), None),
        ]),
    };
    let array = ArrayType {
        dimensions: vec![(0, 1), (-1, 1)],
        element: Type::Declared(0),
    };
    let at = |i: &str, j: &str, field| {
        vec![
            PlaceSelector::Index(vec![literal(i), literal(j)]),
            PlaceSelector::Field(field),
        ]
    };
    let mut main = program(
        vec![
            variable("grid", Type::Array(Box::new(array)), VariableSection::Local, None),
            variable("one", Type::Declared(0), VariableSection::Local, None),
            local("bit", Bool, ""),
        ],
        vec![
            assign(place(0, at("INT#1", "SINT#-1", 0), Int), literal("INT#40")),
            statement(StatementKind::Assign(
                AssignmentTarget::Bit(place(0, at("INT#1", "SINT#-1", 1), Byte), 7),
                literal("BOOL#TRUE"),
            )),
            statement(StatementKind::Assign(
                AssignmentTarget::Bit(place(1, vec![PlaceSelector::Field(0)], Int), 15),
                literal("BOOL#TRUE"),
            )),
            set(
                2,
                Bool,
                of(
                    Bool,
                    ExpressionKind::Bit(place(0, at("INT#1", "SINT#-1", 1), Byte), 7),
                ),
            ),
        ],
    );
    main.types.push(pair);
    let values = values(&main);
    assert_eq!(values.len(), 15);
    assert_eq!(values[0], "grid[0,-1].x = INT#7");
    assert_eq!(values[6], "grid[1,-1].x = INT#40");
    assert_eq!(values[7], "grid[1,-1].y = BYTE#16#80");
    assert_eq!(
        values[12..],
        ["one.x = INT#-32761", "one.y = BYTE#16#00", "bit = BOOL#TRUE"]
    );
}

#[test]
fn a_subscript_outside_and_a_division_by_zero_are_faults() {
    let array = ArrayType {
        dimensions: vec![(1, 3)],
        element: Type::Elementary(Int),
    };
    let outside = program(
        vec![
            variable("a", Type::Array(Box::new(array)), VariableSection::Local, None),
            local("i", Int, "INT#4"),
        ],
        vec![assign(
            place(0, vec![PlaceSelector::Index(vec![read(1, Int)])], Int),
            literal("INT#1"),
        )],
    );
    assert_eq!(
        evaluate(&outside, 1),
        Err(EvaluationError::Fault(Fault::SubscriptRange))
    );
    let quotient = binary(BinaryOperator::Divide, literal("INT#1"), read(0, Int));
    let by_zero = program(vec![local("a", Int, "")], vec![set(0, Int, quotient)]);
    assert_eq!(
        evaluate(&by_zero, 1),
        Err(EvaluationError::Fault(Fault::DivisionByZero))
    );
}

#[test]
fn what_no_document_settles_is_told_with_its_place() {
    let quotient = binary(BinaryOperator::Divide, literal("REAL#1.0"), read(0, Real));
    let main = program(
        vec![local("a", Real, ""), local("d", Date, "")],
        vec![set(0, Real, quotient)],
    );
    let evaluation = evaluate(&main, 1).unwrap();
    assert_eq!(evaluation.values[0].1.to_string(), "REAL#Infinity");
    let opened: Vec<String> = evaluation.opened.iter().map(ToString::to_string).collect();
    assert_eq!(
        opened[0],
        "a real divided by zero (main: Divide of REAL; sought in IEC 60559 and real-arithmetic)"
    );
    assert!(
        opened[1].starts_with("the initial value of a date (main: it is read;"),
        "{opened:?}"
    );
    assert!(!evaluation.binds_the_reference());
}

#[test]
fn a_model_that_contradicts_itself_is_refused_and_never_a_panic() {
    let wrong = [
        set(9, Int, literal("INT#1")),
        set(0, Int, of(Int, ExpressionKind::Call(3, Vec::new()))),
        set(
            0,
            Int,
            binary(BinaryOperator::And, literal("INT#1"), literal("INT#1")),
        ),
        set(
            0,
            Int,
            of(Int, ExpressionKind::Standard(StandardFunction::Len, Vec::new())),
        ),
        statement(StatementKind::Assign(
            AssignmentTarget::Bit(place(0, Vec::new(), Int), 16),
            literal("BOOL#TRUE"),
        )),
        statement(StatementKind::Assign(AssignmentTarget::Result, literal("INT#1"))),
        assign(place(0, vec![PlaceSelector::Field(0)], Int), literal("INT#1")),
        statement(StatementKind::Invoke {
            instance: VariableId(0),
            inputs: Vec::new(),
            outputs: Vec::new(),
        }),
    ];
    for statement in wrong {
        let answer = evaluate(&program(vec![local("a", Int, "")], vec![statement.clone()]), 1);
        assert!(
            matches!(answer, Err(EvaluationError::IllFormed(_))),
            "{statement:?}: {answer:?}"
        );
    }
    let raw = set(0, Int, of(Int, ExpressionKind::Raw("?".to_owned())));
    assert_eq!(
        evaluate(&program(vec![local("a", Int, "")], vec![raw]), 1),
        Err(EvaluationError::Raw)
    );
    let mut recursive = program(
        vec![local("a", Int, "")],
        vec![set(0, Int, of(Int, ExpressionKind::Call(0, Vec::new())))],
    );
    recursive.functions.push(Function {
        name: "f".to_owned(),
        result: Type::Elementary(Int),
        variables: Vec::new(),
        body: vec![statement(StatementKind::Assign(
            AssignmentTarget::Result,
            of(Int, ExpressionKind::Call(0, Vec::new())),
        ))],
    });
    assert!(matches!(
        evaluate(&recursive, 1),
        Err(EvaluationError::IllFormed(_))
    ));
}

#[test]
fn standard_functions_give_what_the_standard_says() {
    let call = |function, arguments: &[&str], ty| {
        let arguments = arguments.iter().map(|argument| literal(argument)).collect();
        let main = program(
            vec![local("r", ty, "")],
            vec![set(0, ty, of(ty, ExpressionKind::Standard(function, arguments)))],
        );
        (values(&main).remove(0), questions(&main))
    };
    use StandardFunction::*;
    let settled = |text: &str| (format!("r = {text}"), vec![]);
    assert_eq!(call(Abs, &["SINT#-128"], Sint), settled("SINT#-128"));
    assert_eq!(call(Abs, &["LREAL#-0.0"], Lreal), settled("LREAL#0.0"));
    assert_eq!(
        call(
            Sel,
            &["BOOL#TRUE", "STRING#'no'", "STRING#'yes'"],
            ElementaryType::String
        ),
        settled("STRING#'yes'")
    );
    assert_eq!(call(Mux, &["SINT#1", "INT#3", "INT#-4"], Int), settled("INT#-4"));
    assert_eq!(
        call(Mux, &["SINT#2", "INT#3", "INT#-4"], Int).1,
        [OpenQuestion::MuxSelector]
    );
    assert_eq!(
        call(Min, &["UDINT#4000000000", "UDINT#5"], Udint),
        settled("UDINT#5")
    );
    assert_eq!(call(Max, &["REAL#1.5", "REAL#1.25"], Real), settled("REAL#1.5"));
    assert_eq!(
        call(Max, &["REAL#0.0", "REAL#-0.0"], Real).1,
        [OpenQuestion::ZerosOfTwoSigns]
    );
    assert_eq!(
        call(Limit, &["INT#0", "INT#15", "INT#10"], Int),
        settled("INT#10")
    );
    assert_eq!(
        call(Limit, &["INT#10", "INT#5", "INT#0"], Int).1,
        [OpenQuestion::LimitsCrossed]
    );
    assert_eq!(call(Ror, &["BYTE#16#81", "INT#1"], Byte), settled("BYTE#16#C0"));
    assert_eq!(call(Len, &["STRING#'abc'"], Int), settled("INT#3"));
    assert_eq!(
        call(Concat, &["STRING#'ab'", "STRING#'c'"], ElementaryType::String),
        settled("STRING#'abc'")
    );
}
