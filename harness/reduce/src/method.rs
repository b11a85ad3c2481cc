//! The order of the passes over a text, and the functions that run them.

use crate::draft::{self, TextDraft};
use crate::passes::literals::{LiteralStep, drop_types, lessen};
use crate::passes::{arrays, chunks, declarations, expressions, initial_values, parameters, statements};
use crate::rules::ReferenceRules;
use crate::{
    CandidateJudge, Interestingness, Pass, Reduction, ReductionBudget, ReductionMethod, StopReason, minimise,
    text_pass,
};
use std::rc::Rc;
use stickler_types::DialectName;

/// The passes for texts: first those that remove many lines, last those that simplify a literal.
pub const PASSES: &[Pass<TextDraft>] = &[
    text_pass!("drop comments", chunks::drop_comments),
    text_pass!("drop statements", statements::drop_statements),
    text_pass!("drop empty statements", statements::drop_empty_statements),
    text_pass!("remove statements", statements::remove_statements),
    text_pass!("drop program organization units", declarations::drop_units),
    text_pass!("drop what is not used", declarations::drop_unused),
    text_pass!(
        "make a function block or a function the program",
        declarations::unit_to_program
    ),
    text_pass!("replace statements by what they guard", statements::splice),
    text_pass!("drop branches", statements::drop_branches),
    text_pass!("forget variables", declarations::forget_variables),
    text_pass!("drop parameters", parameters::forget_parameters),
    text_pass!("give arguments by position", parameters::forget_names),
    text_pass!("drop sections and methods", declarations::drop_sections),
    text_pass!("make variables plain", declarations::plain_sections),
    text_pass!("join sections", declarations::join_sections),
    text_pass!("drop empty sections", chunks::drop_empty_sections),
    text_pass!(
        "replace expressions by typed literals",
        expressions::to_typed_literal
    ),
    text_pass!("replace conditions by TRUE", expressions::to_true),
    text_pass!("replace expressions by literals", expressions::to_literal),
    text_pass!("replace variables by their last values", |view| {
        expressions::to_value(view, 1)
    }),
    text_pass!("replace variables by their first values", |view| {
        expressions::to_value(view, 0)
    }),
    text_pass!("replace calls by what they change", expressions::call_to_value),
    text_pass!("give functions a plain result", declarations::plain_results),
    text_pass!("replace expressions by variables", expressions::to_variable),
    text_pass!(
        "replace variables by others of their type",
        declarations::share_variables
    ),
    text_pass!("drop what is not used any more", declarations::drop_unused),
    text_pass!("replace expressions by their first operands", |view| {
        expressions::to_operand(view, 0)
    }),
    text_pass!("replace expressions by their second operands", |view| {
        expressions::to_operand(view, 1)
    }),
    text_pass!("replace expressions by their third operands", |view| {
        expressions::to_operand(view, 2)
    }),
    text_pass!("drop arguments", expressions::drop_arguments),
    text_pass!("drop initial values", declarations::drop_initials),
    text_pass!("assign initial values", initial_values::assign_initials),
    text_pass!("drop fields", initial_values::forget_fields),
    text_pass!("shorten arrays", initial_values::shorten_arrays),
    text_pass!("drop repetitions", initial_values::drop_repetitions),
    text_pass!("resolve types", declarations::resolve_types),
    text_pass!("unwrap arrays", arrays::unwrap_arrays),
    text_pass!("unwrap structures", arrays::unwrap_structures),
    text_pass!("unwrap bits", arrays::unwrap_bits),
    text_pass!("drop dimensions", arrays::drop_dimensions),
    text_pass!("drop lines", chunks::drop_lines),
    text_pass!("drop tokens", chunks::drop_tokens),
    text_pass!("drop characters", chunks::drop_characters),
    text_pass!("write numbers in decimal", |view| lessen(
        view,
        LiteralStep::Decimal
    )),
    text_pass!("drop the types of literals", drop_types),
    text_pass!("make literals zero", |view| lessen(view, LiteralStep::Zero)),
    text_pass!("make literals one", |view| lessen(view, LiteralStep::One)),
    text_pass!("halve literals", |view| lessen(view, LiteralStep::Half)),
    text_pass!("keep the second half of texts", |view| lessen(
        view,
        LiteralStep::Rest
    )),
    text_pass!("lessen literals", |view| lessen(view, LiteralStep::Less)),
];

/// The passes for texts, with the weight by which a text is smaller than another.
pub const METHOD: ReductionMethod<TextDraft> = ReductionMethod {
    passes: PASSES,
    weight: draft::weight,
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
    text_in_packs(start, dialect, &mut |text: &String| interesting(text), budget)
}

/// Makes a source text as small as possible, like [`text`], with a judge that may be asked about several candidates at a time.
pub fn text_in_packs(
    start: &str,
    dialect: DialectName,
    judge: &mut dyn CandidateJudge<String>,
    budget: &ReductionBudget<'_>,
) -> Reduction<String> {
    let rules = Rc::new(ReferenceRules::new(start, dialect));
    let draft = TextDraft::new(start, dialect, rules);
    let found = minimise(draft, &METHOD, &mut AllowedTexts(&mut *judge), budget);
    let mut found = found.map(|draft| draft.text().to_owned());
    if found.ended == StopReason::Smallest
        && let Ok(rendered) = stickler_reference::render(&found.value, dialect)
        && rendered != found.value
    {
        found.tries += 1;
        if judge.admits(&rendered)
            && judge.judge(std::slice::from_ref(&rendered)) == [Interestingness::Interesting]
        {
            found.value = rendered;
        }
    }
    found
}

/// A judge of texts that admits only those which keep the rules of their reduction.
struct AllowedTexts<'j>(&'j mut dyn CandidateJudge<String>);

impl CandidateJudge<TextDraft> for AllowedTexts<'_> {
    fn admits(&mut self, draft: &TextDraft) -> bool {
        draft.is_allowed() && self.0.admits(&draft.text().to_owned())
    }

    fn judge(&mut self, drafts: &[TextDraft]) -> Vec<Interestingness> {
        let texts: Vec<String> = drafts.iter().map(|draft| draft.text().to_owned()).collect();
        self.0.judge(&texts)
    }

    fn pack_size(&self) -> usize {
        self.0.pack_size()
    }
}
