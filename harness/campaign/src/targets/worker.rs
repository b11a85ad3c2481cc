//! Judging inputs by the oracles of the fuzz targets. No session is needed, for the reference is in this process.

use super::TargetOracle;
use crate::finding::Finding;
use crate::oracle::{InputVerdict, Mismatch, Worker};
use stickler_generate::oracles::InputOutcome;

impl Worker for &TargetOracle {
    fn judge(&mut self, places: &[u64], going: &dyn Fn() -> bool) -> Vec<InputVerdict> {
        let going = places.iter().take_while(|_| going());
        going.map(|&place| self.judge_one(place)).collect()
    }

    fn reduce(&mut self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding {
        self.finding(mismatch, going)
    }
}

impl TargetOracle {
    fn judge_one(&self, place: u64) -> InputVerdict {
        let target = self.target(place);
        let mut verdict = InputVerdict::agreed(place);
        let input = self.input(place);
        match target.judge(&input) {
            Ok(InputOutcome::Checked) => {}
            Ok(InputOutcome::Skipped(word)) => verdict.passed_over = Some(word),
            Err(failure) => verdict.mismatches.push(Mismatch {
                place,
                subject: target.as_str().to_owned(),
                symptom: failure.symptom,
                rule: Vec::new(),
                size: input.len(),
            }),
        }
        verdict
    }
}
