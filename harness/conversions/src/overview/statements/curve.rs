//! Curves of conversion functions: the results of dense samples of operands, which the page of a run draws.
//!
//! Nothing is interpolated: exact arithmetic gives the result of each sample. What several samples in a row have in common is written once.

use serde::Serialize;
use stickler_exact::{Expected, Signature, expected};
use stickler_types::{DialectName, ElementaryType, Value, WordTable, join};

/// The curve of a function. Each text is the number of a word, and a list of items for the samples with blanks between them: `3*item` is three
/// times that item. A number is in quarters of 1, or of a millisecond.
#[derive(Serialize)]
pub(super) struct Curve {
    /// The samples around zero, around the limits of the result's type, and over the whole range of the operand's: `=number`, `+difference`
    /// from the sample before, or `~literal`.
    axis: u32,
    /// The distinct rules, each with its results and their bases. A result is `=number`, `+difference` from its operand, or `~literal`; a basis is
    /// the number of its word, or `-` where no document states the result.
    rules: Vec<[u32; 2]>,
    /// By dialect of the function, the index of its rule.
    of: Vec<usize>,
}

impl Curve {
    /// Returns the curve of a function in its dialects; `None` where a table shows as much, as of texts and of what always fits.
    pub(super) fn of(signature: &Signature, dialects: &[DialectName], words: &mut WordTable) -> Option<Self> {
        let axis = axis(signature)?;
        let mut rules = Vec::new();
        let mut of = Vec::with_capacity(dialects.len());
        for dialect in dialects {
            let call = |operand| expected(signature, std::slice::from_ref(operand), *dialect);
            let given: Vec<Expected> = axis.iter().map(call).collect();
            let basis = |given: &Expected| {
                let word = given.basis.map(|basis| words.number(basis).to_string());
                word.unwrap_or_else(|| "-".to_owned())
            };
            let bases = runs(given.iter().map(basis));
            let mut last = String::new();
            let results = runs(axis.iter().zip(&given).map(|(operand, given)| {
                let difference = item(Some(operand), &given.value);
                let is_line = std::mem::replace(&mut last, difference.clone()) == difference;
                if is_line {
                    difference
                } else {
                    item(None, &given.value)
                }
            }));
            let rule = [results, bases].map(|text| words.number(&text));
            of.push(
                rules
                    .iter()
                    .position(|known| *known == rule)
                    .unwrap_or(rules.len()),
            );
            if of.last() == Some(&rules.len()) {
                rules.push(rule);
            }
        }
        let before = std::iter::once(None).chain(axis.iter().map(Some));
        let axis = words.number(&runs(
            before.zip(&axis).map(|(before, sample)| item(before, sample)),
        ));
        Some(Curve { axis, rules, of })
    }
}

/// Returns the operands, in any order.
fn axis(signature: &Signature) -> Option<Vec<Value>> {
    let (&[from], to) = (&signature.operands[..], signature.result) else {
        return None;
    };
    let is_number = |ty: ElementaryType| ty.bits() > 1 && (ty.is_whole() || ty.is_real() || ty.is_duration());
    let range = from.integer_range();
    let fits = range.is_some_and(|(least, greatest)| to.holds(least) && to.holds(greatest));
    (is_number(from) && is_number(to) && !fits)
        .then(|| [around_zero(from), around_limits(from, to), whole_range(from)].concat())
}

/// Returns the quarters from -3.5 to 3.5, with their neighbours where the type has fractions.
fn around_zero(from: ElementaryType) -> Vec<Value> {
    let quarters = (-14..=14).filter_map(|quarters| operand(from, quarters));
    let beside = quarters.flat_map(|value| match value {
        Value::Plain { ty, raw } if raw != 0 && !ty.is_whole() => {
            [raw - 1, raw, raw + 1].map(|raw| Value::plain(ty, raw)).to_vec()
        }
        value => vec![value],
    });
    beside.collect()
}

/// Returns about 200 operands from below the limits of the result to above them, with the halves beside each limit. The limits of a real are those
/// between which it has each integer, and those of a duration are its milliseconds in 32 bits.
fn around_limits(from: ElementaryType, to: ElementaryType) -> Vec<Value> {
    let ((least, greatest), margin) = match to {
        ElementaryType::Real => ((0x00FF_FFF8, 0x0100_0010), 0),
        ElementaryType::Lreal => ((0x1F_FFFF_FFFF_FFF8, 0x20_0000_0000_0010), 0),
        _ => (to.integer_range().unwrap_or((-0x8000_0000, 0xFFFF_FFFF)), 5),
    };
    let size = greatest - least + 1;
    let (first, last) = (least - size * margin / 4, greatest + size * margin / 4);
    let mut steps = (0..60).map(|number| [1, 2, 5][number % 3] * 10_i128.pow(number as u32 / 3));
    let step = steps.find(|step| (last - first) / step <= 200).unwrap_or(1);
    let even = (first / step..=last / step).map(|number| 4 * number * step);
    let limits = [-size, 0, size]
        .into_iter()
        .flat_map(|by| [least + by, greatest + by]);
    let beside = limits.filter(|limit| (first..=last).contains(limit));
    let beside = beside.flat_map(|limit| [-4, -2, 0, 2, 4].map(|quarters| 4 * limit + quarters));
    even.chain(beside)
        .filter_map(|quarters| operand(from, quarters))
        .collect()
}

/// Returns four whole numbers in each power of ten up to 10^40, few of which end in zeros, since these would hide what a wrap does; and what is at the
/// ends of the type.
fn whole_range(from: ElementaryType) -> Vec<Value> {
    let mut axis = Vec::from_iter(operand(from, 0));
    for fourth in (0..160).chain((160..1233).step_by(48)) {
        let number = 10_f64.powf(f64::from(fourth) / 4.0).round();
        axis.extend([number, -number].into_iter().filter_map(|number| {
            match from.is_real() {
                true => Some(Value::of_real(from, number)),
                false => operand(
                    from,
                    (number as i128)
                        .saturating_add(i128::from(fourth % 4))
                        .saturating_mul(4),
                ),
            }
        }));
    }
    if let Some((least, greatest)) = from.integer_range() {
        axis.extend([least, greatest].map(|limit| Value::plain(from, from.wrap(limit))));
    } else if from.is_real() {
        axis.extend([f64::INFINITY, -f64::INFINITY, f64::NAN].map(|number| Value::of_real(from, number)));
    }
    axis
}

/// Returns the value that is so many quarters of 1, or of a millisecond; `None` where the type has none.
fn operand(ty: ElementaryType, quarters: i128) -> Option<Value> {
    if ty.is_real() {
        return Some(Value::of_real(ty, quarters as f64 / 4.0));
    }
    let (number, is_value) = match ty.is_duration() {
        true => (
            quarters.checked_mul(250_000)?,
            i64::try_from(quarters * 250_000).is_ok(),
        ),
        false => (quarters / 4, quarters % 4 == 0 && ty.holds(quarters / 4)),
    };
    is_value.then(|| Value::plain(ty, ty.wrap(number)))
}

/// Returns how many quarters of 1, or of a millisecond, a value is; `None` where that is no whole number, or a very great one.
fn quarters(value: &Value) -> Option<i128> {
    let Value::Plain { ty, raw } = *value else {
        return None;
    };
    match ty.real_value(raw).map(|number| number * 4.0) {
        Some(quarters) => (quarters.fract() == 0.0 && quarters.abs() < 1e24).then_some(quarters as i128),
        None if ty.is_duration() => {
            (ty.integer_value(raw) % 250_000 == 0).then(|| ty.integer_value(raw) / 250_000)
        }
        None => Some(4 * ty.integer_value(raw)),
    }
}

/// Writes a value, or its difference from another.
fn item(other: Option<&Value>, value: &Value) -> String {
    match (quarters(value), other.and_then(quarters)) {
        (Some(number), Some(other)) => format!("+{}", number - other),
        (Some(number), None) => format!("={number}"),
        (None, _) => format!("~{}", value.without_type()),
    }
}

/// Writes items, of which equal ones in a row are one.
fn runs(items: impl Iterator<Item = String>) -> String {
    let items: Vec<String> = items.collect();
    let runs = items.chunk_by(|one, other| one == other);
    let written = runs.map(|run| match run.len() {
        1 => run[0].clone(),
        number => format!("{number}*{}", run[0]),
    });
    join(written, " ")
}
