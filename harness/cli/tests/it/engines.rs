//! Tests engines that `stickler.toml` names, and the list of all engines.

use crate::common::STICKLER;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

/// Makes a temporary folder with the given `stickler.toml`, in which `STICKLER` stands for the program under test.
fn folder(text: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let text = text.replace("STICKLER", STICKLER);
    fs::write(folder.path().join("stickler.toml"), text).expect("the file is written");
    folder
}

/// Runs `stickler` with an environment in which no compiler can be found.
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

fn reported(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn the_list_says_what_is_here_and_what_is_missing_and_where_its_project_is() {
    let folder = folder("[engines.mine]\ncommand = \"'STICKLER' engine\"\n");
    let output = stickler(folder.path(), &["engines"]);
    assert_eq!(output.status.code(), Some(0), "{}", reported(&output));
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
    assert_eq!(output.status.code(), Some(3), "{}", reported(&output));
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
    assert!(reported(&output).contains("there is no engine `odl`; did you mean `old`?"));
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
    assert_eq!(output.status.code(), Some(0), "{}", reported(&output));
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
    assert_eq!(output.status.code(), Some(3), "{}", reported(&output));
    let list = shown(&output);
    for part in [
        "described  unknown\n  named in    stickler.toml:1\n  run         ",
        "\n  dialects    matiec\n  can         check, execute, scans\n  judged by   code\n",
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
        reported(&output)
    );
    assert!(shown(&output).contains("-31072"), "{}", shown(&output));
}

#[test]
fn every_engine_that_has_a_name_can_be_served_and_validated() {
    let folder = folder("[engines.mine]\ncommand = \"'STICKLER' engine\"\n");
    let page = |name: &str| {
        let output = stickler(folder.path(), &["engine", "--validate", name]);
        assert_eq!(
            output.status.code(),
            Some(0),
            "{}{}",
            shown(&output),
            reported(&output)
        );
        shown(&output)
    };
    assert!(page("reference").ends_with("its compiler gives what it must: 39 of 39.\n"));
    assert_eq!(page("reference"), page("mine"));
    let output = stickler(folder.path(), &["engine", "--validate", "no-such-adapter"]);
    assert_eq!(output.status.code(), Some(3));
    assert!(
        reported(&output).contains("no-such-adapter"),
        "{}",
        reported(&output)
    );
}

/// Checks that validation lets each adapter process end by itself, since a killed one may leave a temporary folder behind.
#[cfg(unix)]
#[test]
fn each_process_that_is_validated_may_come_to_its_own_end() {
    let folder = folder("");
    let script = folder.path().join("adapter.sh");
    let text = format!("echo started >>log\n'{}' engine\necho left >>log\n", STICKLER);
    fs::write(&script, text).expect("written");
    let output = stickler(folder.path(), &["engine", "--validate", "/bin/sh", "adapter.sh"]);
    assert!(output.status.success(), "{}", reported(&output));
    let log = fs::read_to_string(folder.path().join("log")).expect("a log");
    let count = |word| log.lines().filter(|line| *line == word).count();
    assert!(count("started") > 1, "{log}");
    assert_eq!(count("left"), count("started"), "{log}");
}

#[test]
fn a_file_with_a_mistake_stops_what_would_need_it() {
    let folder = folder("[engines.matiec]\nic2c = \"/x\"\n");
    let output = stickler(folder.path(), &["engines"]);
    assert_eq!(output.status.code(), Some(2));
    let message = reported(&output);
    assert!(
        message.starts_with("error: stickler.toml:2:1: unknown key `ic2c`"),
        "{message}"
    );
    let other = folder.path().join("other.toml");
    fs::write(&other, "").expect("the file is written");
    let output = stickler(folder.path(), &["engines", "reference", "--config", "other.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", reported(&output));
}

/// Returns whether Python is installed; reports on stderr where it is not.
fn python() -> bool {
    let there = Command::new("python3").arg("--version").output().is_ok();
    if !there {
        // Not `eprintln`, which nobody sees when the test passes.
        let _ = writeln!(
            std::io::stderr(),
            "skipped: there is no python3 for the example adapter"
        );
    }
    there
}

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines/examples/adapter.py");

/// Runs `stickler` with the environment that the example adapter needs.
fn with_example(arguments: &[&str]) -> Output {
    let mut command = Command::new(STICKLER);
    command
        .args(arguments)
        .env("NO_COLOR", "1")
        .env("STICKLER", STICKLER);
    command.output().expect("the command runs")
}

#[test]
fn the_example_adapter_keeps_to_the_protocol() {
    if !python() {
        return;
    }
    let output = with_example(&["engine", "--validate", "python3", EXAMPLE]);
    let page = shown(&output);
    assert_eq!(output.status.code(), Some(0), "{page}{}", reported(&output));
    assert!(
        page.starts_with("example  1.0\n  dialects    ironplc-ed2, "),
        "{page}"
    );
    assert!(
        page.contains("  ok       `run` gives the value of a sum\n"),
        "{page}"
    );
    assert!(page.ends_with("24 of 24; skipped: 1.\n"), "{page}");
}

#[test]
fn the_example_adapter_runs_cases_as_the_reference_does() {
    if !python() {
        return;
    }
    let cases = concat!(env!("CARGO_MANIFEST_DIR"), "/../../conformance-cases");
    let engine = format!("cmd:python3 '{EXAMPLE}'");
    let output = with_example(&[
        "run",
        "--cases",
        cases,
        "--no-report",
        "--engine",
        &engine,
        "--filter",
        "widening/*assignment(SINT,*@matiec",
    ]);
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}{}",
        shown(&output),
        reported(&output)
    );
}

/// A shell adapter whose first argument is the reply to `hello`, and every other the reply to the next request.
const PARROT: &str = "#!/bin/sh\nfor reply in \"$@\"; do IFS= read -r line || exit 0; printf '%s\\n' \"$reply\"; done\nread -r line\n";

#[test]
fn a_broken_adapter_is_told_from_a_wrong_compiler() {
    let folder = tempfile::tempdir().expect("a folder");
    let parrot = folder.path().join("parrot.sh");
    fs::write(&parrot, PARROT).expect("the file is written");
    let hello = r#"{"type":"hello","protocol":1,"name":"parrot","version":"1","dialects":["matiec"],"abilities":["check"]}"#;
    let validated = |replies: &[&str]| {
        let mut arguments = vec![
            "engine",
            "--validate",
            "sh",
            parrot.to_str().expect("a path"),
            hello,
        ];
        arguments.extend(replies);
        with_example(&arguments)
    };
    let output = validated(&[r#"{"type":"rejected","id":1,"diagnostics":[{"message":"no"}]}"#]);
    let page = shown(&output);
    assert_eq!(output.status.code(), Some(3), "{page}");
    for part in [
        "  WRONG    `check` of a plain program is answered by `accepted`\n             the program is rejected, and is sound: no\n",
        "             → {\"type\":\"check\",\"id\":1,",
        "  BROKEN   a variable that is not declared is rejected, on its line\n             it ended (exit status: 0)\n",
        "  skipped  `run` gives the value of a sum\n",
        "The adapter is broken: ",
    ] {
        assert!(page.contains(part), "{part}\nin\n{page}");
    }
    let output = validated(&["compiling"]);
    assert!(
        shown(&output).contains("`compiling` is no reply"),
        "{}",
        shown(&output)
    );
    let output = validated(&[r#"{"type":"accepted","id":9,"colum":1}"#]);
    assert!(
        shown(&output).contains("it repeats another `id` than 1"),
        "{}",
        shown(&output)
    );
}

#[test]
fn an_adapter_whose_compiler_is_wrong_is_not_broken() {
    if !python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let wrong = folder.path().join("wrong.py");
    let example = fs::read_to_string(EXAMPLE).expect("the example is read");
    let changed = example.replace(
        "line.split(\" = \", 1)",
        "line.replace('INT#5', 'INT#6').split(\" = \", 1)",
    );
    assert_ne!(example, changed);
    fs::write(&wrong, changed).expect("the file is written");
    let output = with_example(&["engine", "--validate", "python3", wrong.to_str().expect("a path")]);
    let page = shown(&output);
    assert_eq!(output.status.code(), Some(1), "{page}");
    assert!(page.contains("`x` is INT#6, and must be INT#5\n"), "{page}");
    assert!(page.contains("Its compiler is wrong in 1 of "), "{page}");
}
