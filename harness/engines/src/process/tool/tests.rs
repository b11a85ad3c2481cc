//! Tests with programs that keep to their limits, and programs that do not.

use super::*;
use std::fs;

const LIMITS: ToolLimits = ToolLimits {
    time: Duration::from_secs(60),
    cpu: Duration::from_secs(60),
    output: 1 << 16,
    memory: 1 << 30,
};

fn shell(script: &str, limits: ToolLimits) -> Result<Ended, Outcome> {
    run(Path::new("sh"), &["-c", script], Path::new("/"), &limits)
}

/// Returns how a program ended, in a line.
fn shown(ended: Result<Ended, Outcome>) -> String {
    let told = ended.and_then(|ended| {
        let code = ended.code()?;
        Ok(format!(
            "{code} {} {}",
            ended.stdout.trim_end(),
            ended.stderr.trim_end()
        ))
    });
    told.unwrap_or_else(|outcome| outcome.to_string())
}

#[test]
fn what_keeps_to_its_limits_is_told_and_what_does_not_is_killed() {
    let short = ToolLimits {
        time: Duration::from_millis(300),
        ..LIMITS
    };
    let late = Outcome::TimedOut { after_ms: 300 }.to_string();
    let flood = "it wrote more than 65536 bytes; its last words: y | y | y | ";
    for (script, limits, part) in [
        // Both streams and the exit code are told.
        ("echo out; echo err >&2; exit 3", LIMITS, "3 out err"),
        // A signal is a crash with the last words.
        ("echo bad luck >&2; kill -ABRT $$", LIMITS, "signal: 6"),
        (
            "echo bad luck >&2; kill -ABRT $$",
            LIMITS,
            "; its last words: bad luck",
        ),
        // What takes too long is killed, also where it says nothing more or ignores the signal to end.
        ("tail -f /dev/null", short, &late),
        ("exec >/dev/null 2>&1; tail -f /dev/null", short, &late),
        (
            "trap '' TERM INT HUP; while :; do tail -f /dev/null; done",
            short,
            &late,
        ),
        // What writes without end is killed.
        ("yes", LIMITS, flood),
        ("yes >&2", LIMITS, flood),
        // The end is seen although a child holds the output.
        ("tail -f /dev/null & echo done; exit 0", LIMITS, "0 done "),
    ] {
        let shown = shown(shell(script, limits));
        assert!(shown.contains(part), "{script}: {shown}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_takes_too_much_memory_or_time_of_the_processor_is_killed_with_its_children() {
    let memory = ToolLimits {
        memory: 1 << 10,
        ..LIMITS
    };
    // Each shell alone holds less than it may.
    let shells = ToolLimits {
        memory: 8 << 20,
        ..LIMITS
    };
    let cpu = ToolLimits {
        cpu: Duration::from_millis(100),
        ..LIMITS
    };
    for (script, limits, reason) in [
        (
            "echo busy >&2; tail -f /dev/null",
            memory,
            "it held more than 0 MiB of memory; its last words: busy",
        ),
        (
            "exec >/dev/null 2>&1; tail -f /dev/null",
            memory,
            "it held more than 0 MiB of memory",
        ),
        (
            "for each in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do sh -c 'tail -f /dev/null; :' & done; wait",
            shells,
            "it held more than 8 MiB of memory",
        ),
        (
            "while :; do :; done",
            cpu,
            "it took more than 0.1 seconds of processor time",
        ),
        (
            "sh -c 'while :; do :; done' & wait",
            cpu,
            "it took more than 0.1 seconds of processor time",
        ),
    ] {
        let reason = reason.to_owned();
        assert_eq!(
            shell(script, limits).unwrap_err(),
            Outcome::Crashed { reason },
            "{script}"
        );
    }
}

#[test]
fn what_cannot_be_started_is_an_error_that_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("compiler");
    fs::write(&file, "#!/bin/sh\n").unwrap();
    let nothing: [&str; 0] = [];
    for (program, part) in [
        (file.as_path(), "ermission denied"),
        (Path::new("/no/such/program"), "/no/such/program"),
    ] {
        let outcome = run(program, &nothing, folder.path(), &LIMITS).unwrap_err();
        let Outcome::Error { message } = outcome else {
            panic!("no error")
        };
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn temporary_files_lie_in_the_folder_and_go_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let script = "echo text >\"$TMPDIR/left.tmp\"; mktemp >name; kill -KILL $$";
    let ended = run(Path::new("sh"), &["-c", script], folder.path(), &LIMITS).unwrap();
    assert!(ended.code().is_err());
    assert!(folder.path().join("left.tmp").is_file());
    let other = fs::read_to_string(folder.path().join("name")).unwrap();
    assert_eq!(Path::new(other.trim()).parent(), Some(folder.path()));
}

#[cfg(target_os = "linux")]
#[test]
fn what_leaves_its_group_is_not_waited_for() {
    let folder = tempfile::tempdir().unwrap();
    let pipes = [folder.path().join("ready"), folder.path().join("end")];
    assert!(Command::new("mkfifo").args(&pipes).status().unwrap().success());
    // The group must not be killed before the child has left it.
    let script = "setsid sh -c 'echo >ready; read line <end' & read line <ready; echo done";
    let ended = run(Path::new("sh"), &["-c", script], folder.path(), &LIMITS);
    assert_eq!(shown(ended), "0 done ");
    // It ends once somebody has had the other side of this open.
    drop(fs::OpenOptions::new().write(true).open(&pipes[1]));
}
