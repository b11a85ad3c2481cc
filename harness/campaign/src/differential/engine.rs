//! An engine of a campaign.

use super::comparison::{Agreement, EngineDisagreement, JudgedProgram, compare};
use crate::finding::EngineInfo;
use stickler_engines::{Engine, EngineSession, Identity, Observation, Outcome, RunRequest};
use stickler_types::DialectName;

/// An engine that takes part in a campaign, with the name by which it was asked for.
#[derive(Clone, Copy)]
pub struct EngineUnderTest<'e> {
    /// The engine.
    pub engine: &'e dyn Engine,
    /// The value of `--engine` that stands for the engine.
    pub asked_for: &'e str,
    /// Whether the engine is the reference, which must also follow what only the rules settle.
    pub is_reference: bool,
}

impl EngineUnderTest<'_> {
    /// Returns the identity of the engine.
    pub(crate) fn identity(&self) -> &Identity {
        self.engine.identity()
    }

    /// Returns the identity of the engine in the form of a finding.
    pub(crate) fn info(&self) -> EngineInfo {
        let Identity { name, version, .. } = self.identity();
        EngineInfo {
            name: name.clone(),
            version: version.clone(),
            asked_for: self.asked_for.to_owned(),
        }
    }
}

/// Runs a program for one scan and observes all of it. An engine that cannot be started again after a crash has crashed.
pub(crate) fn ask(session: &mut EngineSession<'_>, question: JudgedProgram<'_>) -> Outcome {
    let observe: Vec<Observation> = question
        .values
        .iter()
        .map(|(name, value)| Observation::last(name, value.type_name()))
        .collect();
    let request = RunRequest::once(question.dialect, question.text, &observe);
    session.run(&request).unwrap_or_else(|error| Outcome::Crashed {
        reason: error.to_string(),
    })
}

/// Asks an engine that has died over a program whether it still answers at all.
///
/// # Errors
/// A fragment that says how the engine died over the smallest program that there is.
pub(super) fn lives(session: &mut EngineSession<'_>, dialect: DialectName) -> Result<(), String> {
    /// A smallest program, which every dialect has.
    const PROGRAM: &str = "PROGRAM main\nVAR\n    x : INT;\nEND_VAR\n    x := 1;\nEND_PROGRAM\n";
    /// A machine that is short of memory may need a moment.
    const ATTEMPTS: usize = 3;
    let question = JudgedProgram {
        dialect,
        text: PROGRAM,
        values: &[],
        binds: false,
    };
    let mut reason = String::new();
    for _ in 0..ATTEMPTS {
        let outcome = ask(session, question);
        match compare(question, &outcome) {
            Agreement::Disagrees(EngineDisagreement { message, .. }) if has_died(&outcome) => {
                reason = message
            }
            _ => return Ok(()),
        }
    }
    Err(reason)
}

/// Returns whether the engine died over the question and has to be started again.
pub(super) const fn has_died(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Crashed { .. } | Outcome::TimedOut { .. })
}
