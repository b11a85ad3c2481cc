//! The operands that the `inputs` of a `[generate]` table stand for.
//!
//! | entry | operands |
//! |---|---|
//! | `"0"`, `"-1.5"`, `"TRUE"`, `"NaN"` | that literal, of every source type that has it |
//! | `"from.least"`, `"to.greatest+0.5"`, `"-to.modulus"` | a number beside a limit of the source type or of the target |
//! | `"powers-of-two"` | the list of that [name](lists::named) |

use crate::lists;
use crate::number::{halves, whole};
use stickler_types::{ElementaryType, Value, WrittenValue};

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
    let mut each_once: Vec<Value> = Vec::new();
    for value in values {
        if !each_once.contains(&value) {
            each_once.push(value);
        }
    }
    Ok(each_once.into_iter().map(WrittenValue::of).collect())
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
        Value::Text { .. } | Value::Enumerated { .. } | Value::OutOfRange { .. } => 0,
    }
}

/// A number beside a limit of a type: `from.least+1`, `to.greatest-0.5`, `-to.modulus-7`.
struct Limit {
    is_negative: bool,
    of_target: bool,
    name: LimitName,
    /// The halves that are added.
    offset: i128,
}

enum LimitName {
    Least,
    Greatest,
    /// Half the number of values of an unsigned type, a quarter of those of a signed one: the highest bit of a number.
    Half,
    /// The number of values.
    Modulus,
}

impl Limit {
    fn parse(entry: &str) -> Option<Limit> {
        let (is_negative, rest) = match entry.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, entry),
        };
        let (side, rest) = rest.split_once('.')?;
        let (name, offset) = match rest.find(['+', '-']) {
            Some(at) => rest.split_at(at),
            None => (rest, "+0"),
        };
        let (whole, half) = match offset.strip_suffix(".5") {
            Some(whole) => (whole, 1),
            None => (offset, 0),
        };
        let whole = whole.parse::<i128>().ok()?;
        Some(Limit {
            is_negative,
            of_target: match side {
                "from" => false,
                "to" => true,
                _ => return None,
            },
            name: match name {
                "least" => LimitName::Least,
                "greatest" => LimitName::Greatest,
                "half" => LimitName::Half,
                "modulus" => LimitName::Modulus,
                _ => return None,
            },
            offset: 2 * whole + if offset.starts_with('-') { -half } else { half },
        })
    }

    fn value(&self, from: ElementaryType, to: ElementaryType) -> Option<Value> {
        let ty = if self.of_target { to } else { from };
        let (least, greatest) = ty.integer_range()?;
        let limit = match self.name {
            LimitName::Least => least,
            LimitName::Greatest => greatest,
            LimitName::Half => greatest / 2 + 1,
            LimitName::Modulus => 1 << ty.bits(),
        };
        let number = 2 * if self.is_negative { -limit } else { limit } + self.offset;
        if from.is_real() {
            halves(from, number)
        } else {
            whole(from, number / 2)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ElementaryType::{Bool, Lreal, Real, Sint, Usint, Word};

    fn literals(entries: &[&str], from: ElementaryType, to: ElementaryType) -> Vec<String> {
        let entries: Vec<String> = entries.iter().map(|&entry| entry.to_owned()).collect();
        let operands = operands(&entries, from, to).unwrap();
        operands
            .into_iter()
            .map(|operand| operand.literal.into())
            .collect()
    }

    #[test]
    fn numbers_ascend_each_once_and_those_that_the_type_does_not_hold_are_left_out() {
        assert_eq!(
            literals(&["300", "7", "-7", "from.least", "7"], Sint, Word),
            ["-128", "-7", "7"]
        );
        let entries = ["16777217.0", "-1.5", "16777216.0", "0.0", "-0.0", "1.0E99"];
        assert_eq!(
            literals(&entries, Real, Sint),
            ["-1.5", "-0.0", "0.0", "16777216.0"]
        );
    }

    #[test]
    fn a_literal_is_an_operand_of_the_types_that_have_it() {
        let entries = ["0", "0.5", "TRUE", "NaN"];
        assert_eq!(literals(&entries, Word, Sint), ["16#0000"]);
        assert_eq!(literals(&entries, Real, Sint), ["0.5", "NaN"]);
        assert_eq!(literals(&entries, Bool, Sint), ["TRUE"]);
    }

    #[test]
    fn a_limit_can_be_of_either_type_and_lie_between_numbers() {
        let entries = [
            "to.least+0.5",
            "to.greatest-0.5",
            "-to.modulus-7",
            "from.greatest",
        ];
        assert_eq!(literals(&entries, Lreal, Sint), ["-263.0", "-127.5", "126.5"]);
        assert_eq!(
            literals(&["from.half", "from.greatest"], Usint, Real),
            ["128", "255"]
        );
    }

    #[test]
    fn an_unknown_list_is_an_error() {
        for entry in ["powers-of-tow", "to.last", "from"] {
            let error = operands(&[entry.to_owned()], Sint, Usint).unwrap_err();
            assert_eq!(error, format!("`{entry}` is no list of inputs"));
        }
    }
}
