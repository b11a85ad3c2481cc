//! The lists of operands that have a name, because types or formats decide what is in them, and values of a type from exact numbers.

use stickler_types::{ElementaryType, Family, Value};

/// A list of operands for a source type and a target type; empty where it has none for the two.
pub type List = fn(ElementaryType, ElementaryType) -> Vec<Value>;

/// The lists by their names.
const LISTS: [(&str, List); 11] = [
    ("limits", limits),
    ("powers-of-two", powers_of_two),
    ("powers-of-two-and-neighbours", powers_of_two_and_neighbours),
    ("powers-of-two-in-target", powers_of_two_in_target),
    ("powers-of-two-around-real", powers_of_two_around_real),
    ("ends-of-format", ends_of_format),
    ("ends-of-precision", ends_of_precision),
    ("beside-ties", beside_ties),
    ("beside-limits", beside_limits),
    ("few", few),
    ("telling", telling),
];

/// Returns the list of a name.
pub fn named(name: &str) -> Option<List> {
    let (_, list) = LISTS.iter().find(|(known, _)| *known == name)?;
    Some(*list)
}

/// Returns, for integers and bit strings, the limits of both types with their neighbours, 0 and its neighbours, the modulus of the
/// target, and an irregular pattern of bits.
pub fn limits(from: ElementaryType, to: ElementaryType) -> Vec<Value> {
    let (Some(own), Some(other)) = (from.integer_range(), to.integer_range()) else {
        return Vec::new();
    };
    let mut numbers = Vec::new();
    for edge in [own.0, own.1, other.0, other.1] {
        numbers.extend([edge - 1, edge, edge + 1]);
    }
    let modulus = 1 << to.bits();
    numbers.extend([-1, 0, 1, modulus, modulus + 1, -modulus, 100_000]);
    numbers.push(own.1 & 0x55AA_33CC_0FF0_A5C3);
    whole_numbers(from, numbers)
}

/// Returns each power of two that an integer or bit string holds, and of a signed type its opposite.
pub fn powers_of_two(from: ElementaryType, _to: ElementaryType) -> Vec<Value> {
    whole_numbers(from, (0..64).flat_map(|bit| [1 << bit, -(1 << bit)]))
}

/// Returns each power of two that an integer holds and its opposite, with the neighbours that a real target has no number for.
pub fn powers_of_two_and_neighbours(from: ElementaryType, to: ElementaryType) -> Vec<Value> {
    if !to.is_real() {
        return Vec::new();
    }
    let exact = 1_i128 << (fraction_bits(to) + 1);
    let powers = (0..64).flat_map(|bit| [1_i128 << bit, -(1 << bit)]);
    let holds = powers.filter(|&power| whole(from, power).is_some());
    let numbers = holds.flat_map(|power| {
        let reach = i128::from(power.abs() > exact);
        power - reach..=power + reach
    });
    whole_numbers(from, numbers)
}

/// Returns, for a real source and an integer target, the powers of two up to the modulus of the target, 2^63 and 2^64, of both
/// signs.
pub fn powers_of_two_in_target(from: ElementaryType, to: ElementaryType) -> Vec<Value> {
    if !from.is_real() || !to.is_integer() {
        return Vec::new();
    }
    let powers = (0..=to.bits())
        .chain([63, 64])
        .map(|bit| halves(from, 2_i128 << bit));
    powers.flatten().flat_map(both_signs).collect()
}

/// Returns, for LREAL, each power of two from below the least REAL to above the greatest, and below 2^-120, where the subnormal
/// numbers of REAL are near, also one and a half of it: 1.5 * 2^-149 is a tie between two of them.
pub fn powers_of_two_around_real(from: ElementaryType, _to: ElementaryType) -> Vec<Value> {
    if from != ElementaryType::Lreal {
        return Vec::new();
    }
    let one_and_a_half = (-152..-120).map(|exponent| 1.5 * 2_f64.powi(exponent));
    let powers = (-152..=129).map(|exponent| 2_f64.powi(exponent));
    let numbers = powers.chain(one_and_a_half);
    numbers
        .map(|number| Value::plain(from, number.to_bits()))
        .collect()
}

/// Returns both zeros, the least and greatest subnormal, the least normal and the greatest finite number of both signs.
pub fn ends_of_format(from: ElementaryType, _to: ElementaryType) -> Vec<Value> {
    if !from.is_real() {
        return Vec::new();
    }
    let least_normal = 1_u64 << fraction_bits(from);
    let infinity = ((1_u64 << (from.bits() - 1)) - 1) & !(least_normal - 1);
    let raws = [0, 1, least_normal - 1, least_normal, infinity - 1];
    let numbers = raws.map(|raw| Value::plain(from, raw));
    numbers.into_iter().flat_map(both_signs).collect()
}

/// Returns 2^24 and 2^53, above which REAL and LREAL do not have every integer, with their neighbours, of both signs.
pub fn ends_of_precision(from: ElementaryType, _to: ElementaryType) -> Vec<Value> {
    if !from.is_real() {
        return Vec::new();
    }
    let numbers = [1 << 24, 1 << 53].map(|number: i128| number - 1..=number + 2);
    let numbers = numbers.into_iter().flatten();
    let numbers = numbers.filter_map(|number| halves(from, 2 * number));
    numbers.flat_map(both_signs).collect()
}

/// Returns the neighbours of 0.5, 1.5, 2.5 and 3.5 in the format, of both signs.
pub fn beside_ties(from: ElementaryType, _to: ElementaryType) -> Vec<Value> {
    if !from.is_real() {
        return Vec::new();
    }
    let ties = [1, 3, 5, 7].into_iter().filter_map(|tie| halves(from, tie));
    let neighbours = ties.flat_map(|tie| [neighbour(&tie, -1), neighbour(&tie, 1)]);
    neighbours.flat_map(both_signs).collect()
}

/// Returns, for a real source and an integer target, the least number and one past the greatest with their neighbours in the
/// format.
pub fn beside_limits(from: ElementaryType, to: ElementaryType) -> Vec<Value> {
    let Some((least, greatest)) = to.integer_range() else {
        return Vec::new();
    };
    if !from.is_real() || !to.is_integer() {
        return Vec::new();
    }
    let edges = [least, greatest + 1].into_iter().filter(|&edge| edge != 0);
    let edges = edges.filter_map(|edge| halves(from, 2 * edge));
    edges
        .flat_map(|edge| [-1, 0, 1].map(|places| neighbour(&edge, places)))
        .collect()
}

/// Returns one or two values of a type that tell one rule from another.
pub fn few(from: ElementaryType, _to: ElementaryType) -> Vec<Value> {
    let literals: &[&str] = match from.family() {
        Family::Signed | Family::Unsigned | Family::BitString => {
            let small = if from.is_signed() { -2 } else { 2 };
            let greatest = from.integer_range().map(|(_, greatest)| greatest);
            return whole_numbers(from, [small].into_iter().chain(greatest));
        }
        Family::Boolean => &["TRUE"],
        Family::Real => &["-2.5", "3.5"],
        Family::Duration => &["-1.5ms", "1d1ms"],
        Family::Date => &["1969-12-31", "2024-02-29"],
        Family::TimeOfDay => &["12:34:56.789"],
        Family::DateAndTime => &["1969-12-31-23:59:59.5", "2024-02-29-12:34:56"],
        Family::Text if from == ElementaryType::String => &["'42'", "'abc'"],
        Family::Text => &["\"42\"", "\"abc\""],
        Family::Character if from == ElementaryType::Char => &["'a'"],
        Family::Character => &["\"$20AC\""],
    };
    let values = literals
        .iter()
        .map(|literal| Value::parse(&format!("{from}#{literal}")));
    values.flatten().collect()
}

/// Returns one or two values whose result changes where a conversion takes a sign for a bit or a bit for a sign, limits what must
/// wrap, drops the highest bit, or looks at the lowest one only.
pub fn telling(from: ElementaryType, to: ElementaryType) -> Vec<Value> {
    /// An even number whose highest bit is set, in each width.
    const PATTERN: i128 = 0x96AA_33CC_9FF0_A5C2;
    let both = |numbers: [i128; 2]| {
        numbers
            .into_iter()
            .filter_map(|number| halves(from, number))
            .collect()
    };
    if from.is_real() && to == ElementaryType::Bool {
        return both([-5, 9]);
    }
    if from.is_real() && to.is_integer() {
        // Rounding to even and away from zero agree here, so that each differs from truncation in every row.
        return both([-7, 7]);
    }
    let Some((_, greatest)) = from.integer_range().filter(|_| from != ElementaryType::Bool) else {
        return few(from, to);
    };
    let pattern = from.integer_value(from.wrap(PATTERN));
    // What a signed type cannot wrap must show its sign.
    let wraps = to.integer_range().is_some() && to.bits() < from.bits();
    let other = if from.is_signed() && !wraps {
        -2
    } else {
        greatest - 1
    };
    whole_numbers(from, [pattern, other])
}

fn whole_numbers(ty: ElementaryType, numbers: impl IntoIterator<Item = i128>) -> Vec<Value> {
    let values = numbers.into_iter().filter_map(|number| whole(ty, number));
    values.collect()
}

/// Returns the number of stored bits of the fraction of a real type.
fn fraction_bits(ty: ElementaryType) -> u32 {
    if ty == ElementaryType::Real { 23 } else { 52 }
}

/// Returns the real number so many places further away from zero in its format, or nearer to it.
fn neighbour(value: &Value, places: i64) -> Value {
    match *value {
        Value::Plain { ty, raw } => Value::plain(ty, raw.wrapping_add_signed(places)),
        _ => value.clone(),
    }
}

/// Returns a real number and its opposite.
fn both_signs(value: Value) -> [Value; 2] {
    let opposite = match value {
        Value::Plain { ty, raw } => Value::plain(ty, raw ^ 1 << (ty.bits() - 1)),
        _ => value.clone(),
    };
    [value, opposite]
}

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
