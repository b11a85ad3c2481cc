//! Queries of the passes on the syntax tree of the reference.

use std::ops::Range;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Argument, CaseLabel, Declaration, Expression, ExpressionId, ExpressionKind, Pou, SourceUnit, Statement,
    StatementKind,
};

/// Converts a span to a range of bytes.
pub(super) fn bytes(span: Span) -> Range<usize> {
    span.start as usize..span.end as usize
}

/// Returns the program organization units of a text.
pub(super) fn pous<'t, 's>(unit: &'t SourceUnit<'s>) -> impl Iterator<Item = &'t Pou<'s>> {
    unit.declarations
        .iter()
        .filter_map(|declaration| match declaration {
            Declaration::Pou(pou) => Some(pou),
            _ => None,
        })
}

/// Returns the lists of statements inside a statement, in the order of the text.
pub(super) fn bodies(statement: &Statement) -> Vec<&[Statement]> {
    match &statement.kind {
        StatementKind::If { branches, otherwise } => branches
            .iter()
            .map(|(_, body)| body.as_slice())
            .chain(otherwise.as_deref())
            .collect(),
        StatementKind::Case {
            branches, otherwise, ..
        } => branches
            .iter()
            .map(|branch| branch.body.as_slice())
            .chain(otherwise.as_deref())
            .collect(),
        StatementKind::For { body, .. }
        | StatementKind::While { body, .. }
        | StatementKind::Repeat { body, .. } => {
            vec![body]
        }
        _ => Vec::new(),
    }
}

/// Returns every list of statements of a text, outer ones before inner ones; those of the last program organization unit
/// first, because it is the one that runs.
pub(super) fn lists<'t>(unit: &'t SourceUnit<'_>) -> Vec<&'t [Statement]> {
    let mut found = Vec::new();
    let pous: Vec<_> = pous(unit).collect();
    for pou in pous.into_iter().rev() {
        let mut open = vec![pou.body.as_slice()];
        while let Some(list) = open.pop() {
            found.push(list);
            open.extend(list.iter().flat_map(bodies));
        }
    }
    found
}

/// Returns every statement of a text, in the order of [`lists`].
pub(super) fn statements<'t>(unit: &'t SourceUnit<'_>) -> Vec<&'t Statement> {
    lists(unit).into_iter().flatten().collect()
}

/// Returns an expression by its id.
pub(super) fn expression<'t, 's>(unit: &'t SourceUnit<'s>, id: ExpressionId) -> Option<&'t Expression<'s>> {
    unit.expressions.get(id.0 as usize)
}

/// Returns the range of an expression.
pub(super) fn place(unit: &SourceUnit<'_>, id: ExpressionId) -> Range<usize> {
    expression(unit, id).map_or(0..0, |expression| bytes(expression.span))
}

/// Returns the operands and arguments of an expression, in the order of the text.
pub(super) fn operands(expression: &Expression<'_>) -> Vec<ExpressionId> {
    match &expression.kind {
        ExpressionKind::Unary { operand, .. } | ExpressionKind::Parenthesized(operand) => vec![*operand],
        ExpressionKind::Binary { left, right, .. } => vec![*left, *right],
        ExpressionKind::Call { arguments, .. } => arguments.iter().map(value_of).collect(),
        ExpressionKind::Field { base, .. }
        | ExpressionKind::Bit { base, .. }
        | ExpressionKind::Part { base, .. } => vec![*base],
        ExpressionKind::Index { base, subscripts } => {
            [*base].into_iter().chain(subscripts.iter().copied()).collect()
        }
        ExpressionKind::Literal(_)
        | ExpressionKind::Name(_)
        | ExpressionKind::EnumeratedValue(_)
        | ExpressionKind::Error => Vec::new(),
    }
}

/// Returns the expression of an argument.
pub(super) fn value_of(argument: &Argument<'_>) -> ExpressionId {
    match argument {
        Argument::Positional(value)
        | Argument::Named { value, .. }
        | Argument::Output { target: value, .. } => *value,
    }
}

/// Returns the range of a CASE label.
pub(super) fn label(unit: &SourceUnit<'_>, label: &CaseLabel) -> Range<usize> {
    match label {
        CaseLabel::Value(value) => place(unit, *value),
        CaseLabel::Range(low, high) => place(unit, *low).start..place(unit, *high).end,
    }
}

/// Returns `end`, moved past a semicolon that follows.
pub(super) fn with_semicolon(text: &str, end: usize) -> usize {
    let next = behind_blanks(text, end);
    if text[next..].starts_with(';') {
        next + 1
    } else {
        end
    }
}

/// Returns the next byte that is neither blank nor in a comment.
pub(super) fn behind_blanks(text: &str, from: usize) -> usize {
    let mut at = from;
    loop {
        let rest = &text[at..];
        let trimmed = rest.trim_start();
        at += rest.len() - trimmed.len();
        let comment = if trimmed.starts_with("(*") {
            trimmed.find("*)").map(|end| end + 2)
        } else if trimmed.starts_with("//") {
            Some(trimmed.find('\n').unwrap_or(trimmed.len()))
        } else {
            None
        };
        match comment {
            Some(length) => at += length,
            None => return at,
        }
    }
}

/// Returns the range of some statements, with the semicolon of the last one.
pub(super) fn extent(text: &str, statements: &[Statement]) -> Option<Range<usize>> {
    let first = statements.first()?;
    let last = statements.last()?;
    Some(first.span.start as usize..with_semicolon(text, last.span.end as usize))
}
