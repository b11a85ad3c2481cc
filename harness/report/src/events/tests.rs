//! Tests the event log: what is written is read back, and what is no log is named.

use super::{EventLog, Reader, log_of, recognize};
use crate::{LogError, sample};
use std::fs;
use stickler_run::{CaseEvent, Event, FORMAT, Verdict};

fn written(events: &[Event]) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("events.jsonl");
    let mut log = EventLog::create(path.clone()).expect("a log");
    for event in events {
        log.take(event).expect("taken");
    }
    log.flush().expect("flushed");
    fs::read(path).expect("the log")
}

/// Returns the events of a log, and whether they are a whole run.
fn read_back(bytes: &[u8]) -> Result<(Vec<Event>, Result<(), LogError>), LogError> {
    let mut reader = Reader::new(bytes);
    let events = reader.by_ref().collect::<Result<_, _>>()?;
    Ok((events, reader.check_complete()))
}

#[test]
fn what_is_written_is_read_back() {
    let run = sample::run();
    let (events, complete) = read_back(&written(&run)).expect("a log");
    assert_eq!(events, run);
    complete.expect("a whole run");
}

#[test]
fn a_log_without_its_footer_is_called_truncated() {
    let run = sample::run();
    let bytes = written(&run[..run.len() - 1]);
    let (events, complete) = read_back(&bytes).expect("a log");
    assert_eq!(events.len(), run.len() - 1);
    let truncated = complete.expect_err("no footer").to_string();
    let cases = run.len() - 2;
    assert!(
        truncated.contains(&format!("cut short after {cases} cases")),
        "{truncated}"
    );
}

#[test]
fn a_half_written_last_line_counts_as_not_written() {
    let run = sample::run();
    let bytes = written(&run);
    let (events, complete) = read_back(&bytes[..bytes.len() - 10]).expect("a log");
    assert_eq!(events.len(), run.len() - 1);
    assert!(matches!(complete, Err(LogError::Truncated { .. })));
}

#[test]
fn what_is_no_log_is_told_from_a_broken_one() {
    assert!(matches!(read_back(b""), Err(LogError::Empty)));
    assert!(matches!(read_back(b"hello\n"), Err(LogError::NoHeader(_))));
    let mut bytes = written(&sample::run()[..2]);
    bytes.extend_from_slice(b"{}\n");
    assert!(matches!(read_back(&bytes), Err(LogError::Line { line: 4, .. })));
    let mut twice = written(&sample::run());
    twice.extend(written(&sample::run()));
    assert!(matches!(read_back(&twice), Err(LogError::Misplaced { .. })));
}

#[test]
fn what_cases_have_in_common_is_written_once_and_a_passed_case_on_a_short_line() {
    let cases = ["a::p(1)", "a::p(2)"].map(|id| sample::case(id, Verdict::Pass));
    let text = String::from_utf8(log_of(&sample::run_of(cases.to_vec()))).expect("text");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 5, "{text}");
    assert!(
        lines[1].starts_with(r#"{"type":"group","number":0,"group":{"id":"widening/a::p","#),
        "{text}"
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

#[test]
fn a_case_whose_group_is_not_described_is_no_case() {
    let text = String::from_utf8(log_of(&sample::run())).expect("text");
    let without: String = text
        .lines()
        .filter(|line| !line.contains("group\":{"))
        .map(|l| format!("{l}\n"))
        .collect();
    let error = read_back(without.as_bytes()).expect_err("no group");
    assert!(matches!(error, LogError::Group { line: 2 }), "{error}");
}

#[test]
fn a_log_out_of_which_a_case_was_lost_is_broken_though_its_footer_is_there() {
    let mut events = sample::run();
    events.remove(2);
    let error = read_back(&written(&events)).expect_err("a case is missing");
    assert!(matches!(
        error,
        LogError::Miscounted {
            promised: 4,
            cases: 3
        }
    ));
}

#[test]
fn a_log_of_a_later_format_is_not_guessed_at() {
    let mut events = sample::run();
    sample::header(&mut events).format = FORMAT + 1;
    let error = read_back(&written(&events)).expect_err("another format");
    assert!(matches!(error, LogError::Later { format } if format == FORMAT + 1));
}

#[test]
fn an_earlier_format_and_the_wrong_file_are_named_with_what_to_do() {
    let read = |text: &str| read_back(text.as_bytes()).expect_err("no such log").to_string();
    let log = "{\"type\":\"header\",\"format\":1,\"stickler\":\"0.1.0\",\"cases\":1}\n\
               {\"type\":\"case\",\"id\":\"a\",\"expected\":\"accepted\"}\n";
    let reported = read(log);
    assert!(
        reported.contains("format 1") && reported.ends_with("run the cases again with this version"),
        "{reported}"
    );
    let reported = read("{\"format\":1,\n\"stickler\":\"0.1.0\"}\n");
    assert!(reported.contains("results.json of format 1"), "{reported}");
    assert_eq!(
        recognize(log.as_bytes()).as_deref(),
        Some("the event log of a run, of format 1")
    );
    assert_eq!(recognize(b"results[0] := 5;\n"), None);
    let reported = read("{\"format\":2,\n\"stickler\":\"0.1.0\"}\n");
    assert!(
        reported.ends_with("name its folder, or the events.jsonl beside it"),
        "{reported}"
    );
}
