//! A sweep that is interrupted.
#![cfg(unix)]

use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};

#[test]
fn ctrl_c_tells_how_far_a_sweep_came() {
    // Billions of texts, so that it cannot end by itself before the signal comes.
    let mut sweep = Command::new(env!("CARGO_BIN_EXE_stickler"))
        .args(["sweep", "DINT_TO_STRING", "--jobs", "1"])
        .env("NO_COLOR", "1")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let mut out = BufReader::new(sweep.stdout.take().expect("a pipe"));
    let mut lines = String::new();
    // These are shown when the handler stands and the sweep is about to begin.
    for _ in 0..2 {
        out.read_line(&mut lines).expect("a line");
    }
    assert!(lines.contains("4 294 967 296 inputs: every DINT"), "{lines}");
    let killed = Command::new("kill")
        .args(["-INT", &sweep.id().to_string()])
        .status()
        .expect("kill");
    assert!(killed.success());
    out.read_to_string(&mut lines).expect("the rest");
    assert_eq!(sweep.wait().expect("an end").code(), Some(130), "{lines}");
    assert!(lines.contains("  stopped by Ctrl-C after "), "{lines}");
    assert!(lines.contains(" of 4 294 967 296 inputs ("), "{lines}");
    assert!(lines.contains("  no mismatch so far, "), "{lines}");
}
