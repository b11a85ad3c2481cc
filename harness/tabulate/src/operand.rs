//! Values as a program writes them: the operands of the calls in a table.

use stickler_types::{ElementaryType, Value};

/// A value together with the literals that a program writes for it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Operand {
    /// The value.
    pub value: Value,
    /// The literal behind `:=` in a declaration: the untyped one, or the type's own where there is none.
    pub literal: String,
    /// The typed literal.
    pub typed: String,
}

impl Operand {
    /// Returns the operand that writes a value in its canonical spelling.
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

    /// Returns the operand that writes its value as `literal` spells it, or nothing where the type has no such literal.
    #[must_use]
    pub fn written(ty: ElementaryType, literal: &str) -> Option<Operand> {
        let typed = match literal.split_once('#') {
            Some((prefix, _)) if ElementaryType::from_literal_prefix(prefix) == Some(ty) => {
                literal.to_owned()
            }
            _ => format!("{ty}#{literal}"),
        };
        Some(Operand {
            value: Value::parse(&typed).ok()?,
            literal: literal.to_owned(),
            typed,
        })
    }
}

fn has_untyped_literal(value: &Value) -> bool {
    match value {
        Value::Plain { ty, .. } => !(ty.is_duration() || ty.is_date_or_time()),
        Value::Text { .. } => true,
        Value::Enumerated { .. } => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operands_have_an_untyped_literal_where_the_language_has_one() {
        for (typed, literal) in [("WORD#16#00FF", "16#00FF"), ("TIME#1500ms", "TIME#1500ms")] {
            let operand = Operand::of(Value::parse(typed).unwrap());
            assert_eq!((&*operand.literal, &*operand.typed), (literal, typed));
        }
    }

    #[test]
    fn a_literal_is_kept_as_it_is_written() {
        let operand = Operand::written(ElementaryType::String, "'$N'").unwrap();
        assert_eq!((&*operand.literal, &*operand.typed), ("'$N'", "STRING#'$N'"));
        assert_eq!(operand.value, Value::parse("STRING#'$0A'").unwrap());
        let operand = Operand::written(ElementaryType::Time, "TIME#999us").unwrap();
        assert_eq!((&*operand.literal, &*operand.typed), ("TIME#999us", "TIME#999us"));
        assert_eq!(Operand::written(ElementaryType::Sint, "128"), None);
    }
}
