//! A run of a suite on a compiler, and the search for the causes of its failures.

use stickler_causes::{FailedCases, Search, SearchLimits, find};
use stickler_engines::Engine;
use stickler_run::{Cause, Event, Plan, run};
use stickler_suite::Suite;
use stickler_workers::Cancellation;

/// Runs a suite on an engine, and returns the causes of the cases that fail.
pub fn causes(suite: &Suite, engine: &dyn Engine, jobs: usize, limits: SearchLimits) -> Vec<Cause> {
    let plan = Plan {
        jobs,
        ..Plan::default()
    };
    let cancel = Cancellation::new();
    let engines: [&dyn Engine; 1] = [engine];
    let mut failed = FailedCases::new(&plan, &engines);
    let mut sink = |event: Event| failed.take(&event);
    run(&plan, suite, &engines, &mut sink, &cancel).expect("a run");
    let search = Search {
        plan: &plan,
        suite,
        engines: &engines,
        stores: &[],
        limits,
        cancel: &cancel,
    };
    let mut reported = Vec::new();
    let found = find(&failed, &search, &mut |progress| reported.push(progress)).expect("causes");
    assert!(reported.last().is_none_or(|last| last.done == last.of));
    found
}
