//! One conversation with each engine, and what is judged through them.

use super::Differential;
use super::comparison::{Agreement, compare};
use super::entrant::{ask, lives};
use super::subject::Subject;
use crate::bench::{Suspicion, Verdict, Worker};
use crate::finding::Finding;
use stickler_engines::{EngineError, Outcome, Session};

/// A worker with a session of each engine.
pub(super) struct Asking<'b> {
    pub(super) bench: &'b Differential<'b>,
    pub(super) sessions: Vec<Box<dyn Session + 'b>>,
    /// The engine that does not answer any more.
    lost: Option<String>,
}

impl<'b> Asking<'b> {
    /// Opens the sessions.
    ///
    /// # Errors
    /// [`EngineError`] of the first that cannot be opened.
    pub(super) fn new(bench: &'b Differential<'b>) -> Result<Asking<'b>, EngineError> {
        let sessions = bench.entrants.iter().map(|entrant| entrant.engine.session());
        Ok(Asking {
            bench,
            sessions: sessions.collect::<Result<_, _>>()?,
            lost: None,
        })
    }

    fn judge_one(&mut self, place: u64) -> Verdict {
        let mut verdict = Verdict::agreed(place);
        let program = self
            .bench
            .inputs
            .program(place, &self.bench.dialects, self.bench.open);
        let subject = match Subject::new(program) {
            Ok(subject) => subject,
            Err(word) => {
                verdict.passed_over = Some(word);
                return verdict;
            }
        };
        let mut asked = 0;
        for index in 0..self.bench.entrants.len() {
            if !self.bench.entrants[index]
                .identity()
                .speaks(subject.program.dialect)
            {
                continue;
            }
            let (outcome, agreement) = self.hold(index, &subject);
            asked += u64::from(agreement != Agreement::Unsupported);
            if let Some(symptom) = agreement.symptom() {
                verdict.suspicions.push(Suspicion {
                    place,
                    subject: self.bench.entrants[index].identity().name.clone(),
                    symptom: symptom.to_owned(),
                });
            }
            if matches!(outcome, Outcome::Crashed { .. } | Outcome::TimedOut { .. }) {
                verdict.deaths += 1;
                self.see_whether_it_lives(index, &subject);
            }
        }
        if asked == 0 {
            verdict.passed_over = Some("no engine can do it");
        } else if !subject.opened.is_empty() && verdict.suspicions.is_empty() {
            verdict.passed_over = Some("no document settles all of it");
        }
        verdict
    }

    /// Gives the program to one engine, and holds what it does against what it must do.
    pub(super) fn hold(&mut self, index: usize, subject: &Subject) -> (Outcome, Agreement) {
        let question = subject.question(self.bench.entrants[index].is_reference);
        let outcome = ask(&mut *self.sessions[index], question);
        let agreement = compare(question, &outcome);
        (outcome, agreement)
    }

    fn see_whether_it_lives(&mut self, index: usize, subject: &Subject) {
        if !lives(&mut *self.sessions[index], subject.program.dialect) {
            let name = &self.bench.entrants[index].identity().name;
            self.lost.get_or_insert_with(|| {
                format!("engine {name} died over a program, and since then over the smallest program that there is")
            });
        }
    }
}

impl Worker for Asking<'_> {
    fn judge(&mut self, places: &[u64], going: &dyn Fn() -> bool) -> Vec<Verdict> {
        let mut verdicts = Vec::with_capacity(places.len());
        for &place in places {
            if !going() || self.lost.is_some() {
                break;
            }
            verdicts.push(self.judge_one(place));
        }
        verdicts
    }

    fn reduce(&mut self, suspicion: &Suspicion, going: &dyn Fn() -> bool) -> Finding {
        self.finding(suspicion, going)
    }

    fn lost(&self) -> Option<String> {
        self.lost.clone()
    }
}
