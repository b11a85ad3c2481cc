//! The command lines of `stickler judge`, `port`, `reduce` and `reproduce`, which are given programs.

use super::dialects;
use super::numbers::whole;
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;
use stickler_generate::reduce::OutcomeSymptom;
use stickler_types::{DialectName, Observation};

/// `stickler port`.
#[derive(Args, Debug)]
pub struct PortArguments {
    /// Files of Structured Text that are one program, or folders of files *.st; `-` reads stdin
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// The dialect for which the program was written
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub from: DialectName,
    /// The dialect to which it moves
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub to: DialectName,
    /// Make the suggested changes in the files, unless the program is still rejected after them or computes something else
    #[arg(long)]
    pub fix: bool,
    /// Print one JSON object a finding
    #[arg(long)]
    pub json: bool,
    /// Write the findings to FILE in SARIF 2.1.0, for editors and code scanning
    #[arg(long, value_name = "FILE")]
    pub sarif: Option<PathBuf>,
    /// Read the cases, which say what is documented, from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
}

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

/// `stickler reproduce`.
#[derive(Args, Debug)]
pub struct ReproduceArguments {
    /// The case's id, with or without `@dialect`; or a file of Structured Text, whose name ends with `.st`
    #[arg(value_name = "CASE")]
    pub case: String,
    /// The folder to write to, which is made where there is none, and otherwise must be empty
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// The compiler: one with an adapter, or one that stickler.toml describes; it need not be here
    #[arg(long, value_name = "ENGINE")]
    pub engine: String,
    /// The dialect of a file, or the one in which a case is shown
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Option<DialectName>,
    /// Show this variable of a file, such as `speed:INT`; may be repeated, may be a path [default: whether it is accepted]
    #[arg(long, value_name = "NAME:TYPE", value_parser = observation, requires = "dialect")]
    pub observe: Vec<Observation>,
    /// Run N scans of a file
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<u32>(1, u32::MAX.into()), allow_negative_numbers = true)]
    pub scans: u32,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
}

fn observation(text: &str) -> Result<Observation, String> {
    match text.rsplit_once(':') {
        Some((name, type_name)) if !name.is_empty() && !type_name.is_empty() => {
            Ok(Observation::last(name, type_name))
        }
        _ => Err("write the variable and its type, as in `speed:INT`".to_owned()),
    }
}

/// `stickler judge`.
#[derive(Args, Debug)]
pub struct JudgeArguments {
    /// Files of Structured Text that are one program, or folders of files *.st; `-` reads stdin
    #[arg(value_name = "FILE", required_unless_present = "batch")]
    pub files: Vec<PathBuf>,
    /// Read inputs, clock and expected values by scan from FILE, JSON or CSV
    #[arg(
        long,
        value_name = "FILE",
        required_unless_present = "batch",
        conflicts_with = "batch"
    )]
    pub trace: Option<PathBuf>,
    /// Judge each NAME.st in DIR and the folders in it by NAME.json or NAME.csv, or else by trace.json or trace.csv beside it
    #[arg(long, value_name = "DIR", conflicts_with = "files")]
    pub batch: Option<PathBuf>,
    /// Call this function block once a scan [default: the program of the file; in a file without one its last function block,
    /// or else its last function]
    #[arg(long, value_name = "NAME")]
    pub block: Option<String>,
    /// Call this function once a scan
    #[arg(long, value_name = "NAME", conflicts_with = "block")]
    pub function: Option<String>,
    /// The dialect to read it in
    #[arg(long, value_name = "DIALECT", value_parser = super::dialects())]
    pub dialect: DialectName,
    /// Execute it on this engine, as for `stickler run` [default: reference]
    #[arg(long, value_name = "ENGINE")]
    pub engine: Option<String>,
    /// Let TIME, such as T#10ms, pass from each scan to the next where a trace has no clock
    #[arg(long, value_name = "TIME", value_parser = super::duration)]
    pub cycle: Option<i64>,
    /// Take a REAL or LREAL that is at most DIFFERENCE away from the expected one, where a trace says no other
    #[arg(long, value_name = "DIFFERENCE", default_value_t = 0.0)]
    pub tolerance: f64,
    /// Print one JSON object a trace
    #[arg(long)]
    pub json: bool,
}
