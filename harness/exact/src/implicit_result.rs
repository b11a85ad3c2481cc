//! Results of implicit conversions.

use crate::real;
use crate::{integer, moment};
use stickler_types::{ElementaryType, MomentUnits, Value};

/// The unit of a TIME, which is the same whatever counts a date.
const MILLISECONDS: MomentUnits = MomentUnits::Seconds;

/// The result of an implicit conversion, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub enum ImplicitResult {
    /// The result is exactly this value.
    Exactly(Value),
    /// The target cannot hold the value, and no document says what it holds instead.
    Open,
}

/// Returns the value of a variable of type `to` after `value` was assigned to it; `None` for pairs of types that no
/// document converts implicitly.
///
/// The result is the number (rounded once, to the nearest, where the target is a real), the zero-extended bits, the same
/// duration, date or time of day in its long or short form, or for UDINT and TIME the same count of milliseconds.
///
/// Basis: conformance-cases/README.md (a matrix of types).
#[must_use]
pub fn implicit_result(value: &Value, to: ElementaryType) -> Option<ImplicitResult> {
    use ElementaryType::{Lreal, Real, Time, Udint};
    let (from, raw) = match *value {
        Value::Plain { ty, raw } => (ty, raw),
        Value::Text { ty, .. } => return (ty == to).then(|| ImplicitResult::Exactly(value.clone())),
        Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => return None,
    };
    let is_number = |ty: ElementaryType| ty.integer_range().is_some();
    let raw = match (from, to) {
        _ if from == to => raw,
        (Real, Lreal) => real::between(raw, from, to),
        // TIME has 32 bits with a sign in PLCnext Engineer, where the two convert.
        (Udint, Time) => moment::from_units(integer::number(raw, from), to, MomentUnits::ShortTime),
        (Time, Udint) if !moment::has_whole_units(raw, from, MILLISECONDS) => {
            return Some(ImplicitResult::Open);
        }
        (Time, Udint) => return Some(held(moment::units(raw, from, MILLISECONDS), to)),
        _ if is_number(from) && is_number(to) => return Some(held(integer::number(raw, from), to)),
        _ if from.is_integer() && to.is_real() => real::from_integer(integer::number(raw, from), to),
        _ if from.is_form_of(to) => moment::between(raw, to),
        _ => return None,
    };
    Some(ImplicitResult::Exactly(Value::plain(to, raw)))
}

/// Returns the number as a value of the type, if the type holds it.
fn held(number: i128, to: ElementaryType) -> ImplicitResult {
    match to.holds(number) {
        true => ImplicitResult::Exactly(Value::plain(to, integer::wrapped(number, to))),
        false => ImplicitResult::Open,
    }
}
