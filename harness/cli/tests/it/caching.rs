//! Tests the cache of results between runs: which cases are asked again and which are not.

use crate::common::{SUITE, output, text};
use std::fs;
use std::path::Path;
use stickler_report::events::{self, Completeness};
use stickler_run::{Event, Fact};

/// An engine that accepts every program and notes each call; it dies over those with a SINT.
const ENGINE: &str = r#"
[engines.counting]
check = "sh -c 'echo call >> {here}/calls; grep -q SINT $0 && kill -9 $$; exit 0' {file}"
exit = { 0 = "accepted", 1 = "rejected" }
dialects = { ironplc-ed2 = "OPTION", matiec = "OPTION" }
"#;

/// Makes a temporary folder that contains the engine.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_engine(folder.path(), "third");
    folder
}

fn write_engine(folder: &Path, option: &str) {
    let text = ENGINE.replace("OPTION", option);
    fs::write(folder.join("stickler.toml"), text).expect("a configuration");
}

/// The events of a run without its times, its output, and the number of calls of the engine.
struct Ran {
    events: Vec<Event>,
    shown: String,
    reported: String,
    calls: usize,
}

fn run(folder: &Path, options: &[&str]) -> Ran {
    let calls = folder.join("calls");
    let _ = fs::remove_file(&calls);
    let arguments = [
        &["run", "--no-causes", "--cases", SUITE, "--engine", "counting"],
        options,
    ]
    .concat();
    let ran = output(folder, &arguments);
    assert_eq!(ran.status.code(), Some(1), "{}", text(&ran.stderr));
    let mut events = Vec::new();
    let bytes = fs::read(folder.join("reports/latest/events.jsonl")).expect("an event log");
    let mut sink = |mut event: Event| {
        match &mut event {
            Event::Header(header) => {
                header.started.clear();
                header.command.clear();
            }
            Event::Case(case) => case.duration_us = 0,
            Event::Cause(_) => {}
            Event::Footer(footer) => footer.duration_ms = 0,
        }
        events.push(event);
    };
    let completeness = events::read(&bytes[..], &mut sink).expect("a readable log");
    assert_eq!(completeness, Completeness::Complete);
    Ran {
        events,
        shown: text(&ran.stdout),
        reported: text(&ran.stderr),
        calls: fs::read_to_string(calls).unwrap_or_default().lines().count(),
    }
}

/// Returns the number of cases that crashed the engine.
fn crashes(ran: &Ran) -> usize {
    let crash =
        |event: &&Event| matches!(event, Event::Case(case) if Fact::text(&case.got).contains("signal: 9"));
    ran.events.iter().filter(crash).count()
}

#[test]
fn a_second_run_asks_only_what_crashed_and_reports_the_same() {
    let folder = folder();
    let first = run(folder.path(), &[]);
    let crashes = crashes(&first);
    assert!(first.calls > crashes && crashes > 0, "{} {crashes}", first.calls);
    assert!(!first.shown.contains("from the cache"), "{}", first.shown);

    let second = run(folder.path(), &[]);
    assert_eq!(second.calls, crashes);
    assert!(first.events == second.events);
    let cases = first.calls;
    let line = format!(
        "{} of {cases} results come from the cache; see --no-cache.\n",
        cases - crashes
    );
    assert!(second.shown.contains(&line), "{}", second.shown);

    let without = run(folder.path(), &["--no-cache"]);
    assert_eq!(without.calls, cases);
    assert!(first.events == without.events);

    write_engine(folder.path(), "second");
    let changed = run(folder.path(), &[]);
    assert_eq!(changed.calls, cases, "it is another engine");
}

#[test]
fn a_run_without_cache_or_without_reports_leaves_none_behind() {
    let folder = folder();
    run(folder.path(), &["--no-cache"]);
    assert!(!folder.path().join("reports/cache").exists());
    fs::remove_dir_all(folder.path().join("reports")).expect("reports");
    let arguments = ["run", "--cases", SUITE, "--engine", "counting", "--no-report"];
    output(folder.path(), &arguments);
    assert!(!folder.path().join("reports").exists());
}

#[test]
fn a_broken_cache_is_said_and_a_cache_that_cannot_be_kept_too_and_the_run_goes_on() {
    let folder = folder();
    let first = run(folder.path(), &[]);
    let cache = folder.path().join("reports/cache");
    for file in fs::read_dir(&cache).expect("a cache") {
        let path = file.expect("a file").path();
        let text = fs::read_to_string(&path).expect("a text");
        fs::write(&path, text.replace("accepted", "excepted")).expect("a broken cache");
    }
    let second = run(folder.path(), &[]);
    assert_eq!(second.calls, first.calls);
    assert!(
        second.reported.contains("lines are broken"),
        "{}",
        second.reported
    );

    fs::remove_dir_all(&cache).expect("the cache");
    fs::write(&cache, "").expect("a file in the way");
    let third = run(folder.path(), &[]);
    assert_eq!(third.calls, first.calls);
    assert_eq!(
        third.reported.matches("keeps no results").count(),
        1,
        "{}",
        third.reported
    );
    assert!(first.events == second.events && first.events == third.events);
}
