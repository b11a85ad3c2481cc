//! The default operands of the overview: the boundary values of a conversion, few enough to be read at a glance.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;
use stickler_exact::{Operation, Signature};
use stickler_types::{ElementaryType, Family, Value, boundaries, distinct, join, sorted};

/// The values that an overview shows besides the limits of types.
static LISTS: LazyLock<Lists> =
    LazyLock::new(|| toml::from_str(include_str!("inputs.toml")).unwrap_or_default());

/// Lists of values by what they are interesting for.
#[derive(Default, Deserialize)]
struct Lists {
    integers: NamedLists,
    reals: NamedLists,
    texts: NamedLists,
}

type NamedLists = BTreeMap<String, Vec<String>>;

fn list(lists: &NamedLists, name: &str) -> Vec<String> {
    lists.get(name).cloned().unwrap_or_default()
}

/// Returns the types of a signature's operands, in one line.
pub fn types(signature: &Signature) -> String {
    join(signature.operands.iter().map(|ty| ty.name()), ", ")
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
    // Two literals may stand for the same value.
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
    let value = |number| Value::plain(from, from.wrap(number));
    sorted(numbers).into_iter().map(value).collect()
}

fn beside_limits(ty: ElementaryType) -> Vec<i128> {
    match ty.integer_range() {
        Some((least, greatest)) => vec![least - 1, least, greatest, greatest + 1],
        None => Vec::new(),
    }
}

/// Returns integers that are of interest for the operation and the result type of a signature only.
fn telling(signature: &Signature) -> Vec<i128> {
    let key = match (signature.operation, signature.result.family()) {
        (Operation::FromBcd, _) => "from-bcd",
        (Operation::ToBcd, _) => "to-bcd",
        (_, Family::Boolean) => "boolean",
        (_, Family::Real) => "real",
        (_, Family::Duration) => "duration",
        (_, Family::Date | Family::TimeOfDay | Family::DateAndTime) => "moment",
        (_, Family::Character) => "character",
        (_, Family::Text) => "text",
        _ => return Vec::new(),
    };
    let number = |text: String| match text.strip_prefix("16#") {
        Some(digits) => i128::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    list(&LISTS.integers, key)
        .into_iter()
        .filter_map(number)
        .collect()
}

fn reals(from: ElementaryType, to: ElementaryType) -> Vec<String> {
    let double = from == ElementaryType::Lreal;
    let [below_half, least, greatest] = match double {
        true => ["0.49999999999999994", "4.9E-324", "1.7976931348623157E308"],
        false => ["0.49999997", "1.4E-45", "3.4028235E38"],
    };
    let key = match to.family() {
        Family::Boolean => "boolean",
        Family::Signed | Family::Unsigned | Family::BitString => "integer",
        Family::Real if double => "lreal-to-real",
        Family::Real => "real",
        Family::Text => "text",
        _ => "moment",
    };
    let literal = |word: String| match word.as_str() {
        "below-half" => below_half.to_owned(),
        "least" => least.to_owned(),
        "greatest" => greatest.to_owned(),
        _ => word,
    };
    let mut literals: Vec<String> = list(&LISTS.reals, key).into_iter().map(literal).collect();
    if to.is_whole() {
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
    let mut words = match to.family() {
        Family::Boolean => list(&LISTS.texts, "boolean"),
        Family::Real => list(&LISTS.texts, "real"),
        Family::Text | Family::Character => list(&LISTS.texts, "text"),
        Family::Signed | Family::Unsigned | Family::BitString => list(&LISTS.texts, "integer"),
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

#[cfg(test)]
mod tests {
    use super::boundaries;
    use crate::overview::rules;
    use stickler_types::DialectName;

    #[test]
    fn every_signature_has_inputs_of_its_types_and_no_more_than_fit_a_screen() {
        for dialect in DialectName::ALL {
            for function in stickler_exact::functions(dialect) {
                for signature in stickler_exact::signatures(&function, dialect) {
                    let calls = boundaries(&signature);
                    assert!((2..=24).contains(&calls.len()), "{function}: {}", calls.len());
                    assert!(calls.iter().all(|call| signature.takes(call)), "{function}");
                    let rules = rules(&signature, &[dialect]);
                    assert!(rules.iter().all(|(_, rule, _)| rule.contains(' ')), "{rules:?}");
                    for (index, call) in calls.iter().enumerate() {
                        assert!(!calls[..index].contains(call), "{function}: {call:?} twice");
                    }
                }
            }
        }
    }
}
