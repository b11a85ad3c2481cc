//! The judge of the programs that the passes to the normal form propose.

use super::NormalSearch;
use crate::question::until_interesting;
use stickler_engines::EngineError;
use stickler_reduce::{CandidateJudge, Interestingness, TextDraft};
use stickler_suite::Case;

/// The judge of the programs that may be the normal form.
pub(super) struct DraftJudge<'d, 's, 'e> {
    pub(super) search: &'d mut NormalSearch<'s, 'e>,
    /// Whether nothing was judged yet: the start is the normal form so far.
    pub(super) is_start: bool,
    /// The reason why the engine cannot be asked any more.
    pub(super) error: Option<EngineError>,
}

impl DraftJudge<'_, '_, '_> {
    /// Judges programs until one is the normal form: those behind it are judged again, as changes of it.
    fn judged(&mut self, drafts: &[TextDraft]) -> Result<Vec<Interestingness>, EngineError> {
        let cases = drafts.iter().map(|draft| self.search.case_of(draft.text()));
        let cases: Vec<Option<Case>> = cases.collect();
        let search = &mut *self.search;
        search.asked.ask_ahead(cases.iter().flatten(), search.stop)?;
        until_interesting(&cases, |at, case| search.judge_case(drafts[at].text(), case))
    }
}

impl CandidateJudge<TextDraft> for DraftJudge<'_, '_, '_> {
    fn admits(&mut self, _: &TextDraft) -> bool {
        self.error.is_none()
    }

    fn judge(&mut self, drafts: &[TextDraft]) -> Vec<Interestingness> {
        if std::mem::take(&mut self.is_start) {
            return vec![Interestingness::Interesting];
        }
        self.judged(drafts).unwrap_or_else(|failed| {
            self.error = Some(failed);
            vec![Interestingness::Invalid; drafts.len()]
        })
    }

    fn pack_size(&self) -> usize {
        let symptom = &self.search.normal.deviation.sign.symptom;
        self.search.asked.pack_size_of(symptom)
    }
}
