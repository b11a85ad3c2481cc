//! Formats commands that can be pasted into a shell.

use std::env;
pub use stickler_engines::shell_quote as quote;

/// Returns the words by which the user calls this program: `stickler`, or the command of `cargo run` under which it runs.
pub fn program() -> &'static str {
    // Cargo sets an environment variable with the place of the manifest for the programs that it runs.
    let by_cargo = env::var_os("CARGO_MANIFEST_DIR").is_some_and(|folder| !folder.is_empty());
    match (by_cargo, cfg!(debug_assertions)) {
        (false, _) => "stickler",
        (true, false) => "cargo run --release --",
        (true, true) => "cargo run --",
    }
}

/// Returns the command line of this process, quoted for a shell.
pub fn command_line() -> String {
    let arguments = env::args_os().skip(1);
    let quoted = arguments.map(|argument| format!(" {}", quote(&argument.to_string_lossy())));
    format!("stickler{}", quoted.collect::<String>())
}
