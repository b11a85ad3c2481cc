//! Tests an engine in a process of its own, and what of its misbehaviour a table in `tests/stand-ins/process.md` cannot tell.

use crate::stand_ins::LIMITS;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread;
use std::time::Duration;
use stickler_engines::{Ability, Engine, Outcome, ProcessEngine, ProcessLimits, Session};
use stickler_types::DialectName;

const UNRULY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/adapters/unruly.sh");

fn unruly(limits: ProcessLimits) -> ProcessEngine {
    ProcessEngine::start(&format!("sh '{UNRULY}'"), limits).unwrap()
}

/// Starts the adapter with a path in this variable.
fn unruly_with(variable: &str, path: &Path) -> ProcessEngine {
    let line = format!("env '{variable}={}' sh '{UNRULY}'", path.display());
    ProcessEngine::start(&line, LIMITS).unwrap()
}

/// Asks for a check of a program that tells the adapter how to misbehave.
fn please(session: &mut dyn Session, what: &str) -> Outcome {
    session.check(DialectName::MATIEC, &format!("please: {what}"))
}

fn mkfifo(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

#[test]
fn an_engine_is_who_it_says_and_answers_in_turn() {
    let engine = unruly(LIMITS);
    assert_eq!(engine.identity().name, "unruly");
    assert_eq!(engine.identity().dialects, [DialectName::MATIEC]);
    assert_eq!(engine.identity().abilities, [Ability::Check]);
    let mut session = engine.session().unwrap();
    for number in 0..100 {
        let outcome = please(session.as_mut(), &format!("accept {number}"));
        assert_eq!(outcome, Outcome::ACCEPTED);
    }
    drop(session);
    assert_eq!(engine.named("other".to_owned()).identity().name, "other");
}

#[test]
fn sessions_do_not_share_a_process() {
    let engine = unruly(LIMITS);
    let mut one = engine.session().unwrap();
    let mut other = engine.session().unwrap();
    assert!(matches!(please(one.as_mut(), "die"), Outcome::Crashed { .. }));
    assert_eq!(please(other.as_mut(), "accept"), Outcome::ACCEPTED);
}

#[test]
fn a_request_that_nobody_reads_runs_out_of_time() {
    let limits = ProcessLimits {
        reply: Duration::from_millis(300),
        ..LIMITS
    };
    let engine = unruly(limits);
    let mut session = engine.session().unwrap();
    assert_eq!(please(session.as_mut(), "stop reading"), Outcome::ACCEPTED);
    // More than any pipe holds.
    let outcome = session.check(DialectName::MATIEC, &"x".repeat(4 << 20));
    assert_eq!(outcome, Outcome::TimedOut { after_ms: 300 });
}

#[test]
fn what_a_dead_process_started_is_killed_too() {
    let folder = tempfile::tempdir().unwrap();
    let probe = folder.path().join("probe");
    mkfifo(&probe);
    let engine = unruly_with("WITNESS", &probe);
    // Ends when nobody holds the other side any more.
    let reader = thread::spawn(move || fs::read(probe));
    let mut session = engine.session().unwrap();
    let outcome = please(session.as_mut(), "leave a child");
    assert!(matches!(outcome, Outcome::Crashed { .. }), "{outcome:?}");
    assert_eq!(reader.join().unwrap().unwrap(), b"");
}

#[test]
fn a_session_that_ends_takes_leave() {
    let folder = tempfile::tempdir().unwrap();
    let farewell = folder.path().join("farewell");
    let engine = unruly_with("FAREWELL", &farewell);
    drop(engine.session().unwrap());
    assert_eq!(fs::read(farewell).unwrap(), b"bye\n");
}

#[test]
fn a_process_that_does_not_say_hello_in_time_is_no_engine() {
    let limits = ProcessLimits {
        hello: Duration::from_millis(300),
        ..LIMITS
    };
    let error = ProcessEngine::start("sh -c 'echo waiting >&2; tail -f /dev/null'", limits)
        .err()
        .unwrap();
    assert!(
        error.to_string().contains("did not answer `hello` within 300 ms"),
        "{error}"
    );
}
