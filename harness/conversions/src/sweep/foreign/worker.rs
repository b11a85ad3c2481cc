//! Compares one range of inputs: by a program for all of them, and by further programs where its sum is not the exact one.

use super::counter;
use super::findings::ForeignFindings;
use super::plan::{Counting, SweepPlan};
use super::queue::{FIRST_COUNT, Queue};
use crate::literals::{has_literal, literal};
use crate::program::{ConversionProgram, listed};
use crate::session::{FunctionSession, Refusal, RefusalKind};
use crate::sweep::agenda::Sweep;
use crate::sweep::findings::{Difference, MAX_DIFFERENCES, SweepProgress};
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;
use stickler_exact::{Expected, Operation, Signature, expected};
use stickler_types::{DialectName, ElementaryType, Value};
use stickler_workers::Cancellation;

/// The maximum number of inputs of a program with a wrong sum that are observed one by one.
const MAX_UNROLLED: u64 = 64;

/// The number of raw forms that are computed at a time.
const BLOCK: usize = 1024;

/// The state that the workers of a sweep share.
pub struct ForeignSweep<'s> {
    /// The sweep that the workers perform.
    pub sweep: &'s Sweep,
    /// The dialect that the engine is asked to speak, and whose documents apply.
    pub dialect: DialectName,
    /// The plan by which the inputs are given to the engine.
    pub plan: &'s SweepPlan,
    /// The queue of inputs that no worker has taken yet.
    pub queue: Queue,
    /// The findings so far.
    pub findings: Mutex<ForeignFindings>,
    /// The function that is called after each program.
    pub progress: &'s (dyn Fn(SweepProgress) + Sync),
    /// The request to run no more programs.
    pub cancel: &'s Cancellation,
}

impl ForeignSweep<'_> {
    /// Compares the engine's results for the inputs at the given places with exact arithmetic.
    pub fn examine(&self, session: &mut FunctionSession<'_>, places: Range<u64>) {
        match &self.plan.counting {
            Some(counting) => self.count(session, counting, places),
            None => self.list(session, places.collect()),
        }
    }

    /// Updates the findings, counts the given number of inputs as dealt with, and reports the progress.
    fn note(&self, inputs: u64, what: impl FnOnce(&mut ForeignFindings)) {
        let mut findings = self.findings.lock().unwrap_or_else(PoisonError::into_inner);
        what(&mut findings);
        findings.done += inputs;
        // Under the lock, so that what is shown never goes back.
        (self.progress)(findings.progress());
    }

    /// Reads from the findings so far.
    fn known<T>(&self, what: impl FnOnce(&ForeignFindings) -> T) -> T {
        what(&self.findings.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn ask(
        &self,
        session: &mut FunctionSession<'_>,
        program: &ConversionProgram,
    ) -> Result<Vec<Value>, Refusal> {
        self.note(0, |findings| findings.programs += 1);
        session.run(self.dialect, program)
    }

    /// Compares the given places of a stretch by one program, and by more where its sum is wrong.
    fn count(&self, session: &mut FunctionSession<'_>, counting: &Counting, places: Range<u64>) {
        let inputs = places.end - places.start;
        if self.cancel.is_requested() {
            return;
        }
        if inputs <= 1 {
            return self.unroll(session, counting, places);
        }
        let begun = Instant::now();
        let program = counter::summed(&self.sweep.signature, counting, &places);
        match self.ask(session, &program) {
            Ok(totals) if totals == [total(self.sweep, counting, places.clone())] => {
                self.queue.answered(inputs, begun.elapsed());
                self.note(inputs, |_| {});
            }
            Ok(_) => self.open(session, counting, places),
            Err(refusal) => self.divide(session, counting, places, refusal),
        }
    }

    /// Searches the places of a program with a wrong sum for differing results, as long as differences are still collected.
    fn open(&self, session: &mut FunctionSession<'_>, counting: &Counting, places: Range<u64>) {
        let inputs = places.end - places.start;
        let (is_claimed, is_open) = (self.has(&places, true), self.has(&places, false));
        let wanted = self.known(|findings| {
            let few = |kept: &[Difference]| kept.len() < MAX_DIFFERENCES;
            is_claimed && few(&findings.first) || is_open && few(&findings.first_observed)
        });
        if !wanted {
            return self.note(inputs, |findings| match is_claimed {
                true => findings.unexamined += inputs,
                false => findings.unexamined_observed += inputs,
            });
        }
        if inputs <= MAX_UNROLLED {
            return self.unroll(session, counting, places);
        }
        self.halve(session, counting, places);
    }

    fn halve(&self, session: &mut FunctionSession<'_>, counting: &Counting, places: Range<u64>) {
        let middle = u64::midpoint(places.start, places.end);
        self.count(session, counting, places.start..middle);
        self.count(session, counting, middle..places.end);
    }

    /// Returns whether a document speaks of one of the inputs or, where `claimed` is false, does not speak of one.
    fn has(&self, places: &Range<u64>, claimed: bool) -> bool {
        let signature = &self.sweep.signature;
        let is_so = |place| self.expected(&self.sweep.domain.operands(place)).basis.is_some() == claimed;
        match signature.operation {
            // Only for these the digits of the operand matter.
            Operation::FromBcd | Operation::ToBcd => places.clone().any(is_so),
            // Of an integer or a REAL it only matters whether it is too large: within a stretch the magnitude grows or falls
            // from one end to the other.
            _ => is_so(places.start) || is_so(places.end - 1),
        }
    }

    fn expected(&self, operands: &[Value]) -> Expected {
        expected(&self.sweep.signature, operands, self.dialect)
    }

    /// Compares the results of a few places one by one, by a program that keeps each result.
    fn unroll(&self, session: &mut FunctionSession<'_>, counting: &Counting, places: Range<u64>) {
        let program = counter::unrolled(&self.sweep.signature, counting, &places);
        match self.ask(session, &program) {
            Ok(given) => {
                let inputs = places.end - places.start;
                let differing = self.compare(places.collect(), given);
                if !differing && inputs > 1 {
                    self.note(0, |findings| findings.unexplained += inputs);
                }
            }
            Err(refusal) => self.divide(session, counting, places, refusal),
        }
    }

    /// Handles a program that the engine did not answer: halves its places, or records them as unanswered.
    fn divide(
        &self,
        session: &mut FunctionSession<'_>,
        counting: &Counting,
        places: Range<u64>,
        refusal: Refusal,
    ) {
        let inputs = places.end - places.start;
        let goes_on = match refusal.kind {
            RefusalKind::TooManySteps => inputs > 1,
            // Waiting for each half of a small program would take hours.
            RefusalKind::TimedOut => inputs > FIRST_COUNT,
            _ => inputs > 1 && self.known(ForeignFindings::separates_refusals),
        };
        if matches!(refusal.kind, RefusalKind::TooManySteps | RefusalKind::TimedOut) {
            self.queue.too_long(inputs);
        }
        if !goes_on {
            return self.refuse(&[places.start], inputs, refusal);
        }
        self.halve(session, counting, places);
    }

    /// Compares the given places by a program that lists their operands.
    fn list(&self, session: &mut FunctionSession<'_>, places: Vec<u64>) {
        let is_writable = |place: &u64| self.sweep.domain.operands(*place).iter().all(has_literal);
        let (places, unwritable): (Vec<u64>, Vec<u64>) = places.into_iter().partition(is_writable);
        let left_out = unwritable.len() as u64;
        self.note(left_out, |findings| findings.left_out += left_out);
        self.listed(session, places);
    }

    fn listed(&self, session: &mut FunctionSession<'_>, mut places: Vec<u64>) {
        if places.is_empty() || self.cancel.is_requested() {
            return;
        }
        let calls: Vec<Vec<Value>> = places
            .iter()
            .map(|place| self.sweep.domain.operands(*place))
            .collect();
        let Signature { function, result, .. } = &self.sweep.signature;
        match self.ask(session, &listed(function, *result, &calls, literal)) {
            Ok(given) => {
                self.compare(places, given);
            }
            Err(refusal) => {
                let patient =
                    refusal.kind != RefusalKind::TimedOut && self.known(ForeignFindings::separates_refusals);
                if places.len() == 1 || !patient {
                    return self.refuse(&places, places.len() as u64, refusal);
                }
                let rest = places.split_off(places.len() / 2);
                self.listed(session, places);
                self.listed(session, rest);
            }
        }
    }

    /// Compares results with the exact ones, and returns whether any differs.
    fn compare(&self, places: Vec<u64>, given: Vec<Value>) -> bool {
        let inputs = places.len() as u64;
        let mut differences = Vec::new();
        for (place, got) in places.into_iter().zip(given) {
            let operands = self.sweep.domain.operands(place);
            let Some(exact) = self.sweep.exact(&operands) else {
                continue;
            };
            if !exact.admits(&got) {
                differences.push(Difference {
                    place,
                    basis: self.expected(&operands).basis,
                    operands,
                    expected: exact,
                    got,
                });
            }
        }
        let differing = !differences.is_empty();
        self.note(inputs, |findings| {
            differences.into_iter().for_each(|one| findings.differ(one))
        });
        differing
    }

    fn refuse(&self, places: &[u64], inputs: u64, refusal: Refusal) {
        let example = places.first().map(|place| self.sweep.domain.operands(*place));
        let example = example.unwrap_or_default();
        self.note(inputs, |findings| findings.refuse(refusal, inputs, example));
    }
}

/// Returns the checksum of the exact results at the given places.
pub fn total(sweep: &Sweep, counting: &Counting, places: Range<u64>) -> Value {
    let (mut operands, mut results) = ([0; BLOCK], [0; BLOCK]);
    let mut total = 0;
    for start in places.clone().step_by(BLOCK) {
        let end = places.end.min(start + BLOCK as u64);
        // The length is at most `BLOCK`.
        let length = (end - start) as usize;
        sweep.domain.fill(start..end, &mut operands[..length]);
        counting.bulk.fill(&operands[..length], &mut results[..length]);
        total = results[..length]
            .iter()
            .fold(total, |total, raw| counting.checksum.add(total, *raw));
    }
    Value::plain(ElementaryType::Lint, total)
}
