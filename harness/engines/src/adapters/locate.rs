//! Calls of a compiler's programs, and words about what came of them.

use crate::process::{Ended, Folder, ToolLimits, run_tool};
use crate::{EngineError, Identity, Outcome, process};
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::Path;
use std::time::Duration;

/// Returns what a program says when it is asked for its version: its first line that is not blank.
///
/// # Errors
/// A fragment that says why it did not.
pub(super) fn version(program: &Path, arguments: &[&str], folder: &Folder) -> Result<String, String> {
    let ended = process::run_tool(program, arguments, folder.path(), &ToolLimits::default())
        .map_err(|outcome| format!("`{}`: {outcome}", program.display()))?;
    said(&ended).ok_or_else(|| format!("`{}` does not say its version", program.display()))
}

/// The first line of what a program wrote that is not blank.
pub(super) fn said(ended: &Ended) -> Option<String> {
    let lines = ended.stdout.lines().chain(ended.stderr.lines());
    lines
        .map(str::trim)
        .find(|line| !line.is_empty())
        .map(str::to_owned)
}

/// A folder for a session of an engine.
///
/// # Errors
/// [`EngineError::NotStarted`] where none can be made.
pub(super) fn session_folder(engine: &Identity) -> Result<Folder, EngineError> {
    Folder::new().map_err(|reason| EngineError::NotStarted {
        engine: engine.name.clone(),
        reason,
    })
}

/// The outcome of an adapter that could not do its work.
pub(super) fn failed(message: String) -> Outcome {
    Outcome::Error { message }
}

/// Those of so many programs, by their numbers, that are to be asked about alone after a compiler did not come to an end of its
/// own over all of them: every one where it took too long, for smaller packs would each take as long again, and alone only
/// the one at fault does. Otherwise none, and smaller packs tell which it was.
pub(super) fn suspects(outcome: &Outcome, programs: usize) -> BTreeSet<usize> {
    match outcome {
        Outcome::TimedOut { .. } => (0..programs).collect(),
        _ => BTreeSet::new(),
    }
}

/// The first line of what a C or C++ compiler wrote that tells an error.
pub(super) fn first_error(ended: &Ended) -> String {
    let told = ended.stderr.lines().find(|line| line.contains("error"));
    let line = told
        .or(ended.stderr.lines().next())
        .unwrap_or("it does not say why");
    line.chars().filter(|character| !character.is_control()).collect()
}

/// Runs a compiler in a folder of a session, under the limits that every compiler gets.
///
/// # Errors
/// As [`run_tool`].
pub(super) fn call<A: AsRef<OsStr>>(
    program: &Path,
    arguments: &[A],
    folder: &Folder,
) -> Result<Ended, Outcome> {
    run_tool(program, arguments, folder.path(), &ToolLimits::default())
}

/// How long a program that was compiled may run. Those of cases and campaigns are done in milliseconds, so that one which is
/// still at work has a loop that does not end.
pub(super) const EXECUTION_TIMEOUT: Duration = Duration::from_secs(10);

/// Runs what was compiled, under the limits that every execution gets.
///
/// # Errors
/// As [`run_tool`].
pub(super) fn execute<A: AsRef<OsStr>>(
    program: &Path,
    arguments: &[A],
    folder: &Folder,
) -> Result<Ended, Outcome> {
    let limits = ToolLimits {
        time: EXECUTION_TIMEOUT,
        ..ToolLimits::default()
    };
    run_tool(program, arguments, folder.path(), &limits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_programs_of_a_pack_are_asked_about_alone_once_a_compiler_took_too_long_over_it() {
        let timed_out = Outcome::TimedOut { after_ms: 60_000 };
        assert_eq!(suspects(&timed_out, 3), BTreeSet::from([0, 1, 2]));
        let others = [
            Outcome::Crashed {
                reason: "it wrote more than 16777216 bytes".to_owned(),
            },
            failed("it could not be started".to_owned()),
        ];
        for outcome in others {
            assert_eq!(suspects(&outcome, 3), BTreeSet::new(), "{outcome:?}");
        }
    }
}
