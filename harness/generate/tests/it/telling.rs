//! Tests that programs tell wrong compilers apart: a compiler with one of these mistakes gives other values for some
//! programs.
use stickler_generate::evaluate::{EvaluationError, evaluate};
use stickler_generate::generator::{GeneratorSettings, program};
use stickler_generate::model::visit_mut::{VisitorMut, walk_expression, walk_program};
use stickler_generate::model::{
    Argument, BinaryOperator, Expression, ExpressionKind, LiteralForm, Program, StandardFunction, Type,
};
use stickler_generate::random::bytes;
use stickler_types::{DialectName, ElementaryType, Value};

/// The number of programs: a campaign makes as many in some seconds.
const PROGRAMS: u64 = 11_000;

/// The number of programs that must show a mistake for it to count as found.
const MIN_FOUND: usize = 6;

fn made(seed: u64) -> Program {
    let bytes = bytes(seed, (seed * 7 % 3000) as usize);
    program(&bytes, &GeneratorSettings::default())
}

/// A wrong reading of every expression, operands before the whole.
struct Misread<F>(F);

impl<F: FnMut(&mut Expression)> VisitorMut for Misread<F> {
    fn expression(&mut self, expression: &mut Expression) {
        walk_expression(self, expression);
        (self.0)(expression);
    }
}

/// The values that a program gives, with their names.
type Values = Result<Vec<(String, Value)>, EvaluationError>;

/// Counts the programs that give other values when every expression is misread; stops at [`MIN_FOUND`].
fn told_apart(misread: impl Fn(&Program, &mut Expression)) -> usize {
    changed(misread, |wrong, right| wrong != right)
}

/// Counts the programs whose values differ as wanted when every expression is misread; stops at [`MIN_FOUND`].
fn changed(misread: impl Fn(&Program, &mut Expression), differ: impl Fn(Values, Values) -> bool) -> usize {
    let differs = |seed: &u64| {
        let right = made(*seed);
        let mut wrong = right.clone();
        walk_program(
            &mut Misread(|expression: &mut Expression| misread(&right, expression)),
            &mut wrong,
        );
        let values = |program| evaluate(program, 1).map(|evaluation| evaluation.values);
        wrong != right && differ(values(&wrong), values(&right))
    };
    (0..PROGRAMS).filter(differs).take(MIN_FOUND).count()
}

fn literal(value: Value, ty: &Type) -> Expression {
    Expression::new(ty.clone(), ExpressionKind::Literal(value, LiteralForm::Typed))
}

#[test]
fn a_literal_that_is_less_from_one_that_is_equal() {
    let found = told_apart(|_, expression| {
        if let ExpressionKind::Binary(operator @ BinaryOperator::Less, left, _) = &mut expression.kind
            && matches!(left.kind, ExpressionKind::Literal(..))
        {
            *operator = BinaryOperator::LessOrEqual;
        }
    });
    assert_eq!(found, MIN_FOUND);
}

#[test]
fn an_input_that_is_left_out_from_one_that_is_not_its_initial_value() {
    let found = told_apart(|program, expression| {
        let ExpressionKind::Call(function, arguments) = &mut expression.kind else {
            return;
        };
        let given: Vec<_> = arguments.iter().map(|argument| argument.parameter).collect();
        for (parameter, variable) in program.functions[*function].inputs() {
            if let (false, Type::Elementary(ty)) = (given.contains(&parameter), &variable.ty)
                && ty.is_integer()
            {
                let value = literal(Value::plain(*ty, 77), &variable.ty);
                arguments.push(Argument { parameter, value });
            }
        }
    });
    assert_eq!(found, MIN_FOUND);
}

#[test]
fn the_longest_shifts_from_those_that_leave_nothing() {
    for function in [
        StandardFunction::Shl,
        StandardFunction::Shr,
        StandardFunction::Rol,
        StandardFunction::Ror,
    ] {
        let found = told_apart(|_, expression| {
            let (ExpressionKind::Standard(called, arguments), Type::Elementary(ty)) =
                (&expression.kind, &expression.ty)
            else {
                return;
            };
            let last = Value::plain(ElementaryType::Int, u64::from(ty.bits().saturating_sub(1)));
            if *called == function
                && matches!(&arguments[1].kind, ExpressionKind::Literal(count, _) if *count == last)
            {
                *expression = literal(Value::plain(*ty, 0), &expression.ty);
            }
        });
        assert_eq!(found, MIN_FOUND, "{function:?}");
    }
}

#[test]
fn products_that_are_subnormal_from_zero() {
    let is_subnormal = |value: &Value| match *value {
        Value::Plain { ty, raw } => match ty {
            ElementaryType::Real => f32::from_bits(raw as u32).is_subnormal(),
            ElementaryType::Lreal => f64::from_bits(raw).is_subnormal(),
            _ => false,
        },
        _ => false,
    };
    let subnormals = |values: Values| {
        let values = values.unwrap_or_default().into_iter();
        values.filter(|(_, value)| is_subnormal(value)).count()
    };
    let without_products = |_: &Program, expression: &mut Expression| {
        if let (ExpressionKind::Binary(BinaryOperator::Multiply, ..), Type::Elementary(ty)) =
            (&expression.kind, &expression.ty)
            && ty.is_real()
        {
            *expression = literal(Value::plain(*ty, 0), &expression.ty);
        }
    };
    let found = changed(without_products, |wrong, right| {
        subnormals(wrong) < subnormals(right)
    });
    assert_eq!(found, MIN_FOUND);
}

#[test]
fn calls_leave_inputs_out_only_where_documents_say_what_they_are_then() {
    let leaves_out = |open, dialect| {
        let settings = GeneratorSettings {
            open,
            ..GeneratorSettings::of(dialect)
        };
        (0..300).any(|seed| {
            let mut program = program(&bytes(seed, 2000), &settings);
            let inputs: Vec<usize> = { program.functions.iter() }
                .map(|function| function.inputs().count())
                .collect();
            let mut leaves_out = false;
            let mut note = |call: &mut Expression| {
                leaves_out |= matches!(&call.kind, ExpressionKind::Call(function, given) if given.len() < inputs[*function]);
            };
            walk_program(&mut Misread(&mut note), &mut program);
            leaves_out
        })
    };
    for &dialect in DialectName::ALL.iter() {
        let settled = matches!(dialect, DialectName::MATIEC | DialectName::PLCNEXT);
        assert_eq!(leaves_out(false, dialect), settled, "{dialect}");
        assert!(leaves_out(true, dialect), "{dialect}");
    }
}
