//! What the definition of a dialect states of cases that it takes over from the dialect which it extends.
//!
//! Values come from exact arithmetic with the choices that the definition makes.

use crate::assembly::TypeNames;
use crate::conversion_call::Call;
use crate::model::{Acceptance, Case, Expectation, ExpectedValue};
use std::sync::Arc;
use stickler_exact::{ImplicitResult, expected, is_overridden, signatures};
use stickler_types::{DialectName, ElementaryType, Observation, Value};

/// What arrives where a pair of types converts because a definition states so: what `<FROM>_TO_<TO>` gives, as far as
/// somebody says what that is.
pub(crate) fn converted(value: &Value, to: ElementaryType, dialect: DialectName) -> ImplicitResult {
    let from = match value {
        Value::Plain { ty, .. } | Value::Text { ty, .. } => *ty,
        Value::Enumerated { .. } => return ImplicitResult::Open,
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

/// Makes a case expect what the definition of its dialect states, where that decides what comes: a program which is one call
/// of a conversion function. Any other case stays as it is.
pub(crate) fn restate(case: &mut Case, names: &TypeNames) {
    if case.expectation.accepted == Acceptance::Rejected || case.expectation.fault.is_some() {
        return;
    }
    let Some(call) = Call::read(&case.source) else {
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
                name: call.into.into(),
                after: None,
                value: expected.value,
                line: case.line,
            });
            case.basis = basis.into();
            case.title = format!("{}({}) in {}", call.function, call.operand, case.dialect).into();
            case.summary = None;
        }
        None => expectation.accepted = Acceptance::Observed,
    }
    case.expectation = Arc::new(expectation);
    case.observe = [Observation {
        name: call.into.into(),
        type_name: names.elementary(call.result),
        after: None,
    }]
    .into();
}
