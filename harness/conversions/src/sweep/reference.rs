//! The reference's own conversion, by the same functions that its machine calls.

use crate::sweep::comparison::Converter;
use stickler_exact::{Operation, Signature};
use stickler_reference::conversion::{Concatenation, Conversion, concatenation, function};
use stickler_reference::execution::{UnaryFunction, length};
use stickler_types::{Dialect, DialectName, ElementaryType, Value};

/// A conversion function of the reference between fixed types, with the rules of a dialect.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ReferenceFunction {
    kind: ReferenceFunctionKind,
    result: ElementaryType,
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum ReferenceFunctionKind {
    One(Conversion),
    Two(Concatenation),
    Standard(UnaryFunction),
}

impl ReferenceFunction {
    /// Finds the conversion of a function between these types; `None` where the reference has no such function.
    pub fn find(signature: &Signature, dialect: DialectName) -> Option<ReferenceFunction> {
        let dialect = Dialect::of(dialect);
        let (name, result) = (&signature.function[..], signature.result);
        let kind = match signature.operands[..] {
            [operand] if signature.operation == Operation::Elementary => {
                ReferenceFunctionKind::Standard(UnaryFunction::find(name, operand)?)
            }
            [operand] => {
                let found = function(name, dialect)?;
                let takes = found.accepts(operand) && found.results(operand).any(|ty| ty == result);
                takes.then(|| ReferenceFunctionKind::One(found.conversion(operand, result)))?
            }
            [first, second] => {
                let found = concatenation(name, dialect)?;
                (found.operands == [first, second] && found.result == result)
                    .then_some(ReferenceFunctionKind::Two(found))?
            }
            _ => return None,
        };
        Some(ReferenceFunction { kind, result })
    }
}

impl Converter for ReferenceFunction {
    fn convert_all(&self, operands: &[u64], results: &mut [u64]) {
        match self.kind {
            ReferenceFunctionKind::One(conversion) => conversion.apply_to_slice(operands, results),
            ReferenceFunctionKind::Two(_) => results.fill(0),
            ReferenceFunctionKind::Standard(function) => {
                let operands = operands.iter().zip(results);
                operands.for_each(|(operand, result)| *result = function.apply(*operand));
            }
        }
    }

    fn convert(&self, operands: &[Value]) -> Value {
        let plain = |raw| Value::plain(self.result, raw);
        let to_text = self.result.is_text();
        match (self.kind, operands) {
            (ReferenceFunctionKind::One(conversion), [Value::Plain { raw, .. }]) if to_text => {
                Value::text(self.result, conversion.apply_to_text(*raw))
            }
            (ReferenceFunctionKind::One(conversion), [Value::Plain { raw, .. }]) => {
                plain(conversion.apply(*raw))
            }
            (ReferenceFunctionKind::One(conversion), [Value::Text { units, .. }]) if to_text => {
                Value::text(self.result, conversion.text_to_text(units))
            }
            (ReferenceFunctionKind::One(conversion), [Value::Text { units, .. }]) => {
                plain(conversion.apply_from_text(units))
            }
            (
                ReferenceFunctionKind::Two(join),
                [Value::Plain { raw: first, .. }, Value::Plain { raw: second, .. }],
            ) => plain(join.apply_two(*first, *second)),
            (ReferenceFunctionKind::Standard(function), [Value::Plain { raw, .. }]) => {
                plain(function.apply(*raw))
            }
            // LEN alone takes a text.
            (ReferenceFunctionKind::Standard(_), [Value::Text { units, .. }]) => plain(length(units)),
            // No domain has other operands.
            _ => plain(0),
        }
    }
}
