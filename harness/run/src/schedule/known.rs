//! Jobs whose answers are known from earlier runs, and their events in between those of the others.

use super::{Job, RunContext};
use crate::CaseEvent;
use crate::answer_store::{self, AnswerStore};
use crate::answers::Answers;
use std::iter::Peekable;
use std::time::Duration;
use std::vec::IntoIter;

/// Which jobs are known from earlier runs, and how far their events were given on.
pub(super) struct Known {
    /// The jobs that are to be asked about, by their places among all.
    pub(super) open: Vec<usize>,
    /// What is known of the others that were not given on, with their places, in order.
    answers: Peekable<IntoIter<(usize, Answers)>>,
    /// How many events of known jobs were given on.
    pub(super) given: u64,
}

impl Known {
    /// Looks every job up in the memory of its engine.
    pub(super) fn of(jobs: &[Job<'_>], stores: &[Option<&dyn AnswerStore>]) -> Known {
        let recalled = |job: &Job<'_>| {
            let store = stores.get(job.engine).copied().flatten()?;
            answer_store::read(store.get(&answer_store::question(job.case))?)
        };
        let mut open = Vec::new();
        let mut answers = Vec::new();
        for (place, job) in jobs.iter().enumerate() {
            match recalled(job) {
                Some(known) => answers.push((place, known)),
                None => open.push(place),
            }
        }
        Known {
            open,
            answers: answers.into_iter().peekable(),
            given: 0,
        }
    }

    /// Gives the events of the known jobs that stand before an open one, by its number among those, or behind the last.
    pub(super) fn give_before(
        &mut self,
        open: usize,
        jobs: &[Job<'_>],
        context: &RunContext<'_>,
        give: &mut dyn FnMut(&Job<'_>, CaseEvent),
    ) {
        let end = self.open.get(open).copied().unwrap_or(jobs.len());
        while let Some((place, answers)) = self.answers.next_if(|(place, _)| *place < end) {
            // The engine took no time over it.
            give(
                &jobs[place],
                context.event(&jobs[place], &answers, Duration::ZERO),
            );
            self.given += 1;
        }
    }
}
