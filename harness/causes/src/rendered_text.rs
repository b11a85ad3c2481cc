//! Takes what an engine renders as a program of its own: where it rejects that, whoever writes the same by hand meets the same defect.

use crate::failure_sign::{Sign, differing_lines};
use crate::question::{Deviation, Questioner};
use crate::reduction::Smallest;
use stickler_engines::EngineError;
use stickler_run::{CaseEvent, Fact, Symptom};
use stickler_suite::Case;
use stickler_types::Outcome;

impl Questioner<'_> {
    /// Returns the case of the rendered text of a small program, which must be accepted and the engine rejects, with what it does; `None` where
    /// anything else of what it renders is wrong, or the text has a mistake.
    ///
    /// # Errors
    /// [`EngineError`] where no session can be opened.
    pub(crate) fn of_rendered_text(
        &mut self,
        (case, event): (&Case, &CaseEvent),
        smallest: &Smallest,
    ) -> Result<Option<(Case, CaseEvent, Sign)>, EngineError> {
        let is_rejected = |fact: &Fact| matches!(fact, Fact::NotRendered { again: true, .. });
        let Deviation { expected, got, .. } = &smallest.deviation;
        if !got.iter().any(is_rejected) || differing_lines(expected, got).is_some() {
            return Ok(None);
        }
        let Outcome::Rendered { text } = self.session.render(case.dialect, &smallest.program)? else {
            return Ok(None);
        };
        if !stickler_reference::errors(&text, case.dialect).is_empty() {
            return Ok(None);
        }
        let rendered = Case {
            basis: case.basis.clone(),
            ..Case::of_program(&case.id, case.dialect, &text)
        };
        let seen = self.deviation(&rendered)?;
        let seen = seen.filter(|seen| matches!(seen.sign.symptom, Symptom::Rejected(_)));
        Ok(seen.map(|seen| {
            let event = CaseEvent {
                program: Some(text),
                expected: seen.expected,
                got: seen.got,
                ..event.clone()
            };
            (rendered, event, seen.sign)
        }))
    }
}
