//! Functions that several tests of the command line share.

use std::path::Path;
use std::process::{Child, Command, Stdio};

/// The program under test.
pub const STICKLER: &str = env!("CARGO_BIN_EXE_stickler");

/// A small suite, on which the reference is right.
pub const SUITE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/cmd/suite.in/conformance-cases"
);

/// The folder of the clone.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// What the environment of each command says.
pub const ENVIRONMENT: [(&str, &str); 4] = [
    // Rerun commands name `stickler` itself unless cargo ran it, and here cargo runs the tests.
    ("CARGO_MANIFEST_DIR", ""),
    ("NO_COLOR", "1"),
    // The tests may run in a job of GitHub.
    ("GITHUB_ACTIONS", ""),
    // No line of their output is broken, unless they ask for that.
    ("COLUMNS", ""),
];

/// Returns the command that runs the program in a folder, with an empty stdin and no colours.
pub fn stickler(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(STICKLER);
    command
        .envs(ENVIRONMENT)
        .current_dir(folder)
        .args(arguments)
        .stdin(Stdio::null());
    command
}

/// Starts a command with both of its output streams piped.
pub fn under_way(command: &mut Command) -> Child {
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().expect("the command starts")
}

/// Returns the text of an output stream.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Sends SIGINT to a process, as Ctrl-C does.
#[cfg(unix)]
pub fn interrupt(process: &Child) {
    let killed = Command::new("kill")
        .args(["-INT", &process.id().to_string()])
        .status();
    assert!(killed.expect("kill").success());
}
