//! Tests full disks and files: the run ends with a message, and its exit code is no verdict.

use crate::common::{STICKLER, SUITE, output, text};
use std::fs;
use std::process::Command;

#[test]
fn a_file_that_must_not_grow_is_told_and_does_not_end_the_process_by_a_signal() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let limited = format!("ulimit -f 1; exec '{STICKLER}' run --cases '{SUITE}'");
    let run = Command::new("sh")
        .args(["-c", &limited])
        .current_dir(folder.path())
        .output()
        .expect("a shell");
    assert_eq!(run.status.code(), Some(2), "{}", text(&run.stderr));
    let reported = text(&run.stderr);
    assert!(
        reported.contains("cannot write reports/latest/")
            && reported.contains("; make room, or name another folder: File too large"),
        "{reported}"
    );
    assert!(
        !text(&run.stdout).contains("as expected"),
        "{}",
        text(&run.stdout)
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_and_is_no_verdict() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let latest = folder.path().join("reports/latest");
    fs::create_dir_all(&latest).expect("a folder for reports");
    std::os::unix::fs::symlink("/dev/full", latest.join("events.jsonl")).expect("a link");
    let run = output(folder.path(), &["run", "--cases", SUITE]);
    assert_eq!(run.status.code(), Some(2), "{}", text(&run.stderr));
    let reported = text(&run.stderr);
    assert!(
        reported.contains("cannot write reports/latest/events.jsonl; make room, or name another folder")
            && reported.contains("No space left"),
        "{reported}"
    );
    assert!(
        !text(&run.stdout).contains("as expected"),
        "{}",
        text(&run.stdout)
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_in_which_nobody_may_write_is_told_before_anything_runs() {
    // Permissions do not bind the user root, so the folder is one of the kernel's, in which nobody makes a file.
    let folder = tempfile::tempdir().expect("a temporary folder");
    let run = output(
        folder.path(),
        &["run", "--cases", SUITE, "--report", "/sys/kernel"],
    );
    assert_eq!(run.status.code(), Some(2), "{}", text(&run.stderr));
    let reported = text(&run.stderr);
    assert!(
        reported.contains(
            "cannot write /sys/kernel/events.jsonl; make the folder writable, or name another one: "
        ),
        "{reported}"
    );
    assert_eq!(text(&run.stdout), "", "nothing was run");
}
