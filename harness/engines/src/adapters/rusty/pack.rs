//! Many programs in one call of the compiler: it reads its library once for all of them, and the linker starts once.
//!
//! Each program is a file of its own, and so every diagnostic tells whose it is. Mistakes in one file keep the compiler from
//! those of the same kind in no other: such programs are rejected at once, and the others go on without them. What it names
//! after that, when it makes the object file, is asked about alone. What one program does when it runs, no other sees.

use super::RustySession;
use super::diagnostics::{About, Found, rejected, steady};
use super::driver::{Subject, driver, functions};
use super::program::{self, Program};
use crate::adapters::locate::suspects;
use crate::{Diagnostic, Outcome, Packed, RunRequest};
use std::collections::BTreeSet;

/// So often programs are taken out and the rest goes on; then whoever gave the pack makes smaller ones.
const ROUNDS: usize = 12;

/// What is known of a pack after a round.
enum Known {
    /// All ran.
    Outcomes(Vec<Outcome>),
    /// Some are rejected, and some are to be asked about alone; the others were looked at, too.
    Taken {
        rejected: Vec<(usize, Outcome)>,
        alone: BTreeSet<usize>,
    },
    /// Nothing is known of any of them.
    Nothing,
}

/// As [`Session::run_pack`](crate::Session::run_pack).
pub(super) fn run(session: &RustySession<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
    let mut answers = vec![Packed::Alone; requests.len()];
    let taken = session.engine.taken();
    let program = |(place, request)| Program::among_others(request, place, taken);
    let mut programs: Vec<Program<'_>> = requests.iter().enumerate().filter_map(program).collect();
    for _ in 0..ROUNDS {
        if programs.len() < 2 {
            break;
        }
        match look(session, &programs) {
            Known::Outcomes(known) => {
                for (program, outcome) in programs.drain(..).zip(known) {
                    answers[program.place] = Packed::Told(outcome);
                }
            }
            Known::Taken { rejected, alone } => {
                let mut out = alone;
                for (number, outcome) in rejected {
                    answers[programs[number].place] = Packed::Told(outcome);
                    out.insert(number);
                }
                for number in out.into_iter().rev() {
                    programs.remove(number);
                }
            }
            Known::Nothing => break,
        }
    }
    for program in programs {
        answers[program.place] = Packed::Unknown;
    }
    answers
}

/// Compiles, builds and runs programs together.
fn look(session: &RustySession<'_>, programs: &[Program<'_>]) -> Known {
    let subjects: Vec<Subject<'_>> = programs.iter().map(Program::subject).collect();
    let first_file = programs
        .first()
        .map_or_else(String::new, |first| Program::file_of(first.place));
    let Ok(driver) = driver(&subjects, &first_file) else {
        let cannot = |number: &usize| driver(&subjects[*number..=*number], &first_file).is_err();
        return taken(Vec::new(), (0..subjects.len()).filter(cannot).collect());
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
            Known::Outcomes(known.map(steady).collect())
        }
        Err(outcome) => broken_off(&outcome, programs),
    }
}

/// What is known after something did not come to an end of its own.
fn broken_off(outcome: &Outcome, programs: &[Program<'_>]) -> Known {
    let suspects = match outcome {
        Outcome::Crashed { reason } => {
            let named: BTreeSet<usize> = program::named(reason).collect();
            let suspected = |number: &usize| named.contains(&programs[*number].place);
            (0..programs.len()).filter(suspected).collect()
        }
        other => suspects(other, programs.len()),
    };
    taken(Vec::new(), suspects)
}

/// What it is that the compiler does not accept.
fn refused(programs: &[Program<'_>], found: Vec<Found>) -> Known {
    let mut told: Vec<Vec<Diagnostic>> = programs.iter().map(|_| Vec::new()).collect();
    let mut alone = BTreeSet::new();
    for (about, diagnostic) in found {
        match about {
            About::Program(place) => {
                let number = programs.iter().position(|program| program.place == place);
                let Some(number) = number else {
                    return Known::Nothing;
                };
                told[number].push(programs[number].original(diagnostic));
            }
            About::Functions(number) if number < programs.len() => {
                alone.insert(number);
            }
            About::Functions(_) | About::Elsewhere => return Known::Nothing,
        }
    }
    let told = told.into_iter().enumerate().filter(|(_, told)| !told.is_empty());
    let rejected: Vec<(usize, Outcome)> = told
        .map(|(number, told)| (number, rejected(told.into_iter())))
        .collect();
    // Functions that show the variables of a program with errors have some, too.
    for (number, _) in &rejected {
        alone.remove(number);
    }
    taken(rejected, alone)
}

fn taken(rejected: Vec<(usize, Outcome)>, alone: BTreeSet<usize>) -> Known {
    if rejected.is_empty() && alone.is_empty() {
        Known::Nothing
    } else {
        Known::Taken { rejected, alone }
    }
}
