//! The arguments of `stickler site`.

use clap::Args;
use std::path::PathBuf;

/// `stickler site`.
#[derive(Args, Debug)]
pub struct SiteArguments {
    /// The reports of a run: their folder, or its events.jsonl
    #[arg(value_name = "DIR")]
    pub runs: Vec<PathBuf>,
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

Open site/index.html. Of several runs of one version of an engine, the newest by date counts.";
