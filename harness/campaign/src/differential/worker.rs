//! A worker with a session of each engine: programs are judged alone, or in packs where an engine takes several at a time.

use super::DifferentialOracle;
use super::engine::{ask, ask_all, has_died, lives};
use super::question::{Agreement, EvaluatedProgram, JudgedProgram, compare};
use crate::finding::Finding;
use crate::oracle::{InputVerdict, Mismatch, Worker};
use stickler_engines::{EngineError, EngineSession, Outcome};
use stickler_generate::features::distinctive;
use stickler_types::DialectName;

/// A worker with a session of each engine.
pub(super) struct DifferentialWorker<'b> {
    pub(super) oracle: &'b DifferentialOracle<'b>,
    sessions: Vec<EngineSession<'b>>,
    /// The reason for which an engine does not answer any more, by its number; `None` where it does.
    lost: Vec<Option<String>>,
}

/// A place, and its program where there is one.
struct JudgedInput {
    verdict: InputVerdict,
    subject: Option<EvaluatedProgram>,
    /// The number of engines that support the program.
    asked: usize,
}

impl<'b> DifferentialWorker<'b> {
    /// Opens a session of each engine.
    ///
    /// # Errors
    /// [`EngineError`] of the first that cannot be opened.
    pub(super) fn new(oracle: &'b DifferentialOracle<'b>) -> Result<DifferentialWorker<'b>, EngineError> {
        let sessions = oracle
            .engines
            .iter()
            .map(|engine| EngineSession::open(engine.engine));
        Ok(DifferentialWorker {
            oracle,
            sessions: sessions.collect::<Result<_, _>>()?,
            lost: vec![None; oracle.engines.len()],
        })
    }

    fn input(&self, place: u64) -> JudgedInput {
        let mut verdict = InputVerdict {
            place,
            ..InputVerdict::default()
        };
        let program = self
            .oracle
            .program(place)
            .ok_or("none came without what is to be left out");
        let subject = program
            .and_then(EvaluatedProgram::new)
            .map_err(|word| verdict.passed_over = Some(word))
            .ok();
        JudgedInput {
            verdict,
            subject,
            asked: 0,
        }
    }

    /// Asks one engine about all inputs whose dialect it speaks, as many at a time as it takes. Returns whether the engine lives, and was
    /// asked about all of them.
    fn ask_all(&mut self, index: usize, inputs: &mut [JudgedInput], going: &dyn Fn() -> bool) -> bool {
        let identity = self.oracle.engines[index].identity();
        let dialect = |number: &usize| inputs[*number].dialect();
        let speaks = |number: &usize| dialect(number).is_some_and(|dialect| identity.speaks(dialect));
        let mut numbers: Vec<usize> = (0..inputs.len()).filter(speaks).collect();
        numbers.sort_by_key(dialect);
        let of_one_dialect = numbers.chunk_by(|one, other| dialect(one) == dialect(other));
        let packs: Vec<&[usize]> = of_one_dialect
            .flat_map(|group| group.chunks(self.pack_size(index)))
            .collect();
        packs.into_iter().all(|pack| {
            let subjects: Vec<&EvaluatedProgram> = pack
                .iter()
                .filter_map(|&number| inputs[number].subject.as_ref())
                .collect();
            let outcomes = self.hold_all(index, &subjects, going);
            pack.iter().zip(outcomes).all(|(&number, outcome)| {
                outcome.is_some_and(|(outcome, agreement)| {
                    self.enter(index, &mut inputs[number], &outcome, &agreement)
                })
            })
        })
    }

    /// Adds to the verdict on a program what an engine did with it. Returns whether the engine lives.
    fn enter(
        &mut self,
        index: usize,
        input: &mut JudgedInput,
        outcome: &Outcome,
        agreement: &Agreement,
    ) -> bool {
        let Some(subject) = &input.subject else {
            return true;
        };
        input.asked += usize::from(*agreement != Agreement::Unsupported);
        if let Some(symptom) = agreement.symptom() {
            input.verdict.mismatches.push(Mismatch {
                place: input.verdict.place,
                subject: self.oracle.engines[index].identity().name.clone(),
                symptom: symptom.to_owned(),
                rule: distinctive(&subject.program),
                size: subject.text.len(),
            });
        }
        if has_died(outcome) {
            input.verdict.deaths += 1;
            return self.lives(index, subject.program.dialect);
        }
        true
    }

    /// Gives the program to one engine, and compares what it does with what it must do.
    pub(super) fn hold(&mut self, index: usize, subject: &EvaluatedProgram) -> (Outcome, Agreement) {
        let question = subject.question(self.oracle.engines[index].is_reference);
        let outcome = ask(&mut self.sessions[index], question);
        let agreement = compare(question, &outcome);
        (outcome, agreement)
    }

    /// Gives programs of one dialect to one engine, and compares what it does with what it must do. Returns `None` for those
    /// that were not reached while `going` held.
    pub(super) fn hold_all(
        &mut self,
        index: usize,
        subjects: &[&EvaluatedProgram],
        going: &dyn Fn() -> bool,
    ) -> Vec<Option<(Outcome, Agreement)>> {
        let is_reference = self.oracle.engines[index].is_reference;
        let questions: Vec<JudgedProgram<'_>> = subjects
            .iter()
            .map(|subject| subject.question(is_reference))
            .collect();
        ask_all(&mut self.sessions[index], &questions, going)
    }

    /// Returns how many programs an engine is best given at a time, at least one.
    pub(super) fn pack_size(&self, index: usize) -> usize {
        self.sessions[index].engine().pack_size().max(1)
    }

    /// Returns whether an engine that has died can be started again; if not, the campaign is at its end.
    pub(super) fn lives(&mut self, index: usize, dialect: DialectName) -> bool {
        if self.lost[index].is_none() {
            let name = &self.oracle.engines[index].identity().name;
            self.lost[index] = lives(&mut self.sessions[index], dialect).err().map(|reason| {
                format!("engine {name} is lost: over the smallest program that there is it {reason}")
            });
        }
        self.lost[index].is_none()
    }

    /// Returns the reason for which an engine is asked no more; `None` where it lives, as far as is known.
    pub(super) fn gone(&self, index: usize) -> Option<&str> {
        self.lost[index].as_deref()
    }
}

impl JudgedInput {
    fn dialect(&self) -> Option<DialectName> {
        self.subject.as_ref().map(|subject| subject.program.dialect)
    }

    /// Returns the verdict. Where programs are `open`, one that no document settles is judged too: only crashes and hangs count.
    fn into_verdict(self, open: bool) -> InputVerdict {
        let mut verdict = self.verdict;
        if let Some(subject) = self.subject {
            verdict.passed_over = match self.asked {
                0 => Some("no engine can do it"),
                _ if open || subject.opened.is_empty() || !verdict.mismatches.is_empty() => None,
                _ => Some("no document settles all of it"),
            };
        }
        verdict
    }
}

impl Worker for DifferentialWorker<'_> {
    fn judge(&mut self, places: &[u64], going: &dyn Fn() -> bool) -> Vec<InputVerdict> {
        if self.lost().is_some() || !going() {
            return Vec::new();
        }
        let mut inputs: Vec<JudgedInput> = places.iter().map(|&place| self.input(place)).collect();
        for index in 0..self.oracle.engines.len() {
            if !self.ask_all(index, &mut inputs, going) {
                // Some engines have not seen all of it. What was seen to be wrong is wrong all the same.
                inputs.retain(|input| !input.verdict.mismatches.is_empty());
                break;
            }
        }
        inputs
            .into_iter()
            .map(|input| input.into_verdict(self.oracle.open))
            .collect()
    }

    fn reduce(&mut self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding {
        self.finding(mismatch, going)
    }

    fn lost(&self) -> Option<String> {
        self.lost.iter().flatten().next().cloned()
    }
}
