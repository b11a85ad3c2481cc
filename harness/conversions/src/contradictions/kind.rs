//! The kinds of questions, by which contradictions are grouped.

use stickler_types::{ElementaryType, Family, Question};

/// Returns the kind of a question, in words: all conversions of real numbers to integers are one.
pub(super) fn kind_of(question: &Question) -> String {
    let pair = |from: ElementaryType, to: ElementaryType| format!("{} to {}", family(from), family(to));
    match question {
        Question::Implicit((from, to)) => format!("implicit conversion, {}", pair(*from, *to)),
        Question::Part(ty, part) => {
            let form = part.trim_end_matches(|letter: char| letter.is_ascii_digit());
            format!("access to .{form}n of a {}", family(*ty))
        }
        Question::Comparison((left, right)) => format!("{} less than {}", family(*left), family(*right)),
        Question::Call(call) => {
            let operand = call.operands.first().map(|operand| operand.type_name());
            match (operand.and_then(ElementaryType::from_name), &call.function) {
                (Some(from), name) if name.starts_with("TO_") => {
                    format!("overloaded conversion, {}", pair(from, call.result))
                }
                (Some(from), name) if name.contains("_TO_") && !name.contains("BCD") => {
                    format!("conversion, {}", pair(from, call.result))
                }
                (_, name) => name.clone(),
            }
        }
    }
}

const fn family(ty: ElementaryType) -> &'static str {
    match ty.family() {
        Family::Boolean => "BOOL",
        Family::Signed | Family::Unsigned => "integer",
        Family::BitString => "bit string",
        Family::Real => "real",
        Family::Duration => "duration",
        Family::Date | Family::TimeOfDay | Family::DateAndTime => "date or time of day",
        Family::Text | Family::Character => "text",
    }
}
