//! A compiler behind an adapter: a process that speaks the wire protocol on its stdin and stdout.
//!
//! Nothing that such a process does harms a run: when it dies, hangs, floods its output or answers nonsense, the
//! request at hand gets an outcome that says so, the process is killed with all that it started, and the next request
//! meets a fresh one. Basis: design, sections 2 (crash is not reject) and 4.

mod child;
mod command_line;
mod connection;
mod folder;
mod greeting;
mod group;
mod message;
mod pause;
mod session;
mod tool;
mod usage;

use crate::{Engine, EngineError, Identity, Session};
pub(crate) use command_line::CommandLine;
pub(crate) use connection::{Connection, Failure};
pub(crate) use folder::Folder;
pub(crate) use message::excerpt;
use session::ProcessSession;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;
pub(crate) use tool::{Ended, ToolLimits, run as run_tool, run_with as run_tool_with};

/// Kills every process that an engine of this program has started, with all that they started, and removes the folders
/// in which they worked. For a program that is about to end without ending its sessions, as at Ctrl-C: the processes
/// have groups of their own, and so nobody else ends them.
///
/// Whoever calls it must end the program: a thread that works with a process does not return from it any more.
pub fn kill_all_processes() {
    group::kill_all();
    folder::remove_all();
}

/// Kills every process that an engine of this program has started, with all that they started, and lets no other start. For
/// a run that stops: what its engines answer from now on says nothing of them, and is to be passed over. Unlike
/// [`kill_all_processes`] this lets everything go on, so that sessions remove their folders and reports are completed.
pub fn stop_all_processes() {
    group::stop_all();
}

/// What an engine in a process of its own may take and give.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProcessLimits {
    /// How long it may take from its start to the answer to `hello`.
    pub hello: Duration,
    /// How long it may take for one answer.
    pub reply: Duration,
    /// The longest line that it may answer, in bytes.
    pub line: usize,
    /// How much memory it and all that it starts may hold, in bytes; only looked after on Linux.
    pub memory: u64,
}

impl Default for ProcessLimits {
    /// One minute for `hello` and for each reply, since compilers of big programs take seconds; the longest line is
    /// [`MAX_LINE`](crate::protocol::MAX_LINE) bytes, and its memory 4 GiB.
    fn default() -> ProcessLimits {
        ProcessLimits {
            hello: Duration::from_secs(60),
            reply: Duration::from_secs(60),
            line: crate::protocol::MAX_LINE,
            memory: connection::DEFAULT_MAX_MEMORY,
        }
    }
}

/// An engine that is a process, one for each session.
pub struct ProcessEngine {
    identity: Identity,
    command: CommandLine,
    limits: ProcessLimits,
    /// The process that answered the first `hello`; the first session takes it.
    spare: Mutex<Option<Connection>>,
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
    /// As [`ProcessEngine::start`].
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
        })
    }

    /// Gives the engine another name, for a run in which two would otherwise be called the same.
    #[must_use]
    pub fn named(mut self, name: String) -> ProcessEngine {
        self.identity.name = name;
        self
    }
}

impl Engine for ProcessEngine {
    fn identity(&self) -> &Identity {
        &self.identity
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
