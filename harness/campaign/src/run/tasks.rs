//! The tasks of a campaign's workers: judging a batch of inputs, and reducing a mismatch.

use super::Clock;
use crate::finding::Finding;
use crate::oracle::{InputVerdict, Mismatch, Worker};
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// A task of a worker.
pub(super) enum CampaignTask {
    /// Judge the inputs at these places.
    Judge {
        /// The number of the batch.
        number: usize,
        /// The places of the inputs.
        places: Vec<u64>,
    },
    /// Reduce the input of this mismatch.
    Reduce(Mismatch),
}

/// The result of a task.
pub(super) enum Done {
    /// A batch was judged.
    Judged {
        /// The number of the batch.
        number: usize,
        /// The verdicts in the order of the places; fewer than places where the campaign ends.
        verdicts: Vec<InputVerdict>,
        /// The reason for which an engine can no longer be used.
        lost: Option<String>,
        /// The time that it took.
        took: Duration,
    },
    /// A mismatch was reduced.
    Reduced {
        /// The finding that came of it.
        finding: Box<Finding>,
        /// The reason for which an engine can no longer be used.
        lost: Option<String>,
        /// The time that it took.
        took: Duration,
    },
    /// Stickler itself panicked over a task, which has no result; holds the message.
    Panicked(String),
}

impl CampaignTask {
    /// Does the task. A panic is reported like the loss of an engine: the campaign ends, and keeps what it has.
    pub(super) fn attempt(self, worker: &mut dyn Worker, clock: &Clock<'_>) -> Done {
        let what = self.to_string();
        let begun = Instant::now();
        // A worker that has panicked judges nothing more, for the campaign ends.
        let done = catch_unwind(AssertUnwindSafe(|| match self {
            CampaignTask::Judge { number, places } => Done::Judged {
                number,
                verdicts: worker.judge(&places, &|| clock.judges()),
                lost: worker.lost(),
                took: begun.elapsed(),
            },
            CampaignTask::Reduce(mismatch) => Done::Reduced {
                finding: Box::new(worker.reduce(&mismatch, &|| clock.reduces())),
                lost: worker.lost(),
                took: begun.elapsed(),
            },
        }));
        done.unwrap_or_else(|_| {
            Done::Panicked(format!(
                "Stickler itself panicked {what}; that is a defect of Stickler"
            ))
        })
    }
}

impl fmt::Display for CampaignTask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CampaignTask::Judge { places, .. } => {
                let (first, last) = (places.first().unwrap_or(&0), places.last().unwrap_or(&0));
                write!(f, "over one of the inputs {first} to {last}")
            }
            CampaignTask::Reduce(mismatch) => write!(f, "while it made input {} small", mismatch.place),
        }
    }
}
