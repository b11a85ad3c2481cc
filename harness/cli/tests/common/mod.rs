//! What several tests of the command do.

use std::process::{Child, Command};

/// Sends a process what Ctrl-C sends.
pub fn interrupt(process: &Child) {
    let killed = Command::new("kill")
        .args(["-INT", &process.id().to_string()])
        .status();
    assert!(killed.expect("kill").success());
}
