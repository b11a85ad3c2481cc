//! The command lines of `stickler engine` and `stickler engines`.

use clap::Args;

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
