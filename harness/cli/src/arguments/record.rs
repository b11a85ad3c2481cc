//! The arguments of `stickler record`.

use super::dialects;
use super::numbers::whole;
use clap::Args;
use std::path::PathBuf;
use stickler_conversions::recording::RecordedSection;
use stickler_types::DialectName;

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
