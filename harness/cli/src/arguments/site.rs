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

/// The examples at the end of the help of `site`.
pub const SITE_EXAMPLES: &str = "\
Examples:
  stickler run --engine ironplc --report runs/before
  stickler run --engine ironplc --report runs/after     with the compiler's new version
  stickler site runs/before runs/after -o site

  stickler site runs/* handed-in/vendor.jsonl -o site    an events.jsonl alone, of any name

Open site/index.html. Of several runs of one version of an engine the latest counts that has nearly as many cases
as the largest; the site and stderr say which do not count.";
