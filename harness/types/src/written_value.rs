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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_literal_lacks_its_type_where_the_language_lets_it() {
        for (typed, literal) in [
            ("WORD#16#ff", "16#00FF"),
            ("INT#-5", "-5"),
            ("BOOL#TRUE", "TRUE"),
            ("STRING#'a'", "'a'"),
            ("TIME#1s500ms", "TIME#1500ms"),
            ("COLOR#RED", "COLOR#RED"),
        ] {
            assert_eq!(&*WrittenValue::of(Value::parse(typed).unwrap()).literal, literal);
        }
    }

    #[test]
    fn a_literal_is_kept_as_it_is_spelled() {
        for (ty, literal, value) in [
            (ElementaryType::Real, "16777217.0", "REAL#16777216.0"),
            (ElementaryType::Time, "TIME#1.5ms", "TIME#1.5ms"),
            (ElementaryType::Word, "16#ff", "WORD#16#00FF"),
        ] {
            let written = WrittenValue::parse(ty, literal).unwrap();
            assert_eq!(
                (&*written.literal, written.value.to_string().as_str()),
                (literal, value)
            );
        }
        assert!(WrittenValue::parse(ElementaryType::Sint, "128").is_err());
    }
}
