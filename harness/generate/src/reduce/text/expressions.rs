//! Passes that replace expressions by their operands and by literals, and literals by smaller ones.

use super::draft::{TextChange, TextDraft};
use super::tree::{bytes, expression, operands, place, statements};
use crate::reduce::Sites;
use std::ops::Range;
use stickler_syntax::tree::{Expression, ExpressionKind, LiteralKind, SourceUnit, StatementKind};

/// The literals that are tried in the place of an expression of unknown type; the reference decides which are valid there. A real
/// number comes before an integer, which may stand for one.
const PLAIN: [&str; 7] = ["FALSE", "0.0", "0", "''", "T#0s", "TRUE", "1"];

/// A literal of each type that could be part of a type mismatch.
const TYPED: [&str; 8] = [
    "DINT#0",
    "INT#0",
    "LINT#0",
    "UINT#0",
    "LREAL#0.0",
    "WORD#16#0",
    "BOOL#FALSE",
    "T#0s",
];

/// Replaces expressions by a plain literal that is valid in their place, outermost first; the condition of REPEAT by TRUE.
pub(super) fn to_literal(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("to literal", sites, |draft| {
        let unit = draft.tree();
        let ends: Vec<Range<usize>> = statements(&unit)
            .into_iter()
            .filter_map(|statement| match &statement.kind {
                StatementKind::Repeat { until, .. } => Some(place(&unit, *until)),
                _ => None,
            })
            .collect();
        let mut changes = Vec::new();
        for expression in outermost_first(&unit) {
            if !matches!(expression.kind, ExpressionKind::Literal(_)) {
                let at = bytes(expression.span);
                let first = ends.contains(&at).then_some(&"TRUE");
                let all = first.into_iter().chain(&PLAIN);
                let all = all.map(|plain| TextChange::of(at.clone(), *plain)).collect();
                changes.extend(draft.only_allowed(all).into_iter().next());
            }
        }
        changes
    });
}

/// Replaces expressions of a rejected text by typed literals.
///
/// In a type mismatch an untyped literal fits too well: it takes the expected type.
pub(super) fn to_typed_literal(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("to typed literal", sites, |draft| {
        if draft.began_accepted() {
            return Vec::new();
        }
        let unit = draft.tree();
        let mut changes = Vec::new();
        for expression in outermost_first(&unit) {
            if !matches!(expression.kind, ExpressionKind::Literal(_)) {
                let at = bytes(expression.span);
                changes.extend(TYPED.iter().map(|typed| TextChange::of(at.clone(), *typed)));
            }
        }
        draft.only_allowed(changes)
    });
}

/// Replaces expressions by their first operand or argument.
pub(super) fn to_first_operand(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("to first operand", sites, |draft| to_operand(draft, 0));
}

/// Replaces expressions by their second operand or argument.
pub(super) fn to_second_operand(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("to second operand", sites, |draft| to_operand(draft, 1));
}

/// Replaces expressions by their third operand or argument.
pub(super) fn to_third_operand(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("to third operand", sites, |draft| to_operand(draft, 2));
}

fn to_operand(draft: &TextDraft, which: usize) -> Vec<TextChange> {
    let unit = draft.tree();
    let mut changes = Vec::new();
    for whole in outermost_first(&unit) {
        if let Some(operand) = operands(whole).get(which).and_then(|id| expression(&unit, *id)) {
            changes.push(TextChange::of(bytes(whole.span), operand.span.text(&draft.text)));
        }
    }
    draft.only_allowed(changes)
}

/// Drops arguments of calls, and subscripts after the first.
pub(super) fn drop_arguments(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("drop arguments", sites, |draft| {
        let unit = draft.tree();
        let mut changes = Vec::new();
        for call in outermost_first(&unit) {
            if let ExpressionKind::Call { callee, arguments } = &call.kind {
                let open = place(&unit, *callee).end;
                let ends: Vec<usize> = arguments
                    .iter()
                    .map(|argument| place(&unit, super::tree::value_of(argument)).end)
                    .collect();
                let close = call.span.end as usize - 1;
                changes.extend(list_items(&draft.text, open, &ends, close));
            }
        }
        draft.only_allowed(changes)
    });
}

/// Drops each element of a list in brackets, together with one comma; `open` is at or before the opening bracket.
pub(super) fn list_items(text: &str, open: usize, ends: &[usize], close: usize) -> Vec<TextChange> {
    let Some(bracket) = text.get(open..close).and_then(|rest| rest.find(['(', '['])) else {
        return Vec::new();
    };
    let first = open + bracket + 1;
    let mut changes = Vec::new();
    for (number, &end) in ends.iter().enumerate() {
        let range: Option<Range<usize>> = match number.checked_sub(1).and_then(|before| ends.get(before)) {
            // With the comma before it.
            Some(&before) => Some(before..end),
            // The first one with the comma behind it.
            None => text
                .get(end..close)
                .map(|rest| first..end + rest.find(',').map_or(0, |comma| comma + 1)),
        };
        changes.extend(
            range
                .filter(|range| range.start <= range.end)
                .map(TextChange::drop),
        );
    }
    changes
}

/// Returns expressions, outer ones before inner ones, in the order of the text.
pub(super) fn outermost_first<'t, 's>(unit: &'t SourceUnit<'s>) -> Vec<&'t Expression<'s>> {
    let mut all: Vec<&Expression<'s>> = unit.expressions.iter().collect();
    all.sort_by_key(|expression| (expression.span.start, u32::MAX - expression.span.end));
    all
}

/// Writes numbers with a base in decimal, so that a base stays only where it matters.
pub(super) fn literals_to_decimal(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("decimal", sites, |draft| literals(draft, LiteralStep::Decimal));
}

/// Makes numbers 0, and empties texts.
pub(super) fn literals_to_zero(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("zero", sites, |draft| literals(draft, LiteralStep::Zero));
}

/// Makes numbers 1.
pub(super) fn literals_to_one(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("one", sites, |draft| literals(draft, LiteralStep::One));
}

/// Halves numbers and texts.
pub(super) fn halve_literals(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("half", sites, |draft| literals(draft, LiteralStep::Half));
}

/// Makes numbers one less, and texts one character shorter.
pub(super) fn lessen_literals(draft: &mut TextDraft, sites: &mut Sites) {
    draft.change("less", sites, |draft| literals(draft, LiteralStep::Less));
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum LiteralStep {
    Decimal,
    Zero,
    One,
    Half,
    Less,
}

fn literals(draft: &TextDraft, step: LiteralStep) -> Vec<TextChange> {
    let unit = draft.tree();
    let mut changes = Vec::new();
    for expression in outermost_first(&unit) {
        let ExpressionKind::Literal(literal) = &expression.kind else {
            continue;
        };
        if let Some(smaller) = smaller(literal.kind, literal.text(), step) {
            let end = expression.span.end as usize;
            changes.push(TextChange::of(end - literal.text().len()..end, smaller));
        }
    }
    draft.only_allowed(changes)
}

/// Returns the text of a literal without its prefix, made smaller; `None` if that changes nothing.
fn smaller(kind: LiteralKind, text: &str, step: LiteralStep) -> Option<String> {
    let smaller = match kind {
        LiteralKind::Integer => {
            let number: i128 = text.replace('_', "").parse().ok()?;
            match step {
                LiteralStep::Decimal => return None,
                LiteralStep::Zero => 0,
                LiteralStep::One => 1,
                LiteralStep::Half => number / 2,
                LiteralStep::Less => number - number.signum(),
            }
            .to_string()
        }
        LiteralKind::BasedInteger => {
            let (base, digits) = text.split_once('#')?;
            let base: u32 = base.parse().ok().filter(|base| [2, 8, 16].contains(base))?;
            let number = u128::from_str_radix(&digits.replace('_', ""), base).ok()?;
            let number = match step {
                LiteralStep::Decimal => return Some(number.to_string()),
                LiteralStep::Zero => 0,
                LiteralStep::One => 1,
                LiteralStep::Half => number / 2,
                LiteralStep::Less => number.saturating_sub(1),
            };
            match base {
                2 => format!("2#{number:b}"),
                8 => format!("8#{number:o}"),
                _ => format!("16#{number:X}"),
            }
        }
        LiteralKind::Real => match step {
            LiteralStep::Decimal => return None,
            LiteralStep::Zero => "0.0".to_owned(),
            LiteralStep::One => "1.0".to_owned(),
            LiteralStep::Half => format!("{}.0", text.split('.').next()?),
            LiteralStep::Less => {
                let (before, behind) = text.split_once('.')?;
                format!("{before}.{}", behind.chars().next()?)
            }
        },
        LiteralKind::Duration => match step {
            LiteralStep::Zero => "0s".to_owned(),
            LiteralStep::One => "1s".to_owned(),
            LiteralStep::Decimal | LiteralStep::Half | LiteralStep::Less => return None,
        },
        LiteralKind::SingleByteText | LiteralKind::DoubleByteText => {
            let quote = text.get(..1)?;
            let inner = text.get(1..text.len().checked_sub(1)?)?;
            let kept = match step {
                LiteralStep::Decimal => return None,
                LiteralStep::Zero => 0,
                LiteralStep::One => 1,
                LiteralStep::Half => inner.chars().count() / 2,
                LiteralStep::Less => inner.chars().count().saturating_sub(1),
            };
            let kept: String = inner.chars().take(kept).collect();
            format!("{quote}{kept}{quote}")
        }
        LiteralKind::Boolean | LiteralKind::Date | LiteralKind::TimeOfDay | LiteralKind::DateAndTime => {
            return None;
        }
    };
    (smaller != text).then_some(smaller)
}
