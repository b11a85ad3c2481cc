//! Values together with the literals that spell them in programs.

use crate::{ElementaryType, LiteralError, Value};

/// A value with the literal that a program writes for it where its type is expected.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenValue {
    /// The literal without its type, or with it where the type has no other.
    pub literal: Box<str>,
    /// The value.
    pub value: Value,
}

impl WrittenValue {
    /// Returns a value with its canonical literal.
    pub fn of(value: Value) -> WrittenValue {
        WrittenValue {
            literal: value.literal().into(),
            value,
        }
    }

    /// Parses `literal`, which may lack its type, as a value of the type `ty`; keeps the literal as it is spelled.
    ///
    /// # Errors
    /// A [`LiteralError`] if the type has no such literal.
    pub fn parse(ty: ElementaryType, literal: &str) -> Result<WrittenValue, LiteralError> {
        let value = match literal.split_once('#') {
            Some((prefix, _)) if ElementaryType::from_literal_prefix(prefix) == Some(ty) => {
                Value::parse(literal)
            }
            _ => Value::parse(&format!("{ty}#{literal}")),
        };
        Ok(WrittenValue {
            literal: literal.into(),
            value: value?,
        })
    }
}
