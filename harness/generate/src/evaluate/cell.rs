//! The contents of variables: a cell for each elementary value, and lists of cells for arrays, structures and units.

use super::{Evaluated, OpenQuestion, ill_formed};
use stickler_types::{ElementaryType, Value};

/// A place in memory: the number of a unit under execution, then that of a part, of a part of this one, and so on.
pub(super) type Address = Vec<usize>;

/// The content of a variable, or of a part of one.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum MemoryCell {
    /// The raw form of a value (see [`ElementaryType`]), or the index of an enumerated value.
    Plain(u64),
    /// The code units of a text.
    Text(Box<[u16]>),
    /// A value that no document settles, until the variable is assigned: a guess, and the question that it depends on.
    Unsettled(u64, OpenQuestion),
    /// The elements of an array, the last subscript varying fastest; the fields of a structure; or the variables of a unit, behind
    /// which stands the result of a function.
    Parts(Vec<MemoryCell>),
    /// The variable that an in-out stands for.
    Reference(Address),
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

    /// Creates the cell of a unit or a structure with so many parts, which get their contents afterwards.
    pub fn of_parts(number: usize) -> MemoryCell {
        MemoryCell::Parts(vec![MemoryCell::Plain(0); number])
    }

    /// Returns the number of elementary values.
    pub fn size(&self) -> usize {
        match self {
            MemoryCell::Parts(parts) => parts.iter().map(MemoryCell::size).sum(),
            _ => 1,
        }
    }
}
