//! A program made by hand that has a place for every kind of error.

use super::fault_site::literal;
use super::scope::integer;
use crate::model::*;
use stickler_types::{DialectName, ElementaryType as E, Value};

/// Creates the program in a dialect.
pub(super) fn example(dialect: DialectName) -> Program {
    Program {
        dialect,
        types: types(),
        functions: vec![function()],
        blocks: vec![block("Counter", true), block("Timer", false)],
        main: main(dialect),
    }
}

const COLOUR: Type = Type::Declared(0);
const POINT: Type = Type::Declared(2);

fn types() -> Vec<TypeDeclaration> {
    let names =
        |names: &[&str]| DeclaredKind::Enumeration(names.iter().map(|&name| name.to_owned()).collect());
    let declared = |name: &str, kind| TypeDeclaration {
        name: name.to_owned(),
        kind,
    };
    let fields = vec![
        ("x".to_owned(), Type::Elementary(E::Int), None),
        ("y".to_owned(), Type::Elementary(E::Real), Some(literal(E::Real))),
    ];
    vec![
        declared("Colour", names(&["Red", "Green"])),
        declared("Fruit", names(&["Apple", "Pear"])),
        declared("Point", DeclaredKind::Structure(fields)),
        declared("Level", DeclaredKind::Alias(Type::Elementary(E::Dint))),
    ]
}

fn variable(name: &str, ty: Type, section: VariableSection, initial: Option<InitialValue>) -> Variable {
    Variable {
        name: name.to_owned(),
        ty,
        section,
        initial,
    }
}

fn elementary(name: &str, ty: E, section: VariableSection) -> Variable {
    variable(name, Type::Elementary(ty), section, None)
}

fn read(id: usize, ty: Type) -> Expression {
    Expression {
        kind: ExpressionKind::Read(place(id, Vec::new(), ty.clone())),
        ty,
    }
}

fn place(id: usize, path: Vec<PlaceSelector>, ty: Type) -> Place {
    Place {
        variable: VariableId(id),
        path,
        ty,
    }
}

fn statement(kind: StatementKind) -> Statement {
    Statement { kind }
}

fn assign(id: usize, value: Expression) -> Statement {
    let target = AssignmentTarget::Place(place(id, Vec::new(), value.ty.clone()));
    statement(StatementKind::Assign(target, value))
}

fn binary(ty: E, operator: BinaryOperator, left: Expression, right: Expression) -> Expression {
    Expression::elementary(
        ty,
        ExpressionKind::Binary(operator, Box::new(left), Box::new(right)),
    )
}

fn function() -> Function {
    let sum = binary(
        E::Int,
        BinaryOperator::Add,
        read(0, Type::Elementary(E::Int)),
        literal(E::Int),
    );
    Function {
        name: "Weigh".to_owned(),
        result: Type::Elementary(E::Int),
        variables: vec![
            elementary("a", E::Int, VariableSection::Input),
            elementary("b", E::Real, VariableSection::Input),
        ],
        body: vec![statement(StatementKind::Assign(AssignmentTarget::Result, sum))],
    }
}

fn block(name: &str, in_out: bool) -> FunctionBlock {
    let mut variables = vec![
        elementary("step", E::Dint, VariableSection::Input),
        elementary("total", E::Dint, VariableSection::Output),
        elementary("inner", E::Bool, VariableSection::Local),
    ];
    if in_out {
        variables.push(elementary("through", E::Dint, VariableSection::InOut));
    }
    let sum = binary(
        E::Dint,
        BinaryOperator::Add,
        read(1, Type::Elementary(E::Dint)),
        read(0, Type::Elementary(E::Dint)),
    );
    FunctionBlock {
        name: name.to_owned(),
        variables,
        body: vec![assign(1, sum)],
    }
}

/// The variables of main, by their indices.
const I: usize = 0;
const D: usize = 1;
const R: usize = 2;
const B: usize = 3;
const W: usize = 4;
const S: usize = 5;
const T: usize = 6;
const DAY: usize = 7;
const LIST: usize = 8;
const P: usize = 9;
const C: usize = 10;
const COUNTER: usize = 11;
const TIMER: usize = 12;

fn main_variables() -> Vec<Variable> {
    let local = |name, ty| elementary(name, ty, VariableSection::Local);
    let array = Type::Array(Box::new(ArrayType {
        dimensions: vec![(1, 3), (0, 1)],
        element: Type::Elementary(E::Int),
    }));
    let first = InitialValue::Expression(literal(E::Int));
    vec![
        variable("i", Type::Elementary(E::Int), VariableSection::Local, Some(first)),
        local("d", E::Dint),
        local("r", E::Real),
        local("b", E::Bool),
        local("w", E::Word),
        local("s", E::String),
        local("t", E::Time),
        local("day", E::Date),
        variable("list", array, VariableSection::Local, None),
        variable(
            "p",
            POINT,
            VariableSection::Local,
            Some(InitialValue::Structure(vec![(0, literal(E::Int))])),
        ),
        variable("c", COLOUR, VariableSection::Local, None),
        variable("counter", Type::Block(0), VariableSection::Local, None),
        variable("timer", Type::Block(1), VariableSection::Local, None),
        local("k", E::Int),
    ]
}

fn main(dialect: DialectName) -> MainPou {
    let mut body = vec![
        assign(R, literal(E::Real)),
        assign(
            S,
            Expression::elementary(
                E::String,
                ExpressionKind::Standard(StandardFunction::Concat, vec![text(), text()]),
            ),
        ),
        assign(T, literal(E::Time)),
        assign(DAY, literal(E::Date)),
        assign(
            C,
            Expression {
                ty: COLOUR,
                kind: ExpressionKind::Enumerated(1),
            },
        ),
        assign(
            W,
            Expression::elementary(
                E::Word,
                ExpressionKind::Unary(UnaryOperator::Not, Box::new(read(W, Type::Elementary(E::Word)))),
            ),
        ),
        assign(
            I,
            Expression::elementary(
                E::Int,
                ExpressionKind::Standard(StandardFunction::Abs, vec![read(I, Type::Elementary(E::Int))]),
            ),
        ),
        assign(I, call()),
        assign(I, element()),
        branches(),
        choice(),
        invocation(),
    ];
    body.extend(loops());
    body.extend(conversions(dialect));
    MainPou {
        variables: main_variables(),
        body,
    }
}

fn text() -> Expression {
    let value = Value::text(E::String, vec![u16::from(b'x')]);
    Expression::elementary(E::String, ExpressionKind::Literal(value, LiteralForm::Untyped))
}

fn call() -> Expression {
    let argument = |parameter, value| Argument {
        parameter: VariableId(parameter),
        value,
    };
    let arguments = vec![
        argument(0, read(I, Type::Elementary(E::Int))),
        argument(1, read(R, Type::Elementary(E::Real))),
    ];
    Expression::elementary(E::Int, ExpressionKind::Call(0, arguments))
}

fn element() -> Expression {
    let subscripts = PlaceSelector::Index(vec![integer(1), read(I, Type::Elementary(E::Int))]);
    let place = place(LIST, vec![subscripts], Type::Elementary(E::Int));
    Expression::elementary(E::Int, ExpressionKind::Read(place))
}

fn condition() -> Expression {
    let left = read(D, Type::Elementary(E::Dint));
    binary(E::Bool, BinaryOperator::Less, left, literal(E::Dint))
}

fn branches() -> Statement {
    let body = || vec![assign(D, literal(E::Dint))];
    let branches = vec![
        (condition(), body()),
        (read(B, Type::Elementary(E::Bool)), body()),
    ];
    statement(StatementKind::If(branches, Some(body())))
}

fn choice() -> Statement {
    let label = |value: i64| {
        let literal =
            ExpressionKind::Literal(Value::plain(E::Int, value.cast_unsigned()), LiteralForm::Untyped);
        Expression::elementary(E::Int, literal)
    };
    let branch = |label| CaseBranch {
        labels: vec![label],
        body: vec![assign(B, literal(E::Bool))],
    };
    let branches = vec![
        branch(CaseLabel::One(label(1))),
        branch(CaseLabel::Range(label(3), label(5))),
    ];
    statement(StatementKind::Case(
        read(I, Type::Elementary(E::Int)),
        branches,
        None,
    ))
}

fn invocation() -> Statement {
    let argument = |parameter, value| Argument {
        parameter: VariableId(parameter),
        value,
    };
    statement(StatementKind::Invoke {
        instance: VariableId(COUNTER),
        inputs: vec![
            argument(0, literal(E::Dint)),
            argument(3, read(D, Type::Elementary(E::Dint))),
        ],
        outputs: vec![(VariableId(1), place(D, Vec::new(), Type::Elementary(E::Dint)))],
    })
}

fn loops() -> Vec<Statement> {
    let k = VariableId(13);
    let exit = || vec![statement(StatementKind::Exit)];
    let repeated = StatementKind::Repeat(exit(), condition());
    let timed = StatementKind::Invoke {
        instance: VariableId(TIMER),
        inputs: vec![],
        outputs: vec![],
    };
    vec![
        statement(StatementKind::For {
            variable: k,
            from: literal(E::Int),
            to: read(I, Type::Elementary(E::Int)),
            by: None,
            body: vec![statement(timed)],
        }),
        assign(13, literal(E::Int)),
        statement(StatementKind::While(condition(), exit())),
        statement(repeated),
    ]
}

/// Creates conversions between types that do not convert implicitly.
fn conversions(dialect: DialectName) -> Vec<Statement> {
    let convert = |name: &str, argument: Expression| {
        let signature = stickler_exact::signatures(name, dialect).swap_remove(0);
        Expression::elementary(
            signature.result,
            ExpressionKind::Convert(signature, Box::new(argument)),
        )
    };
    let int = || convert("REAL_TO_INT", read(R, Type::Elementary(E::Real)));
    let bool = || convert("INT_TO_BOOL", read(I, Type::Elementary(E::Int)));
    let argument = |parameter, value| Argument {
        parameter: VariableId(parameter),
        value,
    };
    let arguments = vec![argument(0, int()), argument(1, literal(E::Real))];
    vec![
        assign(I, int()),
        assign(
            I,
            binary(
                E::Int,
                BinaryOperator::Add,
                read(I, Type::Elementary(E::Int)),
                int(),
            ),
        ),
        assign(
            I,
            Expression::elementary(E::Int, ExpressionKind::Call(0, arguments)),
        ),
        statement(StatementKind::If(vec![(bool(), vec![])], None)),
        assign(B, bool()),
        assign(P, read(P, POINT)),
    ]
}
