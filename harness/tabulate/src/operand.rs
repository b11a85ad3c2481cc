//! A value as a program writes it: the operands of the calls that the tables make.

use stickler_types::{ElementaryType, Value};

/// A value together with the literals that a program writes for it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Operand {
    /// The value.
    pub value: Value,
    /// What stands behind `:=` in a declaration: the untyped literal, or the type's own where there is none.
    pub literal: String,
    /// The typed literal.
    pub typed: String,
}

impl Operand {
    /// A value in its canonical spelling.
    #[must_use]
    pub fn of(value: Value) -> Operand {
        let typed = value.to_string();
        let literal = match typed.split_once('#') {
            Some((_, untyped)) if has_untyped_literal(&value) => untyped.to_owned(),
            _ => typed.clone(),
        };
        Operand {
            value,
            literal,
            typed,
        }
    }

    /// A number of an integer or bit string type, or of BOOL; taken modulo 2^n where the type does not hold it.
    #[must_use]
    pub fn number(ty: ElementaryType, number: i128) -> Operand {
        Operand::of(Value::plain(ty, ty.wrap(number)))
    }

    /// The value that a literal stands for in a variable of this type, in the canonical spelling.
    ///
    /// # Panics
    /// Where the type has no such literal: the lists of inputs belong to this program, and such an entry is its mistake.
    #[must_use]
    pub fn read(ty: ElementaryType, literal: &str) -> Operand {
        Operand::of(value(ty, literal))
    }

    /// The same, but programs write it just as it stands here.
    ///
    /// # Panics
    /// As [`Operand::read`].
    #[must_use]
    pub fn written(ty: ElementaryType, literal: &str) -> Operand {
        let value = value(ty, literal);
        let typed = match literal.split_once('#') {
            Some((prefix, _)) if ElementaryType::from_literal_prefix(prefix) == Some(ty) => {
                literal.to_owned()
            }
            _ => format!("{ty}#{literal}"),
        };
        Operand {
            value,
            literal: literal.to_owned(),
            typed,
        }
    }

    /// The raw form; 0 of a text.
    #[must_use]
    pub fn raw(&self) -> u64 {
        match self.value {
            Value::Plain { raw, .. } => raw,
            Value::Text { .. } | Value::Enumerated { .. } => 0,
        }
    }
}

fn has_untyped_literal(value: &Value) -> bool {
    match value {
        Value::Plain { ty, .. } => !(ty.is_duration() || ty.is_date_or_time()),
        Value::Text { .. } => true,
        Value::Enumerated { .. } => false,
    }
}

fn value(ty: ElementaryType, literal: &str) -> Value {
    let parsed = match literal.split_once('#') {
        Some((prefix, _)) if ElementaryType::from_literal_prefix(prefix) == Some(ty) => Value::parse(literal),
        _ => Value::parse(&format!("{ty}#{literal}")),
    };
    parsed.unwrap_or_else(|error| panic!("the inputs of {ty} have the entry `{literal}`: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operands_have_an_untyped_literal_where_the_language_has_one() {
        let operand = Operand::read(ElementaryType::Word, "16#ff");
        assert_eq!((&*operand.literal, &*operand.typed), ("16#00FF", "WORD#16#00FF"));
        let operand = Operand::read(ElementaryType::Time, "1s500ms");
        assert_eq!(
            (&*operand.literal, &*operand.typed),
            ("TIME#1500ms", "TIME#1500ms")
        );
    }

    #[test]
    fn a_literal_can_be_kept_as_it_is_written() {
        let operand = Operand::written(ElementaryType::String, "'$N'");
        assert_eq!((&*operand.literal, &*operand.typed), ("'$N'", "STRING#'$N'"));
        assert_eq!(
            operand.value,
            Operand::read(ElementaryType::String, "'$0A'").value
        );
    }
}
