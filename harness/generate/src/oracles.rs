//! The oracles of the fuzz targets, one file each, and [`FuzzTarget`], which names them all.

mod case_file;
mod check;
mod convert;
pub mod execute;
mod literal;
mod numerals;
mod operands;
mod parse;
mod protocol;
mod spans;
mod target;
mod words;

pub use check::{SoundProgram, check, judge as judge_planted, judge_planted_text, judge_sound_text};
use target::failed;
pub use target::{FuzzTarget, InputOutcome, Judged, OracleFailure};
