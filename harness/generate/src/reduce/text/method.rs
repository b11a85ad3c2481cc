//! The order of the passes over a source text, and the function that runs them.

use super::draft::{self, TextDraft};
use super::{arrays, chunks, declarations, expressions, statements, values};
use crate::reduce::search::pass;
use crate::reduce::{Interestingness, Reduction, ReductionBudget, ReductionMethod, StopReason, minimise};
use stickler_types::DialectName;

/// The passes for texts: first those that remove many lines, last those that simplify a literal.
const METHOD: ReductionMethod<TextDraft> = ReductionMethod {
    passes: &[
        pass("drop comments", chunks::drop_comments),
        pass("drop statements", statements::drop_statements),
        pass("drop empty statements", statements::drop_empty_statements),
        pass("drop program organization units", declarations::drop_units),
        pass("drop what is not used", declarations::drop_unused),
        pass(
            "make a function block the program",
            declarations::block_to_program,
        ),
        pass("replace statements by what they guard", statements::splice),
        pass("drop branches", statements::drop_branches),
        pass("forget variables", declarations::forget_variables),
        pass("drop sections", declarations::drop_sections),
        pass("drop empty sections", chunks::drop_empty_sections),
        pass(
            "replace expressions by typed literals",
            expressions::to_typed_literal,
        ),
        pass("replace expressions by literals", expressions::to_literal),
        pass("replace variables by their last values", values::to_final_value),
        pass(
            "replace variables by their first values",
            values::to_initial_value,
        ),
        pass("drop what is not used any more", declarations::drop_unused),
        pass(
            "replace expressions by their first operands",
            expressions::to_first_operand,
        ),
        pass(
            "replace expressions by their second operands",
            expressions::to_second_operand,
        ),
        pass(
            "replace expressions by their third operands",
            expressions::to_third_operand,
        ),
        pass("drop arguments", expressions::drop_arguments),
        pass("drop initial values", declarations::drop_initials),
        pass("resolve types", declarations::resolve_types),
        pass("unwrap arrays", arrays::unwrap_arrays),
        pass("drop dimensions", arrays::drop_dimensions),
        pass("drop lines", chunks::drop_lines),
        pass("drop words", chunks::drop_words),
        pass("drop characters", chunks::drop_characters),
        pass("write numbers in decimal", expressions::literals_to_decimal),
        pass("make literals zero", expressions::literals_to_zero),
        pass("make literals one", expressions::literals_to_one),
        pass("halve literals", expressions::halve_literals),
        pass("lessen literals", expressions::lessen_literals),
    ],
    weight: draft::weight,
    key: draft::key,
};

/// Makes a source text as small as possible while it stays interesting.
///
/// `interesting` is asked about `start` first, and then about each candidate. A candidate of a text that the reference
/// accepts is accepted too; a candidate of a rejected text is rejected for no other reason, or accepted. So no program
/// becomes ill-formed on the way. The result is the same for the same answers; it is formatted by the renderer if it stays
/// interesting.
pub fn text(
    start: &str,
    dialect: DialectName,
    mut interesting: impl FnMut(&str) -> Interestingness,
    budget: &ReductionBudget<'_>,
) -> Reduction<String> {
    let mut ask = |draft: &TextDraft| {
        if draft.is_allowed() {
            interesting(&draft.text)
        } else {
            Interestingness::Invalid
        }
    };
    let mut found = minimise(TextDraft::new(start, dialect), &METHOD, &mut ask, budget);
    if found.ended == StopReason::Smallest
        && let Ok(rendered) = stickler_reference::render(&found.value.text, dialect)
        && rendered != found.value.text
    {
        found.tries += 1;
        if interesting(&rendered) == Interestingness::Interesting {
            found.value.text = rendered;
        }
    }
    Reduction {
        value: found.value.text,
        tries: found.tries,
        refused: found.refused,
        ended: found.ended,
    }
}
