//! The default operands of the overview: the boundary values of a conversion, few enough to be read at a glance.

use stickler_exact::{Operation, Signature};
use stickler_types::{ElementaryType, Family, Value, boundaries};

/// Returns the types of a signature's operands, in one line.
pub fn types(signature: &Signature) -> String {
    let names: Vec<&str> = signature.operands.iter().map(|ty| ty.name()).collect();
    names.join(", ")
}

/// Returns the calls that are shown where no values are given: both zeros, ties, the limits of both types with their neighbours,
/// the infinities and NaN.
pub fn boundaries(signature: &Signature) -> Vec<Vec<Value>> {
    match signature.operands[..] {
        [first, second] => pairs(first, second),
        [from] => of_one(from, signature)
            .into_iter()
            .map(|value| vec![value])
            .collect(),
        _ => Vec::new(),
    }
}

fn of_one(from: ElementaryType, signature: &Signature) -> Vec<Value> {
    let to = signature.result;
    let values = match from.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString => {
            return integers(from, signature);
        }
        Family::Real => literals(from, &reals(from, to)),
        Family::Text => texts(from, to),
        _ => short(from),
    };
    distinct(values)
}

/// Returns pairs of operands: every date with the first and the last time of day.
fn pairs(date: ElementaryType, time: ElementaryType) -> Vec<Vec<Value>> {
    let times = short(time);
    let ends = [times.first(), times.last()];
    let pair = |date: Value| {
        ends.into_iter()
            .flatten()
            .map(move |time| vec![date.clone(), time.clone()])
    };
    short(date).into_iter().flat_map(pair).collect()
}

/// Returns the boundary values of a type that is neither number nor text, in the short list.
fn short(ty: ElementaryType) -> Vec<Value> {
    boundaries::boundaries(ty)
        .into_iter()
        .map(|known| known.value)
        .collect()
}

/// Returns integers in ascending order: the limits of the source; the limits of the target with their neighbours.
fn integers(from: ElementaryType, signature: &Signature) -> Vec<Value> {
    let Some((least, greatest)) = from.integer_range() else {
        return Vec::new();
    };
    let mut numbers = vec![least, -1, 0, 1, greatest];
    numbers.extend(beside_limits(signature.result));
    numbers.extend(telling(signature));
    numbers.retain(|number| (least..=greatest).contains(number));
    numbers.sort_unstable();
    numbers.dedup();
    let value = |number| Value::plain(from, from.wrap(number));
    numbers.into_iter().map(value).collect()
}

fn beside_limits(ty: ElementaryType) -> Vec<i128> {
    match ty.integer_range() {
        Some((least, greatest)) => vec![least - 1, least, greatest, greatest + 1],
        None => Vec::new(),
    }
}

/// Returns integers that are of interest for the operation and the result type of a signature only.
fn telling(signature: &Signature) -> &'static [i128] {
    match (signature.operation, signature.result.family()) {
        (Operation::FromBcd, _) => &[
            0x09,
            0x0A,
            0x10,
            0x1F,
            0x42,
            0x99,
            0xA0,
            0x0999,
            0x1234,
            0x7FFF,
            0x9999,
            0x1234_5678,
            0x9999_9999,
        ],
        (Operation::ToBcd, _) => &[9, 10, 42, 99, 100, 1234, 9999, 10_000, 99_999_999, 100_000_000],
        (_, Family::Boolean) => &[2, 256],
        // The first whole numbers that 24 and 53 bits do not hold.
        (_, Family::Real) => &[
            16_777_216,
            16_777_217,
            16_777_219,
            9_007_199_254_740_992,
            9_007_199_254_740_993,
        ],
        // The first whole milliseconds that 64 bits of nanoseconds do not hold.
        (_, Family::Duration) => &[1000, 9_223_372_036_855],
        // A day in seconds and in milliseconds.
        (_, Family::Date | Family::TimeOfDay | Family::DateAndTime) => {
            &[86_399, 86_400, 86_399_999, 86_400_000]
        }
        (_, Family::Character) => &[65, 255, 256, 65_535, 65_536],
        (_, Family::Text) => &[255],
        _ => &[],
    }
}

fn reals(from: ElementaryType, to: ElementaryType) -> Vec<String> {
    let double = from == ElementaryType::Lreal;
    let below_half = if double {
        "0.49999999999999994"
    } else {
        "0.49999997"
    };
    let (least, greatest) = if double {
        ("4.9E-324", "1.7976931348623157E308")
    } else {
        ("1.4E-45", "3.4028235E38")
    };
    let common: &[&str] = match to.family() {
        Family::Boolean => &["0.0", "-0.0", "0.1", "1.0", "-1.0", least],
        Family::Signed | Family::Unsigned | Family::BitString => &[
            "0.0", "-0.0", below_half, "0.5", "1.5", "2.5", "-0.5", "-1.5", "-2.5",
        ],
        Family::Real if double => &[
            "0.0",
            "-0.0",
            "0.1",
            "0.3333333333333333",
            "16777217.0",
            least,
            "7.0E-46",
            "8.0E-46",
            "1.4E-45",
            "3.4028235E38",
            "3.4028236E38",
            greatest,
        ],
        Family::Real => &["0.0", "-0.0", "0.1", "16777216.0", least, greatest],
        Family::Text => &[
            "0.0",
            "-0.0",
            "0.1",
            "1.0",
            "-2.5",
            "0.3333333333333333",
            "1234567.0",
            "1.0E10",
            "1.0E16",
            "1.0E-5",
            least,
            greatest,
        ],
        // The last is more milliseconds than 64 bits of nanoseconds hold.
        _ => &[
            "0.0", "0.4", "0.5", "1.0", "1.5", "2.5", "-1.0", "1.0E10", "1.0E13",
        ],
    };
    let mut literals: Vec<String> = common.iter().map(|&literal| literal.to_owned()).collect();
    if to.is_integer() || to.is_bit_string() {
        literals.extend(around_limits(to));
        literals.extend(["1.0E10", greatest].map(str::to_owned));
    }
    literals.extend(["NaN", "Infinity", "-Infinity"].map(str::to_owned));
    literals
}

/// Returns real literals around the limits of an integer type: the limits, half beyond them, and one beyond them.
fn around_limits(ty: ElementaryType) -> Vec<String> {
    let Some((least, greatest)) = ty.integer_range() else {
        return Vec::new();
    };
    let mut literals = vec![
        format!("{greatest}.0"),
        format!("{greatest}.5"),
        format!("{}.0", greatest + 1),
    ];
    if least < 0 {
        literals.extend([
            format!("{least}.0"),
            format!("{least}.5"),
            format!("{}.0", least - 1),
        ]);
    } else {
        literals.push("-1.0".to_owned());
    }
    literals
}

fn literals(ty: ElementaryType, literals: &[String]) -> Vec<Value> {
    let read = |literal: &String| Value::parse(&format!("{ty}#{literal}")).ok();
    literals.iter().filter_map(read).collect()
}

fn texts(from: ElementaryType, to: ElementaryType) -> Vec<Value> {
    let mut words: Vec<String> = match to.family() {
        Family::Boolean => ["TRUE", "FALSE", "true", "1", "0", "yes", ""]
            .map(str::to_owned)
            .into(),
        Family::Real => [
            "0", "1.5", "-1.5", "1E3", "1.5E3", ".5", "+1.5", " 1.5 ", "1_000.5", "1.5abc", "abc", "", "1,5",
            "1E400", "NaN",
        ]
        .map(str::to_owned)
        .into(),
        Family::Text | Family::Character => ["", "a", "abc", "\u{e4}"].map(str::to_owned).into(),
        Family::Signed | Family::Unsigned | Family::BitString => [
            "0", "42", "-7", "+5", " 5 ", "007", "1_000", "16#1F", "12abc", "1.5", "1E3", "abc", "",
        ]
        .map(str::to_owned)
        .into(),
        _ => moments(to),
    };
    if let Some((_, greatest)) = to.integer_range().filter(|_| to != ElementaryType::Bool) {
        words.extend([greatest.to_string(), (greatest + 1).to_string()]);
    }
    let units = |word: &String| word.encode_utf16().collect();
    words.iter().map(|word| Value::text(from, units(word))).collect()
}

/// Returns the texts of the boundary values of a duration or date type: each as a typed literal, and without its type.
fn moments(to: ElementaryType) -> Vec<String> {
    let known: Vec<String> = short(to).iter().map(ToString::to_string).collect();
    let bare = known
        .last()
        .and_then(|literal| literal.split_once('#'))
        .map(|(_, bare)| bare.to_owned());
    let others = ["5".to_owned(), "abc".to_owned(), String::new()];
    let first = [known.first(), known.last()].into_iter().flatten().cloned();
    first.chain(bare).chain(others).collect()
}

/// Removes repeated values, since two literals may stand for the same value.
fn distinct(values: Vec<Value>) -> Vec<Value> {
    let mut found: Vec<Value> = Vec::with_capacity(values.len());
    for value in values {
        if !found.contains(&value) {
            found.push(value);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::boundaries;
    use stickler_types::DialectName;

    #[test]
    fn every_signature_has_inputs_of_its_types_and_no_more_than_fit_a_screen() {
        for dialect in DialectName::ALL {
            for function in stickler_exact::functions(dialect) {
                for signature in stickler_exact::signatures(&function, dialect) {
                    let calls = boundaries(&signature);
                    assert!((2..=24).contains(&calls.len()), "{function}: {}", calls.len());
                    assert!(calls.iter().all(|call| signature.takes(call)), "{function}");
                    for (index, call) in calls.iter().enumerate() {
                        assert!(!calls[..index].contains(call), "{function}: {call:?} twice");
                    }
                }
            }
        }
    }
}
