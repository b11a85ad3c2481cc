//! The values beside one that must arrive: programs that compare it with them show whether it became too small or too great.
//!
//! Basis: conformance-cases/README.md (places that are put together).

use stickler_types::{ElementaryType, Value};

/// The placeholders of a smaller value and of a greater one.
pub(crate) const BESIDE: [&str; 2] = ["below", "above"];

/// Returns a value of the same type that is less and one that is greater, as untyped literals; the value itself where the type
/// has none, or no order.
pub(crate) fn beside(value: &Value) -> [String; 2] {
    let Value::Plain { ty, raw } = *value else {
        return [value.literal(), value.literal()];
    };
    let neighbours = match ty.integer_range() {
        Some(range) if ty.is_integer() || ty.is_bit_string() => Some(whole(ty, raw, range)),
        _ if ty.is_real() => real(ty, value),
        _ => None,
    };
    neighbours.unwrap_or_else(|| [value.literal(), value.literal()])
}

/// Returns the numbers before and behind a number, as far as the type has them.
fn whole(ty: ElementaryType, raw: u64, (least, greatest): (i128, i128)) -> [String; 2] {
    [-1, 1].map(|step| {
        let number = (ty.integer_value(raw) + step).clamp(least, greatest);
        Value::plain(ty, ty.wrap(number)).literal()
    })
}

/// Returns zero on the one side of a real number, and a number twice as far from zero on the other.
fn real(ty: ElementaryType, value: &Value) -> Option<[String; 2]> {
    let number: f64 = value
        .without_type()
        .parse()
        .ok()
        .filter(|number: &f64| number.is_finite())?;
    let literal = |number: f64| {
        Value::parse(&format!("{ty}#{number:?}"))
            .ok()
            .map(|found| found.literal())
    };
    Some([
        literal(if number > 0.0 { 0.0 } else { 2.0 * number - 1.0 })?,
        literal(if number < 0.0 { 0.0 } else { 2.0 * number + 1.0 })?,
    ])
}
