//! Expectations that the definition of a dialect states for cases inherited from the dialect that it extends.
//!
//! Their values come from exact arithmetic with the choices of the definition.

use crate::citations::NOT_STATED;
use crate::model::{Case, Expectation, ExpectedValue};
use std::sync::Arc;
use stickler_exact::{ImplicitResult, Signature, expected, is_overridden, signature_of, signatures};
use stickler_types::{Acceptance, DialectName, ElementaryType, Question, Value};

/// Returns what a value becomes where a definition states that a pair of types converts implicitly: the result of
/// `<FROM>_TO_<TO>`, or `Open` where no document or definition says what that is.
pub(crate) fn converted(value: &Value, to: ElementaryType, dialect: DialectName) -> ImplicitResult {
    let Some(from) = value.elementary() else {
        return ImplicitResult::Open;
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

/// Replaces the expectation of a case that asks for the result of a conversion function and observes it, where the definition of the
/// case's dialect decides the result. Leaves any other case unchanged.
pub(crate) fn restate(case: &mut Case) {
    if case.expectation.accepted == Acceptance::Rejected || case.expectation.fault.is_some() {
        return;
    }
    let (Some(Question::Call(call)), [observed]) = (case.question.as_deref(), &*case.observe) else {
        return;
    };
    let operands = &call.operands;
    let is_overridden = |signature: &Signature| is_overridden(signature, operands, case.dialect);
    let Some(signature) = signature_of(call, case.dialect).filter(is_overridden) else {
        return;
    };
    let expected = expected(&signature, operands, case.dialect);
    let mut expectation = Expectation::default();
    match expected.basis {
        Some(basis) => {
            expectation.values.push(ExpectedValue {
                name: Arc::clone(&observed.name),
                after: None,
                value: expected.value,
                line: case.line,
            });
            case.basis = basis.into();
            case.title = format!("{call} in {}", case.dialect).into();
            case.summary = None;
        }
        None => {
            expectation.accepted = Acceptance::Observed;
            case.basis = NOT_STATED.into();
        }
    }
    case.expectation = Arc::new(expectation);
}
