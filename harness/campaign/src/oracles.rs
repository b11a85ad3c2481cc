//! The reference alone: the oracles of the fuzz targets, in rotation.

mod finding;
mod planted;
mod small;
mod worker;

use crate::bench::{Bench, Worker};
use crate::commands::Commands;
use crate::inputs::Inputs;
use crate::texts;
use stickler_engines::EngineError;
use stickler_generate::oracles::FuzzTarget;

/// The bench of a campaign without engines.
pub struct Oracles {
    /// The targets; the place of an input says which of them judges it. At least one.
    pub targets: Vec<FuzzTarget>,
    /// Where inputs come from.
    pub inputs: Inputs,
    /// How commands are written.
    pub commands: Commands,
}

impl Oracles {
    /// The targets of a campaign for which none is named.
    pub const TARGETS: [FuzzTarget; 5] = [
        FuzzTarget::Execute,
        FuzzTarget::Check,
        FuzzTarget::Convert,
        FuzzTarget::Literal,
        FuzzTarget::Parse,
    ];

    /// The target that judges the input at this place.
    fn target(&self, place: u64) -> FuzzTarget {
        let count = self.targets.len().max(1) as u64;
        let index = usize::try_from(place % count).unwrap_or(0);
        self.targets.get(index).copied().unwrap_or(FuzzTarget::Execute)
    }

    fn input(&self, place: u64) -> Vec<u8> {
        texts::input(self.inputs, place, self.target(place))
    }
}

impl Bench for Oracles {
    fn worker(&self) -> Result<Box<dyn Worker + '_>, EngineError> {
        Ok(Box::new(worker::Judging { bench: self }))
    }
}
