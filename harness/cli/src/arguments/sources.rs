//! The arguments of `stickler sources` and `stickler changes`.

use clap::Args;
use std::path::PathBuf;

/// `stickler sources`.
#[derive(Args, Debug)]
pub struct SourcesArguments {
    /// Only these sources, by their keys in sources.toml
    #[arg(value_name = "SOURCE")]
    pub sources: Vec<String>,
    /// Look for the figures that sources quote in the copies of their pages in DIR: DIR/SOURCE.html, or
    /// DIR/SOURCE/SECTION.html where each section is a page; .htm, .md, .txt and .csv are read, too
    #[arg(long, value_name = "DIR")]
    pub check: Option<PathBuf>,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
    /// Print one JSON object a line
    #[arg(long)]
    pub json: bool,
}

/// `stickler changes`.
#[derive(Args, Debug)]
pub struct ChangesArguments {
    /// The cases of the older version: their folder, or the one in which conformance-cases is
    #[arg(value_name = "OLD")]
    pub old: PathBuf,
    /// The cases of the newer version [default: conformance-cases here or above, or those inside the program]
    #[arg(value_name = "NEW")]
    pub new: Option<PathBuf>,
    /// Write the part about the newer version into FILE, in place of the one that is there
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}
