//! The command lines of `stickler bless`, `stickler compare` and `stickler site`, which read the reports of runs.

use clap::Args;
use std::path::PathBuf;

/// `stickler bless`.
#[derive(Args, Debug)]
pub struct BlessArguments {
    /// The folder of a run's reports, or its events.jsonl.gz [default: reports/latest beside the folder of the cases]
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

/// `stickler compare`.
#[derive(Args, Debug)]
pub struct CompareArguments {
    /// The reports of the older run: their folder, or its events.jsonl.gz
    #[arg(value_name = "OLD")]
    pub old: PathBuf,
    /// The reports of the newer run
    #[arg(value_name = "NEW")]
    pub new: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// `stickler site`.
#[derive(Args, Debug)]
pub struct SiteArguments {
    /// The reports of a run: their folder, or an events.jsonl.gz that somebody handed in
    #[arg(value_name = "DIR")]
    pub runs: Vec<PathBuf>,
    /// Read the cases, of whose conversion functions the site tells, from DIR [default: conformance-cases here or above, or those
    /// inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Leave out runs that cannot be read, with a note on stderr; at least one must be readable
    #[arg(long)]
    pub skip_unreadable: bool,
    /// The folder of the site; created where it is missing
    #[arg(short, long, value_name = "SITE")]
    pub output: PathBuf,
}
