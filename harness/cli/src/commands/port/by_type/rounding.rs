//! Suggests how to round a REAL in the other dialect as the one does that makes an integer of it.

use super::{Operation, Typed};
use stickler_syntax::tree::ExpressionId;
use stickler_types::ElementaryType::{self, Real};
use stickler_types::Value;

/// Returns expressions for the number `{x}` and the type `{to}`, one of which may do in the other dialect what a conversion function does in the one.
fn roundings() -> impl Iterator<Item = &'static str> {
    let lines = include_str!("roundings.txt").lines();
    lines.filter(|line| !line.starts_with('#'))
}

/// Returns an expression that makes an integer of a number.
fn made(rounding: &str, number: &str, to: &str) -> String {
    rounding.replace("{x}", number).replace("{to}", to)
}

impl Typed<'_> {
    /// Returns what gives in the other dialect what a conversion gives in the one, for all boundary values: of literals the result, and
    /// otherwise the conversion of an operand that was rounded before. `None` where none is known.
    pub(super) fn rounded(
        &mut self,
        operation: &Operation,
        to: ElementaryType,
        result: Option<Value>,
    ) -> Option<String> {
        let mut is_same = |other: String| matches!(self.compare(operation, to, other), Some(None));
        let operand = match operation.operands[..] {
            [] => return Some(result?.to_string()).filter(|result| is_same(result.clone())),
            [(operand, Real)] => operand,
            _ => return None,
        };
        let written = |rounding: &str, operand: &str| made(rounding, operand, to.name());
        let found = roundings().find(|rounding| is_same(written(rounding, "operand0")))?;
        let is_once = found.matches("{x}").count() == 1 || self.is_pure(operand);
        is_once.then(|| written(found, &self.remedied(operand)))
    }

    /// Returns whether an expression may be written twice, since it calls nothing but standard functions.
    fn is_pure(&self, id: ExpressionId) -> bool {
        let id = self.bare(id);
        match self.operation(id) {
            Some(operation) => operation
                .operands
                .iter()
                .all(|(operand, _)| self.is_pure(*operand)),
            None => !self.text_of(id).contains('('),
        }
    }

    /// Returns whether an operation is, or is part of, what makes an integer of a REAL so that it is the same everywhere.
    pub(super) fn is_rounded(&self, operation: &Operation) -> bool {
        let text = self.text_of(operation.id);
        let to = operation.function.rsplit('_').next().unwrap_or_default();
        let rest = text.split_once("REAL_TO_LREAL(").map_or("", |(_, rest)| rest);
        let mut numbers = rest.match_indices(')').map(|(end, _)| &rest[..end]);
        numbers.any(|number| roundings().any(|rounding| made(rounding, number, to).contains(text)))
    }
}
