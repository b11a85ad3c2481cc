//! Expectations that the definition of a dialect states for cases inherited from the dialect that it extends.
//!
//! Their values come from exact arithmetic with the choices of the definition.

use crate::assembly::TypeNames;
use crate::citations::NOT_STATED;
use crate::model::{Acceptance, Case, Expectation, ExpectedValue};
use std::sync::Arc;
use stickler_exact::{ImplicitResult, call_of_program, expected, is_overridden, signatures};
use stickler_types::{DialectName, ElementaryType, Observation, Value};

/// Returns what a value becomes where a definition states that a pair of types converts implicitly: the result of
/// `<FROM>_TO_<TO>`, or `Open` where no document or definition says what that is.
pub(crate) fn converted(value: &Value, to: ElementaryType, dialect: DialectName) -> ImplicitResult {
    let from = match value {
        Value::Plain { ty, .. } | Value::Text { ty, .. } => *ty,
        Value::Enumerated { .. } | Value::OutOfRange { .. } => return ImplicitResult::Open,
    };
    let operands = std::slice::from_ref(value);
    let found = signatures(&format!("{from}_TO_{to}"), dialect);
    let expected = found
        .first()
        .map(|signature| expected(signature, operands, dialect));
    match expected {
        Some(expected) if expected.basis.is_some() => ImplicitResult::Exactly(expected.value),
        _ => ImplicitResult::Open,
    }
}

/// Replaces the expectation of a case whose program is one call of a conversion function, where the definition of the
/// case's dialect decides the result. Leaves any other case unchanged.
pub(crate) fn restate(case: &mut Case, names: &TypeNames) {
    if case.expectation.accepted == Acceptance::Rejected || case.expectation.fault.is_some() {
        return;
    }
    let Some(call) = call_of_program(&case.source) else {
        return;
    };
    let operands = std::slice::from_ref(&call.operand);
    let found = signatures(call.function, case.dialect)
        .into_iter()
        .find(|signature| signature.result == call.result && signature.takes(operands));
    let Some(signature) = found.filter(|signature| is_overridden(signature, operands, case.dialect)) else {
        return;
    };
    let expected = expected(&signature, operands, case.dialect);
    let mut expectation = Expectation::default();
    match expected.basis {
        Some(basis) => {
            expectation.values.push(ExpectedValue {
                name: call.target.into(),
                after: None,
                value: expected.value,
                line: case.line,
            });
            case.basis = basis.into();
            case.title = format!("{}({}) in {}", call.function, call.operand, case.dialect).into();
            case.summary = None;
        }
        None => {
            expectation.accepted = Acceptance::Observed;
            case.basis = NOT_STATED.into();
        }
    }
    case.expectation = Arc::new(expectation);
    case.observe = [Observation {
        name: call.target.into(),
        type_name: names.elementary(call.result),
        after: None,
    }]
    .into();
}
