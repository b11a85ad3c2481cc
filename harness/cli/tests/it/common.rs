//! What several tests of the command do.

use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

/// The program under test.
pub const STICKLER: &str = env!("CARGO_BIN_EXE_stickler");

/// A small suite, on which the reference is right.
pub const SUITE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/cmd/suite.in/conformance-cases"
);

/// The program in a folder, with nothing to read and no colours.
pub fn stickler(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(STICKLER);
    command
        // Rerun commands name `stickler` itself unless cargo ran it, and here cargo runs the tests.
        .env("CARGO_MANIFEST_DIR", "")
        .env("NO_COLOR", "1")
        .current_dir(folder)
        .args(arguments)
        .stdin(Stdio::null());
    command
}

/// What the program does in a folder.
pub fn output(folder: &Path, arguments: &[&str]) -> Output {
    stickler(folder, arguments).output().expect("the command runs")
}

/// A command that is under way, with both of its streams to be read.
pub fn under_way(command: &mut Command) -> Child {
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().expect("the command starts")
}

/// What a stream of it holds.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Sends a process what Ctrl-C sends.
#[cfg(unix)]
pub fn interrupt(process: &Child) {
    let killed = Command::new("kill")
        .args(["-INT", &process.id().to_string()])
        .status();
    assert!(killed.expect("kill").success());
}
