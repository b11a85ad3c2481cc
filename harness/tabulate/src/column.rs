//! The columns of a sheet: what of a call stands in which cell.

use crate::call::Call;
use stickler_types::ElementaryType;

/// A column of a sheet.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Column {
    /// The name of the function.
    Function,
    /// The type of the operand.
    From,
    /// The type of the result.
    To,
    /// The operand as a declaration initializes a variable with it.
    Input,
    /// The operand as a typed literal.
    Typed,
    /// The type of the second operand.
    SecondFrom,
    /// The second operand as a declaration initializes a variable with it.
    Second,
    /// What stands in the id where the cells would be too long: the function and the operand.
    Id,
    /// A number of the operand's type whose square is infinite.
    Huge,
    /// An expression with `huge` that makes an operand that no literal can write: NaN, an infinity, and -0.0 for those who read
    /// its literal as 0.0.
    Made,
    /// The result as a typed literal, for the dialects in which a probe asserts it.
    Expected,
}

impl Column {
    /// The name of the column, which is also its placeholder.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Column::Function => "function",
            Column::From => "from",
            Column::To => "to",
            Column::Input => "input",
            Column::Typed => "typed",
            Column::SecondFrom => "with",
            Column::Second => "second",
            Column::Id => "id",
            Column::Huge => "huge",
            Column::Made => "made",
            Column::Expected => "expected",
        }
    }

    /// The cell of a call, `expected` being the literal that the probes of its table agree on.
    #[must_use]
    pub fn cell(self, call: &Call, expected: &str) -> String {
        let operand = |at: usize| call.operands.get(at);
        match self {
            Column::Function => call.signature.function.clone(),
            Column::From => call.from().to_string(),
            Column::To => call.to().to_string(),
            Column::Input => operand(0).map_or_else(String::new, |operand| operand.literal.clone()),
            Column::Typed => operand(0).map_or_else(String::new, |operand| operand.typed.clone()),
            Column::SecondFrom => {
                operand(1).map_or_else(String::new, |operand| operand.value.type_name().to_owned())
            }
            Column::Second => operand(1).map_or_else(String::new, |operand| operand.literal.clone()),
            Column::Id => format!(
                "{}/{}",
                call.signature.function,
                operand(0).map_or("", |operand| &operand.typed)
            ),
            Column::Huge if call.from() == ElementaryType::Real => "3.0E38".to_owned(),
            Column::Huge => "1.0E308".to_owned(),
            Column::Made => match operand(0).map(|operand| &*operand.literal) {
                Some("Infinity") => "huge * huge".to_owned(),
                Some("-Infinity") => "-huge * huge".to_owned(),
                Some("-0.0") => "-1.0 / (huge * huge)".to_owned(),
                _ => "huge * huge - huge * huge".to_owned(),
            },
            Column::Expected => expected.to_owned(),
        }
    }
}
