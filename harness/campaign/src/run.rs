//! Running a campaign: places are given out, verdicts taken in order, mismatches reduced, findings reported once.
//!
//! Architecture Invariant: what is found depends on the row of verdicts alone, which is taken in the order of places, never
//! on who was quicker. So the number of workers changes nothing, and with a count a seed finds the same every time.

mod ledger;
mod tasks;
#[cfg(test)]
mod tests;

use crate::finding::Finding;
use crate::oracle::{InputVerdict, Mismatch, Oracle};
use crate::plan::{CampaignPlan, Until};
use ledger::Ledger;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use stickler_engines::EngineError;
use stickler_workers::{Cancellation, Reorder, SpawnError, Supervisor, WorkerPool};
use tasks::{CampaignTask, Done, TaskResult};

/// An event of a campaign that goes on.
#[derive(Debug)]
pub enum CampaignEvent<'a> {
    /// The progress of the campaign.
    Progress(CampaignProgress),
    /// A finding that is new, or better than the earlier one of that name.
    Found(&'a Finding),
}

/// The progress of a campaign.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct CampaignProgress {
    /// Inputs that were judged or passed over.
    pub programs: u64,
    /// Disagreements, whatever became of them.
    pub disagreements: u64,
    /// Findings that differ.
    pub findings: u64,
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
    #[must_use]
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
        ledger: Ledger::default(),
        tell,
    };
    pool.run(
        || oracle.worker().map_err(CampaignError::Engine),
        |worker, task| task.attempt(&mut **worker, &clock),
        &mut campaign,
    )?;
    let interrupted = cancel.is_requested();
    Ok(campaign.ledger.summary(clock.begun.elapsed(), interrupted))
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

    /// Returns whether the time of the campaign is not up.
    fn has_time(&self) -> bool {
        self.before(self.end)
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
    ledger: Ledger,
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
        if let Some((number, places)) = self.next_batch() {
            return Some(CampaignTask::Judge { number, places });
        }
        self.next_reduction().map(CampaignTask::Reduce)
    }

    fn take(&mut self, done: Done) {
        self.lost(done.lost);
        match done.result {
            TaskResult::Judged(number, verdicts) => {
                self.spent.judging += done.took;
                self.verdicts.put(number, verdicts);
                while let Some(verdicts) = self.verdicts.pop() {
                    let entered = verdicts
                        .into_iter()
                        .flat_map(|verdict| self.ledger.enter(verdict));
                    self.reductions.extend(entered);
                }
            }
            TaskResult::Reduced(finding) => {
                self.spent.reducing += done.took;
                if let Some(finding) = self.ledger.found(*finding) {
                    (self.tell)(CampaignEvent::Found(finding));
                }
            }
            TaskResult::Panicked => {}
        }
        (self.tell)(CampaignEvent::Progress(self.ledger.progress()));
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
        let ledger = &self.ledger;
        let rank = |mismatch: &Mismatch| {
            let reduced = ledger.reduced(mismatch);
            (ledger.explains(mismatch), reduced, mismatch.size, mismatch.place)
        };
        let waiting = self.reductions.iter().enumerate();
        let (place, mismatch) = waiting.min_by_key(|(_, mismatch)| rank(mismatch))?;
        let is_first = !ledger.explains(mismatch) && ledger.reduced(mismatch) == 0;
        if !is_first && !self.clock.has_time() {
            // So are all others.
            self.ledger.leave(self.reductions.drain(..).count());
            return None;
        }
        let mismatch = self.reductions.swap_remove(place);
        self.ledger.reduces(&mismatch);
        Some(mismatch)
    }

    /// Ends the campaign where an engine can no longer be used.
    fn lost(&mut self, reason: Option<String>) {
        if let Some(reason) = reason {
            self.clock.over.store(true, Ordering::Relaxed);
            self.ledger.lost(reason);
        }
    }
}
