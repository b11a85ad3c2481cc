//! Planted errors in CASE labels: ranges that are empty.

use super::super::fault_site::FaultSite;
use crate::model::{CaseLabel, Expression, ExpressionKind, LiteralForm, Statement};
use stickler_types::{ElementaryType, Value};

/// Plants a descending range of labels.
///
/// Basis: language/diagnostics-statements.st.
pub(super) fn descending_labels(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let has_integers = |_, kind: &Statement| match kind {
        Statement::Case(_, branches, _) => branches
            .iter()
            .flat_map(|branch| &branch.labels)
            .any(|label| descending(label).is_some()),
        _ => false,
    };
    fault.change_statement(has_integers, |fault, _, kind| {
        let Statement::Case(_, branches, _) = kind else {
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
            let above = Expression::new(one.ty.clone(), ExpressionKind::Raw((value + 1).to_string()));
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
