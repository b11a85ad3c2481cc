//! Engines that `stickler.toml` names, and the list of all that there are.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

const STICKLER: &str = env!("CARGO_BIN_EXE_stickler");

/// A folder with this `stickler.toml`; `STICKLER` in it stands for the program under test.
fn folder(text: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let text = text.replace("STICKLER", STICKLER);
    fs::write(folder.path().join("stickler.toml"), text).expect("the file is written");
    folder
}

/// Calls `stickler` where no compiler is to be found.
fn stickler(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(STICKLER);
    command.args(arguments).current_dir(folder).env("NO_COLOR", "1");
    command.env("PATH", folder);
    for (variable, _) in std::env::vars_os() {
        if variable.to_string_lossy().starts_with("STICKLER_") {
            command.env_remove(variable);
        }
    }
    command.output().expect("the command runs")
}

fn shown(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn told(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn the_list_says_what_is_here_and_what_is_missing_and_where_its_project_is() {
    let folder = folder("[engines.mine]\ncommand = \"'STICKLER' engine\"\n");
    let output = stickler(folder.path(), &["engines"]);
    assert_eq!(output.status.code(), Some(0), "{}", told(&output));
    let list = shown(&output);
    for part in [
        "reference  0.1.0\n  dialects    ironplc-ed2, ",
        "\nironplc  not here\n  problem     there is no `ironplcc` on PATH; install it, or say where it is by\n",
        "  install     https://www.ironplc.com\n",
        "\nmatiec  not here\n",
        "\nmine  0.1.0\n  named in    stickler.toml:1\n",
    ] {
        assert!(list.contains(part), "{part}\nin\n{list}");
    }
}

#[test]
fn what_was_asked_for_and_is_not_here_is_a_failure() {
    let folder = folder("[engines.old]\nadapter = \"ironplc\"\nironplcc = \"bin/ironplcc\"\n");
    let output = stickler(folder.path(), &["engines", "reference", "old", "--json"]);
    assert_eq!(output.status.code(), Some(3), "{}", told(&output));
    let list = shown(&output);
    let lines: Vec<&str> = list.lines().collect();
    assert_eq!(lines.len(), 2, "{list}");
    assert!(
        lines[0].starts_with("{\"name\":\"reference\",\"here\":true,"),
        "{list}"
    );
    assert!(
        lines[1].starts_with("{\"name\":\"old\",\"here\":false,\"adapter\":\"ironplc\","),
        "{list}"
    );
    assert!(lines[1].contains("stickler.toml:3 names `"), "{list}");
    let output = stickler(folder.path(), &["engines", "odl"]);
    assert_eq!(output.status.code(), Some(3));
    assert!(told(&output).contains("there is no engine `odl`; did you mean `old`?"));
}

#[test]
fn an_engine_of_the_file_runs_under_its_name_there() {
    let folder = folder("[engines.mine]\ncommand = \"'STICKLER' engine\"\n");
    let inside = folder.path().join("inside");
    fs::create_dir(&inside).expect("a folder");
    let output = stickler(
        &inside,
        &["conversions", "BOOL_TO_INT", "--engine", "mine", "--json"],
    );
    assert_eq!(output.status.code(), Some(0), "{}", told(&output));
    assert!(shown(&output).contains("\"mine\""), "{}", shown(&output));
}

#[test]
fn a_described_compiler_is_listed_and_runs() {
    // The reference's own command line serves as the compiler.
    let folder = folder(
        "[engines.described]\ncheck = \"'STICKLER' check {file} --dialect {dialect}\"\n\
         run = \"'STICKLER' eval {file} --dialect {dialect} --scans {scans}\"\n\
         diagnostic = '^error\\[(?<code>\\w+)\\]: (?<message>.*)$(?:\\s+-->\\s+(?<file>\\S+):(?<line>\\d+):(?<column>\\d+))?'\n\
         value = '^(?<name>\\S+) = (?<value>.*)$'\nproject = \"https://example.org\"\n\
         [engines.described.dialects]\nmatiec = \"matiec\"\n\
         [engines.absent]\ncheck = \"no-such-compiler {file}\"\nproject = \"https://example.org\"\ndialects.matiec = \"\"\n",
    );
    let output = stickler(folder.path(), &["engines", "described", "absent"]);
    assert_eq!(output.status.code(), Some(3), "{}", told(&output));
    let list = shown(&output);
    for part in [
        "described  unknown\n  named in    stickler.toml:1\n  run         ",
        "\n  dialects    matiec\n  can         check, execute, scans\n",
        "\nabsent  not here\n",
        "there is no `no-such-compiler` on PATH, which `check` names\n  install     https://example.org\n",
    ] {
        assert!(list.contains(part), "{part}\nin\n{list}");
    }
    let arguments = [
        "conversions",
        "DINT_TO_INT",
        "100000",
        "--engine",
        "described",
        "--dialect",
        "matiec",
    ];
    let output = stickler(folder.path(), &arguments);
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}{}",
        shown(&output),
        told(&output)
    );
    assert!(shown(&output).contains("-31072"), "{}", shown(&output));
}

#[test]
fn a_file_with_a_mistake_stops_what_would_need_it() {
    let folder = folder("[engines.matiec]\nic2c = \"/x\"\n");
    let output = stickler(folder.path(), &["engines"]);
    assert_eq!(output.status.code(), Some(2));
    let message = told(&output);
    assert!(
        message.starts_with("error: stickler.toml:2:1: unknown key `ic2c`"),
        "{message}"
    );
    let other = folder.path().join("other.toml");
    fs::write(&other, "").expect("the file is written");
    let output = stickler(folder.path(), &["engines", "reference", "--config", "other.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", told(&output));
}
