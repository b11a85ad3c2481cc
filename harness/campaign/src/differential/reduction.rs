//! Reduces a mismatch of an engine, runs it once more, and makes a finding of it.

use super::engine::{EngineUnderTest, describe, has_died};
use super::question::{Agreement, EvaluatedProgram};
use super::worker::DifferentialWorker;
use crate::basis::basis;
use crate::finding::{Confirmation, DIFFERENTIAL, EngineReport, ExpectedBehavior, Finding, FindingOrigin};
use crate::oracle::Mismatch;
use stickler_causes::CauseKey;
use stickler_engines::Outcome;
use stickler_generate::model::Program;
use stickler_generate::reduce;
use stickler_reduce::{CandidateJudge, Interestingness, ReductionBudget, StopReason};
use stickler_run::Observed;

/// The number of smaller programs that are tried at most where an engine answers from within this process.
const MAX_TRIES_IN_PROCESS: u64 = 5000;
/// The number of smaller programs that are tried at most where each starts a compiler.
const MAX_TRIES: u64 = 800;
/// The number of smaller programs that are tried at most where a compiler is given several at a time.
const MAX_TRIES_IN_PACKS: u64 = 3000;
/// The number of smaller programs in a pack at most: those behind the first that shows the symptom were tried for nothing.
const MAX_REDUCTION_PACK_LEN: usize = 32;
/// The number of smaller programs that are tried at most where each takes as long as an engine may take.
const MAX_TRIES_OF_HANG: u64 = 30;

impl DifferentialWorker<'_> {
    /// Makes the program of a mismatch as small as it can be, and asks every engine about what is left.
    pub(super) fn finding(&mut self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding {
        let oracle = self.oracle;
        let Mismatch { place, .. } = *mismatch;
        // What was judged at this place came from it then, and comes from it again.
        let start = oracle.program(place);
        let start = start.unwrap_or_else(|| oracle.inputs.program(place, &oracle.dialects, oracle.open));
        // A mismatch names an engine of this campaign.
        let is_meant = |engine: &EngineUnderTest<'_>| engine.identity().name == mismatch.subject;
        let index = oracle.engines.iter().position(is_meant).unwrap_or(0);
        let stop = || !going();
        let budget = ReductionBudget {
            tries: self.tries(index, mismatch),
            stop: &stop,
        };
        let opened = EvaluatedProgram::new(start.clone()).is_ok_and(|subject| !subject.opened.is_empty());
        let mut judge = MismatchJudge {
            worker: self,
            index,
            symptom: &mismatch.symptom,
            opened,
            going,
        };
        let reduced = reduce::program(&start, &mut judge, &budget);
        let again = judge.shows(std::slice::from_ref(&reduced.value));
        let is_seen = reduced.ended != StopReason::NotInteresting && again == [Interestingness::Interesting];
        // What was seen once and not again is kept as it was found: a part of it may be nothing at all.
        let (standing, program) = match is_seen {
            true => (Confirmation::Confirmed, reduced.value),
            false => (Confirmation::Flaky, start.clone()),
        };
        let begun = Finding::begin(DIFFERENTIAL, mismatch, oracle.inputs.seed());
        let origin = FindingOrigin {
            open: oracle.open,
            smallest: reduced.ended == StopReason::Smallest && self.gone(index).is_none(),
            tries: reduced.tries,
            ..begun.origin
        };
        let begun = Finding {
            standing,
            origin,
            ..begun
        };
        self.written_down(index, mismatch, &start, program, begun)
    }

    fn tries(&self, index: usize, mismatch: &Mismatch) -> u64 {
        match (&*mismatch.symptom, self.oracle.engines[index].is_reference) {
            ("hang", _) => MAX_TRIES_OF_HANG,
            (_, true) => MAX_TRIES_IN_PROCESS,
            (_, false) if self.pack_size(index) > 1 => MAX_TRIES_IN_PACKS,
            (_, false) => MAX_TRIES,
        }
    }

    fn written_down(
        &mut self,
        index: usize,
        mismatch: &Mismatch,
        start: &Program,
        program: Program,
        begun: Finding,
    ) -> Finding {
        let original = EvaluatedProgram::new(start.clone())
            .map(|subject| subject.text)
            .unwrap_or_default();
        let rule = stickler_generate::features::distinctive(&program);
        let basis = basis(&program);
        let dialect = program.dialect;
        let (text, expected, seen) = match EvaluatedProgram::new(program) {
            Ok(subject) => {
                let seen = self.outcomes(index, mismatch, &subject);
                (subject.text.clone(), expected(&subject, basis), seen)
            }
            // What was evaluated before can be evaluated again; if not, the original says all that is known.
            Err(word) => (
                original.clone(),
                ExpectedBehavior::Property {
                    claim: word.to_owned(),
                },
                SeenAgain::default(),
            ),
        };
        let is_small = begun.standing == Confirmation::Confirmed && begun.origin.smallest;
        let finding = Finding {
            engine: Some(self.oracle.engines[index].info()),
            rule,
            cause: seen.cause.filter(|_| is_small),
            dialect: Some(dialect.as_str().to_owned()),
            origin: FindingOrigin {
                size_found: lines(&original),
                size: lines(&text),
                ..begun.origin
            },
            message: seen.message.unwrap_or_else(|| self.unseen(index, mismatch)),
            expected,
            outcomes: seen.outcomes,
            program: Some(text),
            original: Some(original),
            ..begun
        }
        .named();
        Finding {
            reproduce: self.oracle.commands.of(&finding),
            ..finding
        }
    }

    /// Asks every engine that lives about the program.
    fn outcomes(&mut self, index: usize, mismatch: &Mismatch, subject: &EvaluatedProgram) -> SeenAgain {
        let mut seen = SeenAgain::default();
        for other in 0..self.oracle.engines.len() {
            let engine = &self.oracle.engines[other];
            if self.gone(other).is_some() || !engine.identity().speaks(subject.program.dialect) {
                continue;
            }
            let asked = engine.info();
            let (outcome, agreement) = self.hold(other, subject);
            if let Agreement::Disagrees { symptom, message } = agreement
                && other == index
                && symptom == mismatch.symptom
            {
                seen.message = Some(message);
                seen.cause = cause(subject, &outcome);
            }
            seen.outcomes.push(describe(asked, &outcome));
        }
        seen
    }

    /// Returns the message of a symptom that was seen once and not again.
    fn unseen(&self, index: usize, mismatch: &Mismatch) -> String {
        let symptom = &mismatch.symptom;
        match self.gone(index) {
            Some(reason) => format!("{symptom}, and it could not be run again; {reason}"),
            None => format!("{symptom}, but not when it was run again"),
        }
    }
}

/// The outcomes of the engines on a reduced program.
#[derive(Default)]
struct SeenAgain {
    outcomes: Vec<EngineReport>,
    /// The message and the cause, where the engine in question shows the symptom.
    message: Option<String>,
    cause: Option<CauseKey>,
}

/// Returns the cause that a program shows; `None` where a document leaves something of it open.
fn cause(subject: &EvaluatedProgram, outcome: &Outcome) -> Option<CauseKey> {
    let dialect = subject.program.dialect;
    let key = CauseKey::of_program(&subject.text, dialect, &subject.values, outcome);
    key.filter(|_| subject.opened.is_empty())
}

/// Judges smaller programs by whether an engine shows a symptom on them.
struct MismatchJudge<'j, 'b> {
    worker: &'j mut DifferentialWorker<'b>,
    index: usize,
    symptom: &'j str,
    /// Whether no document settled all of the program that was found.
    opened: bool,
    /// Returns whether a pack that was begun is gone on with; the rest of it is then not judged.
    going: &'j dyn Fn() -> bool,
}

impl MismatchJudge<'_, '_> {
    /// Returns whether the engine shows the symptom on each of these programs.
    ///
    /// An engine that is gone seems to die over every program. So one that has died is asked whether it lives, before the
    /// program is blamed.
    fn shows(&mut self, candidates: &[Program]) -> Vec<Interestingness> {
        let subjects: Vec<Option<EvaluatedProgram>> = candidates
            .iter()
            .map(|candidate| EvaluatedProgram::new(candidate.clone()).ok())
            .collect();
        let evaluated: Vec<&EvaluatedProgram> = subjects.iter().flatten().collect();
        // One program alone is asked about whatever the time is: without an answer a finding could not be confirmed.
        let going = match candidates {
            [_] => &|| true,
            _ => self.going,
        };
        let mut outcomes = self.worker.hold_all(self.index, &evaluated, going).into_iter();
        let mut shows = Vec::with_capacity(candidates.len());
        for subject in &subjects {
            let outcome = subject.as_ref().and_then(|_| outcomes.next().flatten());
            shows.push(match (subject, outcome) {
                (Some(subject), Some((outcome, agreement))) => {
                    let is_gone =
                        has_died(&outcome) && !self.worker.lives(self.index, subject.program.dialect);
                    match is_gone {
                        true => Interestingness::Invalid,
                        false => Interestingness::from(agreement.symptom() == Some(self.symptom)),
                    }
                }
                _ => Interestingness::Invalid,
            });
        }
        shows
    }
}

impl CandidateJudge<Program> for MismatchJudge<'_, '_> {
    fn admits(&mut self, candidate: &Program) -> bool {
        // Some compilers reject a program without variables or statements for itself, whatever else was wrong with it.
        if candidate.main.variables.is_empty() || candidate.main.body.is_empty() {
            return false;
        }
        let subject = EvaluatedProgram::new(candidate.clone());
        // A program that the documents settle must not become one of which they say nothing.
        let is_settled = subject.is_ok_and(|subject| self.opened || subject.opened.is_empty());
        is_settled && self.worker.gone(self.index).is_none()
    }

    fn judge(&mut self, candidates: &[Program]) -> Vec<Interestingness> {
        self.shows(candidates)
    }

    fn pack_size(&self) -> usize {
        self.worker.pack_size(self.index).min(MAX_REDUCTION_PACK_LEN)
    }
}

/// Returns what must happen, by the evaluator.
pub(crate) fn expected(subject: &EvaluatedProgram, basis: String) -> ExpectedBehavior {
    let values = subject.values.iter().map(|(name, value)| Observed {
        name: name.clone(),
        value: value.to_string(),
    });
    ExpectedBehavior::Values {
        values: values.collect(),
        basis: subject.opened.is_empty().then_some(basis),
        opened: subject.opened.iter().map(ToString::to_string).collect(),
    }
}

fn lines(text: &str) -> u64 {
    text.lines().count() as u64
}
