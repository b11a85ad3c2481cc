//! Memory cells, one for each elementary variable.

use super::{Question, Refusal};
use stickler_types::{ElementaryType, Value};

/// What one elementary variable holds.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Cell {
    /// The raw form of a value (see [`ElementaryType`]), the place of an enumerated value, or the address behind an in-out.
    Plain(u64),
    /// The code units of a text.
    Text(Box<[u16]>),
    /// Something that no document settles, until it is assigned; the number is a guess, the question why it is one.
    Unsettled(u64, Question),
}

impl Cell {
    /// The value of an elementary type.
    pub fn into_value(self, ty: ElementaryType) -> Result<Value, Refusal> {
        match self {
            Cell::Plain(raw) | Cell::Unsettled(raw, _) if !ty.is_text() => Ok(Value::plain(ty, raw)),
            Cell::Text(units) if ty.is_text() => Ok(Value::text(ty, units.into_vec())),
            _ => Err(Refusal::IllFormed("a text where there is none")),
        }
    }

    /// The cell of an elementary value.
    pub fn of_value(value: Value) -> Result<Cell, Refusal> {
        match value {
            Value::Plain { raw, .. } => Ok(Cell::Plain(raw)),
            Value::Text { units, .. } => Ok(Cell::Text(units.into_boxed_slice())),
            Value::Enumerated { .. } => Err(Refusal::IllFormed("an enumerated value where a literal stands")),
        }
    }
}
