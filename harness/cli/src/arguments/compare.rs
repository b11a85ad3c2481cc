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
