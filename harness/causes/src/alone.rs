//! The operands of a small program, each in a program of its own: whether the engine already fails with the operand alone is
//! asked before the operation around it is blamed.

use crate::program::{Part, ReadProgram};
use crate::question::{Deviation, wrong_values};
use crate::smaller_case::all_values;
use crate::words::{converted, elementary, is_number, tokens, type_of_word};
use crate::work::{Role, works};
use std::collections::HashSet;
use stickler_reference::errors;
use stickler_syntax::Edits;
use stickler_syntax::source::Span;
use stickler_syntax::token::TokenKind;
use stickler_syntax::tree::{Argument, BinaryOperator, ExpressionId, ExpressionKind, StatementKind};
use stickler_syntax::visitor::Place;
use stickler_types::{DialectName, ElementaryType, Value};

/// A program that does with one operand what another program does with it among other things. Its variable `into` shows the value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Alone {
    pub(crate) program: String,
    /// The type of the variable `into`.
    pub(crate) ty: ElementaryType,
    /// Whether it does nothing but begin a variable with a value.
    pub(crate) is_initial: bool,
    /// The literal, where the operand is one.
    pub(crate) literal: Option<String>,
}

impl Alone {
    /// Assigns a literal.
    fn assigned(ty: ElementaryType, literal: &str) -> Alone {
        Alone {
            literal: Some(literal.to_owned()),
            ..Alone::new(None, ty, literal)
        }
    }

    /// Begins a variable with a literal, and assigns the variable.
    fn initial(ty: ElementaryType, literal: &str) -> Alone {
        Alone {
            literal: Some(literal.to_owned()),
            ..Alone::copied(ty, ty, Some(literal.to_owned()))
        }
    }

    /// Assigns a variable of the type `from`, which may have an initial value.
    fn copied(from: ElementaryType, ty: ElementaryType, initial: Option<String>) -> Alone {
        Alone {
            is_initial: from == ty,
            ..Alone::new(Some((from, initial)), ty, "data")
        }
    }

    /// Assigns an expression, which may use the variable `data` with a type and an initial value.
    fn new(data: Option<(ElementaryType, Option<String>)>, ty: ElementaryType, expression: &str) -> Alone {
        let data = data.map_or(String::new(), |(from, initial)| {
            let initial = initial.map_or(String::new(), |value| format!(" := {value}"));
            format!("    data : {}{initial};\n", from.name())
        });
        let name = ty.name();
        Alone {
            program: format!(
                "{HEAD}{data}    into : {name};\nEND_VAR\n    into := {expression};\nEND_PROGRAM\n"
            ),
            ty,
            is_initial: false,
            literal: None,
        }
    }
}

/// The beginning of each program with an operand alone.
const HEAD: &str = "PROGRAM main\nVAR\n";

/// Returns the FOR loops of a program whose last value is the first one, each alone with that value; and then one that counts from 1
/// to 1. The reference says where a loop ends.
pub(crate) fn loops_alone(program: &ReadProgram<'_, '_>, dialect: DialectName) -> Vec<Alone> {
    let loops = program.at(Place::From).filter_map(|part| {
        let statement = part.statement?;
        let StatementKind::For { control, to, .. } = statement.kind else {
            return None;
        };
        let ty = program.type_of(control)?;
        let (section, start) = (part.pou?.blocks.last()?.span.end, statement.span.start);
        let [from, to] = [part.id, to].map(|limit| program.text(limit));
        let limits = format!("\nVAR loop_from : {0}; loop_to : {0} := 1; END_VAR\n", ty.name());
        let mut edits = Edits::replacing(section as usize..section as usize, limits);
        let given = format!("loop_from := {from}; loop_to := {to};\n");
        edits.replace(start as usize..start as usize, given);
        let (_, values) = all_values(&edits.apply(program.text), dialect);
        let value = |own: &str| {
            let mut values = values.iter().flatten();
            let value = values.find(|(name, _)| name.rsplit('.').next() == Some(own));
            value.map(|(_, value)| value.to_string())
        };
        let only = value("loop_from").filter(|from| Some(from) == value("loop_to").as_ref())?;
        Some((ty, only.rsplit_once('#')?.1.to_owned()))
    });
    let loops: Vec<_> = loops.collect();
    let ends_at_once = !loops.is_empty() || has_loop_to_its_first_value(program, dialect);
    let plain = ends_at_once.then(|| (ElementaryType::Int, "1".to_owned()));
    // What was never assigned is 0.
    let shown = loops.into_iter().filter(|(_, only)| only != "0").chain(plain);
    let alone = |(ty, only): (ElementaryType, String)| {
        let name = ty.name();
        let variables = format!("    count : {name};\n    into : {name};\nEND_VAR\n");
        let body = format!("    FOR count := {only} TO {only} DO\n        into := count;\n    END_FOR;\n");
        Alone {
            program: format!("{HEAD}{variables}{body}END_PROGRAM\n"),
            ty,
            is_initial: false,
            literal: None,
        }
    };
    shown.map(alone).collect()
}

/// Returns whether the last value of a FOR loop is the first one at some time, wherever the loop stands: a loop before it that ends only
/// where they differ never ends.
fn has_loop_to_its_first_value(program: &ReadProgram<'_, '_>, dialect: DialectName) -> bool {
    let mut edits = Edits::new();
    for part in program.at(Place::From) {
        if let Some(statement) = part.statement
            && let StatementKind::For { to, .. } = statement.kind
        {
            let limits = [part.id, to].map(|limit| program.text(limit));
            let waits = format!("REPEAT\nUNTIL ({}) <> ({})\nEND_REPEAT;\n", limits[0], limits[1]);
            let start = statement.span.start as usize;
            edits.replace(start..start, waits);
        }
    }
    let waiting = edits.apply(program.text);
    waiting != program.text
        && all_values(program.text, dialect).1.is_some()
        && errors(&waiting, dialect).is_empty()
        && all_values(&waiting, dialect).1.is_none()
}

/// Returns whether a program is one of those that [`loops_alone`] makes.
pub(crate) fn is_loop_alone(program: &str) -> bool {
    limit_of_loop_alone(program).is_some()
}

/// Returns the only value of the loop of a program that [`loops_alone`] makes; `None` of another one.
pub(crate) fn limit_of_loop_alone(program: &str) -> Option<&str> {
    let header = program.lines().nth(5)?.strip_prefix("    FOR count := ")?;
    let (from, to) = header.strip_suffix(" DO")?.split_once(" TO ")?;
    let is_made = program.starts_with("PROGRAM main\nVAR\n    count : ");
    (is_made && from == to).then_some(to)
}

/// Returns whether what an engine does with a program shows something: of a loop alone only that it does not run.
pub(crate) fn shows(program: &str, seen: &Deviation) -> bool {
    let wrong = wrong_values(&seen.expected, &seen.got).next();
    let is_begun = wrong.is_some_and(|(_, (_, got))| matches!(got, Value::Plain { raw: 0, .. }));
    is_begun || !is_loop_alone(program)
}

/// Returns how far a program is from one with an operand alone: 0 for a value without a variable, 1 for a variable, 2 for others.
pub(crate) fn distance(program: &str) -> u64 {
    let is_alone = program.starts_with(HEAD)
        && program.contains("\nEND_VAR\n    into := ")
        && program.lines().count() < 8;
    match program.contains("    data : ") {
        _ if is_loop_alone(program) => 0,
        _ if !is_alone => 2,
        true => 1,
        false => 0,
    }
}

/// Returns the operands of a program alone: literals first, then variables, then calls of conversion functions. The most
/// general place comes first: an assignment before an initial value.
pub(crate) fn alone(program: &ReadProgram<'_, '_>) -> Vec<Alone> {
    let special = works(program.text)
        .into_iter()
        .filter(|work| work.role == Role::Literal);
    let special: HashSet<Span> = special.map(|work| work.span).collect();
    let (mut literals, mut variables, mut calls) = (Vec::new(), Vec::new(), Vec::new());
    for part in &program.parts {
        let target = program.target(part);
        let source = program.type_of(part.id);
        // The number behind a minus is a part of another literal.
        let is_signed = part
            .around
            .is_some_and(|around| program.literal(around).is_some());
        let literal = program.literal(part.id).filter(|_| !is_signed);
        if let Some(literal) = literal {
            let in_calculation =
                || calculated(program, part).filter(|_| special.contains(&part.expression.span));
            if let Some(ty) = target.or_else(in_calculation).or(source) {
                let is_typed = type_of_word(literal) == Some(ty);
                let plain = literal.split_once('#').filter(|_| is_typed);
                let plain = plain.map(|(_, plain)| untyped(ty, plain));
                for literal in plain.as_deref().into_iter().chain([literal]) {
                    literals.push(Alone::assigned(ty, literal));
                    literals.extend(part.statement.is_none().then(|| Alone::initial(ty, literal)));
                }
            }
        } else if let (Some(ty), Some(from)) = (target, source) {
            let is_variable = program.specification(part.id).is_some();
            let initial = program.initial(program.text(part.id)).map(str::to_owned);
            let value = initial.or_else(|| program.some_value(from));
            variables.extend((is_variable || from != ty).then(|| Alone::copied(from, ty, value)));
        }
        let output = program.output(part).filter(|(from, into)| from != into);
        variables.extend(output.map(|(from, into)| Alone::copied(from, into, program.some_value(from))));
        variables.extend(mixed(program, part));
        variables.extend(behind_arithmetic(program, part));
        calls.extend(calls_alone(program, part));
        calls.extend(operation_alone(program, part));
    }
    let mut found: Vec<Alone> = Vec::new();
    for one in literals.into_iter().chain(variables).chain(calls) {
        if found.iter().all(|other| other.program != one.program) && one.program.trim() != program.text.trim()
        {
            found.push(one);
        }
    }
    found
}

/// Returns what stands behind the type of a literal as a literal without a type: of a bit string with a base, since an integer without one
/// may be no bit string.
fn untyped(ty: ElementaryType, digits: &str) -> String {
    let number = digits.replace('_', "").parse::<u64>().ok();
    match number.filter(|_| ty.is_bit_string() && ty != ElementaryType::Bool) {
        Some(number) => format!("16#{number:X}"),
        None => digits.to_owned(),
    }
}

/// Returns the operands of an infix operator that an expression is, with the operator.
pub(crate) fn binary(
    program: &ReadProgram<'_, '_>,
    id: ExpressionId,
) -> Option<(BinaryOperator, ExpressionId, ExpressionId)> {
    program.unit.expression(id)?.binary()
}

/// Returns whether an operator calculates with numbers.
pub(crate) const fn calculates(operator: BinaryOperator) -> bool {
    use BinaryOperator::*;
    matches!(operator, Add | Subtract | Multiply | Divide | Modulo | Power)
}

/// Returns whether an operator compares.
pub(crate) const fn compares(operator: BinaryOperator) -> bool {
    use BinaryOperator::*;
    matches!(
        operator,
        Equal | NotEqual | Less | Greater | LessOrEqual | GreaterOrEqual
    )
}

/// Returns the type of the number that a calculation is assigned to in which an operand stands.
pub(crate) fn calculated(program: &ReadProgram<'_, '_>, operand: &Part<'_, '_>) -> Option<ElementaryType> {
    let mut part = *operand;
    while let Some(around) = program.around(&part) {
        let is_calculation = binary(program, around.id).is_some_and(|(operator, ..)| calculates(operator));
        if !is_calculation && !matches!(around.expression.kind, ExpressionKind::Unary { .. }) {
            return None;
        }
        part = *around;
    }
    let target = program.target(&part).filter(|_| part.id != operand.id);
    target.filter(|ty| is_number(*ty))
}

/// Returns calls of a conversion function with a literal and with a variable, the latter in the type of what is computed around it too; or
/// the call of another function that the program does not declare with its one operand; where an expression is one.
fn calls_alone(program: &ReadProgram<'_, '_>, part: &Part<'_, '_>) -> Vec<Alone> {
    let Some((callee, arguments)) = program
        .call(part.id)
        .filter(|(callee, _)| !program.declares(callee))
    else {
        return Vec::new();
    };
    let Some(Argument::Positional(value)) = arguments.first() else {
        return Vec::new();
    };
    let (literal, initial) = (program.literal(*value), program.initial(program.text(*value)));
    let operand = literal.or(initial);
    let with_literal = |ty, operand: &str| Alone::new(None, ty, &format!("{callee}({operand})"));
    let with_variable = |from, operand, ty| Alone::new(Some((from, operand)), ty, &format!("{callee}(data)"));
    match (converted(callee), literal) {
        (Some((from, ty)), _) => {
            let value = operand.map(str::to_owned).or_else(|| program.some_value(from));
            let types = std::iter::once(ty).chain(calculated(program, part).filter(|other| *other != ty));
            let variables = types.map(|ty| with_variable(from, value.clone(), ty));
            let literal = operand.filter(|_| arguments.len() == 1);
            let literal = literal.map(|operand| with_literal(ty, operand));
            literal.into_iter().chain(variables).collect()
        }
        (None, _) if arguments.len() > 1 => Vec::new(),
        (None, Some(literal)) => {
            let ty = program.target(part).into_iter();
            ty.map(|ty| with_literal(ty, literal)).collect()
        }
        (None, None) => {
            let types = program.target(part).zip(program.type_of(*value)).into_iter();
            types
                .map(|(ty, from)| with_variable(from, operand.map(str::to_owned), ty))
                .collect()
        }
    }
}

/// Returns the assignment of an operation with one variable that is given to something else than a variable.
fn operation_alone(program: &ReadProgram<'_, '_>, part: &Part<'_, '_>) -> Option<Alone> {
    let operates =
        matches!(part.expression.kind, ExpressionKind::Unary { .. }) || binary(program, part.id).is_some();
    let ty = program
        .target(part)
        .filter(|_| operates && part.place != Place::Value)?;
    let text = program.text(part.id);
    let names = || {
        tokens(text)
            .into_iter()
            .filter(|token| token.kind == TokenKind::Name)
    };
    let name = names().next()?.span.text(text);
    let is_alone = names().all(|token| token.span.text(text).eq_ignore_ascii_case(name));
    let own = program
        .group(name)
        .filter(|_| is_alone && !text.contains(['.', '[', '^']))?;
    let from = elementary(own.specification.span.text(program.text))?;
    let mut edits = Edits::new();
    names().for_each(|token| edits.replace(token.span, "data"));
    let initial = program.initial(name).map(str::to_owned);
    Some(Alone::new(Some((from, initial)), ty, &edits.apply(text)))
}

/// Returns the conversions of each operand to the type of the other, for an operator between numbers of different types. A duration is
/// multiplied by a number as it is.
fn mixed(program: &ReadProgram<'_, '_>, part: &Part<'_, '_>) -> Vec<Alone> {
    let operands = match (binary(program, part.id), program.call(part.id)) {
        (Some((operator, left, right)), _) => {
            (calculates(operator) || compares(operator)).then_some((left, right))
        }
        // A function of the library that calculates with two numbers does what its operator does.
        (None, Some((callee, &[Argument::Positional(left), Argument::Positional(right)]))) => {
            (!program.declares(callee)).then_some((left, right))
        }
        _ => None,
    };
    let Some((left, right)) = operands else {
        return Vec::new();
    };
    let (Some(first), Some(second)) = (program.type_of(left), program.type_of(right)) else {
        return Vec::new();
    };
    if first == second || !is_number(first) || !is_number(second) {
        return Vec::new();
    }
    let value = |id: ExpressionId, ty: ElementaryType| {
        program
            .literal(id)
            .map(str::to_owned)
            .or_else(|| program.some_value(ty))
    };
    let mut found = vec![
        Alone::copied(first, second, value(left, first)),
        Alone::copied(second, first, value(right, second)),
    ];
    // Not every integer may become a REAL, but each does where it is an exponent.
    if let Some(real) = [first, second].into_iter().find(|ty| ty.is_real())
        && (first.is_integer() || second.is_integer())
    {
        found.push(Alone::copied(ElementaryType::Int, real, Some("1".to_owned())));
    }
    found
}

/// Returns the conversions of the operands of a calculation to the type of what is assigned.
fn behind_arithmetic(program: &ReadProgram<'_, '_>, part: &Part<'_, '_>) -> Vec<Alone> {
    let Some(target) = program
        .target(part)
        .filter(|ty| part.place == Place::Value && is_number(*ty))
    else {
        return Vec::new();
    };
    let (mut open, mut sources) = (vec![part.id], Vec::new());
    while let Some(id) = open.pop() {
        match binary(program, id) {
            Some((operator, left, right)) if calculates(operator) => open.extend([right, left]),
            _ => sources.extend(program.type_of(id).filter(|_| id != part.id)),
        }
    }
    let other = sources
        .into_iter()
        .filter(|source| *source != target && is_number(*source));
    other
        .map(|source| Alone::copied(source, target, program.some_value(source)))
        .collect()
}
