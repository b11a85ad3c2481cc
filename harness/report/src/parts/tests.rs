//! Tests of merging the parts of a small run, whole and broken.

use super::{RunPart, merge};
use crate::events::{Reader, log_of};
use crate::sample;
use std::io;
use stickler_mdtest::check_examples;
use stickler_run::{Cause, Event, Verdict};
use stickler_workers::Shard;

/// Returns the events of a whole run of some cases in two files.
fn whole() -> Vec<Event> {
    let mut cases = Vec::new();
    for (file, names) in [("a", 0..20), ("b", 20..40)] {
        for number in names {
            let verdict = if number == 7 { Verdict::Fail } else { Verdict::Pass };
            let mut case = sample::case(&format!("{file}::x({number})"), verdict);
            case.file = format!("conformance-cases/{file}.toml");
            cases.push(case);
        }
    }
    sample::run_of(cases)
}

/// Returns the events of part `index` of `count` of that run.
fn part(index: u32, count: u32) -> Vec<Event> {
    let shard = Shard::new(index, count).expect("a part");
    let cases = whole().into_iter().filter_map(|event| match event {
        Event::Case(case) if shard.holds_case(&case.id, &case.dialect) => Some(case),
        _ => None,
    });
    let mut events = sample::run_of(cases.collect());
    sample::header(&mut events).shard = Some(shard.to_string());
    events
}

fn log(name: &str, events: &[Event]) -> RunPart<io::Cursor<Vec<u8>>> {
    let bytes = log_of(events);
    RunPart {
        name: name.to_owned(),
        log: Ok(Reader::new(io::Cursor::new(bytes))),
    }
}

fn merged(parts: Vec<RunPart<io::Cursor<Vec<u8>>>>) -> (Vec<Event>, Vec<String>) {
    let mut events = Vec::new();
    let missing = merge(parts, "stickler run", &mut |event| events.push(event));
    (events, missing)
}

fn keys(events: &[Event]) -> Vec<(String, String)> {
    let case = |event: &Event| match event {
        Event::Case(case) => Some((case.file.clone(), case.id.clone())),
        Event::Header(_) | Event::Cause(_) | Event::Footer(_) => None,
    };
    events.iter().filter_map(case).collect()
}

fn is_whole(events: &[Event]) -> bool {
    matches!(events.last(), Some(Event::Footer(_)))
}

#[test]
fn all_parts_in_any_order_are_the_whole_run() {
    let parts = vec![
        log("c", &part(3, 3)),
        log("a", &part(1, 3)),
        log("b", &part(2, 3)),
    ];
    let (events, missing) = merged(parts);
    assert_eq!(missing, Vec::<String>::new());
    let expected = whole();
    assert_eq!(events.first(), expected.first(), "the header");
    assert_eq!(events.last(), expected.last(), "the footer");
    let (mut merged, mut expected) = (keys(&events), keys(&expected));
    let files: Vec<&String> = merged.iter().map(|(file, _)| file).collect();
    assert!(files.is_sorted(), "cases come by file");
    merged.sort();
    expected.sort();
    assert_eq!(merged, expected);
}

/// Returns the events of the second part of an example: part 2 of 2 with an edit, or others.
fn second(what: &str) -> Vec<Event> {
    let mut events = part(2, 2);
    match what {
        "part 2 of 3" => return part(2, 3),
        "part 1 of 2 again" => return part(1, 2),
        "a whole run" => return whole(),
        "empty" => events.clear(),
        "cut short" => drop(events.pop()),
        "without a case" => drop(events.remove(3)),
        "with a case of the other" => events[1] = part(1, 2).swap_remove(1),
        "of a newer engine" => sample::header(&mut events).engines[0].version = "0.2.0".to_owned(),
        _ => sample::header(&mut events).format = 1,
    }
    events
}

#[test]
fn golden_broken_parts() {
    check_examples("tests/parts.md", |example| {
        let parts = vec![log("a", &part(1, 2)), log("b", &second(example.text("second")))];
        let (events, missing) = merged(parts);
        assert!(!is_whole(&events) && events.len() > 10, "{missing:?}");
        missing.join("\n")
    });
}

#[test]
fn where_nothing_can_be_read_there_is_no_run() {
    let (events, missing) = merged(vec![log("a", &[])]);
    assert_eq!((events.len(), missing.len()), (0, 1));
}

#[test]
fn a_cause_of_several_parts_is_one_cause_of_the_whole() {
    let with_cause = |index, title: &str| {
        let mut events = part(index, 2);
        let footer = events.pop().expect("a footer");
        let cause = Cause {
            construct: "the same".to_owned(),
            ..sample::cause(title, 5, Verdict::Fail)
        };
        let other = sample::cause(&format!("of part {index}"), 7, Verdict::Fail);
        events.extend([Event::Cause(cause), Event::Cause(other), footer]);
        events
    };
    let parts = vec![
        log("a", &with_cause(1, "first")),
        log("b", &with_cause(2, "second")),
    ];
    let (events, missing) = merged(parts);
    assert_eq!(missing, Vec::<String>::new());
    let causes = events.iter().filter_map(|event| match event {
        Event::Cause(cause) => Some((cause.title.as_str(), cause.number())),
        Event::Header(_) | Event::Case(_) | Event::Footer(_) => None,
    });
    let causes: Vec<(&str, u64)> = causes.collect();
    assert_eq!(causes, [("first", 10), ("of part 1", 7), ("of part 2", 7)]);
    assert!(is_whole(&events));
}
