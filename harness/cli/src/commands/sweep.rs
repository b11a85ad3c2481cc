//! `stickler sweep`: compares the results of a conversion function, or of a standard function of one operand, for every input with exact arithmetic.

mod names;
mod page;
mod programs_page;

use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::progress::Progress;
use crate::{engines, interrupt};
use page::SweepPage;
use std::io::Write;
use std::time::Instant;
use stickler_conversions::sweep::foreign::{self, ForeignError};
use stickler_conversions::sweep::{Sampling, Sweep, SweepMethod, SweepProgress, agenda, run};
use stickler_conversions::{find_function, swept_signatures};
use stickler_engines::Engine;
use stickler_types::boundaries::BoundaryDetail;
use stickler_workers::Cancellation;

/// Sweeps a function and shows the findings after each sweep: of the reference between each of its types and by each of its rules, of
/// another engine in each of the function's dialects that it speaks, through programs that it executes.
///
/// # Errors
/// A name that is no conversion function of the dialects, an engine that cannot be run or speaks none of them, no threads. Sweeps that the
/// engine does not execute are shown on the page; the exit code is [`Exit::EngineNotRun`] if there are no others.
pub fn execute(arguments: &SweepArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let function = arguments.function.to_ascii_uppercase();
    let present = find_function(&function, &arguments.dialect, swept_signatures)
        .inspect_err(|_| names::list_unless_known(&function))?;
    let engine = engines::by_name(&arguments.engine)?;
    let other = (arguments.engine != engines::REFERENCE).then_some(&*engine);
    let (dialects, detail, method) = match other {
        None => (present.having, BoundaryDetail::Fine, SweepMethod::Conversion),
        Some(other) => (
            engines::spoken(other.identity(), &present.having)?,
            BoundaryDetail::Coarse,
            SweepMethod::Programs,
        ),
    };
    let sampling = Sampling {
        inputs: arguments.sample,
        seed: arguments.seed,
        detail,
    };
    let sweeps = agenda(&function, &dialects, sampling, method)?;
    let cancel = interrupt::cancellation()?;
    let mut page = SweepPage::new(out, engine.identity());
    page.lacking(&function, &present.lacking)?;
    let jobs = arguments.jobs.map_or(0, usize::from);
    let (mut executed, mut failed) = (false, false);
    for (index, sweep) in sweeps.iter().enumerate() {
        page.begin(sweep, sampling)?;
        let Some(swept) = swept(sweep, other, jobs, cancel, &mut page)? else {
            continue;
        };
        executed |= swept.executed;
        failed |= swept.failed;
        if !swept.is_complete {
            page.not_begun(sweeps.len() - index - 1)?;
            return Ok(Exit::Interrupted);
        }
    }
    page.total()?;
    Ok(match (executed, failed) {
        (false, _) => Exit::EngineNotRun,
        (true, failed) => Exit::Failures.when(failed),
    })
}

/// The result of a sweep.
struct Swept {
    /// Whether the engine gave a result at all.
    executed: bool,
    failed: bool,
    is_complete: bool,
}

/// Runs a sweep of the reference or of another engine with a progress bar, and shows its findings; `None` where the engine executes nothing.
fn swept(
    sweep: &Sweep,
    other: Option<&dyn Engine>,
    jobs: usize,
    cancel: &Cancellation,
    page: &mut SweepPage<'_>,
) -> anyhow::Result<Option<Swept>> {
    let begun = Instant::now();
    let bar = Progress::new(sweep.domain.len());
    let advance = |reached: SweepProgress| bar.reach(reached.done, reached.mismatches);
    let Some(engine) = other else {
        let findings = run(sweep, &sweep.reference, jobs, &advance, cancel);
        bar.finish();
        let findings = findings?;
        page.end(sweep, &findings, begun.elapsed())?;
        return Ok(Some(Swept {
            executed: true,
            failed: findings.mismatches > 0,
            is_complete: findings.is_complete(),
        }));
    };
    let findings = foreign::run(sweep, engine, jobs, &advance, cancel);
    bar.finish();
    match findings {
        Ok(findings) => {
            page.end_of_programs(&findings, begun.elapsed())?;
            Ok(Some(Swept {
                executed: findings.answered() > 0,
                failed: findings.has_failures(),
                is_complete: findings.is_complete(),
            }))
        }
        Err(error @ ForeignError::NothingRun { .. }) => {
            page.not_run(&error).map(|()| None).map_err(Into::into)
        }
        Err(error) => Err(error.into()),
    }
}
