//! Tests the progress and the cancellation of a sweep.

use crate::support::{Spoilt, sweep};
use std::sync::Mutex;
use stickler_conversions::sweep::{SweepProgress, run};
use stickler_types::DialectName;
use stickler_workers::Cancellation;

#[test]
fn progress_counts_every_input_and_every_mismatch() {
    let sweep = sweep("UINT_TO_INT", DialectName::MATIEC);
    let converter = Spoilt {
        sweep: &sweep,
        spoil: |operand, right| right ^ (operand & 1),
    };
    let seen = Mutex::new(Vec::new());
    let progress = |reached: SweepProgress| seen.lock().expect("no panic").push(reached);
    run(&sweep, &converter, 0, &progress, &Cancellation::new()).expect("threads");
    let mut seen = seen.into_inner().expect("no panic");
    seen.sort_by_key(|reached| reached.done);
    let last = SweepProgress {
        done: 65_536,
        mismatches: 32_768,
    };
    assert_eq!(seen.last(), Some(&last));
}

#[test]
fn a_cancelled_sweep_has_looked_at_everything_up_to_a_place() {
    let sweep = sweep("DINT_TO_INT", DialectName::MATIEC);
    // Everything is wrong, so that the count of mismatches tells what was looked at.
    let converter = Spoilt {
        sweep: &sweep,
        spoil: |_, right| right ^ 1,
    };
    let cancel = Cancellation::new();
    let progress = |reached: SweepProgress| {
        if reached.done >= 1 << 20 {
            cancel.request();
        }
    };
    let found = run(&sweep, &converter, 0, &progress, &cancel).expect("threads");
    assert!(!found.is_complete());
    assert!((1 << 20..1 << 28).contains(&found.done), "{}", found.done);
    assert_eq!(found.mismatches, found.done);
    let places: Vec<u64> = found.first.iter().map(|difference| difference.place).collect();
    assert_eq!(places, (0..10).collect::<Vec<u64>>());
}

#[test]
fn a_sweep_that_is_cancelled_before_it_begins_looks_at_nothing() {
    let sweep = sweep("SINT_TO_INT", DialectName::MATIEC);
    let cancel = Cancellation::new();
    cancel.request();
    let found = run(&sweep, &sweep.reference, 2, &|_| {}, &cancel).expect("threads");
    assert_eq!((found.done, found.inputs), (0, 256));
}
