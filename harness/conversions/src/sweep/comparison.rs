//! Compares the results of a converter with those of exact arithmetic, for a range of inputs.

use crate::sweep::agenda::Sweep;
use crate::sweep::findings::{Difference, SweepFindings, SweepProgress};
use std::ops::Range;
use stickler_exact::{Bulk, expected};
use stickler_types::Value;
use stickler_workers::{Cancellation, SpawnError, WorkerPool};

/// The number of raw forms that are converted before they are compared; three buffers of this size stay in the nearest cache.
const BLOCK: usize = 1024;

/// The number of inputs that a worker takes at a time: about a millisecond's work.
const STEP: usize = 1 << 18;

/// The number of inputs that a worker takes at a time where exact arithmetic has no bulk form.
const SLOW_STEP: usize = 1 << 9;

/// A sweep, the converter that it compares with exact arithmetic, and the buffers of one worker.
#[derive(Clone)]
pub struct SweepComparison<'s> {
    sweep: &'s Sweep,
    converter: &'s dyn Converter,
    /// The bulk form of exact arithmetic, where there is one.
    bulk: Option<Bulk>,
    operands: Vec<u64>,
    expected: Vec<u64>,
    results: Vec<u64>,
}

impl<'s> SweepComparison<'s> {
    /// Makes the comparison of a sweep.
    pub fn new(sweep: &'s Sweep, converter: &'s dyn Converter) -> SweepComparison<'s> {
        SweepComparison {
            sweep,
            converter,
            bulk: Bulk::new(&sweep.signature, &sweep.choices),
            operands: vec![0; BLOCK],
            expected: vec![0; BLOCK],
            results: vec![0; BLOCK],
        }
    }

    /// Returns the number of inputs that a worker takes at a time.
    pub const fn step(&self) -> usize {
        if self.bulk.is_some() { STEP } else { SLOW_STEP }
    }

    /// Makes the record of a wrong result at a place of the domain.
    fn difference(&self, place: u64, operands: Vec<Value>, expected: Value, got: Value) -> Difference {
        let mut dialects = self.sweep.dialects.iter();
        let basis =
            dialects.find_map(|dialect| self::expected(&self.sweep.signature, &operands, *dialect).basis);
        Difference {
            place,
            operands,
            expected,
            got,
            basis,
        }
    }

    /// Compares the results for the inputs at the given places of the domain with exact arithmetic.
    pub fn compare(&mut self, places: Range<u64>) -> SweepFindings {
        let mut found = SweepFindings::new(0);
        match self.bulk {
            Some(bulk) => self.compare_blocks(bulk, places, &mut found),
            None => places.for_each(|place| self.compare_values(place, &mut found)),
        }
        found
    }

    fn compare_blocks(&mut self, bulk: Bulk, places: Range<u64>, found: &mut SweepFindings) {
        for start in places.clone().step_by(BLOCK) {
            let end = places.end.min(start + BLOCK as u64);
            // A block has at most `BLOCK` inputs.
            let length = (end - start) as usize;
            let operands = &mut self.operands[..length];
            let (expected, results) = (&mut self.expected[..length], &mut self.results[..length]);
            self.sweep.domain.fill(start..end, operands);
            self.converter.convert_all(operands, results);
            bulk.fill(operands, expected);
            if results != expected {
                self.collect_differences(start, length, found);
            }
            found.done += end - start;
        }
    }

    /// Adds the differences in a block to the findings. Two NaNs are equal whatever their bits.
    #[cold]
    fn collect_differences(&self, start: u64, length: usize, found: &mut SweepFindings) {
        let plain = |raw| Value::plain(self.sweep.signature.result, raw);
        for (offset, place) in (0..length).zip(start..) {
            let (expected, got) = (plain(self.expected[offset]), plain(self.results[offset]));
            if expected != got {
                found.differ(|| self.difference(place, self.sweep.domain.operands(place), expected, got));
            }
        }
    }

    fn compare_values(&self, place: u64, found: &mut SweepFindings) {
        let sweep = self.sweep;
        let operands = sweep.domain.operands(place);
        let exact = sweep.exact(&operands);
        let got = self.converter.convert(&operands);
        if let Some(exact) = exact.filter(|exact| !exact.admits(&got)) {
            found.differ(|| self.difference(place, operands, exact, got));
        }
        found.done += 1;
    }
}

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

/// A conversion of values. The reference implements it; tests put broken conversions in its place.
pub trait Converter: Sync {
    /// Writes the raw form of the result for the raw form of each operand; called only for conversions of one operand, where
    /// neither the operand nor the result is a text. The slices are equally long.
    fn convert_all(&self, operands: &[u64], results: &mut [u64]);

    /// Returns the result for operands of any types.
    fn convert(&self, operands: &[Value]) -> Value;
}
