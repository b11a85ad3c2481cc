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

/// The examples at the end of the help of `completions`.
pub const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  stickler completions bash > ~/.local/share/bash-completion/completions/stickler
  stickler completions zsh > ~/.zfunc/_stickler
  stickler completions fish > ~/.config/fish/completions/stickler.fish";
