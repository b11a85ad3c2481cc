//! Running cases on workers, and giving their events on in order from the caller's own thread.

mod known;

use crate::answers::{Answers, Desk};
use crate::event::{CaseEvent, EngineHeader, EngineTotals, Event, FORMAT, Footer, Header, PROGRAM};
use crate::memory::{self, Memory};
use crate::pack::{packs, settle};
use crate::reorder::{Dispenser, Reorder};
use crate::{Held, Plan, RunError, Summary, Teller, Totals, select};
use known::Known;
use std::sync::Mutex;
use std::sync::PoisonError;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::time::{Duration, Instant};
use stickler_engines::{Engine, EngineError};
use stickler_suite::{Case, Suite};

/// Runs the cases that the plan selects on every engine that speaks their dialect.
///
/// Events reach `sink` on this thread: a header, the cases in the order of the suite (engines in the order
/// given), a footer. When `cancel` becomes true, workers stop at their next case, what is complete from the
/// front is given on, and there is no footer. Memory is bounded whatever the number of cases; one engine
/// session is open a worker.
///
/// # Errors
/// [`RunError::NoCaseSelected`] before any event; [`RunError::Engine`] where an engine cannot be opened,
/// without a footer if the header is already out; [`RunError::Workers`] where the system gives no threads.
pub fn run(
    plan: &Plan,
    suite: &Suite,
    engines: &[&dyn Engine],
    sink: &mut dyn FnMut(Event),
    cancel: &AtomicBool,
) -> Result<Summary, RunError> {
    run_with(plan, suite, engines, &[], sink, cancel)
}

/// As [`run`], and asks no engine again what is in its memory; `memories` are by engine. What engines answer besides is kept
/// there. But for the times, the events are the same as without.
///
/// # Errors
/// As [`run`].
pub fn run_with(
    plan: &Plan,
    suite: &Suite,
    engines: &[&dyn Engine],
    memories: &[Option<&dyn Memory>],
    sink: &mut dyn FnMut(Event),
    cancel: &AtomicBool,
) -> Result<Summary, RunError> {
    let begun = Instant::now();
    let jobs = jobs(&select(plan, &suite.cases), engines);
    if jobs.is_empty() {
        return Err(RunError::NoCaseSelected);
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(plan.jobs)
        .stack_size(STACK)
        .thread_name(|index| format!("stickler-{index}"))
        .build()?;
    let held: Vec<Option<Held<'_>>> = engines
        .iter()
        .map(|engine| plan.hold(suite, engine.identity()))
        .collect();
    let header = Header {
        baselines: held.iter().flatten().map(|held| held.header().clone()).collect(),
        ..header(plan, suite, engines, jobs.len())
    };
    let outdated = header
        .baselines
        .iter()
        .map(|held| held.outdated.len() as u64)
        .sum();
    sink(Event::Header(header));
    let mut known = Known::of(&jobs, memories);
    let open: Vec<Job<'_>> = known.open.iter().map(|&place| jobs[place]).collect();
    let floor = Floor {
        plan,
        jobs: &open,
        engines,
        memories,
        pack_sizes: engines.iter().map(|engine| pack_size(plan, *engine)).collect(),
        held: &held,
        cancel,
        stop: AtomicBool::new(false),
        broken: Mutex::new(None),
    };
    let mut tally = Tally::new(engines);
    let mut give = |job: &Job<'_>, event: CaseEvent| {
        tally.count(job.engine, &event);
        sink(Event::Case(event));
    };
    known.give_before(0, &jobs, &floor, &mut give);
    floor.work(&pool, &mut |index, event| {
        give(&open[index], event);
        known.give_before(index + 1, &jobs, &floor, &mut give);
    });
    if let Some(error) = floor.broken.into_inner().unwrap_or_else(PoisonError::into_inner) {
        return Err(error.into());
    }
    let cancelled = tally.cases < jobs.len() as u64;
    if !cancelled {
        let duration_ms = u64::try_from(begun.elapsed().as_millis()).unwrap_or(u64::MAX);
        sink(Event::Footer(Footer {
            totals: tally.totals,
            engines: tally.engines,
            duration_ms,
        }));
    }
    Ok(Summary {
        totals: tally.totals,
        cases: tally.cases,
        remembered: known.given,
        outdated,
        cancelled,
    })
}

/// An engine in this process may recurse as deep as its own limits allow; two megabytes are too few for some.
pub(crate) const STACK: usize = 16 << 20;

/// A batch grows while it takes less than this; then workers seldom wake whoever gives their events on, and slow engines
/// still show progress.
const QUICK: Duration = Duration::from_millis(50);

const LARGEST_BATCH: usize = 64;

/// A batch for engines that pack holds so many packs of each, for cases of several kinds alternate.
const PACKS: usize = 2;

fn pack_size(plan: &Plan, engine: &dyn Engine) -> usize {
    if plan.unpacked { 1 } else { engine.pack_size() }
}

/// One case on one engine.
#[derive(Clone, Copy)]
struct Job<'s> {
    case: &'s Case,
    engine: usize,
}

fn jobs<'s>(cases: &[&'s Case], engines: &[&dyn Engine]) -> Vec<Job<'s>> {
    let speakers = |case: &'s Case| {
        let speaks = move |(_, engine): &(usize, &&dyn Engine)| engine.identity().speaks(case.dialect);
        engines
            .iter()
            .enumerate()
            .filter(speaks)
            .map(move |(engine, _)| Job { case, engine })
    };
    cases.iter().flat_map(|case| speakers(case)).collect()
}

/// All that workers share.
struct Floor<'r> {
    plan: &'r Plan,
    jobs: &'r [Job<'r>],
    engines: &'r [&'r dyn Engine],
    pack_sizes: Vec<usize>,
    /// By engine; engines behind the last have none.
    memories: &'r [Option<&'r dyn Memory>],
    /// By engine.
    held: &'r [Option<Held<'r>>],
    cancel: &'r AtomicBool,
    stop: AtomicBool,
    broken: Mutex<Option<EngineError>>,
}

type Batch = (usize, Vec<CaseEvent>);

impl Floor<'_> {
    /// Runs all jobs; `give` gets each event with its job's index, in order.
    fn work(&self, pool: &rayon::ThreadPool, give: &mut dyn FnMut(usize, CaseEvent)) {
        let dispenser = Dispenser::new(self.jobs.len(), pool.current_num_threads());
        let (sender, receiver) = mpsc::channel::<Batch>();
        pool.in_place_scope(|scope| {
            for _ in 0..pool.current_num_threads() {
                let (sender, dispenser) = (sender.clone(), &dispenser);
                scope.spawn(move |_| self.worker(dispenser, &sender));
            }
            drop(sender);
            let mut reorder = Reorder::new();
            let mut index = 0;
            for (start, batch) in receiver {
                let next = reorder.take(start, batch, |event| {
                    give(index, event);
                    index += 1;
                });
                dispenser.given_on(next);
                if self.cancel.load(Ordering::Relaxed) {
                    self.stop.store(true, Ordering::Relaxed);
                }
            }
        });
    }

    fn worker(&self, dispenser: &Dispenser, sender: &mpsc::Sender<Batch>) {
        let _alarm = Alarm(&self.stop);
        let mut desks: Vec<Desk<'_>> = self.engines.iter().map(|&engine| Desk::new(engine)).collect();
        let for_packs = self.size_for_packs();
        let mut size = 1;
        while let Some(range) = dispenser.claim(for_packs.unwrap_or(size), &self.stop) {
            let begun = Instant::now();
            let start = range.start;
            let batch = self.batch(&self.jobs[range], &mut desks);
            size = if begun.elapsed() < QUICK {
                LARGEST_BATCH.min(size * 2)
            } else {
                1.max(size / 2)
            };
            if sender.send((start, batch)).is_err() {
                return;
            }
        }
    }

    /// How many jobs make a batch where an engine packs.
    fn size_for_packs(&self) -> Option<usize> {
        let largest = self.pack_sizes.iter().copied().max().filter(|&size| size > 1);
        largest.map(|size| size * PACKS * self.engines.len())
    }

    /// The events of these jobs; fewer where the run stops.
    fn batch(&self, jobs: &[Job<'_>], desks: &mut [Desk<'_>]) -> Vec<CaseEvent> {
        let cases: Vec<(&Case, usize)> = jobs.iter().map(|job| (job.case, job.engine)).collect();
        let mut events: Vec<Option<CaseEvent>> = jobs.iter().map(|_| None).collect();
        for pack in packs(&cases, &self.pack_sizes) {
            if self.stopping() {
                break;
            }
            if let Err(error) = self.ask(jobs, &pack, desks, &mut events) {
                // Whoever stops the run may have ended its engines.
                if self.stopping() {
                    break;
                }
                self.stop.store(true, Ordering::Relaxed);
                *self.broken.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
                break;
            }
        }
        // What stands behind a gap would never be given on.
        events.into_iter().map_while(|event| event).collect()
    }

    /// Asks about the jobs at these places, which are one pack, and writes their events down.
    fn ask(
        &self,
        jobs: &[Job<'_>],
        pack: &[usize],
        desks: &mut [Desk<'_>],
        events: &mut [Option<CaseEvent>],
    ) -> Result<(), EngineError> {
        let Some(first) = pack.first() else {
            return Ok(());
        };
        let desk = &mut desks[jobs[*first].engine];
        let cases: Vec<&Case> = pack.iter().map(|&place| jobs[place].case).collect();
        let settled = settle(desk, &cases, &|| self.stopping())?;
        for (&place, settled) in pack.iter().zip(settled) {
            events[place] = settled.map(|(answers, time)| {
                self.keep(&jobs[place], &answers);
                self.event(&jobs[place], &answers, time)
            });
        }
        Ok(())
    }

    /// Keeps answers for later runs.
    fn keep(&self, job: &Job<'_>, answers: &Answers) {
        if let Some(Some(memory)) = self.memories.get(job.engine)
            && let Some(text) = memory::written(answers)
        {
            memory.keep(&memory::question(job.case), &text);
        }
    }

    fn stopping(&self) -> bool {
        if self.cancel.load(Ordering::Relaxed) {
            self.stop.store(true, Ordering::Relaxed);
        }
        self.stop.load(Ordering::Relaxed)
    }

    fn event(&self, job: &Job<'_>, answers: &Answers, time: Duration) -> CaseEvent {
        let teller = Teller {
            plan: self.plan,
            engine: self.engines[job.engine].identity(),
            held: self.held[job.engine].as_ref(),
        };
        teller.event(job.case, answers, time)
    }
}

/// Stops the run if its worker panics, so that the others do not wait for cases that never come.
struct Alarm<'a>(&'a AtomicBool);

impl Drop for Alarm<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.store(true, Ordering::Relaxed);
        }
    }
}

/// The verdicts counted as their events go out.
struct Tally {
    totals: Totals,
    engines: Vec<EngineTotals>,
    cases: u64,
}

impl Tally {
    fn new(engines: &[&dyn Engine]) -> Tally {
        let name = |engine: &&dyn Engine| engine.identity().name.clone();
        let none = |engine| EngineTotals {
            name: name(engine),
            totals: Totals::default(),
        };
        Tally {
            totals: Totals::default(),
            engines: engines.iter().map(none).collect(),
            cases: 0,
        }
    }

    fn count(&mut self, engine: usize, event: &CaseEvent) {
        self.totals.count(event.verdict);
        self.engines[engine].totals.count(event.verdict);
        self.cases += 1;
    }
}

fn header(plan: &Plan, suite: &Suite, engines: &[&dyn Engine], cases: usize) -> Header {
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
        filters: plan
            .filters
            .iter()
            .map(|filter| filter.as_str().to_owned())
            .collect(),
        dialects: plan.dialects.iter().map(ToString::to_string).collect(),
        shard: plan.shard.map(|shard| shard.to_string()),
        broken_files: suite.errors.iter().map(ToString::to_string).collect(),
        baselines: Vec::new(),
        defined: plan.defined.clone(),
    }
}

fn engine_header(plan: &Plan, engine: &dyn Engine) -> EngineHeader {
    let identity = engine.identity();
    EngineHeader {
        name: identity.name.clone(),
        version: identity.version.clone(),
        dialects: identity.dialects.iter().map(ToString::to_string).collect(),
        strict: plan.strict(identity),
        commands: identity
            .dialects
            .iter()
            .filter_map(|dialect| Some((dialect.to_string(), engine.own_command(*dialect, PROGRAM)?)))
            .collect(),
    }
}
