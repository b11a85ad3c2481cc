//! Calls of a compiler's programs, and words about what came of them.

use crate::process::{Ended, Folder, ToolLimits, run_tool};
use crate::{EngineError, Identity, Outcome, process};
use std::ffi::OsStr;
use std::path::Path;
use std::time::Duration;

/// What a program says when it is asked for its version: its first line that is not blank.
///
/// # Errors
/// A fragment that says why it did not.
pub(super) fn version(program: &Path, arguments: &[&str], folder: &Folder) -> Result<String, String> {
    let ended = process::run_tool(program, arguments, folder.path(), &ToolLimits::default())
        .map_err(|outcome| format!("`{}` {}", program.display(), reason(&outcome)))?;
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

/// Why a program did not do what it was started for; a fragment.
pub(super) fn reason(outcome: &Outcome) -> String {
    match outcome {
        Outcome::TimedOut { after_ms } => format!("did not end within {}", Outcome::limit(*after_ms)),
        Outcome::Crashed { reason } => format!("crashed: {reason}"),
        Outcome::Error { message } => message.clone(),
        other => format!("answered {other:?}"),
    }
}

/// Why a compiler did not accept a program; a fragment.
pub(super) fn told(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Rejected { diagnostics } => {
            let first = diagnostics.first().map(|first| first.message.as_str());
            first.unwrap_or("it does not say why").to_owned()
        }
        Outcome::Unsupported { reason } => reason.clone(),
        other => reason(other),
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
pub(super) const EXECUTION: Duration = Duration::from_secs(10);

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
        time: EXECUTION,
        ..ToolLimits::default()
    };
    run_tool(program, arguments, folder.path(), &limits)
}
