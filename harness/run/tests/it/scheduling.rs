//! Tests of whole runs over engines that only pretend.

use crate::fixtures::{
    case, footer, go, ids, number, numbered, numbered_ids, puppet, sources, suite, timeless_events, with_jobs,
};
use crate::words::outcome;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex};
use stickler_engines::EngineError;
use stickler_run::{Event, Fact, Plan, RunError, Verdict, run};
use stickler_suite::Case;
use stickler_types::DialectName;
use stickler_workers::Cancellation;

#[test]
fn a_run_is_a_header_the_cases_in_order_and_a_footer() {
    let engine = puppet("puppet", |_| outcome("executed"));
    let plan = Plan {
        started: "today".to_owned(),
        command: "stickler".to_owned(),
        ..with_jobs(3)
    };
    let (summary, events) = go(&plan, &numbered(0..300), &[&engine]);
    let Event::Header(header) = &events[0] else {
        panic!("no header")
    };
    assert_eq!(
        (header.cases, header.started.as_str(), header.suite.as_str()),
        (300, "today", "0.9")
    );
    let expected = numbered_ids(0..300);
    assert_eq!(ids(&events), expected);
    assert_eq!((footer(&events).unwrap().totals.pass, events.len()), (300, 302));
    let summary = summary.unwrap();
    assert_eq!(
        (summary.cases, summary.cancelled, summary.totals.pass),
        (300, false, 300)
    );
}

#[test]
fn events_do_not_depend_on_the_number_of_workers_nor_on_an_earlier_run() {
    let moody = |request: &stickler_engines::RunRequest<'_>| match number(request.source) % 50 {
        0 => outcome("unsupported: a zero"),
        1 => panic!("a one"),
        2..25 => outcome("rejected"),
        _ => outcome("executed\nx = INT#1"),
    };
    let engine = puppet("puppet", moody);
    let cases = numbered(0..500);
    let stream = |jobs| timeless_events(&with_jobs(jobs), &cases, &[&engine]);
    let alone = stream(1);
    assert_eq!(footer(&alone).unwrap().totals.crash, 10);
    for jobs in [1, 2, 7] {
        assert!(stream(jobs) == alone, "{jobs} workers give another stream");
    }
}

#[test]
fn a_slow_first_case_does_not_change_the_order() {
    let ran = Arc::new((Mutex::new(0_usize), Condvar::new()));
    let shared = Arc::clone(&ran);
    let engine = puppet("puppet", move |request| {
        let (count, more) = &*shared;
        let mut count = count.lock().unwrap();
        *count += 1;
        more.notify_all();
        // The first case ends only when others have overtaken it.
        while number(request.source) == 0 && *count < 100 {
            count = more.wait(count).unwrap();
        }
        outcome("executed")
    });
    let (_, events) = go(&with_jobs(2), &numbered(0..200), &[&engine]);
    let expected = numbered_ids(0..200);
    assert_eq!(ids(&events), expected);
}

#[test]
fn a_panicking_engine_is_a_crash_and_gets_a_new_session() {
    let opened = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&opened);
    let mut engine = puppet("puppet", |request| match number(request.source) {
        3 => panic!("broken string"),
        5 => panic!("broken number {}", request.scans),
        _ => outcome("executed"),
    });
    engine.open = Box::new(move || {
        count.fetch_add(1, Ordering::Relaxed);
        Ok(())
    });
    let (_, events) = go(&with_jobs(1), &numbered(0..10), &[&engine]);
    let totals = footer(&events).unwrap().totals;
    assert_eq!((totals.pass, totals.crash), (8, 2));
    for (event, reason) in [(4, "broken string"), (6, "broken number 1")] {
        let Event::Case(crashed) = &events[event] else {
            panic!("no case")
        };
        assert_eq!(
            (crashed.verdict, Fact::text(&crashed.got)),
            (Verdict::Crash, format!("crashed: panicked: {reason}"))
        );
    }
    assert_eq!(opened.load(Ordering::Relaxed), 3);
}

#[test]
fn no_engine_is_asked_a_claim_that_begins_after_its_version() {
    let cases = ["page: Sums", "later-page: Sums"].map(|basis| Case {
        basis: basis.into(),
        dialect: DialectName::IRONPLC_ED3,
        ..case(basis)
    });
    let mut suite = suite(cases.to_vec());
    suite.sources = sources("tests/versions");
    let asked = |name, version: &str| {
        let mut engine = puppet(name, |_| outcome("executed"));
        engine.identity.version = version.to_owned();
        ids(&go(&with_jobs(1), &suite, &[&engine]).1).len()
    };
    assert_eq!(asked("ironplc", "0.239.0"), 1);
    assert_eq!(asked("ironplc", "0.244.0"), 2);
    // Whose version is unknown and whose is none of the system's is asked both.
    assert_eq!(asked("ironplc", "main"), 2);
    assert_eq!(asked("strucpp", "0.1"), 2);
    assert_eq!(asked("reference", "0.1.0"), 2);
}

#[test]
fn every_engine_runs_the_dialects_that_it_speaks() {
    let first = puppet("first", |_| outcome("executed"));
    let mut second = puppet("second", |_| outcome("timed out: 1"));
    second.identity.dialects = vec![DialectName::PLCNEXT];
    let plcnext = Case {
        dialect: DialectName::PLCNEXT,
        ..case("area/1")
    };
    let (_, events) = go(
        &with_jobs(2),
        &suite(vec![case("area/0"), plcnext]),
        &[&first, &second],
    );
    assert_eq!(
        ids(&events),
        [
            "area/0@matiec first",
            "area/1@plcnext first",
            "area/1@plcnext second"
        ]
    );
    let engines = &footer(&events).unwrap().engines;
    assert_eq!((engines[0].name.as_str(), engines[0].totals.pass), ("first", 2));
    assert_eq!(
        (engines[1].name.as_str(), engines[1].totals.timeout),
        ("second", 1)
    );
}

#[test]
fn nothing_selected_is_an_error_before_any_event() {
    let mut silent = puppet("puppet", |_| outcome("executed"));
    silent.identity.dialects = vec![DialectName::PLCNEXT];
    let (outcome, events) = go(&with_jobs(1), &numbered(0..3), &[&silent]);
    assert!(matches!(outcome, Err(RunError::NoCaseSelected)));
    assert_eq!(events, []);
}

#[test]
fn an_engine_that_cannot_be_opened_at_first_or_again_ends_the_run_without_a_footer() {
    for sessions in [0, 2] {
        let left = AtomicUsize::new(sessions);
        let mut engine = puppet("puppet", |_| panic!("broken"));
        engine.open = Box::new(move || {
            let another = left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1));
            another.map(drop).map_err(|_| EngineError::NotStarted {
                engine: "puppet".into(),
                reason: "no strings".into(),
            })
        });
        let (outcome, events) = go(&with_jobs(2), &numbered(0..10_000), &[&engine]);
        assert_eq!(
            outcome.unwrap_err().to_string(),
            "engine puppet could not be started: no strings"
        );
        let [Event::Header(_), cases @ ..] = &events[..] else {
            panic!("no header")
        };
        assert!(cases.len() <= sessions, "{events:?}");
        assert!(
            cases.iter().all(|event| matches!(event, Event::Case(_))),
            "{events:?}"
        );
    }
}

#[test]
fn a_cancelled_run_gives_a_prefix_and_no_footer() {
    let engine = puppet("puppet", |_| outcome("executed"));
    let cancel = Cancellation::new();
    let mut events = Vec::new();
    let mut sink = |event: Event| {
        events.push(event);
        if events.len() > 20 {
            cancel.request();
        }
    };
    let cases = numbered(0..50_000);
    let summary = run(&with_jobs(2), &cases, &[&engine], &mut sink, &cancel).unwrap();
    assert!(summary.cancelled);
    assert_eq!(footer(&events), None);
    assert!((20..10_000).contains(&summary.cases), "{}", summary.cases);
    let expected = numbered_ids(0..events.len() - 1);
    assert_eq!(ids(&events), expected);
    assert_eq!(summary.cases, expected.len() as u64);
}

#[test]
fn a_run_cancelled_before_it_begins_runs_nothing() {
    let engine = puppet("puppet", |_| panic!("asked all the same"));
    let cancel = Cancellation::new();
    cancel.request();
    let mut events = 0;
    let summary = run(
        &with_jobs(2),
        &numbered(0..10),
        &[&engine],
        &mut |_| events += 1,
        &cancel,
    )
    .unwrap();
    assert_eq!((summary.cases, summary.cancelled, events), (0, true, 1));
}
