//! The operands that the `inputs` of a `[generate]` table stand for.
//!
//! | entry | operands |
//! |---|---|
//! | `"0"`, `"-1.5"`, `"TRUE"`, `"NaN"` | that literal, of every source type that has it |
//! | `"from.least"`, `"to.greatest+0.5"`, `"-to.modulus"` | a number beside a limit of the source type or of the target |
//! | `"powers-of-two"` | the list of that [name](lists::named) |

use crate::lists::{self, halves, whole};
use stickler_types::{ElementaryType, Value, WrittenValue, distinct};

/// Returns the operands of a pair of types, numbers in ascending order, each once.
///
/// A number that the source type cannot hold is left out; real numbers are rounded once.
///
/// # Errors
/// A sentence, where an entry is neither a literal, nor a number beside a limit, nor the name of a list.
pub fn operands(
    entries: &[String],
    from: ElementaryType,
    to: ElementaryType,
) -> Result<Vec<WrittenValue>, String> {
    let mut values: Vec<Value> = Vec::new();
    for entry in entries {
        values.extend(of_entry(entry, from, to)?);
    }
    values.sort_by_key(order);
    Ok(distinct(values).into_iter().map(WrittenValue::of).collect())
}

fn of_entry(entry: &str, from: ElementaryType, to: ElementaryType) -> Result<Vec<Value>, String> {
    if let Some(list) = lists::named(entry) {
        return Ok(list(from, to));
    }
    if let Ok(number) = entry.parse::<i128>() {
        return Ok(whole(from, number).into_iter().collect());
    }
    if let Some(limit) = Limit::parse(entry) {
        return Ok(limit.value(from, to).into_iter().collect());
    }
    if entry.starts_with(|first: char| first.is_ascii_lowercase()) {
        return Err(format!("`{entry}` is no list of inputs"));
    }
    Ok(Value::parse(&format!("{from}#{entry}")).into_iter().collect())
}

/// Returns a number that grows with the value of an integer, a bit string or a real number; -0.0 comes before 0.0.
fn order(value: &Value) -> i128 {
    match *value {
        Value::Plain { ty, raw } if ty.is_real() => {
            let sign = 1_u64 << (ty.bits() - 1);
            let magnitude = i128::from(raw & !sign);
            if raw & sign == 0 {
                magnitude
            } else {
                -magnitude - 1
            }
        }
        Value::Plain { ty, raw } => ty.integer_value(raw),
        Value::Text { .. } | Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => 0,
    }
}

/// A number beside a limit of a type: `from.least+1`, `to.greatest-0.5`, `-to.modulus-7`.
struct Limit {
    is_negative: bool,
    of_target: bool,
    /// Returns the limit of a type with this range.
    limit: fn(ElementaryType, (i128, i128)) -> i128,
    /// The halves that are added.
    offset: i128,
}

impl Limit {
    fn parse(entry: &str) -> Option<Limit> {
        let (is_negative, rest) = entry
            .strip_prefix('-')
            .map_or((false, entry), |rest| (true, rest));
        let (side, rest) = rest.split_once('.')?;
        let (name, offset) = rest.find(['+', '-']).map_or((rest, "+0"), |at| rest.split_at(at));
        let (whole, half) = offset.strip_suffix(".5").map_or((offset, 0), |whole| (whole, 1));
        let whole = whole.parse::<i128>().ok()?;
        Some(Limit {
            is_negative,
            of_target: match side {
                "from" => false,
                "to" => true,
                _ => return None,
            },
            limit: match name {
                "least" => |_, (least, _)| least,
                "greatest" => |_, (_, greatest)| greatest,
                // Half the number of values of an unsigned type, a quarter of those of a signed one: the highest bit of a number.
                "half" => |_, (_, greatest)| greatest / 2 + 1,
                // The number of values.
                "modulus" => |ty, _| 1 << ty.bits(),
                _ => return None,
            },
            offset: 2 * whole + if offset.starts_with('-') { -half } else { half },
        })
    }

    fn value(&self, from: ElementaryType, to: ElementaryType) -> Option<Value> {
        let ty = if self.of_target { to } else { from };
        let limit = (self.limit)(ty, ty.integer_range()?);
        let number = 2 * if self.is_negative { -limit } else { limit } + self.offset;
        if from.is_real() {
            halves(from, number)
        } else {
            whole(from, number / 2)
        }
    }
}
