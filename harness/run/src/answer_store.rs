//! Stores the answers of engines from earlier runs, so that the engines need not be asked again.
//!
//! An answer is kept under a digest of the question, which covers everything that the engine is handed. Only results of the
//! engine itself are kept: a crash, a time limit or an invalid answer may be caused by the machine, and the engine is asked
//! again.

use crate::answers::{Answers, ask};
use crate::pack::{packs, settle};
use stickler_engines::{Digest, EngineError, EngineSession, Outcome};
use stickler_suite::Case;
use stickler_types::Dialect;

/// A store of one engine's answers from earlier runs. The implementation keeps the answers of engines apart that differ in
/// anything.
pub trait AnswerStore: Sync {
    /// Returns the answers that were kept under this question before the run began.
    fn get(&self, question: &str) -> Option<&str>;

    /// Keeps answers under a question, for later runs. Neither contains a line feed, and the question contains no blank.
    fn put(&self, question: &str, answers: &str);
}

/// Returns the answers of an engine about a case like [`ask`](ask()), from the store where it has them; other answers are added
/// to it.
///
/// # Errors
/// [`EngineError`] where no session can be opened.
pub fn ask_stored(
    session: &mut EngineSession<'_>,
    case: &Case,
    store: Option<&dyn AnswerStore>,
) -> Result<Answers, EngineError> {
    let Some(store) = store else {
        return ask(session, case);
    };
    let question = question(case);
    if let Some(known) = store.get(&question).and_then(read) {
        return Ok(known);
    }
    let answers = ask(session, case)?;
    if let Some(text) = written(&answers) {
        store.put(&question, &text);
    }
    Ok(answers)
}

/// Asks an engine about several cases like [`ask_stored`], in packs of at most `size` where they may be asked about together. Returns
/// `None` for those that were not reached before `stopping` held.
///
/// # Errors
/// [`EngineError`] where no session can be opened.
pub fn ask_stored_together(
    session: &mut EngineSession<'_>,
    cases: &[&Case],
    store: Option<&dyn AnswerStore>,
    (size, stopping): (usize, &dyn Fn() -> bool),
) -> Result<Vec<Option<Answers>>, EngineError> {
    let known = |case: &&Case| store?.get(&question(case)).and_then(read);
    let mut answers: Vec<Option<Answers>> = cases.iter().map(known).collect();
    let open: Vec<usize> = (0..cases.len()).filter(|&at| answers[at].is_none()).collect();
    let asked: Vec<(&Case, usize)> = open.iter().map(|&at| (cases[at], 0)).collect();
    for pack in packs(&asked, &[size]) {
        let of_pack: Vec<&Case> = pack.iter().map(|&at| asked[at].0).collect();
        let settled = settle(session, &of_pack, stopping)?;
        for (&place, settled) in pack.iter().zip(settled) {
            let Some((found, _)) = settled else { continue };
            if let Some((store, text)) = store.zip(written(&found)) {
                store.put(&question(asked[place].0), &text);
            }
            answers[open[place]] = Some(found);
        }
    }
    Ok(answers)
}

/// Returns the digest of everything that an engine is asked about a case: 32 hexadecimal digits.
pub fn question(case: &Case) -> String {
    let mut digest = Digest::new("question");
    digest.text(case.dialect.as_str()).text(&case.source);
    // An engine that does not know a custom dialect is asked about its base, which the name does not contain.
    digest.text(&format!("{:?}", case.dialect.base()));
    // The definition decides the options of an engine that knows them.
    let overrides = case.dialect.definition().map(Dialect::overrides);
    digest.text(&overrides.unwrap_or_default().join("\n"));
    let asked = (case.scans, &*case.observe, &*case.clock, &*case.set);
    // Numbers and texts always have a form in JSON.
    digest.text(&serde_json::to_string(&asked).unwrap_or_default());
    // Then more is asked than to run it.
    digest.number(case.expectation.rendered.is_some().into());
    digest.finish()
}

/// Serializes answers; returns `None` where they are not to be kept, or cannot be kept without loss.
pub(crate) fn written(answers: &Answers) -> Option<String> {
    let may_be_of_machine = |outcome: &Outcome| {
        matches!(
            outcome,
            Outcome::Crashed { .. }
                | Outcome::Unusable { .. }
                | Outcome::TimedOut { .. }
                | Outcome::Error { .. }
        )
    };
    if answers.outcomes().any(may_be_of_machine) {
        return None;
    }
    let text = serde_json::to_string(answers).ok()?;
    (read(&text).as_ref() == Some(answers)).then_some(text)
}

/// Parses answers; returns `None` where the text was not written by [`written`].
pub(crate) fn read(text: &str) -> Option<Answers> {
    serde_json::from_str(text).ok()
}
