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

pub const ENGINE_EXAMPLES: &str = r#"Examples:
  $ echo '{"type":"hello","protocol":1}' | stickler engine
  {"type":"hello","protocol":1,"name":"reference",...}

  stickler engine --engine ironplc                  a compiler with an adapter
  stickler engine --validate python3 my_adapter.py --quiet

One JSON object a line; harness/engines/README.md describes them. --validate ends
with exit code 3 where the adapter is broken, and with 1 where its compiler is
wrong or the adapter reads it wrongly."#;

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
