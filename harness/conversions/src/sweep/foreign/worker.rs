//! One worker's dealings with an engine: a program for some inputs, and what to do where its answer is not the exact one.

use super::findings::ForeignFindings;
use super::plan::{Counting, Plan};
use super::program;
use super::queue::{FIRST, Queue};
use crate::literals::has_literal;
use crate::program::{Program, listed};
use crate::session::{FunctionSession, Refusal, RefusalKind};
use crate::sweep::agenda::Sweep;
use crate::sweep::findings::{Difference, KEPT};
use crate::sweep::run::Progress;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;
use stickler_exact::{Expected, Operation, expected, value};
use stickler_types::{DialectName, ElementaryType, Value};
use stickler_workers::Cancellation;

/// Differing inputs that are so few are looked at one by one.
const FEW: u64 = 64;

/// How many raw forms are computed at a time.
const BLOCK: usize = 1024;

/// What the workers of a sweep share.
pub struct Inquiry<'s> {
    /// What is swept.
    pub sweep: &'s Sweep,
    /// Whose documents apply; the engine is asked to speak it.
    pub dialect: DialectName,
    /// How the inputs go to the engine.
    pub plan: &'s Plan,
    /// Those that nobody has taken yet.
    pub queue: Queue,
    /// What was found so far.
    pub findings: Mutex<ForeignFindings>,
    /// Told after each program.
    pub progress: &'s (dyn Fn(Progress) + Sync),
    /// Whether no more programs are wanted.
    pub cancel: &'s Cancellation,
}

impl Inquiry<'_> {
    /// Compares what the engine gives for these places with exact arithmetic.
    pub fn look(&self, session: &mut FunctionSession<'_>, places: Range<u64>) {
        match &self.plan.counting {
            Some(counting) => self.count(session, counting, places),
            None => self.list(session, places.collect()),
        }
    }

    /// Notes what was found about so many inputs.
    fn note(&self, inputs: u64, what: impl FnOnce(&mut ForeignFindings)) {
        let mut findings = self.findings.lock().unwrap_or_else(PoisonError::into_inner);
        what(&mut findings);
        findings.done += inputs;
        // Under the lock, so that what is shown never goes back.
        (self.progress)(findings.progress());
    }

    /// Something about what was found so far.
    fn known<T>(&self, what: impl FnOnce(&ForeignFindings) -> T) -> T {
        what(&self.findings.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn ask(&self, session: &mut FunctionSession<'_>, program: &Program) -> Result<Vec<Value>, Refusal> {
        self.note(0, |findings| findings.programs += 1);
        session.run(self.dialect, program)
    }

    /// Looks at these places of a stretch by one program, and by more where its sum is wrong.
    fn count(&self, session: &mut FunctionSession<'_>, counting: &Counting, places: Range<u64>) {
        let inputs = places.end - places.start;
        if self.cancel.is_requested() {
            return;
        }
        if inputs <= 1 {
            return self.unroll(session, counting, places);
        }
        let begun = Instant::now();
        let program = program::summed(&self.sweep.signature, counting, &places);
        match self.ask(session, &program) {
            Ok(totals) if totals == [total(self.sweep, counting, places.clone())] => {
                self.queue.answered(inputs, begun.elapsed());
                self.note(inputs, |_| {});
            }
            Ok(_) => self.open(session, counting, places),
            Err(refusal) => self.divide(session, counting, places, refusal),
        }
    }

    /// Looks into places of which some differ, as far as that is still of interest.
    fn open(&self, session: &mut FunctionSession<'_>, counting: &Counting, places: Range<u64>) {
        let inputs = places.end - places.start;
        let (is_claimed, is_open) = (self.has(&places, true), self.has(&places, false));
        let wanted = self.known(|findings| {
            let few = |kept: &[Difference]| kept.len() < KEPT;
            is_claimed && few(&findings.first) || is_open && few(&findings.first_observed)
        });
        if !wanted {
            return self.note(inputs, |findings| match is_claimed {
                true => findings.unopened += inputs,
                false => findings.unopened_observed += inputs,
            });
        }
        if inputs <= FEW {
            return self.unroll(session, counting, places);
        }
        let middle = u64::midpoint(places.start, places.end);
        self.count(session, counting, places.start..middle);
        self.count(session, counting, middle..places.end);
    }

    /// Whether a document speaks of one of these inputs, or of one of them not.
    fn has(&self, places: &Range<u64>, claimed: bool) -> bool {
        let signature = &self.sweep.signature;
        let is_so = |place| self.expected(&self.sweep.domain.operands(place)).basis.is_some() == claimed;
        match signature.operation {
            // Only of these it matters what digits there are.
            Operation::FromBcd | Operation::ToBcd => places.clone().any(is_so),
            // Of an integer the value does not matter, and of a REAL whether it is too large: within a stretch the
            // magnitude grows from one end to the other.
            _ => is_so(places.start) || is_so(places.end - 1),
        }
    }

    fn expected(&self, operands: &[Value]) -> Expected {
        expected(&self.sweep.signature, operands, self.dialect)
    }

    /// Looks at each of a few places.
    fn unroll(&self, session: &mut FunctionSession<'_>, counting: &Counting, places: Range<u64>) {
        let program = program::unrolled(&self.sweep.signature, counting, &places);
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

    /// Goes on in halves, where an engine does not answer a program about these places.
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
            RefusalKind::TimedOut => inputs > FIRST,
            _ => inputs > 1 && self.known(ForeignFindings::is_patient),
        };
        if matches!(refusal.kind, RefusalKind::TooManySteps | RefusalKind::TimedOut) {
            self.queue.too_long(inputs);
        }
        if !goes_on {
            return self.refuse(&[places.start], inputs, refusal);
        }
        let middle = u64::midpoint(places.start, places.end);
        self.count(session, counting, places.start..middle);
        self.count(session, counting, middle..places.end);
    }

    /// Looks at these places by a list of their operands.
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
        match self.ask(session, &listed(&self.sweep.signature, &calls)) {
            Ok(given) => {
                self.compare(places, given);
            }
            Err(refusal) => {
                let patient =
                    refusal.kind != RefusalKind::TimedOut && self.known(ForeignFindings::is_patient);
                if places.len() == 1 || !patient {
                    return self.refuse(&places, places.len() as u64, refusal);
                }
                let rest = places.split_off(places.len() / 2);
                self.listed(session, places);
                self.listed(session, rest);
            }
        }
    }

    /// Holds results against the exact ones; gives whether any differs.
    fn compare(&self, places: Vec<u64>, given: Vec<Value>) -> bool {
        let inputs = places.len() as u64;
        let mut differences = Vec::new();
        for (place, got) in places.into_iter().zip(given) {
            let operands = self.sweep.domain.operands(place);
            let exact = value(&self.sweep.signature, &operands, &self.sweep.choices);
            if exact != got {
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
            differences
                .into_iter()
                .for_each(|difference| findings.differ(difference));
        });
        differing
    }

    fn refuse(&self, places: &[u64], inputs: u64, refusal: Refusal) {
        let example = places
            .first()
            .map(|place| self.sweep.domain.operands(*place))
            .unwrap_or_default();
        self.note(inputs, |findings| findings.refuse(refusal, inputs, example));
    }
}

/// The sum of the exact results at these places.
pub fn total(sweep: &Sweep, counting: &Counting, places: Range<u64>) -> Value {
    let (mut operands, mut results) = ([0; BLOCK], [0; BLOCK]);
    let (mut total, mut start) = (0, places.start);
    while start < places.end {
        let end = places.end.min(start + BLOCK as u64);
        // At most `BLOCK`.
        let length = (end - start) as usize;
        sweep.domain.fill(start..end, &mut operands[..length]);
        counting.bulk.fill(&operands[..length], &mut results[..length]);
        total = results[..length]
            .iter()
            .fold(total, |total, raw| counting.checksum.add(total, *raw));
        start = end;
    }
    Value::plain(ElementaryType::Lint, total)
}
