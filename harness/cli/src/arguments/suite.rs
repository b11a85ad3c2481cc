//! The command lines of `stickler list`, `show`, `lint`, `sources` and `changes`, which are about the cases and their sources.

use super::SelectionArguments;
use clap::Args;
use std::path::PathBuf;

/// `stickler list`.
#[derive(Args, Debug)]
pub struct ListArguments {
    /// The selected cases.
    #[command(flatten)]
    pub selection: SelectionArguments,
    /// List claims instead: each section of each document, how many cases check it, and in which files
    #[arg(long)]
    pub basis: bool,
    /// List the numbers instead: how many cases each dialect has in each area, and how many different questions they ask
    #[arg(long, conflicts_with_all = ["basis", "sources", "places", "left_out"])]
    pub count: bool,
    /// List the sources of the claims instead, and Stickler's own rules: what each is, where it opens, for whom it speaks,
    /// and how many of the cases rest on it
    #[arg(long, conflicts_with_all = ["basis", "left_out"])]
    pub sources: bool,
    /// List the places instead in which values stand: how many cases have each source together with each target and surrounding
    #[arg(long, conflicts_with_all = ["basis", "sources", "left_out"])]
    pub places: bool,
    /// List the features of the language instead, each with the tables of IEC 61131-3 that are about it: how many of the cases
    /// use it
    #[arg(long, conflicts_with_all = ["basis", "sources", "places", "count", "left_out"])]
    pub features: bool,
    /// List instead the cases that a dialect of stickler.toml does not take over from the one that it extends, because
    /// what it overrides changes them and no source in Stickler says how
    #[arg(long, conflicts_with = "basis")]
    pub left_out: bool,
    /// Print one JSON object a line
    #[arg(long)]
    pub json: bool,
}

/// `stickler show`.
#[derive(Args, Debug)]
pub struct ShowArguments {
    /// The case's id, with or without `@dialect`
    #[arg(value_name = "CASE")]
    pub case: String,
    /// Draw the scans up to N of a case with many, such as N of a value `count@N` [default: the first ones]
    #[arg(long, value_name = "N")]
    pub scan: Option<u32>,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
}

/// `stickler lint`.
#[derive(Args, Debug)]
pub struct LintArguments {
    /// The folder of the cases [default: conformance-cases here or above, or those inside the program]
    #[arg(value_name = "DIR")]
    pub cases: Option<PathBuf>,
}

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
