//! Engines side by side: each program of a seed is given to all of them, and their results are compared with the evaluator's.
//!
//! The evaluator computes what the documents say a program gives, without any engine. So one engine is enough, and two that
//! are wrong alike are both found.

mod engine;
mod question;
mod reduction;
mod worker;

pub use engine::EngineUnderTest;
pub(crate) use engine::{ask, ask_all, describe};
pub(crate) use question::{Agreement, EvaluatedProgram, JudgedProgram, compare};
pub(crate) use reduction::expected;

use crate::commands::ReproductionCommands;
use crate::exclusions::Exclusions;
use crate::inputs::Inputs;
use crate::oracle::{Oracle, Worker};
use stickler_engines::EngineError;
use stickler_generate::model::Program;
use stickler_types::DialectName;

/// The oracle of a campaign with engines: each program is given to all of them.
pub struct DifferentialOracle<'e> {
    /// The engines.
    pub engines: Vec<EngineUnderTest<'e>>,
    /// The source of the programs.
    pub inputs: Inputs,
    /// The dialects that programs are made for; an engine is asked only for those that it speaks.
    pub dialects: Vec<DialectName>,
    /// Whether programs may use what documents leave open. Values of such programs are not compared.
    pub open: bool,
    /// The parts of the language that programs shall not have.
    pub without: Exclusions,
    /// The parts from which the commands of a finding are written.
    pub commands: ReproductionCommands,
}

impl DifferentialOracle<'_> {
    /// Returns the program at a place; `None` where every program that was tried has something excluded.
    fn program(&self, place: u64) -> Option<Program> {
        self.inputs
            .program_without(place, &self.dialects, self.open, &self.without)
    }
}

impl Oracle for DifferentialOracle<'_> {
    fn worker(&self) -> Result<Box<dyn Worker + '_>, EngineError> {
        Ok(Box::new(worker::DifferentialWorker::new(self)?))
    }
}
