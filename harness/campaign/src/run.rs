//! Running a campaign: places are given out, verdicts taken in order, mismatches reduced, findings reported once.
//!
//! Architecture Invariant: what is found depends on the row of verdicts alone, which is taken in the order of places, never
//! on who was quicker. So the number of workers changes nothing, and with a count a seed finds the same every time.

mod tasks;
#[cfg(test)]
mod tests;

use crate::finding::{Confirmation, Finding};
use crate::oracle::{InputVerdict, Mismatch, Oracle};
use crate::plan::{CampaignPlan, Until, is_reduced};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use stickler_engines::EngineError;
use stickler_workers::{Cancellation, Reorder, SpawnError, Supervisor, WorkerPool};
use tasks::{CampaignTask, Done, TaskResult};

/// An event of a campaign that goes on.
#[derive(Debug)]
pub enum CampaignEvent<'a> {
    /// The progress of the campaign, as far as it has come.
    Progress(&'a CampaignSummary),
    /// A finding that is new, or better than the earlier one of that name.
    Found(&'a Finding),
}

/// The result of a campaign.
#[derive(Debug, Default)]
pub struct CampaignSummary {
    /// Inputs that were judged or passed over.
    pub programs: u64,
    /// The number of inputs that were passed over, by the reason.
    pub passed_over: BTreeMap<&'static str, u64>,
    /// The number of disagreements, by subject and symptom.
    pub disagreements: BTreeMap<(String, String), u64>,
    /// The number of times that engines died or hung and were started anew.
    pub deaths: u64,
    /// The findings, by name.
    pub findings: BTreeMap<String, Finding>,
    /// The number of disagreements that became the finding of this name.
    pub times: BTreeMap<String, u64>,
    /// The number of disagreements that were not reduced, since many like them were, or a finding explains them.
    pub left: u64,
    /// The way in which the campaign ended.
    pub ended: CampaignEnd,
    /// The time that the campaign took.
    pub elapsed: Duration,
}

impl CampaignSummary {
    /// Returns whether a campaign that came to its end judged no program at all.
    pub fn is_empty(&self) -> bool {
        self.ended == CampaignEnd::Done && self.passed_over.values().sum::<u64>() == self.programs
    }
}

/// The way in which a campaign ended.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum CampaignEnd {
    /// All places were judged, or the time was up.
    #[default]
    Done,
    /// The campaign was told to stop.
    Interrupted,
    /// An engine can no longer be used; holds the reason.
    Lost(String),
}

/// Runs a campaign. `tell` is called on the caller's thread. When `cancel` is requested, what is under way is given up: a
/// mismatch that is being reduced becomes a finding as it is.
///
/// # Errors
/// [`CampaignError`] where an engine or a thread cannot be started; no input was judged then.
pub fn run(
    plan: &CampaignPlan,
    oracle: &dyn Oracle,
    tell: &mut dyn FnMut(CampaignEvent<'_>),
    cancel: &Cancellation,
) -> Result<CampaignSummary, CampaignError> {
    let clock = Clock::new(plan.until, cancel);
    let pool = WorkerPool::new(plan.jobs);
    let mut campaign = Campaign {
        clock: &clock,
        batches: plan.batches().enumerate(),
        batches_ahead: pool.threads() * BATCHES_AHEAD,
        begun: 0,
        verdicts: Reorder::default(),
        reductions: Vec::new(),
        spent: Spent::default(),
        summary: CampaignSummary::default(),
        reduced: BTreeMap::new(),
        tell,
    };
    pool.run(
        || oracle.worker().map_err(CampaignError::Engine),
        |worker, task| task.attempt(&mut **worker, &clock),
        &mut campaign,
    )?;
    let mut summary = campaign.summary;
    if summary.ended == CampaignEnd::Done && cancel.is_requested() {
        summary.ended = CampaignEnd::Interrupted;
    }
    summary.elapsed = clock.begun.elapsed();
    Ok(summary)
}

/// An error that ends a campaign before an input is judged, or the survey before it.
#[derive(Debug, thiserror::Error)]
pub enum CampaignError {
    /// An engine could not be started.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// The worker threads could not be started.
    #[error(transparent)]
    Workers(#[from] SpawnError),
}

/// The times at which the work of a campaign ends.
pub(crate) struct Clock<'c> {
    begun: Instant,
    /// The time from which on no place is judged while a mismatch waits for its reduction.
    reserve: Option<Instant>,
    /// The time from which on no place is judged any more.
    end: Option<Instant>,
    /// The time from which on nothing is reduced any more.
    late: Option<Instant>,
    cancel: &'c Cancellation,
    /// Whether an engine is lost.
    over: AtomicBool,
}

/// The time for which mismatches may still be reduced once the time of a campaign is up.
const REDUCTION_TIMEOUT: Duration = Duration::from_secs(10);

impl<'c> Clock<'c> {
    fn new(until: Until, cancel: &'c Cancellation) -> Clock<'c> {
        let begun = Instant::now();
        let (reserve, end) = match until {
            Until::Count(_) => (None, None),
            Until::Time(time) => (begun.checked_add(time / 4 * 3), begun.checked_add(time)),
        };
        Clock {
            begun,
            reserve,
            end,
            late: end.and_then(|end| end.checked_add(REDUCTION_TIMEOUT)),
            cancel,
            over: AtomicBool::new(false),
        }
    }

    /// Returns whether more inputs are to be judged.
    pub(crate) fn judges(&self) -> bool {
        !self.over.load(Ordering::Relaxed) && self.before(self.end)
    }

    /// Returns whether mismatches that wait for their reduction come before all inputs.
    fn reserves(&self) -> bool {
        !self.before(self.reserve)
    }

    /// Returns whether a reduction is to go on.
    pub(crate) fn reduces(&self) -> bool {
        self.before(self.late)
    }

    fn before(&self, end: Option<Instant>) -> bool {
        !self.cancel.is_requested() && end.is_none_or(|end| Instant::now() < end)
    }
}

/// The number of batches that a worker may be ahead of the oldest one that is not judged, so that verdicts do not pile up
/// behind a slow one.
const BATCHES_AHEAD: usize = 4;

/// A campaign under way: gives out batches of places and mismatches to be reduced, and takes what comes of them.
struct Campaign<'c, 't, B> {
    clock: &'c Clock<'c>,
    batches: B,
    batches_ahead: usize,
    /// The number of batches that were given out.
    begun: usize,
    verdicts: Reorder<Vec<InputVerdict>>,
    /// The mismatches that wait for their reduction.
    reductions: Vec<Mismatch>,
    spent: Spent,
    summary: CampaignSummary,
    /// The number of mismatches that were given out to be reduced, by subject and symptom.
    reduced: BTreeMap<(String, String), u64>,
    tell: &'t mut dyn FnMut(CampaignEvent<'_>),
}

/// The time that all workers together spent.
#[derive(Default)]
struct Spent {
    judging: Duration,
    reducing: Duration,
}

impl<B: Iterator<Item = (usize, Vec<u64>)>> Supervisor<CampaignTask, Done> for Campaign<'_, '_, B> {
    /// Returns a reduction as long as these have not taken more than half of the time, and otherwise a batch.
    fn next_task(&mut self) -> Option<CampaignTask> {
        let is_due = self.clock.reserves() || self.spent.reducing <= self.spent.judging;
        if is_due && let Some(mismatch) = self.next_reduction() {
            return Some(CampaignTask::Reduce(mismatch));
        }
        let batch = self.next_batch();
        batch
            .map(|(number, places)| CampaignTask::Judge(number, places))
            .or_else(|| self.next_reduction().map(CampaignTask::Reduce))
    }

    fn take(&mut self, done: Done) {
        if let Some(reason) = done.lost {
            self.clock.over.store(true, Ordering::Relaxed);
            if self.summary.ended == CampaignEnd::Done {
                self.summary.ended = CampaignEnd::Lost(reason);
            }
        }
        match done.result {
            TaskResult::Judged(number, verdicts) => {
                self.spent.judging += done.took;
                self.verdicts.put(number, verdicts);
                while let Some(verdicts) = self.verdicts.pop() {
                    verdicts.into_iter().for_each(|verdict| self.enter(verdict));
                }
            }
            TaskResult::Reduced(finding) => {
                self.spent.reducing += done.took;
                self.found(*finding);
            }
            TaskResult::Panicked => {}
        }
        (self.tell)(CampaignEvent::Progress(&self.summary));
    }
}

impl<B: Iterator<Item = (usize, Vec<u64>)>> Campaign<'_, '_, B> {
    fn next_batch(&mut self) -> Option<(usize, Vec<u64>)> {
        let is_ahead = self.begun - self.verdicts.taken() >= self.batches_ahead;
        let waits = self.clock.reserves() && !self.reductions.is_empty();
        if is_ahead || waits || !self.clock.judges() {
            return None;
        }
        let batch = self.batches.next()?;
        self.begun += 1;
        Some(batch)
    }

    /// Returns the next mismatch to reduce: one that no finding explains before one that is probably known, a symptom of which
    /// few were reduced before others, and small inputs before large ones. Once the time is up, only the first of each symptom is
    /// still made a finding, as it is; the others are left.
    fn next_reduction(&mut self) -> Option<Mismatch> {
        let rank = |(place, mismatch): (usize, &Mismatch)| {
            let reduced = self.reduced.get(&key(mismatch)).copied().unwrap_or(0);
            (
                self.explains(mismatch),
                reduced,
                mismatch.size,
                mismatch.place,
                place,
            )
        };
        let (is_explained, reduced, .., place) = self.reductions.iter().enumerate().map(rank).min()?;
        if (is_explained || reduced > 0) && !self.clock.before(self.clock.end) {
            // So are all others.
            self.summary.left += self.reductions.drain(..).count() as u64;
            return None;
        }
        let mismatch = self.reductions.swap_remove(place);
        *self.reduced.entry(key(&mismatch)).or_default() += 1;
        Some(mismatch)
    }

    /// Counts a verdict, and keeps those of its mismatches that are to be reduced. Verdicts are entered in the order of their places.
    fn enter(&mut self, verdict: InputVerdict) {
        self.summary.programs += 1;
        self.summary.deaths += verdict.deaths;
        if let Some(word) = verdict.passed_over {
            *self.summary.passed_over.entry(word).or_default() += 1;
        }
        for mismatch in verdict.mismatches {
            let number = self.summary.disagreements.entry(key(&mismatch)).or_default();
            *number += 1;
            if is_reduced(*number) {
                self.reductions.push(mismatch);
            } else {
                self.summary.left += 1;
            }
        }
    }

    /// Takes a finding, and tells it where it is new, or better than the earlier one of its name.
    fn found(&mut self, finding: Finding) {
        *self.summary.times.entry(finding.id.clone()).or_default() += 1;
        if finding.is_best_of(&self.summary.findings) {
            (self.tell)(CampaignEvent::Found(&finding));
            self.summary.findings.insert(finding.id.clone(), finding);
        }
    }

    /// Returns whether a finding that was confirmed probably has the cause of a mismatch.
    fn explains(&self, mismatch: &Mismatch) -> bool {
        let mut findings = self.summary.findings.values();
        findings
            .any(|finding| finding.standing == Confirmation::Confirmed && mismatch.is_explained_by(finding))
    }
}

fn key(mismatch: &Mismatch) -> (String, String) {
    (mismatch.subject.clone(), mismatch.symptom.clone())
}
