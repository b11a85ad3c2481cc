//! `cargo xtask bless`: renews every golden text.
//!
//! A golden text is a file with what a program writes now. The test that compares it has `golden` in its name, and writes the file anew
//! where the environment says so; thus a new one needs no entry here.

use crate::{exit_code, root, tabulate};
use std::env;
use std::process::Command;

/// Renews the tables, then every golden text that a test compares; returns the exit code.
pub fn execute() -> u8 {
    let tabulated = tabulate::execute(false);
    let mut tests = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    tests.args([
        "test",
        "--quiet",
        "--workspace",
        "--lib",
        "--bins",
        "--tests",
        "golden",
    ]);
    tests.current_dir(root()).env("STICKLER_BLESS", "1");
    // The switch of `trycmd`, which compares the outputs of the command line.
    tests.env("TRYCMD", "overwrite");
    tabulated.max(exit_code(&mut tests))
}
