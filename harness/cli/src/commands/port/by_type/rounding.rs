//! Suggests how to round a REAL in the other dialect as the one does that makes an integer of it.

use super::{Operation, Typed};
use stickler_reference::conversion::conversion_function_name;
use stickler_syntax::tree::ExpressionId;
use stickler_types::ElementaryType::{Lreal, Real};
use stickler_types::{Dialect, ElementaryType, Value};

/// Returns the expressions that round `{x}`, one of which may do in the other dialect what a conversion function does in the one.
fn roundings() -> impl Iterator<Item = &'static str> {
    let lines = include_str!("roundings.txt").lines();
    lines.filter(|line| !line.starts_with('#'))
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
        let dialect = Dialect::of(self.dialects[1]);
        let mut is_same = |other: String| matches!(self.compare(operation, to, other), Some(None));
        let operand = match operation.operands[..] {
            [] => return Some(result?.to_string()).filter(|result| is_same(result.clone())),
            [(operand, Real)] => operand,
            _ => return None,
        };
        let widen = conversion_function_name(Real, Lreal, dialect)?;
        let convert = conversion_function_name(Lreal, to, dialect)?;
        let written = |rounding: &str, operand: &str| {
            let rounded = rounding.replace("{x}", &format!("{widen}({operand})"));
            format!("{convert}({rounded})")
        };
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

    /// Returns whether an operation converts what was rounded before, which is the same integer everywhere.
    pub(super) fn is_rounded(&self, operation: &Operation) -> bool {
        let [(operand, _)] = operation.places[..] else {
            return false;
        };
        let text = self.text_of(operand);
        let mut numbers = text.match_indices(' ').map(|(end, _)| &text[..end]);
        numbers.any(|number| roundings().any(|rounding| rounding.replace("{x}", number) == text))
    }
}
