//! The arguments of `stickler site`.

use clap::Args;
use std::path::PathBuf;

/// `stickler site`.
#[derive(Args, Debug)]
pub struct SiteArguments {
    /// The reports of a run: their folder, or an events.jsonl that somebody handed in
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
