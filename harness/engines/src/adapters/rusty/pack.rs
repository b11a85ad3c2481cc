//! Many programs in one call of the compiler: it reads its library once for all of them, and the linker starts once.
//!
//! Each program is a file of its own, and so every diagnostic tells whose it is. Mistakes in one file keep the compiler from
//! those of the same kind in no other: such programs are rejected at once, and the others go on without them. What it names
//! after that, when it makes the object file, is asked about alone. What one program does when it runs, no other sees.

use super::RustySession;
use super::diagnostics::{About, Found, rejected, steady};
use super::driver::{Subject, driver, functions};
use super::program::Program;
use crate::adapters::locate::suspects;
use crate::adapters::rename::places_named;
use crate::adapters::rounds::{self, MAX_ROUNDS, Round};
use crate::{Diagnostic, Outcome, Packed, RunRequest};
use std::collections::{BTreeMap, BTreeSet};

/// As [`Session::run_pack`](crate::Session::run_pack).
pub(super) fn run(session: &RustySession<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
    let mut answers = vec![Packed::Alone; requests.len()];
    let taken = session.engine.taken();
    let program = |(place, request)| Program::among_others(request, place, taken);
    let programs: Vec<Program<'_>> = requests.iter().enumerate().filter_map(program).collect();
    let place = |program: &Program<'_>| program.place;
    rounds::play(programs, MAX_ROUNDS, &mut answers, place, |programs| {
        look(session, programs)
    });
    answers
}

/// Compiles, builds and runs programs together.
fn look(session: &RustySession<'_>, programs: &[Program<'_>]) -> Round {
    let subjects: Vec<Subject<'_>> = programs.iter().map(Program::subject).collect();
    let first_file = programs
        .first()
        .map_or_else(String::new, |first| Program::file_of(first.place));
    let Ok(driver) = driver(&subjects, &first_file) else {
        let cannot = |number: &usize| driver(&subjects[*number..=*number], &first_file).is_err();
        return Round::alone((0..subjects.len()).filter(cannot).collect());
    };
    match session.compile(programs, &functions(&subjects, &driver.subjects)) {
        Ok(found) if found.is_empty() => {}
        Ok(found) => return refused(programs, found),
        Err(outcome) => return broken_off(&outcome, programs),
    }
    let linked = session.engine.linked();
    let built = session
        .engine
        .builder
        .build_with(&driver.text, &linked, &session.folder);
    match built {
        Ok(()) => {
            let known = driver.execute_all(&session.folder).into_iter();
            Round::Ran(known.map(steady).collect())
        }
        Err(outcome) => broken_off(&outcome, programs),
    }
}

/// Returns what is known after something did not come to an end of its own.
fn broken_off(outcome: &Outcome, programs: &[Program<'_>]) -> Round {
    let suspects = match outcome {
        Outcome::Crashed { reason } => {
            let named: BTreeSet<usize> = places_named(reason).into_iter().collect();
            let suspected = |number: &usize| named.contains(&programs[*number].place);
            (0..programs.len()).filter(suspected).collect()
        }
        other => suspects(other, programs.len()),
    };
    Round::alone(suspects)
}

/// Takes out the programs that the compiler does not accept.
fn refused(programs: &[Program<'_>], found: Vec<Found>) -> Round {
    let mut told: Vec<Vec<Diagnostic>> = programs.iter().map(|_| Vec::new()).collect();
    let mut alone = BTreeSet::new();
    for (about, diagnostic) in found {
        match about {
            About::Program(place) => {
                let number = programs.iter().position(|program| program.place == place);
                let Some(number) = number else {
                    return Round::nothing();
                };
                told[number].push(programs[number].original(diagnostic));
            }
            About::Functions(number) if number < programs.len() => {
                alone.insert(number);
            }
            About::Functions(_) | About::Elsewhere => return Round::nothing(),
        }
    }
    // Functions that show the variables of a program with errors have some, too: what is rejected replaces what was suspected.
    let mut known: BTreeMap<usize, Packed> =
        alone.into_iter().map(|number| (number, Packed::Alone)).collect();
    let told = told.into_iter().enumerate().filter(|(_, told)| !told.is_empty());
    known.extend(told.map(|(number, told)| (number, Packed::Answered(rejected(told.into_iter())))));
    Round::TakenOut(known)
}
