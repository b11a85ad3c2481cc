//! The command line of `completions`.

use clap::Args;
use clap_complete::Shell;

/// `stickler completions`.
#[derive(Args, Debug)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub shell: Shell,
}
