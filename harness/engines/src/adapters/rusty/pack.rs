//! Runs many programs in one call of the compiler: it reads its library once for all of them, and the linker starts once.
//!
//! Each program is a file of its own, and so every diagnostic names its program. Mistakes in one file hide no mistakes of the
//! same kind in another: such programs are rejected at once, and the others go on without them. A program that the compiler
//! names later, when it makes the object file, is run alone. No program sees what another does when it runs.

use super::diagnostics::{ErrorPart, LocatedDiagnostic};
use super::diagnostics::{rejected, steady};
use super::driver::RustyDriver;
use super::program::PackedProgram;
use super::{Rusty, execution};
use crate::adapters::locate::suspects;
use crate::adapters::recipe::Workplace;
use crate::adapters::rename::places_named;
use crate::adapters::rounds::{self, Round};
use crate::{Diagnostic, Outcome, Packed, RunRequest};
use std::collections::{BTreeMap, BTreeSet};

/// Runs a pack of programs, as [`Session::run_pack`](crate::Session::run_pack) does.
pub(super) fn run(adapter: &Rusty, workplace: &Workplace<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
    let taken = &adapter.taken;
    let member = |place, request| PackedProgram::among_others(request, place, taken);
    rounds::pack(
        requests,
        member,
        |member| member.place,
        |members| {
            let round = run_round(adapter, workplace, members);
            round.unwrap_or_else(|outcome| broken_off(&outcome, members))
        },
    )
}

/// Compiles, builds and runs programs together.
///
/// # Errors
/// The outcome of a compiler that did not finish.
fn run_round(
    adapter: &Rusty,
    workplace: &Workplace<'_>,
    programs: &[PackedProgram<'_>],
) -> Result<Round, Outcome> {
    let driver = RustyDriver::of(programs);
    let recipe = execution(programs, &driver);
    let warnings = adapter.compile(workplace, &recipe, &[])?;
    if warnings.iter().any(|(_, reported)| reported.is_error()) {
        return Ok(refused(programs, &driver, warnings));
    }
    adapter.build(&recipe, workplace)?;
    let known = driver
        .driver
        .execute_all(&recipe, workplace)
        .into_iter()
        .zip(programs);
    let outcome = |(outcome, program): (Outcome, &PackedProgram<'_>)| {
        steady(outcome).with_warnings(program.own(&warnings))
    };
    Ok(Round::Ran(known.map(outcome).collect()))
}

/// Returns the round of a pack that the compiler or a program did not finish.
fn broken_off(outcome: &Outcome, programs: &[PackedProgram<'_>]) -> Round {
    let suspects = match outcome {
        Outcome::Crashed { reason } | Outcome::Unusable { reason } => {
            let named: BTreeSet<usize> = places_named(reason).into_iter().collect();
            let suspected = |number: &usize| named.contains(&programs[*number].place);
            (0..programs.len()).filter(suspected).collect()
        }
        other => suspects(other, programs.len()),
    };
    Round::alone(suspects)
}

/// Removes the programs that the compiler does not accept.
fn refused(programs: &[PackedProgram<'_>], driver: &RustyDriver<'_>, found: Vec<LocatedDiagnostic>) -> Round {
    let mut mistakes: BTreeMap<usize, Vec<Diagnostic>> = BTreeMap::new();
    let mut known: BTreeMap<usize, Packed> = BTreeMap::new();
    for (about, diagnostic) in found {
        let number = match about {
            ErrorPart::Program(place) => programs.iter().position(|program| program.place == place),
            ErrorPart::Functions(line) => driver.program_at(line),
            ErrorPart::Elsewhere => None,
        };
        let Some(number) = number else {
            return Round::nothing();
        };
        match about {
            ErrorPart::Program(_) => {
                let original = programs[number].original(diagnostic);
                mistakes.entry(number).or_default().push(original);
            }
            _ => _ = known.insert(number, Packed::Alone),
        }
    }
    // The functions that show the variables of a program with errors have errors, too: a rejection replaces the suspicion.
    let rejections = mistakes.into_iter();
    known.extend(
        rejections.map(|(number, mistakes)| (number, Packed::Answered(rejected(mistakes.into_iter())))),
    );
    Round::TakenOut(known)
}
