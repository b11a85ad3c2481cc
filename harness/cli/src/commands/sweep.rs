//! `stickler sweep`: compares the results of a conversion function for every input with exact arithmetic.

mod names;
mod page;
mod programs;
mod programs_page;

use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::progress::Progress;
use crate::{engines, interrupt};
use page::SweepPage;
use std::io::Write;
use std::time::Instant;
use stickler_conversions::sweep::{Sampling, Sweep, SweepFindings, SweepMethod, SweepProgress, agenda, run};
use stickler_conversions::{FunctionDialects, find_function};
use stickler_types::boundaries::BoundaryDetail;
use stickler_workers::Cancellation;

/// Sweeps a function between each of its types and by each of its rules, and shows the findings after each sweep.
///
/// # Errors
/// A name that is no conversion function of the dialects, an engine that cannot be run, no threads.
pub fn execute(arguments: &SweepArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let function = arguments.function.to_ascii_uppercase();
    let present =
        find_function(&function, &arguments.dialect).inspect_err(|_| names::list_unless_known(&function))?;
    let engine = engines::by_name(&arguments.engine)?;
    if arguments.engine != engines::REFERENCE {
        return programs::execute(&function, &present, engine.as_ref(), arguments, out);
    }
    let FunctionDialects { having, lacking } = present;
    let sampling = Sampling {
        inputs: arguments.sample,
        seed: arguments.seed,
        detail: BoundaryDetail::Fine,
    };
    let sweeps = agenda(&function, &having, sampling, SweepMethod::Conversion)?;
    let cancel = interrupt::cancellation()?;
    let mut page = SweepPage::new(out, engine.identity());
    page.lacking(&function, &lacking)?;
    let jobs = arguments.jobs.map_or(0, usize::from);
    for (index, sweep) in sweeps.iter().enumerate() {
        page.begin(sweep, sampling)?;
        let begun = Instant::now();
        let findings = observed(sweep, jobs, cancel)?;
        page.end(sweep, &findings, begun.elapsed())?;
        if !findings.is_complete() {
            page.not_begun(sweeps.len() - index - 1)?;
            return Ok(Exit::Interrupted);
        }
    }
    page.total()?;
    Ok(page.exit())
}

/// Runs a sweep of the reference with a progress bar.
fn observed(sweep: &Sweep, jobs: usize, cancel: &Cancellation) -> anyhow::Result<SweepFindings> {
    let bar = Progress::new(sweep.domain.len());
    let advance = |reached: SweepProgress| bar.reach(reached.done, reached.mismatches);
    let findings = run(sweep, &sweep.reference, jobs, &advance, cancel);
    bar.finish();
    Ok(findings?)
}
