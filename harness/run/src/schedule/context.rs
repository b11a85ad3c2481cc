//! The workers' side of a run: asks engines about a batch of jobs, and turns their answers into events.

use super::{Batch, Job};
use crate::answer_store::{self, AnswerStore};
use crate::answers::Answers;
use crate::event::CaseEvent;
use crate::pack::{packs, settle};
use crate::{CaseJudge, Lacks, MatchedBaseline, Plan};
use std::iter::Peekable;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use std::vec::IntoIter;
use stickler_engines::{Engine, EngineError, EngineSession};
use stickler_suite::{Case, Suite};
use stickler_workers::Cancellation;

/// The number of packs of each engine in a batch; more than one, since cases of several kinds alternate.
const PACKS_PER_BATCH: usize = 2;

/// The data that all workers of a run share.
pub(super) struct RunContext<'r> {
    pub(super) plan: &'r Plan,
    pub(super) suite: &'r Suite,
    pub(super) jobs: &'r [Job<'r>],
    pub(super) engines: &'r [&'r dyn Engine],
    /// The store of each engine; engines behind the end of the slice have none.
    pub(super) stores: &'r [Option<&'r dyn AnswerStore>],
    /// The features that each engine lacks, by the index of the engine.
    pub(super) lacks: &'r [Lacks<'r>],
    /// The matched baseline of each engine.
    pub(super) baselines: &'r [Option<MatchedBaseline<'r>>],
    pub(super) cancel: &'r Cancellation,
    /// Whether an engine cannot be used any more, so that the run ends.
    pub(super) is_broken: AtomicBool,
}

impl<'r> RunContext<'r> {
    /// Returns a worker's sessions, one for each engine; none is open yet.
    pub(super) fn sessions(&self) -> Vec<EngineSession<'r>> {
        let engines = self.engines.iter();
        engines.map(|&engine| EngineSession::new(engine)).collect()
    }

    /// Returns the number of jobs in a batch; `None` where no engine packs, so that it adapts.
    pub(super) fn batch_len_for_packs(&self) -> Option<usize> {
        let largest = self.pack_sizes().into_iter().max().filter(|&size| size > 1)?;
        Some(largest * PACKS_PER_BATCH * self.engines.len())
    }

    fn pack_sizes(&self) -> Vec<usize> {
        let size = |engine: &&dyn Engine| if self.plan.unpacked { 1 } else { engine.pack_size() };
        self.engines.iter().map(size).collect()
    }

    /// Runs a batch of jobs. There are fewer events than jobs where the run stops.
    pub(super) fn batch(
        &self,
        number: usize,
        jobs: Range<usize>,
        sessions: &mut [EngineSession<'_>],
    ) -> Batch {
        let begun = Instant::now();
        let (start, len) = (jobs.start, jobs.len());
        let mut events: Vec<Option<CaseEvent>> = jobs.clone().map(|_| None).collect();
        let error = self.ask_all(&self.jobs[jobs], sessions, &mut events).err();
        // Whoever cancels the run may have ended its engines.
        let error = error.filter(|_| !self.is_stopping());
        if error.is_some() {
            self.is_broken.store(true, Ordering::Relaxed);
        }
        Batch {
            number,
            start,
            len,
            // What stands behind a gap would never be given on.
            events: events.into_iter().map_while(|event| event).collect(),
            time: begun.elapsed(),
            error,
        }
    }

    fn ask_all(
        &self,
        jobs: &[Job<'_>],
        sessions: &mut [EngineSession<'_>],
        events: &mut [Option<CaseEvent>],
    ) -> Result<(), EngineError> {
        let cases: Vec<(&Case, usize)> = jobs.iter().map(|job| (job.case, job.engine)).collect();
        let packs = packs(&cases, &self.pack_sizes());
        for pack in packs.iter().take_while(|_| !self.is_stopping()) {
            self.ask(jobs, pack, sessions, events)?;
        }
        Ok(())
    }

    /// Runs the jobs with these indices, which are one pack, and stores their events.
    fn ask(
        &self,
        jobs: &[Job<'_>],
        pack: &[usize],
        sessions: &mut [EngineSession<'_>],
        events: &mut [Option<CaseEvent>],
    ) -> Result<(), EngineError> {
        let Some(first) = pack.first() else {
            return Ok(());
        };
        let session = &mut sessions[jobs[*first].engine];
        let cases: Vec<&Case> = pack.iter().map(|&place| jobs[place].case).collect();
        let settled = settle(session, &cases, &|| self.is_stopping())?;
        for (&place, settled) in pack.iter().zip(settled) {
            events[place] = settled.map(|(answers, time)| {
                self.keep(&jobs[place], &answers);
                self.event(&jobs[place], &answers, time)
            });
        }
        Ok(())
    }

    /// Stores answers for later runs.
    fn keep(&self, job: &Job<'_>, answers: &Answers) {
        if let Some(Some(store)) = self.stores.get(job.engine)
            && let Some(text) = answer_store::written(answers)
        {
            store.put(&answer_store::question(job.case), &text);
        }
    }

    /// Returns whether the run ends before its last job.
    pub(super) fn is_stopping(&self) -> bool {
        self.cancel.is_requested() || self.is_broken.load(Ordering::Relaxed)
    }

    /// Judges the answers of an engine about a job.
    pub(super) fn event(&self, job: &Job<'_>, answers: &Answers, time: Duration) -> CaseEvent {
        let judge = CaseJudge {
            plan: self.plan,
            suite: self.suite,
            engine: self.engines[job.engine].identity(),
            lacks: self.lacks.get(job.engine),
            baseline: self.baselines[job.engine].as_ref(),
        };
        judge.event(job.case, answers, time)
    }
}

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
