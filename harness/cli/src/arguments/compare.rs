//! The arguments of `stickler compare`.

use clap::Args;
use std::path::PathBuf;

/// `stickler compare`.
#[derive(Args, Debug)]
pub struct CompareArguments {
    /// The reports of the older run: their folder, or its events.jsonl
    #[arg(value_name = "OLD")]
    pub old: PathBuf,
    /// The reports of the newer run
    #[arg(value_name = "NEW")]
    pub new: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// The examples at the end of the help of `compare`.
pub const COMPARE_EXAMPLES: &str = "\
Examples:
  stickler run --engine ironplc --report reports/before
  stickler run --engine ironplc                     with the compiler's new version
  stickler compare reports/before reports/latest

The exit code is 1 where something crashed or broke that did not before. Where each run has one engine, the two are
compared whatever their names.";
