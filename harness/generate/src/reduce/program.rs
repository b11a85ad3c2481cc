//! Reduction of programs of the model: of their texts, by the passes of [`stickler_reduce`].
//!
//! A text that the [reader](crate::reader) does not read back, or that the reference rejects for a new reason, is no candidate. So
//! every candidate is a well-typed program. Whether it ends and avoids what documents leave open, the predicate must ask the
//! evaluator before it starts an engine.

#[cfg(test)]
mod tests;

use crate::model::Program;
use crate::reader::read;
use crate::writer::{Style, write};
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;
use stickler_reduce::{
    CandidateJudge, Interestingness, METHOD, Reduction, ReductionBudget, ReferenceRules, TextDraft,
    TextRules, TextState, minimise,
};
use stickler_types::DialectName;

/// Makes a program as small as possible while it stays interesting.
///
/// The judge, which may be asked about several programs at a time, is asked about `start` first, and then about each candidate. It should answer [`Interestingness::Invalid`]
/// if the evaluator refuses the program or meets an open question, and ask an engine only about other candidates. The result
/// is the same for the same answers.
pub fn program(
    start: &Program,
    judge: &mut dyn CandidateJudge<Program>,
    budget: &ReductionBudget<'_>,
) -> Reduction<Program> {
    let text = write(start, &Style::default()).text;
    let rules = Rc::new(ReadableTexts(unless_it_panics(|| {
        ReferenceRules::new(&text, start.dialect)
    })));
    let draft = TextDraft::new(&text, start.dialect, rules);
    let mut judge = ProgramJudge {
        start,
        text,
        admitted: Vec::new(),
        judge,
    };
    let found = minimise(draft, &METHOD, &mut judge, budget);
    found.map(|draft| judge.program(&draft).unwrap_or_else(|| start.clone()))
}

/// Judges texts as the programs that they are.
struct ProgramJudge<'j> {
    start: &'j Program,
    /// The text of the start, which is judged as it is.
    text: String,
    /// The programs that were admitted and are judged next.
    admitted: Vec<Program>,
    judge: &'j mut dyn CandidateJudge<Program>,
}

impl ProgramJudge<'_> {
    /// Returns the program that a text is; `None` where it is none, or not allowed.
    fn program(&self, draft: &TextDraft) -> Option<Program> {
        match draft.text() == self.text {
            true => Some(self.start.clone()),
            false if draft.is_allowed() => read(draft.text(), draft.dialect()),
            false => None,
        }
    }
}

impl CandidateJudge<TextDraft> for ProgramJudge<'_> {
    fn admits(&mut self, draft: &TextDraft) -> bool {
        let program = self.program(draft);
        let admitted = program.filter(|program| self.judge.admits(program));
        let is_admitted = admitted.is_some();
        self.admitted.extend(admitted);
        is_admitted
    }

    fn judge(&mut self, _: &[TextDraft]) -> Vec<Interestingness> {
        self.judge.judge(&std::mem::take(&mut self.admitted))
    }

    fn pack_size(&self) -> usize {
        self.judge.pack_size()
    }
}

/// Allows the texts that are programs of the model and that the reference accepts, or rejects as the first one; where it panics,
/// that may be the symptom. `None` where it panicked over the first one.
struct ReadableTexts(Option<ReferenceRules>);

impl TextRules for ReadableTexts {
    fn allow(&self, text: &str, dialect: DialectName) -> bool {
        let is_allowed = |rules: &ReferenceRules| unless_it_panics(|| rules.allow(text, dialect));
        self.0.as_ref().and_then(is_allowed).unwrap_or(true) && read(text, dialect).is_some()
    }

    fn start(&self) -> TextState {
        self.0.as_ref().map_or(TextState::Accepted, ReferenceRules::start)
    }

    fn values(&self, text: &str, dialect: DialectName, scans: u32) -> HashMap<String, String> {
        let values = |rules: &ReferenceRules| unless_it_panics(|| rules.values(text, dialect, scans));
        self.0.as_ref().and_then(values).unwrap_or_default()
    }
}

fn unless_it_panics<R>(ask: impl FnOnce() -> R) -> Option<R> {
    catch_unwind(AssertUnwindSafe(ask)).ok()
}
