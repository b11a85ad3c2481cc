//! The command line of `reduce`.

use super::dialects;
use super::numbers::whole;
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;
use stickler_generate::reduce::OutcomeSymptom;
use stickler_types::DialectName;

/// `stickler reduce`.
#[derive(Args, Debug)]
pub struct ReduceArguments {
    /// A file of Structured Text; `-` reads stdin
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The engine that does not do what the reference does: a compiler with an adapter, or `cmd:COMMAND LINE`; with the
    /// reference itself, what it says of the program is kept
    #[arg(long, value_name = "ENGINE", default_value = "reference")]
    pub engine: String,
    /// The dialect to read it in [default: the first one of the engine in which the file shows the symptom]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Option<DialectName>,
    /// Keep this symptom: crash, hang, error, rejected:CODE, not-rejected:CODE, value:TYPE, missing:TYPE, fault:FAULT or
    /// no-fault:FAULT [default: the first that shows]
    #[arg(long, value_name = "SYMPTOM")]
    pub symptom: Option<OutcomeSymptom>,
    /// Write the program to FILE instead of stdout
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Ask the engine about at most N smaller programs
    #[arg(long, value_name = "N", default_value_t = 2000, value_parser = whole::<u64>(0, u64::MAX), allow_negative_numbers = true)]
    pub tries: u64,
    /// Take a `cmd:` engine that does not answer within TIME for one that hangs: 500ms, 10s [default: 60s]
    #[arg(long, value_name = "TIME", value_parser = super::fuzz::time)]
    pub hang: Option<Duration>,
}
