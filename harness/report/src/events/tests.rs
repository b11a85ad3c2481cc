//! Tests the event log: what is written is read back, and what is no log is named.

use super::{EventLog, NAME, Reader, log_of, recognize, unpacked};
use crate::{LogError, sample};
use std::fs;
use stickler_mdtest::{assert_fits, check_examples};
use stickler_run::{CaseEvent, Event, FORMAT, Verdict};

/// Returns the compressed log of a run.
fn packed(events: &[Event]) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(NAME);
    let mut log = EventLog::create(path.clone()).expect("a log");
    for event in events {
        log.take(event).expect("taken");
    }
    log.flush().expect("flushed");
    // What a machine that dies now leaves.
    fs::read(path).expect("the log")
}

/// Returns the events of a log, and whether they are a whole run.
fn read_back(bytes: &[u8]) -> Result<(Vec<Event>, Result<(), LogError>), LogError> {
    let mut reader = Reader::new(unpacked(bytes)?);
    let events = reader.by_ref().collect::<Result<_, _>>()?;
    Ok((events, reader.check_complete()))
}

#[test]
fn what_is_written_is_read_back() {
    let run = sample::run();
    for log in [packed(&run), log_of(&run)] {
        let (events, complete) = read_back(&log).expect("a log");
        assert_eq!(events, run);
        complete.expect("a whole run");
    }
}

#[test]
fn a_compressed_log_without_its_end_has_all_that_was_written() {
    let run = sample::run();
    let log = packed(&run);
    let (events, complete) = read_back(&log[..log.len() - 30]).expect("a log");
    assert!(events.len() < run.len() && events[..] == run[..events.len()]);
    complete.expect_err("it has no footer");
}

/// Returns the log of a run to which something happened, or this text.
fn broken(log: &str) -> Vec<u8> {
    let mut run = sample::run();
    match log {
        "without its footer" => drop(run.pop()),
        "without a case" => drop(run.remove(2)),
        "of a later format" => sample::header(&mut run).format = FORMAT + 1,
        "with a line that is no event" => run.truncate(2),
        _ => {}
    }
    let bytes = log_of(&run);
    match log {
        "with half a last line" => bytes[..bytes.len() - 10].to_vec(),
        "with a line that is no event" => [&bytes[..], b"{}\n"].concat(),
        "twice" => bytes.repeat(2),
        "without its groups" => {
            let text = String::from_utf8(bytes).expect("text");
            let lines = text
                .split_inclusive('\n')
                .filter(|line| !line.contains("group\":{"));
            lines.collect::<String>().into_bytes()
        }
        _ if log.starts_with("with") || log.starts_with("of") => bytes,
        text => text.as_bytes().to_vec(),
    }
}

#[test]
fn golden_broken_logs() {
    check_examples("tests/logs.md", |example| {
        let bytes = broken(example.text("log"));
        match (example.wanted(), read_back(&bytes)) {
            ("recognized", _) => recognize(&bytes).unwrap_or_default(),
            (_, Err(error)) => error.to_string(),
            (_, Ok((events, complete))) => {
                let error = complete.expect_err("what is broken is no whole run");
                format!("{} events, and {error}", events.len())
            }
        }
    });
}

#[test]
fn what_cases_have_in_common_is_written_once_and_a_passed_case_on_a_short_line() {
    let cases = ["a::p(1)", "a::p(2)"].map(|id| sample::case(id, Verdict::Pass));
    let text = String::from_utf8(log_of(&sample::run_of(cases.to_vec()))).expect("text");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 5, "{text}");
    assert_fits(
        lines[1],
        r#"{"type":"group","number":0,"group":{"id":"widening/a::p",…"#,
    );
    assert_eq!(lines[3], r#"[0,"(2)",12,305419896]"#);
}

#[test]
fn a_passed_case_that_has_more_to_tell_is_written_whole() {
    let case = sample::case("a", Verdict::Pass);
    let of_baseline = CaseEvent {
        baseline: Some(sample::baseline_note()),
        ..case.clone()
    };
    let with_line = CaseEvent {
        line: Some(7),
        ..case
    };
    let run = sample::run_of(vec![of_baseline, sample::open_case("b"), with_line]);
    assert_eq!(read_back(&log_of(&run)).expect("a log").0, run);
}

#[test]
fn what_several_engines_are_asked_is_written_once() {
    let case = |engine: &str, id: &str| CaseEvent {
        engine: engine.to_owned(),
        program: Some(format!("PROGRAM {id}")),
        ..sample::case(id, Verdict::Fail)
    };
    let [one, other] = ["one", "other"].map(|engine| case(engine, "a"));
    let run = sample::run_of(vec![one.clone(), other, case("other", "b"), one]);
    let log = log_of(&run);
    assert_eq!(read_back(&log).expect("a log").0, run);
    assert_eq!(String::from_utf8_lossy(&log).matches("PROGRAM a").count(), 2);
}

#[test]
fn a_case_with_its_program_has_its_question() {
    let question = "REAL_TO_INT(REAL#2.5) : INT";
    let case = CaseEvent {
        question: Some(question.parse().expect("a question")),
        ..sample::case("a", Verdict::Fail)
    };
    let run = sample::run_of(vec![case]);
    let log = log_of(&run);
    let text = String::from_utf8_lossy(&log);
    assert!(text.contains(&format!(r#""question":"{question}""#)), "{text}");
    assert_eq!(read_back(&log).expect("a log").0, run);
}
