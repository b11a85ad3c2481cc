//! Messages about values that do not fit where they stand.

use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::types::{TypeId, TypeTable};
use stickler_types::{ElementaryType, joined};

/// Names an inferred type in a message.
pub(super) fn describe(types: &TypeTable, inferred: Inferred) -> String {
    match inferred {
        Inferred::Known(ty) => types.name(ty),
        Inferred::Integer(_) => "an integer literal".to_owned(),
        Inferred::Real => "a real literal".to_owned(),
        Inferred::Text { wide: true, .. } => "a text literal in double quotes".to_owned(),
        Inferred::Text { .. } => "a text literal".to_owned(),
        Inferred::Nothing => "what has no value by itself".to_owned(),
        Inferred::Enumerated => "an enumerated value".to_owned(),
        Inferred::Pending | Inferred::Error => "an error".to_owned(),
    }
}

/// Says why a value does not fit where it stands.
pub(super) fn misfit(types: &TypeTable, inferred: Inferred, target: TypeId, context: ValueContext) -> String {
    let name = types.name(target);
    let value = describe(types, inferred);
    match (inferred, context) {
        (Inferred::Nothing, _) => "the call gives no value".to_owned(),
        (Inferred::Known(_), ValueContext::Condition) => format!("a condition is {name}, not {value}"),
        (Inferred::Known(_), _) => format!("{value} does not convert implicitly to {name}"),
        _ => format!("{value} is no {name} here"),
    }
}

/// Says why a value is no argument of a function that takes several types as they come. A long list would hide the point.
pub(super) fn misfit_of_any(types: &TypeTable, inferred: Inferred, allowed: &[ElementaryType]) -> String {
    let value = describe(types, inferred);
    let names: Vec<_> = allowed.iter().map(|ty| ty.name()).collect();
    match (inferred, names.len()) {
        (Inferred::Nothing, _) => "the call gives no value".to_owned(),
        (_, 2..=4) => format!("the function takes {}, not {value}", joined(&names, "or")),
        _ => format!("the function does not take {value}"),
    }
}
