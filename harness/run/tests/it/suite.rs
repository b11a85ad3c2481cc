//! Tests of the real suite on the real reference: no state is shared between cases, workers or runs.

use crate::fixtures::timeless_events;
use std::path::Path;
use stickler_engines::Reference;
use stickler_run::{Event, Plan};
use stickler_suite::Suite;
use stickler_workers::Shard;

/// Returns the events of a run of one part in twenty, which is quick and covers every kind of case.
fn events(suite: &Suite, reference: &Reference, jobs: usize) -> Vec<Event> {
    let plan = Plan {
        jobs,
        shard: Some(Shard::new(1, 20).unwrap()),
        ..Plan::default()
    };
    timeless_events(&plan, suite, &[reference])
}

#[test]
fn two_runs_of_the_suite_give_the_same_events_but_for_durations() {
    let suite = Suite::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases"));
    // Tests beside this one define dialects, which a reference that is made later speaks.
    let reference = Reference::new();
    let alone = events(&suite, &reference, 1);
    assert!(alone.len() > 100, "only {} events", alone.len());
    for (first, second) in alone.iter().zip(&events(&suite, &reference, 4)) {
        assert_eq!(first, second);
    }
    assert_eq!(alone.len(), events(&suite, &reference, 2).len());
}
