//! Runs cases on workers, and passes their events on in order from the caller's own thread.

mod batches;
mod context;

use crate::answer_store::AnswerStore;
use crate::event::{CaseEvent, EngineHeader, EngineTotals, Event, FORMAT, Footer, Header, PROGRAM};
use crate::lacks::{self, Survey, WaitingCases};
use crate::{MatchedBaseline, Plan, RunError, RunSummary, Totals, Verdict, is_asked, select};
use batches::Batches;
use context::{KnownAnswers, RunContext};
use std::ops::Range;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};
use stickler_engines::{Ability, Engine, EngineError, Reproduction, RunRequest};
use stickler_suite::{Case, Suite};
use stickler_types::DialectName;
use stickler_workers::{Cancellation, Reorder, SpawnError, Supervisor, WorkerPool};

/// Runs the cases that the plan selects on every engine that speaks their dialect.
///
/// Events reach `sink` on this thread: a header, the cases in the order of the suite (engines in the order given), a footer.
/// When `cancel` is requested, workers stop at their next case, the events up to the first missing one are passed on, and
/// there is no footer. Memory is bounded whatever the number of cases; each worker has one engine session open.
///
/// # Errors
/// [`RunError::NoCaseSelected`] before any event; [`RunError::Engine`] where an engine cannot be opened,
/// without a footer if the header is already out; [`RunError::Workers`] where the system gives no threads.
pub fn run(
    plan: &Plan,
    suite: &Suite,
    engines: &[&dyn Engine],
    sink: &mut dyn FnMut(Event),
    cancel: &Cancellation,
) -> Result<RunSummary, RunError> {
    run_with(plan, suite, engines, &[], sink, cancel)
}

/// Runs the cases like [`run`], and takes answers that are in the store of an engine from there instead of asking; `stores`
/// has one entry per engine. Other answers are added to the store. But for the times, the events are the same as without
/// stores.
///
/// # Errors
/// Fails as [`run`] does.
pub fn run_with(
    plan: &Plan,
    suite: &Suite,
    engines: &[&dyn Engine],
    stores: &[Option<&dyn AnswerStore>],
    sink: &mut dyn FnMut(Event),
    cancel: &Cancellation,
) -> Result<RunSummary, RunError> {
    let begun = Instant::now();
    let selected = select(plan, &suite.cases);
    let jobs = jobs(&selected, engines, suite);
    if jobs.is_empty() {
        return Err(RunError::NoCaseSelected);
    }
    let baselines: Vec<Option<MatchedBaseline<'_>>> = engines
        .iter()
        .map(|engine| plan.matched_baseline(suite, engine.identity()))
        .collect();
    let header = Header {
        baselines: baselines
            .iter()
            .flatten()
            .map(|baseline| baseline.header().clone())
            .collect(),
        ..header(plan, suite, engines, jobs.len())
    };
    let outdated = header
        .baselines
        .iter()
        .map(|baseline| baseline.outdated.len() as u64)
        .sum();
    sink(Event::Header(header));
    let survey = Survey {
        plan,
        suite,
        engines,
        stores,
        cancel,
    };
    let lacks = lacks::survey(&survey, &selected)?;
    let mut known = KnownAnswers::of(&jobs, stores);
    let open: Vec<Job<'_>> = known.open.iter().map(|&place| jobs[place]).collect();
    let context = RunContext {
        plan,
        suite,
        jobs: &open,
        engines,
        stores,
        lacks: &lacks,
        baselines: &baselines,
        cancel,
        is_broken: AtomicBool::new(false),
    };
    let mut tally = VerdictTally::new(engines);
    let mut give = |job: &Job<'_>, event: CaseEvent| {
        tally.count(job.engine, &event);
        sink(Event::Case(event));
    };
    known.give_before(0, &jobs, &context, &mut give);
    let mut give = |index: usize, event| {
        give(&open[index], event);
        known.give_before(index + 1, &jobs, &context, &mut give);
    };
    let pool = WorkerPool::new(plan.jobs);
    let mut schedule = Schedule {
        context: &context,
        batches: Batches::new(open.len(), pool.threads(), context.batch_len_for_packs()),
        begun: 0,
        reorder: Reorder::default(),
        given: 0,
        error: None,
        give: &mut give,
    };
    pool.run(
        || Ok::<_, SpawnError>(context.sessions()),
        |sessions, (number, jobs)| context.batch(number, jobs, sessions),
        &mut schedule,
    )?;
    if let Some(error) = schedule.error {
        return Err(error.into());
    }
    let cancelled = tally.cases < jobs.len() as u64;
    let mut lacking = 0;
    if !cancelled {
        for ((engine, lacks), waiting) in engines.iter().zip(&lacks).zip(tally.waiting) {
            for cause in waiting.causes(lacks, *engine) {
                lacking += u64::from(cause.is_failing_lack());
                sink(Event::Cause(cause));
            }
        }
        let duration_ms = u64::try_from(begun.elapsed().as_millis()).unwrap_or(u64::MAX);
        sink(Event::Footer(Footer {
            totals: tally.totals,
            engines: tally.engines,
            duration_ms,
            causes_ms: None,
        }));
    }
    Ok(RunSummary {
        totals: tally.totals,
        cases: tally.cases,
        from_cache: known.given,
        outdated,
        lacking,
        cancelled,
    })
}

/// A case to run on an engine.
#[derive(Clone, Copy)]
struct Job<'s> {
    case: &'s Case,
    engine: usize,
}

fn jobs<'s>(cases: &[&'s Case], engines: &[&dyn Engine], suite: &Suite) -> Vec<Job<'s>> {
    let asked = |case: &'s Case| {
        let is_asked = move |(_, engine): &(usize, &&dyn Engine)| is_asked(case, engine.identity(), suite);
        engines
            .iter()
            .enumerate()
            .filter(is_asked)
            .map(move |(engine, _)| Job { case, engine })
    };
    cases.iter().flat_map(|case| asked(case)).collect()
}

/// The result of a batch of jobs.
struct Batch {
    number: usize,
    /// The index of the first job.
    start: usize,
    /// The number of jobs in the batch.
    len: usize,
    /// The events of the jobs in their order; fewer than jobs where the run stops.
    events: Vec<CaseEvent>,
    time: Duration,
    /// The error because of which an engine cannot be used any more.
    error: Option<EngineError>,
}

/// Hands jobs out in batches, and passes their events on in order.
struct Schedule<'r, 'g> {
    context: &'r RunContext<'r>,
    batches: Batches,
    /// The number of batches that were handed out.
    begun: usize,
    reorder: Reorder<Batch>,
    /// The number of events that were passed on.
    given: usize,
    error: Option<EngineError>,
    /// The receiver of each event, with the index of its job.
    give: &'g mut dyn FnMut(usize, CaseEvent),
}

impl Supervisor<(usize, Range<usize>), Batch> for Schedule<'_, '_> {
    fn next_task(&mut self) -> Option<(usize, Range<usize>)> {
        if self.context.is_stopping() {
            return None;
        }
        let jobs = self.batches.next(self.given)?;
        let number = self.begun;
        self.begun += 1;
        Some((number, jobs))
    }

    fn take(&mut self, mut batch: Batch) {
        self.batches.took(batch.len, batch.time);
        self.error = self.error.take().or(batch.error.take());
        self.reorder.put(batch.number, batch);
        while let Some(batch) = self.reorder.pop() {
            // Behind a batch that was not finished nothing is given on.
            if batch.start == self.given {
                for event in batch.events {
                    (self.give)(self.given, event);
                    self.given += 1;
                }
            }
        }
    }
}

/// The verdict counts of the events that were passed on.
struct VerdictTally {
    totals: Totals,
    engines: Vec<EngineTotals>,
    cases: u64,
    /// The cases that wait for features, of each engine.
    waiting: Vec<WaitingCases>,
}

impl VerdictTally {
    fn new(engines: &[&dyn Engine]) -> VerdictTally {
        let none = |engine: &&dyn Engine| EngineTotals {
            name: engine.identity().name.clone(),
            totals: Totals::default(),
        };
        VerdictTally {
            totals: Totals::default(),
            engines: engines.iter().map(none).collect(),
            cases: 0,
            waiting: engines.iter().map(|_| WaitingCases::default()).collect(),
        }
    }

    fn count(&mut self, engine: usize, event: &CaseEvent) {
        self.totals.count(event.verdict);
        self.engines[engine].totals.count(event.verdict);
        if event.verdict == Verdict::Waiting {
            self.waiting[engine].take(event);
        }
        self.cases += 1;
    }
}

fn header(plan: &Plan, suite: &Suite, engines: &[&dyn Engine], cases: usize) -> Header {
    let filters = plan.filters.iter().map(|filter| filter.as_str().to_owned());
    let excluded = plan.excluded.iter();
    let excluded = excluded.map(|filter| format!("not {}", filter.as_str()));
    Header {
        format: FORMAT,
        stickler: env!("CARGO_PKG_VERSION").to_owned(),
        suite: suite.version.to_string(),
        started: plan.started.clone(),
        command: plan.command.clone(),
        engines: engines
            .iter()
            .map(|engine| engine_header(plan, *engine))
            .collect(),
        cases: cases as u64,
        filters: filters.chain(excluded).collect(),
        dialects: plan.dialects.iter().map(ToString::to_string).collect(),
        shard: plan.shard.map(|shard| shard.to_string()),
        broken_files: suite.errors.iter().map(ToString::to_string).collect(),
        baselines: Vec::new(),
        defined: plan.defined.clone(),
        sources: suite.sources.iter().cloned().collect(),
    }
}

fn engine_header(plan: &Plan, engine: &dyn Engine) -> EngineHeader {
    let identity = engine.identity();
    EngineHeader {
        name: identity.name.clone(),
        version: identity.version.clone(),
        dialects: identity.dialects.iter().map(ToString::to_string).collect(),
        strict: plan.strict(identity),
        rerun: plan.rerun_template(&identity.name),
        commands: identity
            .dialects
            .iter()
            .filter_map(|dialect| Some((dialect.to_string(), commands(engine, *dialect)?)))
            .collect(),
    }
}

/// Returns the commands that give [`PROGRAM`] to an engine without Stickler: those that also run it, where they need no other
/// file, and otherwise those that only check it.
fn commands(engine: &dyn Engine, dialect: DialectName) -> Option<String> {
    let request = RunRequest::once(dialect, "PROGRAM main\n    ;\nEND_PROGRAM\n", &[]);
    let shown = [Ability::Execute, Ability::Check].into_iter();
    let mut shown = shown.filter_map(|ability| engine.reproduce(&request, ability).ok());
    let alone = |shown: &Reproduction| matches!(&shown.files[..], [program] if program.name == PROGRAM);
    Some(shown.find(alone)?.commands_with_tools())
}
