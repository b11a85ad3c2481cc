//! Misplaced statements, empty ranges of labels, and texts that are no statements.

use super::super::fault_site::FaultSite;
use crate::model::{CaseLabel, Expression, ExpressionKind, LiteralForm, StatementKind};
use stickler_types::{Dialect, ElementaryType, Value};

/// Plants EXIT outside a loop.
///
/// Basis: language/diagnostics-statements.st.
pub(super) fn exit(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    outside_loops(fault, "EXIT;")
}

/// Plants CONTINUE outside a loop.
///
/// Basis: language/diagnostics-statements.st.
pub(super) fn continue_(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    outside_loops(fault, "CONTINUE;")
}

fn outside_loops(fault: &mut FaultSite<'_, '_>, text: &str) -> Option<()> {
    fault.insert(
        |_, in_loop| !in_loop,
        |_, _| Some(StatementKind::Raw(text.to_owned())),
    )
}

/// Plants a descending range of labels.
///
/// Basis: language/diagnostics-statements.st.
pub(super) fn descending_labels(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let has_integers = |_, kind: &StatementKind| match kind {
        StatementKind::Case(_, branches, _) => branches
            .iter()
            .flat_map(|branch| &branch.labels)
            .any(|label| descending(label).is_some()),
        _ => false,
    };
    fault.change_statement(has_integers, |fault, _, kind| {
        let StatementKind::Case(_, branches, _) = kind else {
            return None;
        };
        let mut labels: Vec<_> = branches
            .iter_mut()
            .flat_map(|branch| &mut branch.labels)
            .filter(|label| descending(label).is_some())
            .collect();
        let which = fault.choose((0..labels.len()).collect())?;
        let label = labels.get_mut(which)?;
        **label = descending(label)?;
        Some(())
    })
}

/// Turns a label of integer literals into a descending range.
fn descending(label: &CaseLabel) -> Option<CaseLabel> {
    match label {
        CaseLabel::Range(low, high) if value(low)? < value(high)? => {
            Some(CaseLabel::Range(high.clone(), low.clone()))
        }
        CaseLabel::Range(..) => None,
        CaseLabel::One(one) => {
            let (text, value) = (one.clone(), value(one)?);
            let (_, high) = integer_type(one)?.integer_range()?;
            let above = Expression {
                ty: one.ty.clone(),
                kind: ExpressionKind::Raw((value + 1).to_string()),
            };
            (value < high).then_some(CaseLabel::Range(above, text))
        }
    }
}

fn integer_type(expression: &Expression) -> Option<ElementaryType> {
    match expression.kind {
        ExpressionKind::Literal(Value::Plain { ty, .. }, LiteralForm::Untyped) => {
            Some(ty).filter(|ty| ty.is_integer())
        }
        _ => None,
    }
}

fn value(expression: &Expression) -> Option<i128> {
    match expression.kind {
        ExpressionKind::Literal(Value::Plain { ty, raw }, _) if ty.is_integer() => {
            Some(ty.integer_value(raw))
        }
        _ => None,
    }
}

/// Plants an unclosed comment; no statement after it can be said to be wrong.
///
/// Basis: ironplc-problem-codes: P0001; the line: conformance-cases/README.md (marks).
pub(super) fn open_comment(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    fault.insert_text(|fault, _| {
        let texts = [
            "(* never closed",
            "; (* never closed",
            "; (* closed *) (* not closed *",
        ];
        fault.choose(texts.to_vec()).map(str::to_owned)
    })
}

/// Plants a malformed statement that begins like a statement, and ends before the next one begins.
///
/// Basis: language/syntax-recovery.st.
pub(super) fn no_statement(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    fault.insert_text(|fault, unit| {
        let name = fault.variable_text(unit, ElementaryType::Int)?;
        let texts = [
            format!("{name} := ;"),
            format!("{name} := ({name} + 1;"),
            format!("{name} := {name} + ;"),
            format!("{name} := {name} {name};"),
            format!("{name} := 1 + * 2;"),
            format!("{name} = 1;"),
            format!("IF {name} > 1 {name} := 2; END_IF;"),
            format!("WHILE {name} > 1 {name} := 2; END_WHILE;"),
            format!("FOR {name} = 1 TO 2 DO ; END_FOR;"),
            format!("REPEAT {name} := 2; UNTIL END_REPEAT;"),
        ];
        fault.choose(texts.to_vec())
    })
}

/// Plants characters that are no part of the language.
///
/// Basis: ironplc-problem-codes: P0003.
pub(super) fn no_token(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    fault.insert_text(|fault, unit| {
        let name = fault.variable_text(unit, ElementaryType::Int)?;
        let texts = [
            format!("{name} := {name} ? 3;"),
            format!("{name} := {name} ! 3;"),
            format!("{name} := 1 \\ 2;"),
            format!("{name} := {name} ~ 1;"),
        ];
        fault.choose(texts.to_vec())
    })
}

/// Plants a comment to the end of the line, where the dialect does not have it.
///
/// Basis: language/comments.st.
pub(super) fn line_comment(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    if Dialect::of(fault.original.dialect).line_comments {
        return None;
    }
    fault.insert_text(|fault, _| {
        let texts = ["// over there", "; // it's 5 o'clock (* or 6", "; // a := ;"];
        fault.choose(texts.to_vec()).map(str::to_owned)
    })
}
