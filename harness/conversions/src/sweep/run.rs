//! Compares all inputs of a sweep on all cores, until done or cancelled.

use crate::sweep::agenda::Sweep;
use crate::sweep::comparison::SweepComparison;
use crate::sweep::converter::Converter;
use crate::sweep::findings::{SweepFindings, SweepProgress};
use std::ops::Range;
use stickler_workers::{Cancellation, SpawnError, WorkerPool};

/// Compares the result of every input of the sweep with exact arithmetic, on the given number of threads (0: one for each
/// processor).
///
/// Calls `progress` whenever some more inputs are done. When `cancel` is requested, finishes the inputs that have been begun and
/// leaves the rest: the compared inputs always are all inputs up to a place.
///
/// # Errors
/// [`SpawnError`] where the system gives no threads.
pub fn run(
    sweep: &Sweep,
    converter: &dyn Converter,
    jobs: usize,
    progress: &dyn Fn(SweepProgress),
    cancel: &Cancellation,
) -> Result<SweepFindings, SpawnError> {
    let inputs = sweep.domain.len();
    let comparison = SweepComparison::new(sweep, converter);
    let mut findings = SweepFindings::new(inputs);
    let tasks = tasks(comparison.step(), inputs).take_while(|_| !cancel.is_requested());
    WorkerPool::new(jobs).for_each(
        tasks,
        || Ok::<_, SpawnError>(comparison.clone()),
        |comparison, places| comparison.compare(places),
        |found| {
            findings.add(found);
            progress(findings.progress());
        },
    )?;
    Ok(findings)
}

/// Returns the places of all inputs in order, in ranges of `step`.
fn tasks(step: usize, inputs: u64) -> impl Iterator<Item = Range<u64>> {
    let starts = (0..inputs).step_by(step);
    starts.map(move |start| start..inputs.min(start.saturating_add(step as u64)))
}
