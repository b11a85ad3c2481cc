//! Values of a type from exact numbers.

use stickler_types::{ElementaryType, Value};

/// Returns a number of an integer or bit string type, or nothing where the type does not hold it.
pub(crate) fn whole(ty: ElementaryType, number: i128) -> Option<Value> {
    let holds = ty != ElementaryType::Bool && ty.holds(number);
    holds.then(|| Value::plain(ty, ty.wrap(number)))
}

/// Returns a real number that is a number of halves, rounded once, or nothing where it would be infinite.
pub(crate) fn halves(ty: ElementaryType, halves: i128) -> Option<Value> {
    let sign = if halves < 0 { "-" } else { "" };
    let magnitude = halves.unsigned_abs();
    let digit = if magnitude.is_multiple_of(2) { 0 } else { 5 };
    Value::parse(&format!("{ty}#{sign}{}.{digit}", magnitude / 2)).ok()
}
