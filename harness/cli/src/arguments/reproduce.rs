//! The command line of `reproduce`.

use super::dialects;
use super::numbers::whole;
use clap::Args;
use std::path::PathBuf;
use stickler_types::{DialectName, Observation};

/// `stickler reproduce`.
#[derive(Args, Debug)]
pub struct ReproduceArguments {
    /// The case's id, with or without `@dialect`; or a file of Structured Text, whose name ends with `.st`
    #[arg(value_name = "CASE")]
    pub case: String,
    /// The folder to write to, which is made where there is none, and otherwise must be empty
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// The compiler: one with an adapter, or one that stickler.toml describes; it need not be here
    #[arg(long, value_name = "ENGINE")]
    pub engine: String,
    /// The dialect of a file, or the one in which a case is shown
    #[arg(long, value_name = "DIALECT", value_parser = dialects())]
    pub dialect: Option<DialectName>,
    /// Show this variable of a file, such as `speed:INT`; may be repeated, may be a path [default: whether it is accepted]
    #[arg(long, value_name = "NAME:TYPE", value_parser = observation, requires = "dialect")]
    pub observe: Vec<Observation>,
    /// Run N scans of a file
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<u32>(1, u32::MAX.into()), allow_negative_numbers = true)]
    pub scans: u32,
    /// Read the cases from DIR [default: conformance-cases here or above, or those inside the program]
    #[arg(long, value_name = "DIR")]
    pub cases: Option<PathBuf>,
}

fn observation(text: &str) -> Result<Observation, String> {
    match text.rsplit_once(':') {
        Some((name, type_name)) if !name.is_empty() && !type_name.is_empty() => {
            Ok(Observation::last(name, type_name))
        }
        _ => Err("write the variable and its type, as in `speed:INT`".to_owned()),
    }
}
