//! The oracle of a campaign without engines: the fuzz targets, which judge the reference, in rotation.

mod planted;
mod reduction;

use crate::commands::ReproductionCommands;
use crate::finding::Finding;
use crate::inputs::Inputs;
use crate::oracle::{InputVerdict, Mismatch, Oracle, Worker};
use crate::texts;
use stickler_engines::EngineError;
use stickler_generate::oracles::{FuzzTarget, InputOutcome};

/// The oracle of a campaign without engines: each input is judged by a fuzz target.
pub struct TargetOracle {
    /// The targets; the place of an input says which of them judges it. At least one.
    pub targets: Vec<FuzzTarget>,
    /// The source of the inputs.
    pub inputs: Inputs,
    /// The parts from which the commands of a finding are written.
    pub commands: ReproductionCommands,
}

impl TargetOracle {
    /// The targets of a campaign for which none is named.
    pub const TARGETS: [FuzzTarget; 5] = [
        FuzzTarget::Execute,
        FuzzTarget::Check,
        FuzzTarget::Convert,
        FuzzTarget::Literal,
        FuzzTarget::Parse,
    ];

    /// Returns the target that judges the input at this place.
    fn target(&self, place: u64) -> FuzzTarget {
        let count = self.targets.len().max(1) as u64;
        let index = usize::try_from(place % count).unwrap_or(0);
        self.targets.get(index).copied().unwrap_or(FuzzTarget::Execute)
    }

    fn input(&self, place: u64) -> Vec<u8> {
        texts::input(self.inputs, place, self.target(place))
    }
}

impl Oracle for TargetOracle {
    fn worker(&self) -> Result<Box<dyn Worker + '_>, EngineError> {
        Ok(Box::new(self))
    }
}

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
        let mut verdict = InputVerdict {
            place,
            ..InputVerdict::default()
        };
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
