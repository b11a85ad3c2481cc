//! The reference's own conversion, by the same functions that its machine calls.

use crate::sweep::converter::Converter;
use stickler_exact::Signature;
use stickler_reference::Dialect;
use stickler_reference::conversion::{Concatenation, Conversion, concatenation, function};
use stickler_types::{DialectName, ElementaryType, Value};

/// A conversion function of the reference between fixed types, with the rules of a dialect.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Reference {
    kind: Kind,
    result: ElementaryType,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Kind {
    One(Conversion),
    Two(Concatenation),
}

impl Reference {
    /// Finds the conversion of a function between these types; `None` where the reference has no such function.
    #[must_use]
    pub fn find(signature: &Signature, dialect: DialectName) -> Option<Reference> {
        let dialect = Dialect::of(dialect);
        let (name, result) = (&signature.function[..], signature.result);
        let kind = match signature.operands[..] {
            [operand] => {
                let found = function(name, &dialect)?;
                let takes = found.accepts(operand) && found.results(operand).any(|ty| ty == result);
                takes.then(|| Kind::One(found.conversion(operand, result)))?
            }
            [first, second] => {
                let found = concatenation(name, &dialect)?;
                (found.operands == [first, second] && found.result == result).then_some(Kind::Two(found))?
            }
            _ => return None,
        };
        Some(Reference { kind, result })
    }
}

impl Converter for Reference {
    fn convert_all(&self, operands: &[u64], results: &mut [u64]) {
        let Kind::One(conversion) = self.kind else {
            return results.fill(0);
        };
        conversion.apply_to_slice(operands, results);
    }

    fn convert(&self, operands: &[Value]) -> Value {
        let plain = |raw| Value::plain(self.result, raw);
        let to_text = self.result.is_text();
        match (self.kind, operands) {
            (Kind::One(conversion), [Value::Plain { raw, .. }]) if to_text => {
                Value::text(self.result, conversion.apply_to_text(*raw))
            }
            (Kind::One(conversion), [Value::Plain { raw, .. }]) => plain(conversion.apply(*raw)),
            (Kind::One(conversion), [Value::Text { units, .. }]) if to_text => {
                Value::text(self.result, conversion.text_to_text(units))
            }
            (Kind::One(conversion), [Value::Text { units, .. }]) => plain(conversion.apply_from_text(units)),
            (Kind::Two(join), [Value::Plain { raw: first, .. }, Value::Plain { raw: second, .. }]) => {
                plain(join.apply_two(*first, *second))
            }
            // No domain has other operands.
            _ => plain(0),
        }
    }
}
