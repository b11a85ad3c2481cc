//! The arguments of `stickler judge`.

use clap::Args;
use std::path::PathBuf;
use stickler_types::DialectName;

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
