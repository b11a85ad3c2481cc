//! One who judges by the oracles. It needs no conversation, for the reference is in this process.

use super::Oracles;
use crate::bench::{Suspicion, Verdict, Worker};
use crate::finding::Finding;
use stickler_generate::oracles::InputOutcome;

/// A worker.
pub(super) struct Judging<'b> {
    pub(super) bench: &'b Oracles,
}

impl Worker for Judging<'_> {
    fn judge(&mut self, places: &[u64], going: &dyn Fn() -> bool) -> Vec<Verdict> {
        let going = places.iter().take_while(|_| going());
        going.map(|&place| self.judge_one(place)).collect()
    }

    fn reduce(&mut self, suspicion: &Suspicion, going: &dyn Fn() -> bool) -> Finding {
        self.finding(suspicion, going)
    }
}

impl Judging<'_> {
    fn judge_one(&self, place: u64) -> Verdict {
        let target = self.bench.target(place);
        let mut verdict = Verdict::agreed(place);
        match target.judge(&self.bench.input(place)) {
            Ok(InputOutcome::Checked) => {}
            Ok(InputOutcome::Skipped(word)) => verdict.passed_over = Some(word),
            Err(failure) => verdict.suspicions.push(Suspicion {
                place,
                subject: target.name().to_owned(),
                symptom: failure.symptom,
            }),
        }
        verdict
    }
}
