//! Tests what a golden text cannot show: tables of any width, and readers that go away.

use crate::common::{ROOT, SUITE, stickler, text, under_way};
use std::path::Path;

#[test]
fn the_tables_fit_the_columns_and_a_pipe_gets_no_control_character() {
    let whole = format!("{ROOT}/conformance-cases");
    for width in [60, 100, 200] {
        let arguments = ["run", "--cases", &whole, "--filter", "language/*", "--no-report"];
        let mut command = stickler(Path::new("."), &arguments);
        let run = command.env("COLUMNS", width.to_string()).env_remove("NO_COLOR");
        let run = run.output().expect("the command runs");
        assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
        let shown = text(&run.stdout);
        let widest = shown.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(width) && shown.lines().count() <= 24, "{shown}");
        let streams = format!("{shown}{}", text(&run.stderr));
        assert!(
            !streams.chars().any(|c| c.is_control() && c != '\n'),
            "{streams:?}"
        );
    }
}

/// Runs a command whose reader is gone; returns its exit code and what it reports.
fn unread(arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = under_way(&mut stickler(Path::new("."), arguments));
    drop(command.stdout.take());
    let end = command.wait_with_output().expect("the command ends");
    (end.status.code(), text(&end.stderr))
}

#[test]
fn a_reader_that_goes_away_is_no_error_and_does_not_turn_a_rejection_into_success() {
    assert_eq!(unread(&["list", "--cases", SUITE]), (Some(0), String::new()));
    let rejected = ["check", "tests/cmd/source.in/bytes.st", "--dialect", "matiec"];
    let (code, reported) = unread(&rejected);
    assert_eq!(code, Some(1), "{reported}");
}
