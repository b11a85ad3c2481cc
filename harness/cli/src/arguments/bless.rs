//! The arguments of `stickler bless`.

use clap::Args;
use std::path::PathBuf;

/// `stickler bless`.
#[derive(Args, Debug)]
pub struct BlessArguments {
    /// The folder of a run's reports, or its events.jsonl [default: reports/latest beside the folder of the cases]
    #[arg(value_name = "REPORT")]
    pub report: Option<PathBuf>,
    /// Only the baseline of this engine, by its name in the report; may be repeated [default: all but the reference]
    #[arg(long, value_name = "ENGINE")]
    pub engine: Vec<String>,
    /// Rewrite FILE [default: reports/baselines/ENGINE.toml beside the folder of the cases]
    #[arg(long, value_name = "FILE")]
    pub baseline: Option<PathBuf>,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Only show what would be different
    #[arg(long)]
    pub dry_run: bool,
}
