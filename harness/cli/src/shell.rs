//! Commands that can be pasted into a shell.

use std::env;
pub use stickler_engines::shell_quote as quote;

/// Returns how the reader calls `stickler`: one who came by `cargo run` has no `stickler` to call.
pub fn program() -> &'static str {
    // Cargo tells the programs that it runs where their manifest is.
    let by_cargo = env::var_os("CARGO_MANIFEST_DIR").is_some_and(|folder| !folder.is_empty());
    match (by_cargo, cfg!(debug_assertions)) {
        (false, _) => "stickler",
        (true, false) => "cargo run --release --",
        (true, true) => "cargo run --",
    }
}

/// The command line of this process, to be pasted again.
pub fn command_line() -> String {
    let arguments: Vec<String> = env::args_os()
        .skip(1)
        .map(|a| a.to_string_lossy().into_owned())
        .collect();
    let mut line = String::from("stickler");
    for argument in &arguments {
        line.push(' ');
        line.push_str(&quote(argument));
    }
    line
}
