//! Runs many programs in one C++ program: the C++ compiler, which takes most of the time, starts once for all of them.
//!
//! Each program is translated alone, so that a rejection needs no further round. The C++ of accepted programs stands side by
//! side, each in a namespace of its own. No program sees what another does when it runs.

use super::driver::{StrucppSubject, driver};
use super::{AcceptedProgram, Strucpp, execution};
use crate::adapters::locate::suspects;
use crate::adapters::recipe::Workplace;
use crate::adapters::rename::declared;
use crate::adapters::rounds::{self, Round};
use crate::{Packed, RunRequest};
use std::collections::BTreeSet;

/// The number of rounds of a pack, fewer than [`rounds::MAX_ROUNDS`]: each round costs seconds of a C++ compiler, which names
/// all programs with errors at once.
const MAX_ROUNDS: usize = 4;

/// Runs a pack of programs, as [`Session::run_pack`](crate::Session::run_pack) does.
pub(super) fn run(adapter: &Strucpp, workplace: &Workplace<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
    let mut answers = vec![Packed::Alone; requests.len()];
    let mut members = Vec::with_capacity(requests.len());
    for (place, request) in requests.iter().enumerate() {
        match adapter.accepted(request) {
            Ok(accepted) if declared(request, &adapter.taken, false).is_some() => {
                members.push((place, accepted));
            }
            Ok(_) => {}
            Err(outcome) => answers[place] = Packed::Answered(outcome),
        }
    }
    let place = |(place, _): &(usize, AcceptedProgram<'_>)| *place;
    rounds::play(members, MAX_ROUNDS, &mut answers, place, |members| {
        build_and_run(adapter, workplace, members).unwrap_or_else(Round::alone)
    });
    answers
}

/// Builds and runs programs in one C++ program.
///
/// # Errors
/// The numbers of the programs that the C++ compiler names in errors, or of all where it does not finish; none where it names
/// no program.
fn build_and_run(
    adapter: &Strucpp,
    workplace: &Workplace<'_>,
    members: &[(usize, AcceptedProgram<'_>)],
) -> Result<Round, BTreeSet<usize>> {
    let subjects: Vec<&StrucppSubject<'_>> = members.iter().map(|(_, accepted)| &accepted.subject).collect();
    let driver = driver(&subjects);
    let mut recipe = execution("", &driver.text());
    for (number, (_, accepted)) in members.iter().enumerate() {
        let text = in_a_namespace(&accepted.translated.header, &accepted.translated.program);
        recipe = recipe.file(&format!("program_{number}.cpp"), text);
    }
    workplace.begin(&recipe).map_err(|_| BTreeSet::new())?;
    let built = adapter.builder.try_build(&recipe, workplace);
    let ended = built.map_err(|outcome| suspects(&outcome, members.len()))?;
    if ended.status.success() {
        let outcomes = driver.execute_all(&recipe, workplace).into_iter().zip(members);
        let with_warnings =
            outcomes.map(|(outcome, (_, accepted))| outcome.with_warnings(accepted.translated.diagnostics()));
        return Ok(Round::Ran(with_warnings.collect()));
    }
    let marks = [("program_", '.'), ("pack_", ':')].into_iter();
    let named = marks.flat_map(|(mark, end)| numbers(&ended.stderr, mark, end));
    Err(named.filter(|number| *number < members.len()).collect())
}

/// Returns the C++ of a program without the lines that a namespace must not have: the headers that they include are included
/// already.
fn in_a_namespace(header: &str, program: &str) -> String {
    let kept = |line: &&str| {
        let line = line.trim_start();
        !(line.starts_with("#include") || line.starts_with("#pragma once"))
    };
    let lines = header.lines().chain(program.lines()).filter(kept);
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// Returns the numbers between these marks in a text.
fn numbers(text: &str, mark: &str, end: char) -> Vec<usize> {
    let behind = text.split(mark).skip(1);
    let number = |behind: &str| behind.split_once(end)?.0.parse().ok();
    behind.filter_map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_programs_that_a_compiler_complains_of_are_named() {
        let stderr = "In file included from driver.cpp:9:\nprogram_12.cpp:3:1: error: no\n\
                      driver.cpp: In function 'int pack_7::run_subject()':\nprogram_x.cpp";
        assert_eq!(numbers(stderr, "program_", '.'), [12]);
        assert_eq!(numbers(stderr, "pack_", ':'), [7]);
    }

    #[test]
    fn what_is_included_already_is_left_out() {
        let text = in_a_namespace(
            "#pragma once\n#include <array>\n#undef OVERFLOW\nnamespace strucpp {}\n",
            "#include \"program.hpp\"\nint x;\n",
        );
        assert_eq!(text, "#undef OVERFLOW\nnamespace strucpp {}\nint x;\n");
    }
}
