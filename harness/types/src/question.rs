//! The question that a program asks a compiler, as a value.

use crate::{ElementaryType, Value, WrittenValue};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

/// Two types: of a value and of the variable to which it goes, or of the two sides of a comparison.
pub type TypePair = (ElementaryType, ElementaryType);

/// A question about the conversions of a compiler.
///
/// Its text is what [`Question::to_string`] writes and `parse` reads: `implicit(INT,DINT)`, `bits(WORD,%X7)`, `less(INT,UINT)`,
/// `REAL_TO_INT(REAL#2.5) : INT`.
#[derive(Clone, PartialEq, Debug)]
pub enum Question {
    /// Whether a variable of the second type takes a value of the first.
    Implicit(TypePair),
    /// Whether a variable of the type has this bit or part: `7`, `%X7` or `%B1`.
    Part(ElementaryType, String),
    /// Whether a value of the first type is less than one of the second.
    Comparison(TypePair),
    /// The result of a call.
    Call(ConversionCall),
}

/// A call of a function with values.
#[derive(Clone, PartialEq, Debug)]
pub struct ConversionCall {
    /// The name of the function in upper case.
    pub function: String,
    /// The operands.
    pub operands: Vec<Value>,
    /// The type of the variable that takes the result.
    pub result: ElementaryType,
}

/// The error for a text that is no question.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error(
    "`{0}` is no question such as `implicit(INT,DINT)`, `bits(WORD,%X7)`, `less(INT,UINT)` or `REAL_TO_INT(REAL#2.5) : INT`"
)]
pub struct UnknownQuestion(String);

/// Returns whether a text names a bit or a part of a variable, as it stands after the variable and its dot: `7`, `%X7`, `%B1`.
pub fn is_part(text: &str) -> bool {
    let index = match text.strip_prefix('%') {
        Some(sized) => sized.strip_prefix(['X', 'B', 'W', 'D', 'L']),
        None => Some(text),
    };
    index.is_some_and(|index| !index.is_empty() && index.bytes().all(|byte| byte.is_ascii_digit()))
}

impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Question::Implicit((from, into)) => write!(f, "implicit({from},{into})"),
            Question::Part(ty, part) => write!(f, "bits({ty},{part})"),
            Question::Comparison((left, right)) => write!(f, "less({left},{right})"),
            Question::Call(call) => write!(f, "{call} : {}", call.result),
        }
    }
}

impl fmt::Display for ConversionCall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}(", self.function)?;
        for (index, operand) in self.operands.iter().enumerate() {
            let separator = if index > 0 { ", " } else { "" };
            write!(f, "{separator}{operand}")?;
        }
        write!(f, ")")
    }
}

impl FromStr for Question {
    type Err = UnknownQuestion;

    /// Parses the text of a question. The literal of an operand may have its type twice, as in `TIME#T#5ms`.
    fn from_str(text: &str) -> Result<Question, UnknownQuestion> {
        parsed(text).ok_or_else(|| UnknownQuestion(text.to_owned()))
    }
}

fn parsed(text: &str) -> Option<Question> {
    let (name, rest) = text.split_once('(')?;
    let types = |rest: &str| {
        let (first, second) = rest.strip_suffix(')')?.split_once(',')?;
        Some((ElementaryType::declared(first)?, second.to_owned()))
    };
    let pair = |rest: &str| {
        let (first, second) = types(rest)?;
        Some((first, ElementaryType::declared(&second)?))
    };
    match name {
        "implicit" => pair(rest).map(Question::Implicit),
        "less" => pair(rest).map(Question::Comparison),
        "bits" => {
            let (ty, part) = types(rest)?;
            is_part(&part).then_some(Question::Part(ty, part))
        }
        function => {
            let (operands, result) = rest.rsplit_once(") : ")?;
            // A text may hold the separator, and no function takes a text beside another operand.
            let operands = match operand(operands) {
                Some(only) => vec![only],
                None => operands.split(", ").map(operand).collect::<Option<_>>()?,
            };
            let is_name = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
            (!function.is_empty() && function.bytes().all(is_name)).then_some(Question::Call(
                ConversionCall {
                    function: function.to_ascii_uppercase(),
                    operands,
                    result: ElementaryType::declared(result)?,
                },
            ))
        }
    }
}

/// Parses a literal behind the name of its type.
fn operand(text: &str) -> Option<Value> {
    let (ty, literal) = text.split_once('#')?;
    let written = WrittenValue::parse(ElementaryType::from_literal_prefix(ty)?, literal);
    Some(written.ok()?.value)
}

impl Serialize for Question {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Question {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Question, D::Error> {
        let text = Cow::<'de, str>::deserialize(deserializer)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}
