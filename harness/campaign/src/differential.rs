//! Engines side by side: each program of a seed is given to all of them, and what they do is held against the evaluator.
//!
//! The evaluator computes what the documents say a program gives, without any engine. So one engine is enough, and two that
//! are wrong alike are both found.

mod comparison;
mod entrant;
mod finding;
mod pace;
mod pack;
mod subject;
mod told;
mod worker;

pub(crate) use comparison::{Agreement, Disagreement, Question, compare};
pub use entrant::Entrant;
pub(crate) use entrant::ask;
pub(crate) use finding::expected;
pub use pace::Packs;
pub(crate) use subject::Subject;
pub(crate) use told::told;

use crate::bench::{Bench, Worker};
use crate::commands::Commands;
use crate::inputs::Inputs;
use crate::without::Without;
use stickler_engines::EngineError;
use stickler_generate::model::Program;
use stickler_types::DialectName;

/// The bench of a campaign with engines.
pub struct Differential<'e> {
    /// The engines.
    pub entrants: Vec<Entrant<'e>>,
    /// Where programs come from.
    pub inputs: Inputs,
    /// The dialects that programs are made for; an engine is asked only for those that it speaks.
    pub dialects: Vec<DialectName>,
    /// Whether programs may use what documents leave open. Values of such programs are not compared.
    pub open: bool,
    /// What programs shall not have.
    pub without: Without,
    /// When an engine is given several programs at a time.
    pub packs: Packs,
    /// How commands are written.
    pub commands: Commands,
}

impl Differential<'_> {
    /// The program at a place; `None` where nothing comes without what is to be left out.
    fn program(&self, place: u64) -> Option<Program> {
        self.inputs
            .program_without(place, &self.dialects, self.open, &self.without)
    }
}

impl Bench for Differential<'_> {
    fn worker(&self) -> Result<Box<dyn Worker + '_>, EngineError> {
        Ok(Box::new(worker::Asking::new(self)?))
    }
}
