//! Calls the programs of a compiler, reads what they print, and describes their errors.

use crate::process::{Ended, Folder, ToolLimits, run_tool};
use crate::{EngineError, Identity, NamedValue, Outcome};
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::Path;
use std::time::Duration;
use stickler_types::{DialectName, Fault};

/// Returns the first line of a program's output that is not blank.
pub(super) fn said(ended: &Ended) -> Option<String> {
    let lines = ended.stdout.lines().chain(ended.stderr.lines());
    lines
        .map(str::trim)
        .find(|line| !line.is_empty())
        .map(str::to_owned)
}

/// Creates a folder for a session of an engine.
///
/// # Errors
/// [`EngineError::NotStarted`] where the folder cannot be created.
pub(super) fn session_folder(engine: &Identity) -> Result<Folder, EngineError> {
    Folder::new().map_err(|reason| EngineError::NotStarted {
        engine: engine.name.clone(),
        reason,
    })
}

/// Returns the outcome of a request that an engine does not support.
pub(super) fn unsupported(reason: impl Into<String>) -> Outcome {
    Outcome::Unsupported {
        reason: reason.into(),
    }
}

/// Returns the outcome of a request in a dialect that an engine does not speak.
pub(super) fn speaks_not(dialect: DialectName) -> Outcome {
    unsupported(format!("it does not speak {dialect}"))
}

/// Returns the outcome of a program that stopped at a fault, with the values that are known of it.
pub(super) fn faulted(fault: Fault, values: Vec<NamedValue>) -> Outcome {
    Outcome::Faulted {
        fault,
        line: None,
        values,
        warnings: Vec::new(),
    }
}

/// Returns the outcome of an adapter that could not do its work.
pub(super) fn failed(message: String) -> Outcome {
    Outcome::Error { message }
}

/// Returns the numbers of the programs that must be run alone after a compiler did not finish `programs` programs together: all
/// of them where it took too long, since each smaller pack would take as long again, while alone only the program at fault
/// does. Otherwise none, since smaller packs show which program it was.
pub(super) fn suspects(outcome: &Outcome, programs: usize) -> BTreeSet<usize> {
    match outcome {
        Outcome::TimedOut { .. } => (0..programs).collect(),
        _ => BTreeSet::new(),
    }
}

/// Returns whether a line is one of a linker, which finds a name twice or not at all.
pub(super) fn is_of_linker(line: &str) -> bool {
    ["multiple definition of", "undefined reference to"]
        .iter()
        .any(|words| line.contains(words))
}

/// Returns the first line of the output of a C or C++ compiler that reports an error. What the linker found comes before the line
/// that only says that the linker failed.
pub(super) fn first_error(ended: &Ended) -> String {
    let mut lines = ended.stderr.lines();
    let error = lines
        .clone()
        .find(|line| is_of_linker(line))
        .or_else(|| lines.clone().find(|line| line.contains("error")));
    let line = error.or(lines.next()).unwrap_or("it does not say why");
    line.chars().filter(|character| !character.is_control()).collect()
}

/// Runs a compiler in a folder of a session, under the limits that every compiler gets.
///
/// # Errors
/// An outcome as [`run_tool`] returns.
pub(super) fn call<A: AsRef<OsStr>>(
    program: &Path,
    arguments: &[A],
    folder: &Folder,
) -> Result<Ended, Outcome> {
    run_tool(program, arguments, folder.path(), &ToolLimits::default())
}

/// The time limit for running a compiled program. Programs of cases and campaigns take milliseconds, so that a program which
/// still runs then has an endless loop.
pub(super) const EXECUTION_TIMEOUT: Duration = Duration::from_secs(10);

/// Returns the text without terminal control sequences: some compilers colour their output also where no terminal reads it.
pub(crate) fn without_colours(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_programs_of_a_pack_are_asked_about_alone_once_a_compiler_took_too_long_over_it() {
        let timed_out = Outcome::TimedOut { after_ms: 60_000 };
        assert_eq!(suspects(&timed_out, 3), BTreeSet::from([0, 1, 2]));
        let others = [
            Outcome::crashed("it wrote more than 16777216 bytes"),
            failed("it could not be started".to_owned()),
        ];
        for outcome in others {
            assert_eq!(suspects(&outcome, 3), BTreeSet::new(), "{outcome:?}");
        }
    }
}
