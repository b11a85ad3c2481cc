//! Tests the example adapter in Python, an adapter in another language; where no Python is installed, each test says so and checks nothing.

use crate::common::{ROOT, STICKLER, stickler, text};
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Command;
use stickler_mdtest::assert_fits;

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines/examples/adapter.py");

/// Runs `stickler` with the environment that the example adapter needs; returns its exit code and its output on both streams.
fn with_example(arguments: &[&str]) -> Option<(Option<i32>, String)> {
    if Command::new("python3").arg("--version").output().is_err() {
        // Not `eprintln`, which nobody sees when the test passes.
        let _ = writeln!(
            std::io::stderr(),
            "skipped: there is no python3 for the example adapter"
        );
        return None;
    }
    let mut command = stickler(Path::new("."), arguments);
    let output = command
        .env("STICKLER", STICKLER)
        .output()
        .expect("the command runs");
    Some((output.status.code(), text(&output.stdout) + &text(&output.stderr)))
}

#[test]
fn it_keeps_to_the_protocol() {
    let Some((code, page)) = with_example(&["engine", "--validate", "python3", EXAMPLE]) else {
        return;
    };
    assert_eq!(code, Some(0), "{page}");
    assert_fits(&page, "example  1.0\n  dialects    ironplc-ed2, …");
    assert_fits(&page, "…  ok       `run` gives the value of a sum\n…");
    assert!(page.ends_with("25 of 25; skipped: 1.\n"), "{page}");
}

#[test]
fn it_runs_cases_as_the_reference_does() {
    let cases = format!("{ROOT}/conformance-cases");
    let engine = format!("cmd:python3 '{EXAMPLE}'");
    let run = ["run", "--cases", &cases, "--no-report", "--engine", &engine];
    let filter = ["--filter", "widening/*assignment(SINT,*@matiec"];
    if let Some((code, page)) = with_example(&[&run[..], &filter].concat()) {
        assert_eq!(code, Some(0), "{page}");
    }
}

#[test]
fn an_adapter_whose_compiler_is_wrong_is_not_broken() {
    let folder = tempfile::tempdir().expect("a folder");
    let wrong = folder.path().join("wrong.py");
    let example = fs::read_to_string(EXAMPLE).expect("the example is read");
    let changed = example.replace(
        "line.split(\" = \", 1)",
        "line.replace('INT#5', 'INT#6').split(\" = \", 1)",
    );
    assert_ne!(example, changed);
    fs::write(&wrong, changed).expect("the file is written");
    let validate = ["engine", "--validate", "python3", wrong.to_str().expect("a path")];
    if let Some((code, page)) = with_example(&validate) {
        assert_eq!(code, Some(1), "{page}");
        assert!(page.contains("`x` is INT#6, and must be INT#5\n"), "{page}");
        assert!(page.contains("Its compiler is wrong in 1 of "), "{page}");
    }
}
