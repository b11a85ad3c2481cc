//! The kinds of questions, by which contradictions are grouped.

use stickler_types::{ElementaryType, Family, Question};

/// Returns the kind of a question, in words: all conversions of real numbers to integers are one.
#[must_use]
pub fn kind_of(question: &Question) -> String {
    let pair = |(from, to): (ElementaryType, ElementaryType)| {
        format!("{} to {}", family(from.family()), family(to.family()))
    };
    match question {
        Question::Implicit(types) => format!("implicit conversion, {}", pair(*types)),
        Question::Part(ty, part) => {
            let form: String = part.chars().filter(|letter| !letter.is_ascii_digit()).collect();
            format!("access to .{form}n of {}", family(ty.family()))
        }
        Question::Comparison((left, right)) => {
            format!("{} < {}", family(left.family()), family(right.family()))
        }
        Question::Call(call) => {
            let operands = call.operands.iter().map(|operand| operand.type_name());
            let types: Option<Vec<_>> = operands.map(ElementaryType::from_name).collect();
            match types.as_deref() {
                // `REAL_TO_INT` and `TO_INT` round by rules of their own where a system has both.
                Some([from]) if call.function.starts_with("TO_") => {
                    format!("overloaded conversion, {}", pair((*from, call.result)))
                }
                Some([from]) if call.function.contains("_TO_") && !call.function.contains("BCD") => {
                    format!("conversion, {}", pair((*from, call.result)))
                }
                _ => call.function.clone(),
            }
        }
    }
}

const fn family(family: Family) -> &'static str {
    match family {
        Family::Boolean => "BOOL",
        Family::Signed | Family::Unsigned => "integer",
        Family::BitString => "bit string",
        Family::Real => "real",
        Family::Duration => "duration",
        Family::Date => "date",
        Family::TimeOfDay => "time of day",
        Family::DateAndTime => "date and time",
        Family::Text => "text",
        Family::Character => "character",
    }
}
