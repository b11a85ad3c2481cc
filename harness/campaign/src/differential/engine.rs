//! An engine of a campaign, what it is asked, and the text in which a finding saves what it did.

use super::question::{Agreement, JudgedProgram, compare};
use crate::finding::{EngineInfo, EngineReport};
use stickler_engines::{Engine, EngineSession, Identity, Observation, Outcome, Packed, RunRequest};
use stickler_generate::reduce::diagnostic_line;
use stickler_types::{DialectName, Value};

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
    let observe = observations(&question);
    let request = RunRequest::once(question.dialect, question.text, &observe);
    session
        .run(&request)
        .unwrap_or_else(|error| Outcome::crashed(error.to_string()))
}

/// Runs programs of one dialect, in packs where the engine takes several at a time. Programs about which the answer to a pack
/// says nothing are asked about again, in packs of half the size, so that a pack changes no outcome. Returns the outcome of each
/// program, and how it compares with what was asked; `None` for those that were not reached while `going` held.
pub(crate) fn ask_all(
    session: &mut EngineSession<'_>,
    questions: &[JudgedProgram<'_>],
    going: &dyn Fn() -> bool,
) -> Vec<Option<(Outcome, Agreement)>> {
    let mut outcomes: Vec<Option<Outcome>> = vec![None; questions.len()];
    let places: Vec<usize> = (0..questions.len()).collect();
    let most = session.engine().pack_size().max(1);
    let mut open: Vec<Vec<usize>> = places.chunks(most).rev().map(<[usize]>::to_vec).collect();
    while let Some(pack) = open.pop() {
        if !going() {
            break;
        }
        if let [place] = pack[..] {
            outcomes[place] = Some(ask(session, questions[place]));
            continue;
        }
        let mut unknown = Vec::new();
        for (place, packed) in pack.iter().copied().zip(ask_pack(session, questions, &pack)) {
            match packed {
                Packed::Answered(outcome) => outcomes[place] = Some(outcome),
                Packed::Unknown => unknown.push(place),
                Packed::Alone => open.push(vec![place]),
            }
        }
        let half = pack.len().div_ceil(2);
        open.extend(unknown.chunks(half).map(<[usize]>::to_vec));
    }
    let compared = questions.iter().zip(outcomes).map(|(question, outcome)| {
        let outcome = outcome?;
        let agreement = compare(*question, &outcome);
        Some((outcome, agreement))
    });
    compared.collect()
}

/// Runs a pack of these programs. Where no session can be opened, nothing is known of any.
fn ask_pack(session: &mut EngineSession<'_>, questions: &[JudgedProgram<'_>], pack: &[usize]) -> Vec<Packed> {
    let observed: Vec<Vec<Observation>> = pack
        .iter()
        .map(|&place| observations(&questions[place]))
        .collect();
    let requests: Vec<RunRequest<'_>> = pack
        .iter()
        .zip(&observed)
        .map(|(&place, observe)| RunRequest::once(questions[place].dialect, questions[place].text, observe))
        .collect();
    session
        .run_pack(&requests)
        .unwrap_or_else(|_| vec![Packed::Unknown; pack.len()])
}

fn observations(question: &JudgedProgram<'_>) -> Vec<Observation> {
    let values = question.values.iter();
    values
        .map(|(name, value)| Observation::last(name, value.type_name()))
        .collect()
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
            Agreement::Disagrees { message, .. } if has_died(&outcome) => reason = message,
            _ => return Ok(()),
        }
    }
    Err(reason)
}

/// Returns whether the engine died over the question and has to be started again.
pub(super) const fn has_died(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Crashed { .. } | Outcome::TimedOut { .. })
}

/// Describes an outcome, one fact a line.
pub(crate) fn describe(engine: EngineInfo, outcome: &Outcome) -> EngineReport {
    let values = |values: &[(String, Value)]| {
        values
            .iter()
            .map(|(name, value)| format!("{name} = {value}"))
            .collect::<Vec<String>>()
    };
    let (word, said) = match outcome {
        Outcome::Accepted { .. } => ("accepted", Vec::new()),
        Outcome::Executed { values: got, .. } => ("executed", values(got)),
        Outcome::Rejected { diagnostics } => ("rejected", diagnostics.iter().map(diagnostic_line).collect()),
        Outcome::Faulted {
            fault,
            line,
            values: got,
            ..
        } => {
            let line = line.map(|line| format!(" on line {line}")).unwrap_or_default();
            let mut said = vec![format!("{fault}{line}")];
            said.extend(values(got));
            ("faulted", said)
        }
        Outcome::Rendered { .. } => ("rendered", Vec::new()),
        Outcome::Unsupported { reason } => ("unsupported", vec![reason.clone()]),
        Outcome::NotImplemented { reason } => ("not implemented", vec![reason.clone()]),
        Outcome::Crashed { reason } | Outcome::Unusable { reason } => ("crashed", vec![reason.clone()]),
        Outcome::TimedOut { .. } => ("timed out", vec![outcome.to_string()]),
        Outcome::Error { message } => ("error", vec![message.clone()]),
    };
    EngineReport {
        engine,
        outcome: word.to_owned(),
        said,
    }
}
