//! Values, biased to boundaries.

use crate::random::Random;
use std::sync::LazyLock;
use stickler_types::{ElementaryType, Family, Value};

/// The values of a type at which something changes; the default value first.
pub(super) fn boundaries(ty: ElementaryType) -> &'static [Value] {
    static TABLE: LazyLock<Vec<Vec<Value>>> =
        LazyLock::new(|| ElementaryType::ALL.into_iter().map(written_out).collect());
    &TABLE[ty as usize]
}

/// A value of a type: often a boundary, sometimes a small one, sometimes any.
pub(super) fn value(ty: ElementaryType, random: &mut Random<'_, '_>) -> Value {
    match random.weighted(&[3, 2, 1]) {
        1 => random
            .pick(boundaries(ty))
            .cloned()
            .unwrap_or(Value::plain(ty, 0)),
        2 if ty.integer_range().is_some() => Value::plain(ty, ty.wrap(i128::from(random.bits()))),
        _ => small(ty, random),
    }
}

/// A value near the default, of which sums and products stay in range for a while.
fn small(ty: ElementaryType, random: &mut Random<'_, '_>) -> Value {
    let number = i128::from(random.below(12) as u64);
    match ty.family() {
        Family::Boolean => Value::plain(ty, number as u64 & 1),
        Family::Signed if number > 9 => Value::plain(ty, ty.wrap(9 - number)),
        _ if ty.integer_range().is_some() => Value::plain(ty, ty.wrap(number)),
        _ => random
            .pick(boundaries(ty))
            .cloned()
            .unwrap_or(Value::plain(ty, 0)),
    }
}

fn written_out(ty: ElementaryType) -> Vec<Value> {
    match ty.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString => integers(ty),
        Family::Real => reals(ty),
        _ => vec![default_value(ty)],
    }
}

/// What a variable holds that nobody has given a value.
pub(super) fn default_value(ty: ElementaryType) -> Value {
    if ty.is_text() {
        Value::text(ty, Vec::new())
    } else {
        Value::plain(ty, 0)
    }
}

/// 0, 1, -1, the limits and one inside them, each power of two and its neighbours.
fn integers(ty: ElementaryType) -> Vec<Value> {
    let Some((least, greatest)) = ty.integer_range() else {
        return Vec::new();
    };
    let mut numbers = vec![0, 1, -1, greatest, least, greatest - 1, least + 1];
    for power in (0..ty.bits()).map(|bit| 1_i128 << bit) {
        numbers.extend([power, power - 1, power + 1, -power, -power - 1]);
    }
    let mut seen = Vec::new();
    for number in numbers {
        if (least..=greatest).contains(&number) && !seen.contains(&number) {
            seen.push(number);
        }
    }
    seen.into_iter()
        .map(|number| Value::plain(ty, ty.wrap(number)))
        .collect()
}

fn reals(ty: ElementaryType) -> Vec<Value> {
    let numbers = [
        0.0, 1.0, -1.0, 0.5, -0.5, 1.5, 2.5, -2.5, 0.1, -0.0, 100.0, 127.5, 255.0, -129.0, 32767.0, -32768.0,
        65536.0, 1e6,
    ];
    let raw = |number: f64| match ty {
        ElementaryType::Real => u64::from((number as f32).to_bits()),
        _ => number.to_bits(),
    };
    numbers.map(|number| Value::plain(ty, raw(number))).into()
}
