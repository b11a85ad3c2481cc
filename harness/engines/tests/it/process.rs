//! Tests an engine in a process of its own, and every way in which it may misbehave.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread;
use std::time::Duration;
use stickler_engines::{Ability, Engine, Outcome, ProcessEngine, ProcessLimits, RunRequest, Session};
use stickler_types::DialectName;

const UNRULY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/adapters/unruly.sh");

/// Limits that suffice on a busy machine; a test of a process that hangs sets shorter ones.
const LIMITS: ProcessLimits = ProcessLimits {
    hello: Duration::from_secs(60),
    reply: Duration::from_secs(60),
    line: 1 << 16,
    memory: 4 << 30,
};

fn unruly(limits: ProcessLimits) -> ProcessEngine {
    ProcessEngine::start(&format!("sh '{UNRULY}'"), limits).unwrap()
}

/// Asks for a check of a program that tells the adapter how to misbehave.
fn please(session: &mut dyn Session, what: &str) -> Outcome {
    session.check(DialectName::MATIEC, &format!("please: {what}"))
}

/// Returns the outcome of asking the adapter to misbehave, and checks that it answers as usual afterwards.
fn outcome_of(what: &str, limits: ProcessLimits) -> Outcome {
    let engine = unruly(limits);
    let mut session = engine.session().unwrap();
    let outcome = please(session.as_mut(), what);
    assert_eq!(
        please(session.as_mut(), "accept"),
        Outcome::ACCEPTED,
        "after {what}"
    );
    outcome
}

/// Returns the outcome of asking the adapter to misbehave, without a further request, which might exceed a short time limit.
fn outcome_of_slow(what: &str, limits: ProcessLimits) -> Outcome {
    let engine = unruly(limits);
    let mut session = engine.session().unwrap();
    please(session.as_mut(), what)
}

fn not_started(command_line: &str) -> String {
    let error = ProcessEngine::start(command_line, LIMITS)
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.contains("`cmd:") && error.contains("could not be started"),
        "{error}"
    );
    error
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
fn a_process_that_exits_has_crashed_and_its_last_words_are_told() {
    let Outcome::Crashed { reason } = outcome_of("exit", LIMITS) else {
        panic!("no crash")
    };
    assert_eq!(
        reason,
        "it ended (exit status: 7); its stderr ends: first | out of cheese"
    );
}

#[test]
fn a_process_that_a_signal_ends_has_crashed() {
    let Outcome::Crashed { reason } = outcome_of("die", LIMITS) else {
        panic!("no crash")
    };
    assert!(reason.contains("signal: 9"), "{reason}");
}

#[test]
fn a_process_that_does_not_answer_runs_out_of_time() {
    let limits = ProcessLimits {
        reply: Duration::from_millis(300),
        ..LIMITS
    };
    let engine = unruly(limits);
    let mut session = engine.session().unwrap();
    let outcome = please(session.as_mut(), "hang");
    assert_eq!(outcome, Outcome::TimedOut { after_ms: 300 });
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
fn an_answer_without_an_end_is_an_error() {
    let outcome = outcome_of("flood", LIMITS);
    let message = "its answer is longer than 65536 bytes".to_owned();
    assert_eq!(outcome, Outcome::Error { message });
}

#[test]
fn nonsense_is_an_error_and_quoted() {
    let Outcome::Error { message } = outcome_of("talk", LIMITS) else {
        panic!("no error")
    };
    assert!(message.contains("`compiling...`"), "{message}");
    assert!(matches!(outcome_of("binary", LIMITS), Outcome::Error { .. }));
}

#[test]
fn half_an_answer_is_none() {
    let limits = ProcessLimits {
        reply: Duration::from_millis(300),
        ..LIMITS
    };
    let outcome = outcome_of_slow("begin an answer", limits);
    assert_eq!(outcome, Outcome::TimedOut { after_ms: 300 });
    let Outcome::Error { message } = outcome_of("break off", LIMITS) else {
        panic!("no error")
    };
    assert!(message.contains("which is no reply"), "{message}");
}

#[test]
fn an_answer_to_a_request_that_was_not_made_is_an_error() {
    for what in ["mistake the id", "run ahead"] {
        let Outcome::Error { message } = outcome_of(what, LIMITS) else {
            panic!("no error")
        };
        assert!(message.contains("out of turn"), "{message}");
    }
}

#[test]
fn a_process_that_ignores_signals_is_killed_all_the_same() {
    let limits = ProcessLimits {
        reply: Duration::from_millis(300),
        ..LIMITS
    };
    let outcome = outcome_of_slow("ignore signals", limits);
    assert_eq!(outcome, Outcome::TimedOut { after_ms: 300 });
}

#[cfg(target_os = "linux")]
#[test]
fn a_process_that_holds_too_much_memory_has_crashed() {
    let engine = unruly(ProcessLimits {
        memory: 1 << 10,
        ..LIMITS
    });
    let mut session = engine.session().unwrap();
    let reason = "it held more than 0 MiB of memory".to_owned();
    assert_eq!(please(session.as_mut(), "hang"), Outcome::Crashed { reason });
}

#[test]
fn an_answer_too_many_is_not_taken_for_the_answer_to_the_next_request() {
    let engine = unruly(LIMITS);
    let mut session = engine.session().unwrap();
    assert_eq!(please(session.as_mut(), "repeat"), Outcome::ACCEPTED);
    let Outcome::Error { message } = please(session.as_mut(), "exit") else {
        panic!("no error")
    };
    assert!(message.contains("out of turn"), "{message}");
    assert_eq!(please(session.as_mut(), "accept"), Outcome::ACCEPTED);
}

#[test]
fn an_answer_to_another_question_is_an_error() {
    let engine = unruly(LIMITS);
    let mut session = engine.session().unwrap();
    let Outcome::Error { message } = session.render(DialectName::MATIEC, "accept") else {
        panic!("no error")
    };
    assert!(message.contains("`render` by `accepted`"), "{message}");
    // An engine that can only check answers `run` so.
    let request = RunRequest::once(DialectName::MATIEC, "accept", &[]);
    assert_eq!(session.run(&request), Outcome::ACCEPTED);
}

#[test]
fn what_a_dead_process_started_is_killed_too() {
    let folder = tempfile::tempdir().unwrap();
    let probe = folder.path().join("probe");
    mkfifo(&probe);
    let engine = ProcessEngine::start(
        &format!("env 'WITNESS={}' sh '{UNRULY}'", probe.display()),
        LIMITS,
    )
    .unwrap();
    // Ends when nobody holds the other side any more.
    let reader = thread::spawn(move || fs::read(probe));
    let mut session = engine.session().unwrap();
    let outcome = please(session.as_mut(), "leave a child");
    assert!(matches!(outcome, Outcome::Crashed { .. }), "{outcome:?}");
    assert_eq!(reader.join().unwrap().unwrap(), b"");
}

#[test]
fn a_death_is_seen_although_a_child_holds_the_output() {
    let Outcome::Crashed { reason } = outcome_of("orphan the output", LIMITS) else {
        panic!("no crash")
    };
    assert_eq!(reason, "it ended (exit status: 7)");
}

#[test]
fn a_stderr_that_nobody_reads_blocks_nothing() {
    assert_eq!(outcome_of("complain", LIMITS), Outcome::ACCEPTED);
}

#[test]
fn a_session_that_ends_takes_leave() {
    let folder = tempfile::tempdir().unwrap();
    let farewell = folder.path().join("farewell");
    let engine = ProcessEngine::start(
        &format!("env 'FAREWELL={}' sh '{UNRULY}'", farewell.display()),
        LIMITS,
    )
    .unwrap();
    drop(engine.session().unwrap());
    assert_eq!(fs::read(farewell).unwrap(), b"bye\n");
}

#[test]
fn what_cannot_be_started_is_told() {
    let error = not_started("no-such-program-anywhere --flag");
    assert!(
        error.contains("there is no program `no-such-program-anywhere`"),
        "{error}"
    );
    let error = not_started("sh -c 'echo no licence >&2; exit 3'");
    assert!(
        error.contains("it ended (exit status: 3); its stderr ends: no licence"),
        "{error}"
    );
    let error = not_started("sh -c 'echo Usage: st FILE; cat'");
    assert!(error.contains("`Usage: st FILE`"), "{error}");
    assert!(not_started("sh -c 'open").contains("quote"));
    assert!(not_started("").contains("behind `cmd:`"));
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
