//! The sweep of an engine other than the reference, through programs that it executes.

use super::page::SweepPage;
use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::progress::Progress;
use crate::{engines, interrupt};
use std::io::Write;
use std::time::Instant;
use stickler_conversions::FunctionDialects;
use stickler_conversions::sweep::foreign::{ForeignError, ForeignFindings, run};
use stickler_conversions::sweep::{Sampling, Sweep, SweepMethod, SweepProgress, agenda};
use stickler_engines::Engine;
use stickler_types::boundaries::BoundaryDetail;
use stickler_workers::Cancellation;

/// Sweeps a function in each of its dialects that the engine speaks, and shows the findings after each sweep.
///
/// # Errors
/// An engine that speaks none of the dialects or cannot be started, no threads. Sweeps that the engine does not execute are
/// shown on the page; the exit code is [`Exit::EngineNotRun`] if there are no others.
pub fn execute(
    function: &str,
    present: &FunctionDialects,
    engine: &dyn Engine,
    arguments: &SweepArguments,
    out: &mut dyn Write,
) -> anyhow::Result<Exit> {
    let dialects = engines::spoken(engine.identity(), &present.having)?;
    let sampling = Sampling {
        inputs: arguments.sample,
        seed: arguments.seed,
        detail: BoundaryDetail::Coarse,
    };
    let sweeps = agenda(function, &dialects, sampling, SweepMethod::Programs)?;
    let cancel = interrupt::cancellation()?;
    let mut page = SweepPage::new(out, engine.identity());
    page.lacking(function, &present.lacking)?;
    let jobs = arguments.jobs.map_or(0, usize::from);
    let (mut executed, mut failed) = (false, false);
    for (index, sweep) in sweeps.iter().enumerate() {
        page.begin(sweep, sampling)?;
        let begun = Instant::now();
        let findings = match observed(sweep, engine, jobs, cancel) {
            Ok(findings) => findings,
            Err(error @ ForeignError::NothingRun { .. }) => {
                page.not_run(&error)?;
                continue;
            }
            Err(error) => return Err(error.into()),
        };
        page.end_of_programs(&findings, begun.elapsed())?;
        executed |= findings.answered() > 0;
        failed |= findings.has_failures();
        if !findings.is_complete() {
            page.not_begun(sweeps.len() - index - 1)?;
            return Ok(Exit::Interrupted);
        }
    }
    page.total()?;
    Ok(match (executed, failed) {
        (false, _) => Exit::EngineNotRun,
        (true, true) => Exit::Failures,
        (true, false) => Exit::AsExpected,
    })
}

/// Runs a sweep through programs with a progress bar.
fn observed(
    sweep: &Sweep,
    engine: &dyn Engine,
    jobs: usize,
    cancel: &Cancellation,
) -> Result<ForeignFindings, ForeignError> {
    let bar = Progress::new(sweep.domain.len());
    let advance = |reached: SweepProgress| bar.reach(reached.done, reached.mismatches);
    let findings = run(sweep, engine, jobs, &advance, cancel);
    bar.finish();
    findings
}
