//! Memory cells, one for each elementary variable.

use super::{Evaluated, OpenQuestion, ill_formed};
use stickler_types::{ElementaryType, Value};

/// The content of one elementary variable.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum MemoryCell {
    /// The raw form of a value (see [`ElementaryType`]), the index of an enumerated value, or the address of an in-out.
    Plain(u64),
    /// The code units of a text.
    Text(Box<[u16]>),
    /// A value that no document settles, until the variable is assigned: a guess, and the question that it depends on.
    Unsettled(u64, OpenQuestion),
}

impl MemoryCell {
    /// Converts the content to a value of an elementary type.
    pub fn into_value(self, ty: ElementaryType) -> Evaluated<Value> {
        match self {
            MemoryCell::Plain(raw) | MemoryCell::Unsettled(raw, _) if !ty.is_text() => {
                Ok(Value::plain(ty, raw))
            }
            MemoryCell::Text(units) if ty.is_text() => Ok(Value::text(ty, units.into_vec())),
            _ => Err(ill_formed("a text where a number is stored, or the reverse")),
        }
    }

    /// Creates the cell of an elementary value.
    pub fn of_value(value: Value) -> Evaluated<MemoryCell> {
        match value {
            Value::Plain { raw, .. } => Ok(MemoryCell::Plain(raw)),
            Value::Text { units, .. } => Ok(MemoryCell::Text(units.into_boxed_slice())),
            Value::Enumerated { .. } | Value::OutOfRange { .. } | Value::Near { .. } => {
                Err(ill_formed("a value without a literal of its own"))
            }
        }
    }
}
