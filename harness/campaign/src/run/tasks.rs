//! The tasks of a campaign's workers: judging a batch of inputs, and reducing a mismatch.

use super::Clock;
use crate::finding::Finding;
use crate::oracle::{InputVerdict, Mismatch, Worker};
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// A task of a worker.
pub(super) enum CampaignTask {
    /// Judge the batch of this number: the inputs at these places.
    Judge(usize, Vec<u64>),
    /// Reduce the input of this mismatch.
    Reduce(Mismatch),
}

/// A task that was done.
pub(super) struct Done {
    /// What came of the task.
    pub(super) result: TaskResult,
    /// The reason for which an engine can no longer be used, or Stickler itself.
    pub(super) lost: Option<String>,
    /// The time that the task took.
    pub(super) took: Duration,
}

/// The result of a task.
pub(super) enum TaskResult {
    /// The batch of this number was judged, with verdicts in the order of the places; fewer than places where the campaign ends.
    Judged(usize, Vec<InputVerdict>),
    /// A mismatch was reduced to a finding.
    Reduced(Box<Finding>),
    /// Stickler itself panicked over the task, which has no result.
    Panicked,
}

impl CampaignTask {
    /// Does the task. A panic is reported like the loss of an engine: the campaign ends, and keeps what it has.
    pub(super) fn attempt(self, worker: &mut dyn Worker, clock: &Clock<'_>) -> Done {
        let what = self.to_string();
        let begun = Instant::now();
        // A worker that has panicked judges nothing more, for the campaign ends.
        let done = catch_unwind(AssertUnwindSafe(|| {
            let result = match self {
                CampaignTask::Judge(number, places) => {
                    TaskResult::Judged(number, worker.judge(&places, &|| clock.judges()))
                }
                CampaignTask::Reduce(mismatch) => {
                    TaskResult::Reduced(Box::new(worker.reduce(&mismatch, &|| clock.reduces())))
                }
            };
            (result, worker.lost())
        }));
        let (result, lost) = done.unwrap_or_else(|_| {
            let defect = format!("Stickler itself panicked {what}; that is a defect of Stickler");
            (TaskResult::Panicked, Some(defect))
        });
        Done {
            result,
            lost,
            took: begun.elapsed(),
        }
    }
}

impl fmt::Display for CampaignTask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CampaignTask::Judge(_, places) => {
                let (first, last) = (places.first().unwrap_or(&0), places.last().unwrap_or(&0));
                write!(f, "over one of the inputs {first} to {last}")
            }
            CampaignTask::Reduce(mismatch) => write!(f, "while it made input {} small", mismatch.place),
        }
    }
}
