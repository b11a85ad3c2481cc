//! Tests of runs with stored answers: engines are not asked again what they answered before, and the events are the same.

use crate::fixtures::{Book, case, numbered, puppet, suite, timeless_run, with_jobs};
use crate::words::outcome;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use stickler_engines::{ClosureEngine, Engine, Outcome, RunRequest};
use stickler_run::{AnswerStore, Event, Plan, RunSummary, run_with};
use stickler_suite::{Case, Suite};
use stickler_types::{ClockSetting, DialectName, Observation, Setting, Value};
use stickler_workers::Cancellation;

/// Answers so that of ten programs one is rejected, one crashes the engine, and the others are executed.
fn moody(request: &RunRequest<'_>) -> Outcome {
    match request.source.bytes().last() {
        Some(b'0') => outcome("rejected"),
        Some(b'1') => outcome("crashed: a one"),
        _ => outcome("executed\nx = INT#1"),
    }
}

/// Runs the suite on this engine, and returns the summary and the events without their durations.
fn go(
    suite: &Suite,
    engine: &ClosureEngine<'_>,
    memory: Option<&dyn AnswerStore>,
    jobs: usize,
) -> (RunSummary, Vec<Event>) {
    timeless_run(&with_jobs(jobs), suite, &[engine], &[memory])
}

#[test]
fn a_second_run_asks_only_what_is_new_or_says_nothing_of_the_engine_and_its_events_are_the_same() {
    let asked = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&asked);
    let engine = puppet("puppet", move |request| {
        count.fetch_add(1, Ordering::Relaxed);
        moody(request)
    });
    let (_, without) = go(&numbered(0..300), &engine, None, 2);
    asked.store(0, Ordering::Relaxed);

    let book = Book::default();
    let (summary, first) = go(&numbered(0..300), &engine, Some(&book), 2);
    assert!(first == without, "a memory changes the events");
    assert_eq!((asked.swap(0, Ordering::Relaxed), summary.from_cache), (300, 0));

    for jobs in [1, 2, 7] {
        let book = Book {
            before: book.now.lock().unwrap().clone(),
            ..Book::default()
        };
        let (summary, second) = go(&numbered(0..300), &engine, Some(&book), jobs);
        assert!(second == without, "what is cached changes the events");
        assert_eq!((asked.swap(0, Ordering::Relaxed), summary.from_cache), (30, 270));
    }

    let book = book.turned();
    let (_, without) = go(&numbered(100..400), &engine, None, 2);
    asked.store(0, Ordering::Relaxed);
    let (summary, third) = go(&numbered(100..400), &engine, Some(&book), 2);
    assert!(third == without);
    // Twenty of the old ones crashed.
    assert_eq!((asked.load(Ordering::Relaxed), summary.from_cache), (120, 180));
}

#[test]
fn an_answer_that_cannot_be_read_is_asked_again() {
    let engine = puppet("puppet", moody);
    let book = Book::default();
    let (_, first) = go(&numbered(2..10), &engine, Some(&book), 1);
    let mut book = book.turned();
    for answer in book.before.values_mut() {
        *answer = answer.replace("INT#1", "INT#ONE");
    }
    let (summary, second) = go(&numbered(2..10), &engine, Some(&book), 1);
    assert!(first == second && summary.from_cache == 0);
}

#[test]
fn what_is_cached_does_not_wait_for_a_run_that_stops() {
    let book = Book::default();
    go(&numbered(2..5), &puppet("puppet", moody), Some(&book), 1);
    let book = book.turned();
    let cancel = Arc::new(Cancellation::new());
    let raise = Arc::clone(&cancel);
    let engine = puppet("puppet", move |request| {
        raise.request();
        moody(request)
    });
    let mut events = Vec::new();
    let mut sink = |event: Event| events.push(event);
    let engines: [&dyn Engine; 1] = [&engine];
    let plan = Plan::default();
    let summary = run_with(
        &plan,
        &numbered(2..9),
        &engines,
        &[Some(&book)],
        &mut sink,
        &cancel,
    )
    .unwrap();
    // What the engine answered while it was stopped says nothing of it.
    assert_eq!(
        (summary.cases, summary.from_cache, summary.cancelled),
        (3, 3, true)
    );
    assert_eq!(events.len(), 4, "a header and what was cached");
    assert!(book.now.lock().unwrap().is_empty());
}

#[test]
fn whatever_an_engine_is_handed_is_part_of_the_question_and_nothing_else() {
    let observe = |name: &str, type_name: &str, after| Observation {
        after,
        ..Observation::last(name, type_name)
    };
    let set = |before, literal: &str| Setting {
        before,
        name: "in".into(),
        value: Value::parse(literal).unwrap(),
    };
    let clock = |before| ClockSetting {
        before,
        nanoseconds: 1_000_000_000,
    };
    let changes: &[&dyn Fn(&mut Case)] = &[
        &|_| (),
        &|case| case.source = "another".into(),
        &|case| case.dialect = DialectName::PLCNEXT,
        &|case| case.scans = 2,
        &|case| case.observe = Arc::new([observe("x", "INT", None)]),
        &|case| case.observe = Arc::new([observe("xI", "NT", None)]),
        &|case| case.observe = Arc::new([observe("x", "INT", Some(1))]),
        &|case| case.clock = Arc::new([clock(1)]),
        &|case| case.clock = Arc::new([clock(2)]),
        &|case| case.set = Arc::new([set(1, "INT#1")]),
        &|case| case.set = Arc::new([set(2, "INT#1")]),
        &|case| case.set = Arc::new([set(1, "INT#2")]),
    ];
    let changed = |change: &&dyn Fn(&mut Case)| {
        let mut case = case("program");
        change(&mut case);
        case
    };
    let mut different: Vec<Case> = changes.iter().map(changed).collect();
    // This is asked the same as the first.
    different.push(Case {
        id: "other/id".into(),
        title: "Another title".into(),
        line: 7,
        ..case("program")
    });
    let book = Book::default();
    let engine = puppet("puppet", |_| Outcome::ACCEPTED);
    go(&suite(different), &engine, Some(&book), 1);
    assert_eq!(book.now.into_inner().unwrap().len(), changes.len());
}
