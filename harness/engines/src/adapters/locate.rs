//! Where a compiler's programs are: an environment variable says so, or PATH does.

use crate::process::{Ended, Folder, ToolLimits, run_tool};
use crate::{EngineError, Identity, Outcome, process};
use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A program on this machine: what the environment variable names, or else what PATH has under this name.
///
/// # Errors
/// A fragment that says what is missing and how to name it.
pub(super) fn program(name: &str, variable: &str) -> Result<PathBuf, String> {
    if let Some(told) = env::var_os(variable) {
        return existing(Path::new(&told), variable, Path::is_file);
    }
    on_path(name, env::var_os("PATH").as_deref())
        .ok_or_else(|| format!("there is no `{name}` on PATH; install it, or say by {variable} where it is"))
}

/// A folder that an environment variable names, or else the first of these that there is.
///
/// # Errors
/// As [`program`].
pub(super) fn folder(what: &str, variable: &str, candidates: &[PathBuf]) -> Result<PathBuf, String> {
    if let Some(told) = env::var_os(variable) {
        return existing(Path::new(&told), variable, Path::is_dir);
    }
    candidates
        .iter()
        .find(|folder| folder.is_dir())
        .cloned()
        .ok_or_else(|| format!("{what} was not found; say by {variable} where it is"))
}

fn existing(path: &Path, variable: &str, is: fn(&Path) -> bool) -> Result<PathBuf, String> {
    // The programs run in folders of their own, from which a relative path leads elsewhere.
    match path.canonicalize() {
        Ok(path) if is(&path) => Ok(path),
        _ => Err(format!(
            "{variable} names `{}`, which is not there",
            path.display()
        )),
    }
}

fn on_path(name: &str, path: Option<&OsStr>) -> Option<PathBuf> {
    let file = format!("{name}{}", env::consts::EXE_SUFFIX);
    env::split_paths(path?)
        .map(|folder| folder.join(&file))
        .find(|candidate| candidate.is_file())
        .and_then(|found| std::path::absolute(found).ok())
}

/// What a program says when it is asked for its version: its first line that is not blank.
///
/// # Errors
/// A fragment that says why it did not.
pub(super) fn version(program: &Path, arguments: &[&str], folder: &Folder) -> Result<String, String> {
    let ended = process::run_tool(program, arguments, folder.path(), &ToolLimits::default())
        .map_err(|outcome| format!("`{}` {}", program.display(), reason(&outcome)))?;
    said(&ended).ok_or_else(|| format!("`{}` does not say its version", program.display()))
}

fn said(ended: &Ended) -> Option<String> {
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
        Outcome::TimedOut { after_ms } => format!("did not end within {after_ms} ms"),
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
const EXECUTION: Duration = Duration::from_secs(10);

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_found_on_path_and_a_missing_one_named_with_its_variable() {
        let folder = Folder::new().unwrap();
        let file = format!("compiler{}", env::consts::EXE_SUFFIX);
        let there = folder.write(&file, "").unwrap();
        let path = env::join_paths([Path::new("/no/such/folder"), folder.path()]).unwrap();
        assert_eq!(on_path("compiler", Some(&path)), Some(there));
        assert_eq!(on_path("compiler", None), None);
        let error = program("no-such-compiler", "STICKLER_NO_SUCH_COMPILER").unwrap_err();
        assert!(
            error.contains("`no-such-compiler`") && error.contains("STICKLER_NO_SUCH_COMPILER"),
            "{error}"
        );
    }

    #[test]
    fn a_variable_that_leads_nowhere_is_told() {
        let error = existing(Path::new("/no/such/file"), "STICKLER_X", Path::is_file).unwrap_err();
        assert_eq!(error, "STICKLER_X names `/no/such/file`, which is not there");
    }

    #[test]
    fn a_folder_is_the_first_candidate_that_there_is() {
        let folder = Folder::new().unwrap();
        let there = folder.path().to_owned();
        let candidates = [PathBuf::from("/no/such/folder"), there.clone()];
        assert_eq!(
            super::folder("it", "STICKLER_NO_SUCH_FOLDER", &candidates),
            Ok(there)
        );
        assert!(super::folder("it", "STICKLER_NO_SUCH_FOLDER", &[]).is_err());
    }
}
