//! Other programs that do the same: where the engine does right with one of them, it says in which way the engine does an operation.

use crate::alone::{binary, calculates, compares};
use crate::forms::{body, end_of_variables};
use crate::malformed::number_of_literal;
use crate::program::ReadProgram;
use crate::words::{converted, is_number, tokens, type_of_word};
use std::collections::BTreeSet;
use stickler_reference::{errors, place_of_input};
use stickler_syntax::Edits;
use stickler_syntax::token::TokenKind;
use stickler_syntax::tree::{
    Argument, BinaryOperator, ExpressionId, ExpressionKind, Literal, LiteralKind, PouKind, StatementKind,
    UnaryOperator, VariableBlock, VariableKind,
};
use stickler_syntax::visitor::Place;
use stickler_types::{DialectName, ElementaryType, Family, join};

/// Returns a program with an operation on two values of one type in a statement of its own, before what it gives is converted to
/// the type of the target; `None` where it has no statement that does both.
pub(crate) fn in_two_steps(program: &ReadProgram<'_, '_>) -> Option<String> {
    let text = program.text;
    program.at(Place::Value).find_map(|part| {
        let statement = part.statement?;
        let target = program.target(part)?;
        let (own, inner) = match part.expression.kind {
            ExpressionKind::Unary {
                operator: UnaryOperator::Not,
                operand,
            } => (complemented(program, operand)?, part.id),
            _ => match calculated(program, part.id)? {
                // Of several operations the first may leave its type, and the last come back to it.
                (own, left) if own == target => (calculated(program, left)?.0, left),
                (own, _) => (own, part.id),
            },
        };
        if target == own && inner == part.id {
            return None;
        }
        let first = body(text, part.pou?)?.start;
        let StatementKind::Assignment { target: assigned, .. } = statement.kind else {
            return None;
        };
        let mut edits = Edits::replacing(
            statement.span,
            format!(
                "partial := {};\n    {} := {}",
                program.text(inner),
                program.text(assigned),
                program.text(part.id).replacen(program.text(inner), "partial", 1)
            ),
        );
        let section = format!("VAR\n    partial : {};\nEND_VAR\n    ", own.name());
        // Before the first statement, which may be this one.
        let head = text[..first].trim_end().len();
        edits.replace(head..head, format!("\n{}", section.trim_end()));
        Some(edits.apply(text))
    })
}

/// Returns the one type of the operands of a calculation, and its left operand; `None` where they have several types, and of another
/// expression.
fn calculated(program: &ReadProgram<'_, '_>, id: ExpressionId) -> Option<(ElementaryType, ExpressionId)> {
    let (operator, left, right) = binary(program, id)?;
    let own = |id| program.type_of(id).or_else(|| Some(calculated(program, id)?.0));
    // A literal without a type has that of the other operand.
    let is_of = |ty, id| own(id).map_or(program.literal(id).is_some(), |own| own == ty);
    let ty = own(left).or_else(|| own(right))?;
    (calculates(operator) && is_of(ty, left) && is_of(ty, right)).then_some((ty, left))
}

/// Returns a program in which a PROGRAM or a FUNCTION assigns the elementary values with which its variables begin; `None` where it has none.
pub(crate) fn with_assigned_initials(program: &ReadProgram<'_, '_>) -> Option<String> {
    let mut edits = Edits::new();
    let mut is_changed = false;
    for pou in program
        .unit
        .pous()
        .filter(|pou| pou.kind != PouKind::FunctionBlock)
    {
        let plain = |block: &&VariableBlock<'_>| {
            matches!(block.kind, VariableKind::Local | VariableKind::Temporary) && !block.constant
        };
        let end = pou.blocks.last()?.span.end as usize;
        let groups = pou.blocks.iter().filter(plain).flat_map(|block| &block.groups);
        for group in groups.filter(|group| program.elementary(&group.specification).is_some()) {
            if let Some(initializer) = &group.initializer {
                let value = initializer.span.text(program.text);
                let names = group
                    .names
                    .iter()
                    .map(|name| format!("\n    {} := {value};", name.text));
                edits.replace(end..end, names.collect::<String>());
                edits.remove(group.specification.span.end as usize..initializer.span.end as usize);
                is_changed = true;
            }
        }
    }
    is_changed.then(|| edits.apply(program.text))
}

/// Returns a program with the numbers that are arguments of a function of its own assigned to variables first, which have the types of the
/// inputs; `None` where it has none.
pub(crate) fn with_assigned_arguments(program: &ReadProgram<'_, '_>) -> Option<String> {
    let mut edits = Edits::new();
    let mut number = 0;
    let arguments = [Place::Argument, Place::NamedArgument];
    for part in program
        .parts
        .iter()
        .filter(|part| arguments.contains(&part.place))
    {
        let callee = part.around.and_then(|around| program.call(around));
        let is_own = callee.is_some_and(|(name, _)| program.declares(name) && !program.is_instance(name));
        let written = program.text(part.id);
        let is_number = number_of_literal(written).is_some() || written.parse::<f64>().is_ok();
        let places = part.statement.zip(part.pou).zip(program.target(part));
        let Some(((statement, pou), ty)) = places.filter(|_| is_own && is_number) else {
            continue;
        };
        let end = end_of_variables(program.text, pou)?;
        number += 1;
        let name = format!("given_{number}");
        edits.replace(end..end, format!("    {name} : {};\n", ty.name()));
        edits.replace(part.expression.span, name.as_str());
        let start = statement.span.start as usize;
        edits.replace(start..start, format!("{name} := {written};\n    "));
    }
    (number > 0).then(|| edits.apply(program.text))
}

/// Returns a program with a positive number in the place of a negative real number that becomes an integer without a sign; `None` where it has
/// none. It is 1.5 times 2 to the power of 63, of which a type of fewer bits gets 0 where numbers wrap; one of 64 bits gets a number of its own.
pub(crate) fn with_positive_number(program: &ReadProgram<'_, '_>) -> Option<String> {
    let callees = program.at(Place::Callee).map(|part| program.text(part.id));
    let (_, into) = callees
        .filter_map(converted)
        .find(|(from, into)| from.is_real() && into.family() != Family::Signed && is_number(*into))?;
    let beyond = if into.bits() == 64 { "5.0" } else { "1.3835058E19" };
    program.literals().find_map(|(part, written)| {
        let (prefix, number) = written.split_at(written.find('#').map_or(0, |at| at + 1));
        number
            .starts_with('-')
            .then(|| Edits::replacing(part.expression.span, format!("{prefix}{beyond}")).apply(program.text))
    })
}

/// Returns a program with comparison operators in the place of the comparison functions; `None` where it has none.
pub(crate) fn with_comparison_operators(program: &ReadProgram<'_, '_>) -> Option<String> {
    let operators = [
        ("EQ", "="),
        ("NE", "<>"),
        ("LT", "<"),
        ("LE", "<="),
        ("GT", ">"),
        ("GE", ">="),
    ];
    let mut calls = program
        .parts
        .iter()
        .filter_map(|part| Some((part, program.call(part.id)?)));
    calls.find_map(|(part, (function, arguments))| {
        let operator = operators
            .iter()
            .find(|(name, _)| function.eq_ignore_ascii_case(name))?
            .1;
        let [Argument::Positional(left), Argument::Positional(right)] = arguments[..] else {
            return None;
        };
        let compared = format!("({} {operator} {})", program.text(left), program.text(right));
        Some(Edits::replacing(part.expression.span, compared).apply(program.text))
    })
}

/// Returns the type of what a complement is made of, which may be another complement in parentheses.
fn complemented(program: &ReadProgram<'_, '_>, id: ExpressionId) -> Option<ElementaryType> {
    match program.unit.expression(id)?.kind {
        ExpressionKind::Parenthesized(inner) => complemented(program, inner),
        ExpressionKind::Unary {
            operator: UnaryOperator::Not,
            operand,
        } => complemented(program, operand),
        _ => program.type_of(id),
    }
}

/// Returns a program with the operands of an operator in the other order, where they have different types; `None` where it has none.
pub(crate) fn with_swapped_operands(program: &ReadProgram<'_, '_>) -> Option<String> {
    let given = [Place::Value, Place::Argument, Place::NamedArgument];
    let mut parts = program.parts.iter().filter(|part| given.contains(&part.place));
    parts.find_map(|part| {
        let (operator, left, right) = binary(program, part.id)?;
        let is_mixed = !compares(operator) && program.type_of(left)? != program.type_of(right)?;
        let swapped = format!(
            "{} {} {}",
            program.text(right),
            operator.as_str(),
            program.text(left)
        );
        is_mixed.then(|| Edits::replacing(part.expression.span, swapped).apply(program.text))
    })
}

/// Returns a program in which the named arguments of the first call of a standard function that has them in another order stand in that of
/// the inputs; `None` where there is none.
pub(crate) fn with_ordered_arguments(program: &ReadProgram<'_, '_>) -> Option<String> {
    program.parts.iter().find_map(|part| {
        let (function, arguments) = program.call(part.id)?;
        let named = arguments.iter().map(|argument| match argument {
            Argument::Named { name, value } => {
                Some((place_of_input(function, name.text)?, name.text, *value))
            }
            Argument::Positional(_) | Argument::Output { .. } => None,
        });
        let mut ordered = named.collect::<Option<Vec<_>>>()?;
        if program.declares(function) || ordered.is_sorted_by_key(|(place, ..)| *place) {
            return None;
        }
        ordered.sort_by_key(|(place, ..)| *place);
        let ordered = ordered.into_iter();
        let ordered = ordered.map(|(_, name, value)| format!("{name} := {}", program.text(value)));
        let call = format!("{function}({})", join(ordered, ", "));
        Some(Edits::replacing(part.expression.span, call).apply(program.text))
    })
}

/// Returns a program with texts of single-byte characters in the place of those of double-byte ones; `None` where it has none.
pub(crate) fn with_single_bytes(program: &ReadProgram<'_, '_>) -> Option<String> {
    let mut edits = Edits::new();
    for token in tokens(program.text) {
        let written = token.span.text(program.text);
        if written.eq_ignore_ascii_case("WSTRING") {
            edits.replace(token.span, "STRING");
        } else if token.kind == TokenKind::DoubleByteText {
            edits.replace(token.span, written.replace('\'', "$'").replace('"', "'"));
        }
    }
    let single = edits.apply(program.text);
    (single != program.text).then_some(single)
}

/// Returns a program with variables in the place of the texts and truth values that are operands or arguments; `None` where it has none.
pub(crate) fn with_variables_for_literals(program: &ReadProgram<'_, '_>) -> Option<String> {
    with_variables(program, |place, literal| match literal.kind {
        _ if place == Place::Value => None,
        LiteralKind::SingleByteText => Some("STRING"),
        LiteralKind::DoubleByteText => Some("WSTRING"),
        LiteralKind::Boolean => Some("BOOL"),
        _ => None,
    })
}

/// Returns a program with comparisons in the place of the truth values in its statements.
pub(crate) fn with_comparisons(program: &ReadProgram<'_, '_>) -> Option<String> {
    let mut edits = Edits::new();
    for part in &program.parts {
        if matches!(&part.expression.kind, ExpressionKind::Literal(literal) if literal.kind == LiteralKind::Boolean)
        {
            edits.replace(part.expression.span, "(0 = 0)");
        }
    }
    Some(edits.apply(program.text))
}

/// Returns a program with a duration, or with a date or a time of day, of which nothing is right in the place of each that is wrong where
/// it stands alone; `None` where it has none.
pub(crate) fn with_wrong_moment(program: &ReadProgram<'_, '_>, is_duration: bool) -> Option<String> {
    let mut edits = Edits::new();
    let mut is_any = false;
    for token in tokens(program.text)
        .into_iter()
        .filter(|token| token.kind.is_literal())
    {
        let written = token.span.text(program.text);
        let ty = type_of_word(written).filter(|ty| ty.is_moment() && ty.is_duration() == is_duration);
        let Some((ty, (prefix, _))) = ty.zip(written.split_once('#')) else {
            continue;
        };
        let alone = format!(
            "PROGRAM main VAR r : {} := {written}; END_VAR END_PROGRAM",
            ty.name()
        );
        is_any |= !errors(&alone, DialectName::IEC_ED3).is_empty();
        let wrong = match ty.family() {
            Family::Duration => "1s1s__1d",
            Family::Date => "2001-13-45",
            Family::TimeOfDay => "99:99:99",
            _ => "2001-13-45-99:99:99",
        };
        edits.replace(token.span, format!("{prefix}#{wrong}"));
    }
    is_any.then(|| edits.apply(program.text))
}

/// Returns a program with variables in the place of the integers in its statements; `None` where it has none.
pub(crate) fn with_variables_for_numbers(program: &ReadProgram<'_, '_>) -> Option<String> {
    with_variables(program, |_, literal| {
        (literal.kind == LiteralKind::Integer && literal.prefix().is_none()).then_some("INT")
    })
}

/// Returns a program with variables in the place of the literals in its statements for which `ty` gives a type.
fn with_variables(
    program: &ReadProgram<'_, '_>,
    ty: impl Fn(Place, &Literal<'_>) -> Option<&'static str>,
) -> Option<String> {
    let mut edits = Edits::new();
    let mut declared = BTreeSet::new();
    for part in &program.parts {
        let ExpressionKind::Literal(literal) = &part.expression.kind else {
            continue;
        };
        let Some(ty) = ty(part.place, literal) else {
            continue;
        };
        let Some(end) = part
            .statement
            .and(part.pou)
            .and_then(|pou| end_of_variables(program.text, pou))
        else {
            continue;
        };
        let name = format!("given_{}", ty.to_ascii_lowercase());
        edits.replace(part.expression.span, name.as_str());
        if declared.insert((end, ty)) {
            edits.replace(end..end, format!("    {name} : {ty};\n"));
        }
    }
    (!declared.is_empty()).then(|| edits.apply(program.text))
}

/// Returns a program in which the numbers have the types of what they are given to; `None` where it has none without a type.
pub(crate) fn with_typed_numbers(program: &ReadProgram<'_, '_>) -> Option<String> {
    let mut edits = Edits::new();
    let mut is_changed = false;
    for (part, written) in program.literals() {
        let is_number = written.starts_with(|first: char| first.is_ascii_digit() || first == '-');
        let is_plain = is_number && !written.contains(' ') && type_of_word(written).is_none();
        if let Some(ty) = program.target(part).filter(|_| is_plain) {
            edits.replace(part.expression.span, format!("{}#{written}", ty.name()));
            is_changed = true;
        }
    }
    is_changed.then(|| edits.apply(program.text))
}

/// Returns a program with a comparison turned round, whose operands have different types; `None` where it has none.
pub(crate) fn turned_round(program: &ReadProgram<'_, '_>) -> Option<String> {
    program.at(Place::Value).find_map(|part| {
        let (operator, left, right) = binary(program, part.id)?;
        let types = (program.type_of(left)?, program.type_of(right)?);
        let turned = match operator {
            BinaryOperator::Less => BinaryOperator::Greater,
            BinaryOperator::Greater => BinaryOperator::Less,
            BinaryOperator::LessOrEqual => BinaryOperator::GreaterOrEqual,
            BinaryOperator::GreaterOrEqual => BinaryOperator::LessOrEqual,
            same => same,
        };
        let text = format!(
            "{} {} {}",
            program.text(right),
            turned.as_str(),
            program.text(left)
        );
        let is_mixed = compares(operator) && types.0 != types.1;
        is_mixed.then(|| Edits::replacing(part.expression.span, text).apply(program.text))
    })
}
