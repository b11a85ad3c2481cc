//! The exit codes of `stickler`: one list for the code and the help text; a test checks the manual against it.

use std::process::ExitCode;
use stickler_campaign::CampaignError;
use stickler_conversions::sweep::foreign::ForeignError;
use stickler_engines::EngineError;
use stickler_run::{RunError, Totals, Verdict};

/// The exit codes of the commands, in the order in which they outrank each other.
///
/// Where several apply, the greatest is reported: an error that kept a command from its work outranks the findings of the
/// work, so that a pipeline never takes a half-read suite for a verdict on a compiler.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Exit {
    /// All results are as expected.
    AsExpected,
    /// A result of an engine is not as expected, or an entry of its baseline is out of date; `check`, `eval` and `render`: the
    /// program is rejected or faults;
    /// `matrix`: a cell differs; `conversions`: a value contradicts a document; `lint`: a finding;
    /// `engine --validate`: the adapter follows the protocol, but its compiler is wrong.
    Failures,
    /// The filters select no case, or the engines support none of the selected cases; `fuzz`: no program was judged.
    NothingTested,
    /// The command line, a case file, or a named file or folder cannot be used.
    Usage,
    /// An engine could not be run at all; `engines`: a named engine cannot be run; `engine --validate`: the adapter is broken.
    EngineNotRun,
    /// The command was stopped by Ctrl-C; the event log lacks its footer.
    Interrupted,
}

/// The number with which the process ends, and the meaning in one line, of each exit code in the order of [`Exit`].
///
/// Basis: harness/docs/testing-a-compiler.md (exit codes); 130 is what shells give a process that SIGINT ended.
const CODES: [(u8, &str); 6] = [
    (0, "all is as expected"),
    (
        1,
        "conformance failures (check, eval, render: the program is rejected or faults)",
    ),
    (
        4,
        "no case selected, or none that the engine supports; fuzz: no program was judged",
    ),
    (
        2,
        "wrong usage, a broken case file, or a file or folder that cannot be used",
    ),
    (3, "an engine could not be run"),
    (130, "stopped by Ctrl-C"),
];

impl Exit {
    /// Returns the number with which the process ends.
    pub const fn number(self) -> u8 {
        CODES[self as usize].0
    }

    /// Returns the exit code where something holds, and otherwise that all is as expected.
    pub const fn when(self, holds: bool) -> Exit {
        if holds { self } else { Exit::AsExpected }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> ExitCode {
        ExitCode::from(exit.number())
    }
}

/// Returns the exit code of a run from the totals of its verdicts, and from whether something else fails it: an entry of a baseline that is
/// out of date, or a promised feature that is lacking.
pub fn of_totals(totals: &Totals, fails: bool) -> Exit {
    if totals.unexpected() > 0 || fails {
        return Exit::Failures;
    }
    // The last line of the page reports that too. A pipeline must not take such a run for that of a conforming compiler.
    if totals.of(Verdict::Unsupported) + totals.of(Verdict::Waiting) == totals.all() {
        return Exit::NothingTested;
    }
    Exit::AsExpected
}

/// Returns the exit code of an error that ended a command.
///
/// Any error without an exit code of its own gives [`Exit::Usage`]: a file that cannot be read, a folder that cannot be written.
pub fn of_error(error: &anyhow::Error) -> Exit {
    match error.downcast_ref::<RunError>() {
        Some(RunError::NoCaseSelected) => Exit::NothingTested,
        Some(RunError::Engine(_) | RunError::RejectsAll { .. } | RunError::Workers(_)) => Exit::EngineNotRun,
        None if error.is::<NoSuchEngine>() || error.is::<SpeaksNone>() => Exit::EngineNotRun,
        None if error.is::<EngineError>() || error.is::<CampaignError>() => Exit::EngineNotRun,
        None if error.is::<ForeignError>() => Exit::EngineNotRun,
        None => Exit::Usage,
    }
}

/// The error for a name that no engine has.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error(
    "there is no engine `{name}`{}; there are {known}, and there is `cmd:COMMAND LINE` for any program that speaks the wire \
     protocol, such as `cmd:stickler engine`; stickler.toml can name others",
    meant.as_ref().map(|meant| format!("; did you mean `{meant}`?")).unwrap_or_default()
)]
pub struct NoSuchEngine {
    /// The unknown name.
    pub name: String,
    /// The most similar name of an engine, if any is similar.
    pub meant: Option<String>,
    /// The names of all engines, in a list.
    pub known: String,
}

/// The error for an engine that speaks none of the requested dialects.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("engine {engine} speaks none of {asked}; it says that it speaks: {spoken}{hint}")]
pub struct SpeaksNone {
    /// The name of the engine.
    pub engine: String,
    /// The requested dialects, in a list.
    pub asked: String,
    /// The dialects that the engine speaks, in a list.
    pub spoken: String,
    /// The words behind the list of dialects that tell how to ask for them, with their comma; empty where nothing has to be asked.
    pub hint: String,
}

/// Returns the list of exit codes that `--help` shows.
pub fn listing() -> String {
    let mut codes = CODES;
    codes.sort_unstable();
    let lines = codes.map(|(number, meaning)| format!("  {number:>3}  {meaning}\n"));
    let lines = lines.concat();
    format!("Exit codes:\n{lines}Where several apply: 130 over 3 over 2 over 4 over 1.")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_engine_that_cannot_be_started_has_one_exit_code_whichever_command_needs_it() {
        let not_started = || EngineError::NotStarted {
            engine: "none".to_owned(),
            reason: "it is not here".to_owned(),
        };
        let errors: [anyhow::Error; 4] = [
            not_started().into(),
            RunError::from(not_started()).into(),
            CampaignError::from(not_started()).into(),
            ForeignError::from(not_started()).into(),
        ];
        assert!(errors.iter().all(|error| of_error(error) == Exit::EngineNotRun));
    }

    #[test]
    fn what_kept_a_command_from_its_work_outranks_what_the_work_found() {
        let findings = [Exit::AsExpected, Exit::Failures, Exit::NothingTested];
        let obstacles = [Exit::Usage, Exit::EngineNotRun, Exit::Interrupted];
        assert!([findings, obstacles].concat().is_sorted());
        assert_eq!(findings.map(Exit::number), [0, 1, 4]);
        assert_eq!(obstacles.map(Exit::number), [2, 3, 130]);
    }

    #[test]
    fn the_manual_has_the_same_list() {
        let manual = include_str!("../../docs/testing-a-compiler.md");
        for (number, meaning) in CODES {
            let row = format!("\n| {number} | {meaning} |\n");
            assert!(manual.contains(&row), "{row}");
        }
    }
}
