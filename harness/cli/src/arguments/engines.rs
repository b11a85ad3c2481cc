//! The command lines of `stickler engine`, `stickler engines` and `stickler record`.

use super::dialects;
use super::numbers::whole;
use clap::Args;
use std::path::PathBuf;
use stickler_conversions::recording::RecordedSection;
use stickler_types::DialectName;

/// `stickler engine`.
#[derive(Args, Debug)]
pub struct EngineArguments {
    /// Serve this engine: a name that `stickler engines` lists [default: reference]
    #[arg(long, value_name = "ENGINE", conflicts_with = "validate")]
    pub engine: Option<String>,
    /// Start this adapter, ask it the questions of the smoke set, and tell whether it is broken or its compiler wrong: a
    /// command with its arguments, or the name of an engine
    #[arg(long, value_name = "CMD", num_args = 1.., allow_hyphen_values = true)]
    pub validate: Vec<String>,
}

/// `stickler engines`.
#[derive(Args, Debug)]
pub struct EnginesArguments {
    /// Only these: exit code 3 tells that one of them cannot be used
    #[arg(value_name = "ENGINE")]
    pub engine: Vec<String>,
    /// Print one JSON object a line
    #[arg(long)]
    pub json: bool,
}

/// `stickler record`.
#[derive(Args, Debug)]
pub struct RecordArguments {
    /// Ask this engine, as for `stickler run`
    #[arg(long, value_name = "ENGINE")]
    pub engine: String,
    /// Write FILE, such as conformance-cases/recordings/NAME.toml [default: stdout]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Only this dialect; may be repeated [default: all that the engine speaks]
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Vec<DialectName>,
    /// Only this section: implicit, bits, comparisons or functions; may be repeated [default: all]. What FILE holds of the others stays
    #[arg(long, value_name = "SECTION", value_parser = super::one_of(RecordedSection::ALL, RecordedSection::as_str), hide_possible_values = true)]
    pub only: Vec<RecordedSection>,
    /// The name of the compiler [default: that of the engine]
    #[arg(long, value_name = "TEXT")]
    pub product: Option<String>,
    /// The version of the compiler [default: as the engine says]
    #[arg(long, value_name = "TEXT", alias = "version")]
    pub product_version: Option<String>,
    /// The commit from which the compiler was built, where that is known
    #[arg(long, value_name = "TEXT")]
    pub commit: Option<String>,
    /// Ask N programs at a time [default: one a processor]
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1024), allow_negative_numbers = true)]
    pub jobs: Option<u16>,
}
