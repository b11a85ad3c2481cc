//! The exit codes of `stickler`: one list for the code and the help text; a test checks the manual against it.

use std::process::ExitCode;
use stickler_campaign::CampaignError;
use stickler_conversions::sweep::foreign::ForeignError;
use stickler_engines::EngineError;
use stickler_run::{RunError, Totals, Verdict};

/// The exit codes of the commands.
///
/// Where several apply, [`Exit::worst`] decides: an error that kept a command from its work outranks the findings of the
/// work, so that a pipeline never takes a half-read suite for a verdict on a compiler.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Exit {
    /// All results are as expected.
    AsExpected,
    /// A result of an engine is not as expected, or an entry of its baseline is out of date; `check`, `eval` and `render`: the
    /// program is rejected or faults;
    /// `matrix`: a cell differs; `conversions`: a value contradicts a document; `lint`: a finding;
    /// `engine --validate`: the adapter follows the protocol, but its compiler is wrong.
    Failures,
    /// The command line, a case file, or a named file or folder cannot be used.
    Usage,
    /// An engine could not be run at all; `engines`: a named engine cannot be run; `engine --validate`: the adapter is broken.
    EngineNotRun,
    /// The filters select no case, or the engines support none of the selected cases; `fuzz`: no program was judged.
    NothingTested,
    /// The command was stopped by Ctrl-C; the event log lacks its footer.
    Interrupted,
}

impl Exit {
    /// Every exit code, in the order of their numbers.
    pub const ALL: [Exit; 6] = [
        Exit::AsExpected,
        Exit::Failures,
        Exit::Usage,
        Exit::EngineNotRun,
        Exit::NothingTested,
        Exit::Interrupted,
    ];

    /// Returns the number with which the process ends.
    pub const fn number(self) -> u8 {
        self.row().0
    }

    /// Returns the explanation in one line, for the help text.
    pub const fn meaning(self) -> &'static str {
        self.row().2
    }

    /// Returns the one of two exit codes that the process reports: 130 over 3 over 2 over 4 over 1 over 0.
    pub fn worst(self, other: Exit) -> Exit {
        if self.row().1 >= other.row().1 {
            self
        } else {
            other
        }
    }

    /// Returns the exit code where something holds, and otherwise that all is as expected.
    pub const fn when(self, holds: bool) -> Exit {
        if holds { self } else { Exit::AsExpected }
    }

    /// Returns the number of the exit code, its rank among several, and its meaning.
    ///
    /// Basis: harness/docs/testing-a-compiler.md (exit codes); 130 is what shells give a process that SIGINT ended.
    const fn row(self) -> (u8, u8, &'static str) {
        match self {
            Exit::AsExpected => (0, 0, "all is as expected"),
            Exit::Failures => (
                1,
                1,
                "conformance failures (check, eval, render: the program is rejected or faults)",
            ),
            Exit::Usage => (
                2,
                3,
                "wrong usage, a broken case file, or a file or folder that cannot be used",
            ),
            Exit::EngineNotRun => (3, 4, "an engine could not be run"),
            Exit::NothingTested => (
                4,
                2,
                "no case selected, or none that the engine supports; fuzz: no program was judged",
            ),
            Exit::Interrupted => (130, 5, "stopped by Ctrl-C"),
        }
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
    let line = |exit: Exit| format!("  {:>3}  {}\n", exit.number(), exit.meaning());
    let lines = Exit::ALL.map(line).concat();
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
        assert_eq!(Exit::Failures.worst(Exit::Usage), Exit::Usage);
        assert_eq!(Exit::Usage.worst(Exit::Failures), Exit::Usage);
        assert_eq!(Exit::NothingTested.worst(Exit::Usage), Exit::Usage);
        assert_eq!(Exit::EngineNotRun.worst(Exit::Interrupted), Exit::Interrupted);
        assert_eq!(Exit::AsExpected.worst(Exit::Failures), Exit::Failures);
    }

    #[test]
    fn the_manual_has_the_same_list() {
        let manual = include_str!("../../docs/testing-a-compiler.md");
        for exit in Exit::ALL {
            let row = format!("\n| {} | {} |\n", exit.number(), exit.meaning());
            assert!(manual.contains(&row), "{row}");
        }
    }
}
