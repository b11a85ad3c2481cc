//! A record of the conversions and the bits of a program: where each stands in the tree and in the code.
//!
//! Made by [`check_traced`](super::check_traced()) for tools that explain or change a program at such a place; an ordinary check
//! keeps no record.

use crate::instruction::Label;
use stickler_syntax::tree::ExpressionId;
use stickler_types::ElementaryType;

/// A place of a program at which a value meets a type, or a bit is read or written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TracedUse {
    /// The expression that [`UseKind`] names.
    pub expression: ExpressionId,
    /// The kind of use.
    pub kind: UseKind,
    /// The label behind the code of the use: there the result lies on top of its stack, or the bit has been written. `None`
    /// where no code of its own is left, because it was folded into a constant.
    pub end: Option<Label>,
}

/// The kinds of use that are recorded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UseKind {
    /// The expression stands where a value of an elementary type is expected.
    Expected {
        /// The type of the expression; `None` for an untyped literal and for what is of no elementary type.
        from: Option<ElementaryType>,
        /// The type that is expected.
        to: ElementaryType,
        /// Whether the value may stand there.
        fits: bool,
    },
    /// The expression is an operand, which is converted to the type in which its operator computes.
    Operand {
        /// The type of the operand.
        from: ElementaryType,
        /// The type in which the operator computes.
        to: ElementaryType,
    },
    /// The expression is the variable that takes an output by `=>`.
    Captured {
        /// The type of the output.
        from: ElementaryType,
        /// The type of the variable.
        to: ElementaryType,
        /// Whether the output may go there.
        fits: bool,
    },
    /// The expression is the argument of a type conversion function.
    Converted {
        /// The type of the argument.
        from: ElementaryType,
        /// The type of the result.
        to: ElementaryType,
    },
    /// The expression selects a bit of a value of this type, and the bit is read.
    BitRead(ElementaryType),
    /// The expression selects a bit of a variable of this type, and the bit is written.
    BitWritten(ElementaryType),
}

/// The uses of a program in the order in which they are lowered.
#[derive(Debug, Default)]
pub(super) struct Trace(Vec<TracedUse>);

impl Trace {
    pub(super) fn push(&mut self, entry: TracedUse) {
        self.0.push(entry);
    }

    /// Notes that all code behind a label is gone.
    pub(super) fn truncate(&mut self, position: Label) {
        for entry in self.0.iter_mut().rev() {
            match entry.end {
                Some(end) if end <= position => break,
                _ => entry.end = None,
            }
        }
    }

    pub(super) fn finish(self) -> Vec<TracedUse> {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instruction::{Instruction, Part};
    use crate::semantics::check_traced;
    use stickler_syntax::source::LineIndex;
    use stickler_types::{Dialect, DialectName};

    /// Returns the uses of a program, each with the text of its expression, and the instruction before the label where it ends.
    fn uses(text: &str) -> Vec<(String, UseKind, Option<Instruction>)> {
        let dialect = Dialect::of(DialectName::IRONPLC_ED3);
        let (unit, errors) = stickler_syntax::parse(text, dialect);
        assert_eq!(errors, []);
        let (checked, _, uses) = check_traced(&unit, text, &LineIndex::new(text), dialect);
        let code = checked.map(|checked| checked.program.code).unwrap_or_default();
        let reported = |found: TracedUse| {
            let span = unit.expressions[found.expression.0 as usize].span;
            let text = text[span.start as usize..span.end as usize].to_owned();
            let last = found.end.and_then(|end| code.get(end as usize - 1)).copied();
            (text, found.kind, last)
        };
        uses.into_iter().map(reported).collect()
    }

    #[test]
    fn a_use_ends_where_its_value_lies_on_the_stack() {
        let text = "PROGRAM p VAR b : BYTE; i : INT; d : DINT; END_VAR d := i; b.3 := b.1; END_PROGRAM";
        let found = uses(text);
        let [
            (widened, UseKind::Expected { fits: true, .. }, Some(Instruction::Convert(_))),
            rest @ ..,
        ] = &found[..]
        else {
            panic!("{found:?}")
        };
        assert_eq!(widened, "i");
        let of = ElementaryType::Byte;
        let bit = |first| Part {
            first,
            ty: ElementaryType::Bool,
        };
        assert_eq!(
            rest[0],
            (
                "b.1".to_owned(),
                UseKind::BitRead(of),
                Some(Instruction::Part(bit(1)))
            )
        );
        let store = Instruction::StorePart { part: bit(3), of };
        assert_eq!(rest[2], ("b.3".to_owned(), UseKind::BitWritten(of), Some(store)));
    }

    #[test]
    fn what_is_folded_and_what_is_refused_is_recorded_without_code() {
        let text = "PROGRAM p VAR d : DINT; s : SINT; END_VAR d := SINT_TO_DINT(SINT#1); s := d; END_PROGRAM";
        let found = uses(text);
        let kinds: Vec<_> = found
            .iter()
            .map(|(text, kind, _)| (text.as_str(), *kind))
            .collect();
        let (from, to) = (ElementaryType::Dint, ElementaryType::Sint);
        assert!(kinds.contains(&(
            "d",
            UseKind::Expected {
                from: Some(from),
                to,
                fits: false
            }
        )));
        assert!(kinds.contains(&("SINT#1", UseKind::Converted { from: to, to: from })));
    }
}
