//! Compares all inputs of a sweep through an engine, in one session for each worker, until done or cancelled.

use super::counter;
use super::findings::ForeignFindings;
use super::plan::SweepPlan;
use super::queue::Queue;
use super::worker::ForeignSweep;
use crate::literals::{has_literal, literal};
use crate::program::{ConversionProgram, listed};
use crate::session::{FunctionSession, Refusal};
use crate::sweep::agenda::Sweep;
use crate::sweep::findings::SweepProgress;
use std::sync::{Mutex, PoisonError};
use stickler_engines::{Engine, EngineError};
use stickler_types::DialectName;
use stickler_workers::{Cancellation, SpawnError, WorkerPool};

/// The error of a sweep that could not be started.
#[derive(Debug, thiserror::Error)]
pub enum ForeignError {
    /// No session could be opened.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// The engine answered none of the first programs.
    #[error("{engine} could not be asked {function} in {dialect}: it {refusal}{}", advice(*.counts))]
    NothingRun {
        /// The engine's name.
        engine: String,
        /// The name of the function.
        function: String,
        /// The dialect.
        dialect: DialectName,
        /// The reason for which the engine gave no values.
        refusal: Box<Refusal>,
        /// Whether the programs were to count through the operands.
        counts: bool,
    },
    /// The system gives no threads.
    #[error(transparent)]
    Workers(#[from] SpawnError),
}

/// Returns advice for the error of a sweep whose programs count; empty otherwise.
const fn advice(counts: bool) -> &'static str {
    if counts {
        "; `--sample N` asks by lists of literals instead of a loop"
    } else {
        ""
    }
}

/// Compares the result of every input of the sweep that a program can make with exact arithmetic, in the given number of
/// sessions (0: one for each processor). The sweep must have one dialect, as those of
/// [`SweepMethod::Programs`](crate::sweep::SweepMethod::Programs) have.
///
/// Treats `progress` and `cancel` as [`crate::sweep::run()`] does; waits for a program that was given to the engine.
///
/// # Errors
/// [`ForeignError`]: no session, no thread, or none of a few inputs from all over the domain is answered at all.
pub fn run(
    sweep: &Sweep,
    engine: &dyn Engine,
    jobs: usize,
    progress: &(dyn Fn(SweepProgress) + Sync),
    cancel: &Cancellation,
) -> Result<ForeignFindings, ForeignError> {
    let plan = SweepPlan::of(sweep);
    let dialect = sweep.dialects.first().copied().unwrap_or(DialectName::ALL[0]);
    if !cancel.is_requested() {
        probe(sweep, &plan, engine, dialect)?;
    }
    let findings = ForeignFindings {
        inputs: sweep.domain.len(),
        done: plan.left_out,
        left_out: plan.left_out,
        ..ForeignFindings::default()
    };
    let foreign_sweep = ForeignSweep {
        sweep,
        dialect,
        plan: &plan,
        queue: Queue::new(plan.stretches.clone(), plan.counting.is_some()),
        findings: Mutex::new(findings),
        progress,
        cancel,
    };
    let claim = || foreign_sweep.queue.claim().filter(|_| !cancel.is_requested());
    let tasks = std::iter::from_fn(claim);
    WorkerPool::new(jobs).for_each(
        tasks,
        || FunctionSession::open(engine).map_err(ForeignError::Engine),
        |session, places| foreign_sweep.examine(session, places),
        |()| (),
    )?;
    let findings = foreign_sweep.findings.into_inner();
    Ok(findings.unwrap_or_else(PoisonError::into_inner))
}

/// Runs a few small programs until the engine answers one of them; the error is the refusal of the first one.
fn probe(
    sweep: &Sweep,
    plan: &SweepPlan,
    engine: &dyn Engine,
    dialect: DialectName,
) -> Result<(), ForeignError> {
    let mut session = FunctionSession::open(engine)?;
    let mut refusal = None;
    for program in probes(sweep, plan) {
        match session.run(dialect, &program) {
            Ok(_) => return Ok(()),
            Err(reason) => refusal = refusal.or(Some(reason)),
        }
    }
    match refusal {
        // There is no input to ask.
        None => Ok(()),
        Some(refusal) => Err(ForeignError::NothingRun {
            engine: engine.identity().name.clone(),
            function: sweep.signature.function.clone(),
            dialect,
            refusal: Box::new(refusal),
            counts: plan.counting.is_some(),
        }),
    }
}

/// Returns small programs for inputs from all over the domain.
fn probes(sweep: &Sweep, plan: &SweepPlan) -> Vec<ConversionProgram> {
    let signature = &sweep.signature;
    if let Some(counting) = &plan.counting {
        let ends = plan
            .stretches
            .iter()
            .map(|stretch| stretch.start..stretch.end.min(stretch.start + 2));
        // The first has but one input; those in the middle have two.
        let some = ends.filter(|places| places.end - places.start > 1).step_by(100);
        return some
            .map(|places| counter::summed(signature, counting, &places))
            .collect();
    }
    let length = sweep.domain.len();
    (0..8)
        .map(|eighth| length / 8 * eighth + length % 8 / 2)
        .filter(|place| *place < length)
        .map(|place| sweep.domain.operands(place))
        .filter(|call| call.iter().all(has_literal))
        .map(|call| listed(&signature.function, signature.result, &[call], literal))
        .collect()
}
