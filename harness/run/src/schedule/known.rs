//! Jobs whose answers are known from earlier runs, and the insertion of their events among those of the other jobs.

use super::{Job, RunContext};
use crate::CaseEvent;
use crate::answer_store::{self, AnswerStore};
use crate::answers::Answers;
use std::iter::Peekable;
use std::time::Duration;
use std::vec::IntoIter;

/// The jobs whose answers are known from earlier runs, and the progress of passing their events on.
pub(super) struct KnownAnswers {
    /// The indices of the jobs that engines must be asked about.
    pub(super) open: Vec<usize>,
    /// The known answers whose events were not passed on yet, with the indices of their jobs, in order.
    answers: Peekable<IntoIter<(usize, Answers)>>,
    /// The number of events of known jobs that were passed on.
    pub(super) given: u64,
}

impl KnownAnswers {
    /// Looks every job up in the answer store of its engine.
    pub(super) fn of(jobs: &[Job<'_>], stores: &[Option<&dyn AnswerStore>]) -> KnownAnswers {
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
        KnownAnswers {
            open,
            answers: answers.into_iter().peekable(),
            given: 0,
        }
    }

    /// Passes on the events of the known jobs before the open job with this number among the open ones, or all that remain
    /// where there is no such open job.
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
