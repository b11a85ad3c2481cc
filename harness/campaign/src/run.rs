//! The campaign itself: places are given out, verdicts taken in order, suspicions made small, findings told once.
//!
//! Architecture Invariant: what is found depends on the row of verdicts alone, which is taken in the order of places, never
//! on who was quicker. So the number of workers changes nothing, and with a count a seed finds the same every time.

mod ledger;
#[cfg(test)]
mod tests;
mod workers;

use crate::bench::{Bench, Verdict};
use crate::finding::Finding;
use crate::plan::{Plan, Until};
use ledger::Ledger;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use stickler_engines::EngineError;
use workers::{Done, Pool, Task};

/// What a campaign tells while it goes on.
#[derive(Debug)]
pub enum Event<'a> {
    /// How far it is.
    Progress(Progress),
    /// A finding that is new, or better than the one of that name before.
    Found(&'a Finding),
}

/// How far a campaign is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Progress {
    /// Inputs that were judged or passed over.
    pub programs: u64,
    /// Disagreements, whatever became of them.
    pub disagreements: u64,
    /// Findings that differ.
    pub findings: u64,
}

/// What a campaign did.
#[derive(Debug)]
pub struct Summary {
    /// Inputs that were judged or passed over.
    pub programs: u64,
    /// How many inputs were passed over, by the reason.
    pub passed_over: BTreeMap<&'static str, u64>,
    /// How often each subject disagreed, by its symptom.
    pub disagreements: BTreeMap<(String, String), u64>,
    /// How often engines died or hung and were started anew.
    pub deaths: u64,
    /// The findings, by name.
    pub findings: BTreeMap<String, Finding>,
    /// How often a disagreement became the finding of this name.
    pub times: BTreeMap<String, u64>,
    /// Disagreements that were not made small, since many like them were.
    pub left: u64,
    /// How it ended.
    pub ended: Ended,
    /// How long it took.
    pub elapsed: Duration,
}

/// How a campaign ended.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Ended {
    /// All places were judged, or the time was up.
    Done,
    /// It was told to stop.
    Interrupted,
    /// An engine can no longer be used: why.
    Lost(String),
}

/// Runs a campaign. `tell` is called on this thread. When `cancel` becomes true, what is under way is given up: a
/// suspicion that is being made small becomes a finding as it is.
///
/// # Errors
/// [`EngineError`] where an engine cannot be started; no input was judged then.
pub fn run(
    plan: &Plan,
    bench: &dyn Bench,
    tell: &mut dyn FnMut(Event<'_>),
    cancel: &AtomicBool,
) -> Result<Summary, EngineError> {
    let clock = Clock::new(plan.until, cancel);
    let jobs = match plan.jobs {
        0 => std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
        jobs => jobs,
    };
    std::thread::scope(|scope| {
        let pool = Pool::start(scope, bench, &clock, jobs)?;
        let mut campaign = Campaign {
            pool: &pool,
            ledger: Ledger::default(),
            clock: &clock,
            tell,
        };
        campaign.go_on(plan, jobs);
        Ok(campaign
            .ledger
            .summary(clock.begun.elapsed(), cancel.load(Ordering::Relaxed)))
    })
}

/// When work ends.
pub(crate) struct Clock<'c> {
    begun: Instant,
    /// No place is judged any more.
    end: Option<Instant>,
    /// Nothing is made smaller any more.
    late: Option<Instant>,
    cancel: &'c AtomicBool,
    /// An engine is lost.
    over: AtomicBool,
}

/// How long findings may still be made small once the time of a campaign is up.
const GRACE: Duration = Duration::from_secs(10);

impl<'c> Clock<'c> {
    fn new(until: Until, cancel: &'c AtomicBool) -> Clock<'c> {
        let begun = Instant::now();
        let end = match until {
            Until::Count(_) => None,
            Until::Time(time) => begun.checked_add(time),
        };
        Clock {
            begun,
            end,
            late: end.and_then(|end| end.checked_add(GRACE)),
            cancel,
            over: AtomicBool::new(false),
        }
    }

    /// Whether more inputs are to be judged.
    pub(crate) fn judges(&self) -> bool {
        !self.over.load(Ordering::Relaxed) && self.before(self.end)
    }

    /// Whether more is to be tried to make something small.
    pub(crate) fn reduces(&self) -> bool {
        self.before(self.late)
    }

    fn before(&self, end: Option<Instant>) -> bool {
        !self.cancel.load(Ordering::Relaxed) && end.is_none_or(|end| Instant::now() < end)
    }
}

/// A campaign under way.
struct Campaign<'p, 't, 'c> {
    pool: &'p Pool,
    ledger: Ledger,
    clock: &'p Clock<'c>,
    tell: &'t mut dyn FnMut(Event<'_>),
}

impl Campaign<'_, '_, '_> {
    fn go_on(&mut self, plan: &Plan, jobs: usize) {
        let mut batches = plan.batches().enumerate();
        let mut waiting: BTreeMap<usize, Vec<Verdict>> = BTreeMap::new();
        let mut next = 0;
        let mut judging = 0;
        let mut under_way = 0;
        loop {
            // A few batches ahead of the workers, so that none waits; not many, so that verdicts do not pile up behind a slow one.
            while judging + waiting.len() < jobs * 4
                && self.clock.judges()
                && let Some((index, places)) = batches.next()
            {
                self.pool.give(Task::Judge { index, places });
                judging += 1;
                under_way += 1;
            }
            if under_way == 0 {
                break;
            }
            under_way -= 1;
            match self.pool.take() {
                Some(Done::Judged { index, verdicts }) => {
                    judging -= 1;
                    waiting.insert(index, verdicts);
                    while let Some(verdicts) = waiting.remove(&next) {
                        under_way += self.enter(verdicts);
                        next += 1;
                    }
                }
                Some(Done::Reduced(finding)) => self.found(*finding),
                Some(Done::GivenUp) => {}
                Some(Done::Lost(reason)) => {
                    // It is no answer to a task.
                    under_way += 1;
                    self.clock.over.store(true, Ordering::Relaxed);
                    self.ledger.lost(reason);
                }
                None => break,
            }
            (self.tell)(Event::Progress(self.ledger.progress()));
        }
    }

    /// Takes verdicts, and gives out what is to be made small: how many tasks.
    fn enter(&mut self, verdicts: Vec<Verdict>) -> usize {
        let mut tasks = 0;
        for verdict in verdicts {
            for suspicion in self.ledger.enter(verdict) {
                self.pool.give(Task::Reduce(suspicion));
                tasks += 1;
            }
        }
        tasks
    }

    fn found(&mut self, finding: Finding) {
        if let Some(finding) = self.ledger.found(finding) {
            (self.tell)(Event::Found(finding));
        }
    }
}
