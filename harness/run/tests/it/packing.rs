//! Tests of runs in which an engine is given several programs at a time: only the duration may change.

use crate::fixtures::{
    events_of_a_twentieth, footer, ids, number, numbered, numbered_ids, puppet, timeless_events, with_jobs,
};
use crate::words::{expecting, outcome};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use stickler_engines::{Engine, EngineError, Identity, Outcome, Packed, Reference, RunRequest, Session};
use stickler_run::{Event, Plan, run};
use stickler_types::DialectName;
use stickler_workers::Cancellation;

/// A function that states for each program of a pack whether its outcome is certain, from the outcomes of all programs.
type Sure = fn(&[Outcome]) -> Vec<bool>;

/// Behaves like a compiler that stops at its first error: a pack is certain only where every program runs to its end.
fn of_all_or_none(outcomes: &[Outcome]) -> Vec<bool> {
    let all = outcomes
        .iter()
        .all(|outcome| matches!(outcome, Outcome::Executed { .. }));
    vec![all; outcomes.len()]
}

/// Behaves like a compiler that reports every error: where there are any, only the programs that have one are certain.
fn of_what_is_told(outcomes: &[Outcome]) -> Vec<bool> {
    let reported = |outcome: &Outcome| matches!(outcome, Outcome::Rejected { .. });
    match outcomes.iter().any(reported) {
        true => outcomes.iter().map(reported).collect(),
        false => of_all_or_none(outcomes),
    }
}

/// An engine that packs around one that does not: it asks about every program alone, and reveals as little as a compiler
/// that compiles all of them together.
struct Packing<E> {
    engine: E,
    size: usize,
    sure: Sure,
    packs: AtomicUsize,
    largest: AtomicUsize,
    alone: AtomicUsize,
}

impl<E: Engine> Packing<E> {
    fn new(engine: E, size: usize, sure: Sure) -> Packing<E> {
        Packing {
            engine,
            size,
            sure,
            packs: AtomicUsize::new(0),
            largest: AtomicUsize::new(0),
            alone: AtomicUsize::new(0),
        }
    }

    /// Returns the number of packs that the engine was given, the size of the largest, and the number of programs it was
    /// given alone.
    fn asked(&self) -> (usize, usize, usize) {
        let of = |count: &AtomicUsize| count.load(Ordering::Relaxed);
        (of(&self.packs), of(&self.largest), of(&self.alone))
    }
}

impl<E: Engine> Engine for Packing<E> {
    fn identity(&self) -> &Identity {
        self.engine.identity()
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let session = self.engine.session()?;
        Ok(Box::new(PackingSession {
            engine: self,
            session,
        }))
    }

    fn pack_size(&self) -> usize {
        self.size
    }
}

struct PackingSession<'e, E> {
    engine: &'e Packing<E>,
    session: Box<dyn Session + 'e>,
}

impl<E> Session for PackingSession<'_, E> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.engine.alone.fetch_add(1, Ordering::Relaxed);
        self.session.run(request)
    }

    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        assert!(
            requests
                .iter()
                .all(|request| request.dialect == requests[0].dialect)
        );
        self.engine.packs.fetch_add(1, Ordering::Relaxed);
        self.engine.largest.fetch_max(requests.len(), Ordering::Relaxed);
        let outcomes: Vec<Outcome> = requests.iter().map(|request| self.session.run(request)).collect();
        let sure = (self.engine.sure)(&outcomes);
        let reported = |(outcome, sure)| match sure {
            true => Packed::Answered(outcome),
            false => Packed::Unknown,
        };
        outcomes.into_iter().zip(sure).map(reported).collect()
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.session.check(dialect, source)
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.session.render(dialect, source)
    }
}

#[test]
fn packed_and_unpacked_runs_of_the_suite_are_the_same() {
    let unpacked = events_of_a_twentieth(&Reference::new(), 0);
    for sure in [of_all_or_none as Sure, of_what_is_told] {
        let packing = Packing::new(Reference::new(), 64, sure);
        let packed = events_of_a_twentieth(&packing, 0);
        assert_eq!(unpacked.len(), packed.len());
        for (unpacked, packed) in unpacked.iter().zip(&packed) {
            assert_eq!(unpacked, packed);
        }
        let (packs, largest, alone) = packing.asked();
        assert!(packs > 100 && largest == 64, "{packs} packs of up to {largest}");
        assert!(alone > 0, "nothing stands alone");
    }
}

#[test]
fn a_culprit_is_found_in_few_packs_and_asked_alone() {
    let puppet = puppet("puppet", |request| match number(request.source) {
        77 => outcome("rejected\n1 P4035"),
        _ => outcome("executed"),
    });
    let packing = Packing::new(puppet, 128, of_all_or_none);
    let events = timeless_events(&with_jobs(1), &numbered(0..4096), &[&packing]);
    let (_, _, alone) = packing.asked();
    // The culprit, its neighbour of the last pack, and those at the end, where batches are small.
    assert!((2..30).contains(&alone), "{alone} alone");
    let footer = footer(&events).unwrap();
    assert_eq!((footer.totals.pass, footer.totals.fail), (4095, 1));
}

#[test]
fn accepted_and_rejected_programs_do_not_meet_and_unreadable_ones_stand_alone() {
    let mut suite = numbered(0..64);
    for (number, case) in suite.cases.iter_mut().enumerate() {
        case.expectation = expecting(["", "", "error 1 P4035", "error 1 P0002"][number % 4]).expectation;
    }
    let puppet = puppet("puppet", |request| match number(request.source) % 4 {
        0 | 1 => outcome("executed"),
        2 => outcome("rejected\n1 P4035"),
        _ => outcome("rejected\n1 P0002"),
    });
    let packing = Packing::new(puppet, 8, |outcomes| {
        let rejected = |outcome: &Outcome| matches!(outcome, Outcome::Rejected { .. });
        let first = rejected(&outcomes[0]);
        assert!(outcomes.iter().all(|outcome| rejected(outcome) == first));
        vec![true; outcomes.len()]
    });
    let events = timeless_events(&with_jobs(1), &suite, &[&packing]);
    let (packs, largest, alone) = packing.asked();
    assert!(packs >= 6 && largest == 8, "{packs} packs of up to {largest}");
    assert!((16..24).contains(&alone), "{alone} alone");
    assert_eq!(ids(&events), numbered_ids(0..64));
}

#[test]
fn an_unpacked_run_asks_about_each_program_alone() {
    let packing = Packing::new(puppet("puppet", |_| outcome("executed")), 16, of_all_or_none);
    let plan = Plan {
        unpacked: true,
        ..Plan::default()
    };
    let suite = numbered(0..64);
    run(&plan, &suite, &[&packing], &mut drop, &Cancellation::new()).unwrap();
    assert_eq!(packing.asked(), (0, 0, 64));
}

#[test]
fn an_engine_that_panics_over_a_pack_or_answers_too_little_is_asked_alone() {
    for sure in [(|_| panic!("broken")) as Sure, |_| Vec::new(), |_| vec![true]] {
        let packing = Packing::new(puppet("puppet", |_| outcome("executed")), 16, sure);
        let events = timeless_events(&with_jobs(2), &numbered(0..64), &[&packing]);
        let footer = footer(&events).unwrap();
        assert_eq!(footer.totals.pass, 64);
    }
}

#[test]
fn an_engine_that_packs_and_one_that_does_not_share_a_run() {
    let packing = Packing::new(puppet("packs", |_| outcome("executed")), 16, of_all_or_none);
    let single = puppet("single", |_| outcome("executed"));
    let events = timeless_events(&with_jobs(2), &numbered(0..200), &[&packing, &single]);
    let expected = (0..200)
        .flat_map(|number| ["packs", "single"].map(|engine| format!("area/{number}@matiec {engine}")));
    assert!(ids(&events).into_iter().eq(expected));
    assert!(packing.asked().1 == 16);
}

#[test]
fn a_run_that_is_cancelled_within_a_pack_gives_a_prefix() {
    let cancel = Arc::new(Cancellation::new());
    let flag = Arc::clone(&cancel);
    let puppet = puppet("puppet", move |request| {
        // In the midst of halving, so that some of the pack are settled and others are not.
        if number(request.source) == 900 {
            flag.request();
        }
        match number(request.source) % 7 {
            0 => outcome("rejected\n1 P4035"),
            _ => outcome("executed"),
        }
    });
    let packing = Packing::new(puppet, 64, of_all_or_none);
    let cases = numbered(0..5000);
    let mut events = Vec::new();
    let mut sink = |event: Event| events.push(event);
    let summary = run(&with_jobs(2), &cases, &[&packing], &mut sink, &cancel).unwrap();
    let ids = ids(&events);
    assert_eq!(
        (ids.len() + 1, footer(&events)),
        (events.len(), None),
        "a header and cases"
    );
    assert!(summary.cancelled && summary.cases == ids.len() as u64);
    assert!(ids.len() < 2000, "{} cases", ids.len());
    assert_eq!(ids, numbered_ids(0..ids.len()));
}
