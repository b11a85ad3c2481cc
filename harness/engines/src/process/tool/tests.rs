//! Tests with programs that keep to their limits, and programs that do not.

use super::*;

const LIMITS: ToolLimits = ToolLimits {
    time: Duration::from_secs(60),
    cpu: Duration::from_secs(60),
    output: 1 << 16,
    memory: 1 << 30,
};

fn shell(script: &str, limits: ToolLimits) -> Result<Ended, Outcome> {
    run(Path::new("sh"), &["-c", script], Path::new("/"), &limits)
}

#[test]
fn both_streams_and_the_exit_code_are_told() {
    let ended = shell("echo out; echo err >&2; exit 3", LIMITS).unwrap();
    assert_eq!((ended.stdout.as_str(), ended.stderr.as_str()), ("out\n", "err\n"));
    assert_eq!(ended.code(), Ok(3));
}

#[test]
fn a_signal_is_a_crash_with_the_last_words() {
    let outcome = shell("echo bad luck >&2; kill -ABRT $$", LIMITS)
        .unwrap()
        .code()
        .unwrap_err();
    let Outcome::Crashed { reason } = outcome else {
        panic!("no crash")
    };
    assert!(
        reason.contains("signal: 6") && reason.ends_with("bad luck"),
        "{reason}"
    );
}

#[test]
fn what_takes_too_long_is_killed() {
    let time = Duration::from_millis(300);
    let hang = shell("tail -f /dev/null", ToolLimits { time, ..LIMITS });
    assert_eq!(hang.unwrap_err(), Outcome::TimedOut { after_ms: 300 });
    let silent = shell(
        "exec >/dev/null 2>&1; tail -f /dev/null",
        ToolLimits { time, ..LIMITS },
    );
    assert_eq!(silent.unwrap_err(), Outcome::TimedOut { after_ms: 300 });
}

#[test]
fn what_writes_without_end_is_killed() {
    for flood in ["yes", "yes >&2"] {
        let Outcome::Crashed { reason } = shell(flood, LIMITS).unwrap_err() else {
            panic!("no crash")
        };
        let words = "it wrote more than 65536 bytes; its last words: y | y | y | ";
        assert!(reason.starts_with(words), "{reason}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_takes_too_much_memory_is_killed() {
    let limits = ToolLimits {
        memory: 1 << 10,
        ..LIMITS
    };
    let scripts = [
        ("echo busy >&2; tail -f /dev/null", "; its last words: busy"),
        ("exec >/dev/null 2>&1; tail -f /dev/null", ""),
    ];
    for (script, words) in scripts {
        let outcome = shell(script, limits).unwrap_err();
        let reason = format!("it held more than 0 MiB of memory{words}");
        assert_eq!(outcome, Outcome::Crashed { reason }, "{script}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn the_memory_of_what_a_process_started_counts_with_its_own() {
    // Each shell alone holds less than it may.
    let limits = ToolLimits {
        memory: 8 << 20,
        ..LIMITS
    };
    let outcome = shell(
        "for each in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do sh -c 'tail -f /dev/null; :' & done; wait",
        limits,
    );
    assert!(matches!(outcome, Err(Outcome::Crashed { .. })), "{outcome:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn what_computes_for_too_long_is_killed_although_its_children_did_it() {
    let limits = ToolLimits {
        cpu: Duration::from_millis(100),
        ..LIMITS
    };
    for script in ["while :; do :; done", "sh -c 'while :; do :; done' & wait"] {
        let outcome = shell(script, limits).unwrap_err();
        let reason = "it took more than 0.1 seconds of processor time".to_owned();
        assert_eq!(outcome, Outcome::Crashed { reason }, "{script}");
    }
}

#[test]
fn what_ignores_the_signal_to_end_is_killed_all_the_same() {
    let time = Duration::from_millis(300);
    let stubborn = "trap '' TERM INT HUP; while :; do tail -f /dev/null; done";
    let outcome = shell(stubborn, ToolLimits { time, ..LIMITS });
    assert_eq!(outcome.unwrap_err(), Outcome::TimedOut { after_ms: 300 });
}

#[test]
fn what_is_not_executable_is_an_error_that_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("compiler");
    std::fs::write(&file, "#!/bin/sh\n").unwrap();
    let nothing: [&str; 0] = [];
    let Outcome::Error { message } = run(&file, &nothing, folder.path(), &LIMITS).unwrap_err() else {
        panic!("no error")
    };
    assert!(message.contains("ermission denied"), "{message}");
}

#[test]
fn the_end_is_seen_although_a_child_holds_the_output() {
    let ended = shell("tail -f /dev/null & echo done; exit 0", LIMITS).unwrap();
    assert_eq!(ended.stdout, "done\n");
    assert_eq!(ended.code(), Ok(0));
}

#[test]
fn temporary_files_lie_in_the_folder_and_go_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let script = "echo text >\"$TMPDIR/left.tmp\"; mktemp >name; kill -KILL $$";
    let ended = run(Path::new("sh"), &["-c", script], folder.path(), &LIMITS).unwrap();
    assert!(ended.code().is_err());
    assert!(folder.path().join("left.tmp").is_file());
    let other = std::fs::read_to_string(folder.path().join("name")).unwrap();
    assert_eq!(Path::new(other.trim()).parent(), Some(folder.path()));
}

#[cfg(target_os = "linux")]
#[test]
fn what_leaves_its_group_is_not_waited_for() {
    let folder = tempfile::tempdir().unwrap();
    let made = Command::new("mkfifo")
        .args([folder.path().join("ready"), folder.path().join("end")])
        .status();
    assert!(made.unwrap().success());
    // The group must not be killed before the child has left it.
    let script = "setsid sh -c 'echo >ready; read line <end' & read line <ready; echo done";
    let ended = run(Path::new("sh"), &["-c", script], folder.path(), &LIMITS).unwrap();
    assert_eq!((ended.stdout.as_str(), ended.code()), ("done\n", Ok(0)));
    // It ends once somebody has had the other side of this open.
    drop(
        std::fs::OpenOptions::new()
            .write(true)
            .open(folder.path().join("end")),
    );
}

#[test]
fn what_cannot_be_started_is_an_error() {
    let nothing: [&str; 0] = [];
    let outcome = run(Path::new("/no/such/program"), &nothing, Path::new("/"), &LIMITS).unwrap_err();
    let Outcome::Error { message } = outcome else {
        panic!("no error")
    };
    assert!(message.contains("/no/such/program"), "{message}");
}
