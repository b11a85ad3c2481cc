//! Tests of merging the parts of a small run, whole and broken.

use super::{RunPart, merge};
use crate::events::{Reader, log_of};
use crate::sample;
use std::io;
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

/// Returns the events of part 2 of 2, edited.
fn edited(edit: impl FnOnce(&mut Vec<Event>)) -> Vec<Event> {
    let mut events = part(2, 2);
    edit(&mut events);
    events
}

#[test]
fn what_is_missing_or_no_part_of_the_run_is_named_and_the_rest_is_not_taken_for_the_whole() {
    let missing_part = "part 2/2 is missing";
    let cut = edited(|events| drop(events.pop()));
    let cases = cut.len() - 1;
    let cut_short =
        format!("part 2/2 (b): the run was cut short after {cases} cases: its event log has no footer");
    let lossy = edited(|events| drop(events.remove(3)));
    let strange = edited(|events| events[1] = part(1, 2).swap_remove(1));
    let newer = edited(|events| sample::header(events).engines[0].version = "0.2.0".to_owned());
    let of_format_1 = edited(|events| sample::header(events).format = 1);
    for (second, reasons) in [
        (
            part(2, 3),
            &[
                "b is no part of the same run as a: its number of parts is 3",
                missing_part,
            ][..],
        ),
        (cut, &[&cut_short]),
        (
            lossy,
            &[
                "part 2/2 (b) cannot be read to its end: the event log promises 23 cases and holds 22, so it is not whole",
            ],
        ),
        (
            strange,
            &["part 2/2 (b) holds widening/a::x(0), which is another part's"],
        ),
        (
            part(1, 2),
            &["part 1/2 is there more than once: a and b", missing_part],
        ),
        (whole(), &["b is a whole run, and no part of one", missing_part]),
        (
            newer,
            &[
                "b is no part of the same run as a: its list of engines is reference 0.2.0",
                missing_part,
            ],
        ),
        (
            Vec::new(),
            &["b cannot be read: the event log is empty", missing_part],
        ),
        (
            of_format_1,
            &[
                "b cannot be read: the event log has format 1, which an earlier version of Stickler wrote",
                missing_part,
            ],
        ),
    ] {
        let (events, missing) = merged(vec![log("a", &part(1, 2)), log("b", &second)]);
        assert_eq!(missing.len(), reasons.len(), "{missing:?}");
        for (missing, reason) in missing.iter().zip(reasons) {
            assert!(missing.starts_with(reason), "{reason}: {missing}");
        }
        assert!(!is_whole(&events) && events.len() > 10, "{missing:?}");
    }
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
