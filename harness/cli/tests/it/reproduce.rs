//! Tests `stickler reproduce` where no compiler is here: its files, and its errors.

use crate::common::{STICKLER, SUITE, text};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const CASE: &str = "widening/integer::assignment(SINT,INT,-128)@ironplc-ed2";

/// Runs `stickler reproduce` in a folder, where no compiler can be found.
fn reproduce(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(STICKLER);
    command.arg("reproduce").args(arguments);
    command
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .env("PATH", folder);
    for (variable, _) in std::env::vars_os() {
        if variable.to_string_lossy().starts_with("STICKLER_") {
            command.env_remove(variable);
        }
    }
    command.output().expect("the command runs")
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).expect("the file is there")
}

#[test]
fn the_files_need_no_compiler_to_be_written_and_name_no_place_of_this_machine() {
    let folder = tempfile::tempdir().unwrap();
    let output = reproduce(
        folder.path(),
        &[CASE, "--engine", "ironplc", "shown", "--cases", SUITE],
    );
    let reported = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{reported}");
    assert!(reported.contains("the files are not tried: "), "{reported}");
    assert!(reported.contains("no `ironplcc` on PATH"), "{reported}");
    let shown = folder.path().join("shown");
    let names = ["program.st", "run.sh", "README.md"].map(|name| read(&shown, name));
    let [program, script, page] = &names;
    assert!(program.starts_with("PROGRAM main\n"), "{program}");
    assert!(!program.contains("(*!"), "{program}");
    assert!(
        script.contains("\nIRONPLCC=\"${IRONPLCC:-ironplcc}\"\n"),
        "{script}"
    );
    assert!(page.contains("Expected, by "), "{page}");
    for text in &names {
        assert!(!text.contains(&*folder.path().to_string_lossy()), "{text}");
    }
    assert!(text(&output.stdout).ends_with("To see it again: sh shown/run.sh\n"));
}

#[cfg(unix)]
#[test]
fn the_script_may_be_executed() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    reproduce(
        folder.path(),
        &[CASE, "--engine", "ironplc", "shown", "--cases", SUITE],
    );
    let script = folder.path().join("shown/run.sh");
    assert_eq!(script.metadata().unwrap().permissions().mode() & 0o777, 0o755);
}

#[test]
fn a_file_of_ones_own_shows_the_variables_that_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let source = "PROGRAM main\nVAR\n  speed : INT;\nEND_VAR\n  speed := 5;\nEND_PROGRAM\n";
    fs::write(folder.path().join("motor.st"), source).unwrap();
    let arguments = ["motor.st", "--engine", "matiec", "shown", "--dialect", "matiec"];
    let output = reproduce(
        folder.path(),
        &[&arguments[..], &["--observe", "speed:INT", "--scans", "2"]].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let driver = read(&folder.path().join("shown"), "driver.c");
    for line in [
        "for (unsigned scan = 1; scan <= 2; scan++) {",
        "printf(\"speed = %d\\n\", (int)memory.program.SPEED.value);",
    ] {
        assert!(driver.contains(line), "{driver}");
    }
}

#[test]
fn what_cannot_be_reproduced_is_an_error_that_says_why() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("stickler.toml"),
        "[engines.mine]\ncommand = 'my-adapter'\n",
    )
    .unwrap();
    fs::write(folder.path().join("motor.st"), "").unwrap();
    for (arguments, parts) in [
        (
            &["widening/integr", "--engine", "ironplc", "shown"][..],
            &["there is no case `widening/integr`"][..],
        ),
        (
            &[
                "widening/integer::assignment(SINT,INT,-128)@plcnext",
                "--engine",
                "ironplc",
                "shown",
            ],
            &[
                "is not in the dialect plcnext; did you mean",
                "assignment(SINT,INT,-128)@ironplc-ed2",
            ],
        ),
        (
            &[CASE, "--engine", "ironplcc", "shown"],
            &["`ironplcc`", "`ironplc`"],
        ),
        (
            &[CASE, "--engine", "reference", "shown"],
            &["reference has no command line of its own"],
        ),
        (
            &[CASE, "--engine", "mine", "shown"],
            &["mine has no command line of its own"],
        ),
        (
            &[CASE, "--engine", "cmd:x", "shown"],
            &["cmd:x has no command line of its own"],
        ),
        (
            &[CASE, "--engine", "matiec", "shown"],
            &["matiec does not show", "does not speak"],
        ),
        (
            &[CASE, "--engine", "ironplc", "."],
            &[". is not empty", "name a folder"],
        ),
        (&["motor.st", "--engine", "matiec", "shown"], &["--dialect"]),
        (
            &[
                "motor.st",
                "--engine",
                "matiec",
                "shown",
                "--dialect",
                "matiec",
                "--observe",
                "speed",
            ],
            &["as in `speed:INT`"],
        ),
        (
            &["no.st", "--engine", "matiec", "shown", "--dialect", "matiec"],
            &["cannot read no.st"],
        ),
    ] {
        let output = reproduce(folder.path(), &[arguments, &["--cases", SUITE]].concat());
        let reported = text(&output.stderr);
        let code = if reported.contains("there is no engine") {
            3
        } else {
            2
        };
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {reported}");
        for part in parts {
            assert!(reported.contains(part), "{part}\nin\n{reported}");
        }
        assert!(!folder.path().join("shown").exists(), "{arguments:?}");
    }
}

#[test]
fn a_dialect_that_the_compiler_does_not_speak_is_told_with_one_that_it_speaks() {
    let folder = tempfile::tempdir().unwrap();
    let suite = concat!(env!("CARGO_MANIFEST_DIR"), "/../../conformance-cases");
    let named = ["language/comments@ironplc-ed2", "--engine", "matiec", "shown"];
    let output = reproduce(folder.path(), &[&named[..], &["--cases", suite]].concat());
    let reported = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{reported}");
    for part in ["does not speak", "; it shows `language/comments@matiec`"] {
        assert!(reported.contains(part), "{part}\nin\n{reported}");
    }
}
