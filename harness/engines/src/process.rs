//! A compiler behind an adapter: a process that speaks the wire protocol on its stdin and stdout.
//!
//! Nothing that such a process does harms a run: when it dies, hangs, floods its output or answers nonsense, the request at
//! hand gets an outcome that says so, the process is killed with all that it started, and the next request starts a fresh one.
//! Basis: harness/engines/README.md (what happens when an adapter breaks the rules).

mod child;
mod command_line;
mod connection;
mod folder;
mod greeting;
mod group;
mod message;
mod session;
mod tool;
mod usage;

use crate::reproduction::HERE;
use crate::{Ability, Engine, EngineError, Identity, NoReproduction, Reproduction, RunRequest, Session};
pub(crate) use command_line::CommandLine;
pub(crate) use connection::{Connection, Failure};
pub(crate) use folder::Folder;
pub(crate) use message::{excerpt, line};
use session::ProcessSession;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
pub(crate) use tool::{Ended, ToolLimits, run as run_tool, run_with as run_tool_with};

/// Kills every process that an engine of this program has started, with all that they started, and removes their working
/// folders. Meant for a program that is about to end without ending its sessions, as at Ctrl-C: the processes have groups of
/// their own, so that nothing else ends them.
///
/// The caller must end the program: a thread that works with a process never returns from it afterwards.
pub fn kill_all_processes() {
    group::kill_all();
    folder::remove_all();
}

/// Kills every process that an engine of this program has started, with all that they started, and prevents the start of any
/// other. Meant for a run that stops: later answers of its engines say nothing about the engines, and must be ignored. Unlike
/// [`kill_all_processes`] this lets threads go on, so that sessions remove their folders and reports are completed.
pub fn stop_all_processes() {
    group::stop_all();
}

/// The limits of an engine in a process of its own: time, line length and memory.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProcessLimits {
    /// The time limit from the start of the process to its answer to `hello`.
    pub hello: Duration,
    /// The time limit for one answer.
    pub reply: Duration,
    /// The longest line that the process may answer, in bytes.
    pub line: usize,
    /// The memory that the process and all that it starts may hold, in bytes; only checked on Linux.
    pub memory: u64,
}

impl Default for ProcessLimits {
    /// Returns one minute for `hello` and for each reply, since compilers of big programs take seconds; lines of at most
    /// [`MAX_LINE`](crate::protocol::MAX_LINE) bytes, and 4 GiB of memory.
    fn default() -> ProcessLimits {
        ProcessLimits {
            hello: Duration::from_secs(60),
            reply: Duration::from_secs(60),
            line: crate::protocol::MAX_LINE,
            memory: connection::DEFAULT_MAX_MEMORY,
        }
    }
}

/// An engine in a process of its own, one process for each session.
pub struct ProcessEngine {
    identity: Identity,
    command: CommandLine,
    limits: ProcessLimits,
    /// The process that answered the first `hello`; the first session takes it.
    spare: Mutex<Option<Connection>>,
    /// The command by which a person runs a program on the compiler, and the folder of the file that states it.
    reproduced_by: Option<(String, PathBuf)>,
}

impl ProcessEngine {
    /// Starts the process of a command line, such as `stickler engine` or `my-adapter --compiler 'C:\my tools\st'`, and
    /// asks who it is. The line is split as a POSIX shell splits it, but no shell takes part: nothing is expanded.
    ///
    /// # Errors
    /// [`EngineError`] where the line cannot be split, nothing can be started, or `hello` is not answered as the
    /// protocol has it, with the end of what the process wrote to stderr.
    pub fn start(command_line: &str, limits: ProcessLimits) -> Result<ProcessEngine, EngineError> {
        ProcessEngine::of(CommandLine::split(command_line)?, limits)
    }

    /// Starts the process of a command line in a folder, from which a program with a path is sought.
    ///
    /// # Errors
    /// Fails as [`ProcessEngine::start`] does.
    pub fn start_in(
        folder: &Path,
        command_line: &str,
        limits: ProcessLimits,
    ) -> Result<ProcessEngine, EngineError> {
        ProcessEngine::of(CommandLine::split(command_line)?.inside(folder), limits)
    }

    fn of(command: CommandLine, limits: ProcessLimits) -> Result<ProcessEngine, EngineError> {
        let (connection, identity) = command.greet(&limits)?;
        Ok(ProcessEngine {
            identity,
            command,
            limits,
            spare: Mutex::new(Some(connection)),
            reproduced_by: None,
        })
    }

    /// Returns the engine under another name, for a run in which two engines would otherwise have the same name.
    pub fn named(mut self, name: String) -> ProcessEngine {
        self.identity.name = name;
        self
    }

    /// Returns the engine with the [command](Reproduction::by_command) by which a person runs a program on its compiler, and the folder of the
    /// file that states it.
    pub fn reproduced_by(mut self, command: &str, folder: &Path) -> ProcessEngine {
        self.reproduced_by = Some((command.to_owned(), folder.to_owned()));
        self
    }
}

impl Engine for ProcessEngine {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn reproduce(&self, request: &RunRequest<'_>, _: Ability) -> Result<Reproduction, NoReproduction> {
        match &self.reproduced_by {
            Some((command, _)) => Ok(Reproduction::by_command(command, request)),
            None => Err(NoReproduction::NoTools(self.identity.name.clone())),
        }
    }

    fn tools(&self) -> Vec<(String, PathBuf)> {
        let here = self.reproduced_by.iter();
        here.map(|(_, folder)| (HERE.to_owned(), folder.clone()))
            .collect()
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).take();
        let connection = match spare {
            Some(connection) => connection,
            None => self.command.greet(&self.limits)?.0,
        };
        Ok(Box::new(ProcessSession::new(
            &self.command,
            &self.limits,
            &self.identity,
            connection,
        )))
    }
}

/// The time limit of every program in milliseconds; 0 where each has that of its adapter.
static TIMEOUT: AtomicU64 = AtomicU64::new(0);

/// The time at which every question ends, and the time that each may take.
static END: Mutex<Option<(Instant, Duration)>> = Mutex::new(None);

/// Sets the time for which any program that an engine starts may run, and for which any answer may take, in place of what adapters
/// and descriptions say.
pub fn limit_programs(time: Duration) {
    TIMEOUT.store(milliseconds(time), Ordering::Relaxed);
}

/// Ends every question to an engine at this time, the one that is being answered then, too, and each after so long; `None` lifts that. What
/// ends so is [timed out](crate::Outcome::TimedOut).
pub fn end_questions_at(end: Option<(Instant, Duration)>) {
    *END.lock().unwrap_or_else(PoisonError::into_inner) = end;
}

/// Returns the time that a program may take from now on, of which its adapter says `usual`.
pub(crate) fn time_limit(usual: Duration) -> Duration {
    let timeout = match TIMEOUT.load(Ordering::Relaxed) {
        0 => None,
        milliseconds => Some(Duration::from_millis(milliseconds)),
    };
    let end = *END.lock().unwrap_or_else(PoisonError::into_inner);
    let left = end.map(|(end, each)| end.saturating_duration_since(Instant::now()).min(each));
    shortest(usual, timeout, left)
}

/// Returns the limit by a usual one, by another that replaces it, and by the time that is left until an end.
fn shortest(usual: Duration, timeout: Option<Duration>, left: Option<Duration>) -> Duration {
    let limit = timeout.unwrap_or(usual);
    left.map_or(limit, |left| limit.min(left))
}

/// Returns a time in whole milliseconds.
pub(crate) fn milliseconds(time: Duration) -> u64 {
    u64::try_from(time.as_millis()).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_for_every_program_replaces_the_usual_one_and_none_goes_beyond_the_end() {
        let [usual, short, long] = [60, 5, 600].map(Duration::from_secs);
        assert_eq!(shortest(usual, None, None), usual);
        assert_eq!(shortest(usual, Some(long), None), long);
        assert_eq!(shortest(usual, Some(long), Some(short)), short);
        assert_eq!(shortest(usual, None, Some(Duration::ZERO)), Duration::ZERO);
    }
}
