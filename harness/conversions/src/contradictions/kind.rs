//! The kinds of questions, by which contradictions are grouped.

use stickler_types::{ElementaryType, Family, Question};

/// Returns the kind of a question, in words: all conversions of real numbers to integers are one.
pub(super) fn kind_of(question: &Question) -> String {
    match question {
        Question::Implicit(_) => "implicit conversion".to_owned(),
        Question::Part(..) => "bits and parts of variables".to_owned(),
        Question::Comparison(_) => "comparison of two types".to_owned(),
        Question::Call(call) => {
            let operand = call.operands.first().map(|operand| operand.type_name());
            match (operand.and_then(ElementaryType::from_name), &call.function) {
                (Some(from), name) if name.contains("TO_") && !name.contains("BCD") => {
                    format!("conversion, {} to {}", family(from), family(call.result))
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
