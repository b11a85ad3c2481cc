//! The command line of `stickler engines`.

use clap::Args;

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

pub const ENGINES_EXAMPLES: &str = "\
Examples:
  stickler engines
  stickler engines ironplc matiec                   are these two here?
  stickler engines --json                           for other programs";
