//! A group of processes: the start of its leader, its end, and the end of all groups at once.

use process_wrap::std::{ChildWrapper, CommandWrap};
use std::ffi::OsStr;
use std::process::{ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, RwLock, RwLockReadGuard, Weak};
use std::time::{Duration, Instant};
use std::{io, thread};

/// A process with all that belongs to it. A thread that waits for its end holds the lock only while it checks.
type SharedProcess = Mutex<Box<dyn ChildWrapper>>;

/// Every process that was started and has not been let go.
static ALIVE: Mutex<Vec<Weak<SharedProcess>>> = Mutex::new(Vec::new());

/// The state of the program's end. A thread that starts a process holds this until the process is among [`ALIVE`], so that
/// [`kill_all`] misses none.
static ENDING: RwLock<Ending> = RwLock::new(Ending::No);

/// Whether processes may still be started. Later variants are further steps towards the end of the program; the state never
/// goes back.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Ending {
    No,
    /// No process is started any more.
    Processes,
    /// The program itself ends.
    Program,
}

/// Kills every process that an engine of this program has started, with all that they started; none starts after it.
pub(super) fn stop_all() {
    end(Ending::Processes);
}

/// Kills every process that an engine of this program has started, with all that they started. Meant for a program that is
/// about to end without ending its sessions, as at Ctrl-C: the processes have groups of their own, so that nothing else ends
/// them. No process starts afterwards, and no thread that works with one goes on: it would take the death of its engine for a
/// crash of the engine's own, report it, and start the next one.
pub(super) fn kill_all() {
    end(Ending::Program);
}

fn end(what: Ending) {
    let mut ending = ENDING.write().unwrap_or_else(PoisonError::into_inner);
    *ending = what.max(*ending);
    drop(ending);
    let alive = std::mem::take(&mut *lock(&ALIVE));
    for process in alive.iter().filter_map(Weak::upgrade) {
        // A process that has ended already is what is wanted.
        let _ = lock(&process).start_kill();
    }
}

/// Delays the end of the program for as long as the returned guard is kept; never returns where the end has begun.
fn goes_on() -> RwLockReadGuard<'static, Ending> {
    let ending = ENDING.read().unwrap_or_else(PoisonError::into_inner);
    if *ending == Ending::Program {
        drop(ending);
        loop {
            thread::park();
        }
    }
    ending
}

/// Locks a mutex, also where a thread panicked while it held the lock: no value here is left half changed.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The longest pause between two checks of a process.
const MAX_PAUSE: Duration = Duration::from_millis(16);

/// A running process with all that it starts. Dropping it kills them all.
pub(super) struct ProcessGroup {
    wrapped: Arc<SharedProcess>,
    /// Whether the group was killed already, after which its number may belong to another.
    killed: bool,
}

/// The parent's ends of a process's pipes; `None` where none was asked for.
pub(super) struct Pipes {
    pub(super) stdin: Option<ChildStdin>,
    pub(super) stdout: Option<ChildStdout>,
    pub(super) stderr: Option<ChildStderr>,
}

impl ProcessGroup {
    /// Starts a process as the leader of a group (on Windows: in a job) of its own.
    ///
    /// # Errors
    /// A fragment that says why the process could not be started.
    pub(super) fn start(
        program: &OsStr,
        prepare: impl FnOnce(&mut Command),
    ) -> Result<(ProcessGroup, Pipes), String> {
        let ending = goes_on();
        if *ending == Ending::Processes {
            return Err("the run stops".to_owned());
        }
        let mut wrap = CommandWrap::with_new(program, |command| {
            // What a compiler says when it dies does not depend on the environment of the run.
            command.env_remove("RUST_BACKTRACE");
            prepare(command);
        });
        #[cfg(unix)]
        wrap.wrap(process_wrap::std::ProcessGroup::leader());
        #[cfg(windows)]
        wrap.wrap(process_wrap::std::JobObject);
        let mut wrapped = wrap.spawn().map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => format!("there is no program `{}`", program.display()),
            _ => error.to_string(),
        })?;
        let pipes = Pipes {
            stdin: wrapped.stdin().take(),
            stdout: wrapped.stdout().take(),
            stderr: wrapped.stderr().take(),
        };
        let wrapped = Arc::new(Mutex::new(wrapped));
        let mut alive = lock(&ALIVE);
        alive.retain(|process| process.strong_count() > 0);
        alive.push(Arc::downgrade(&wrapped));
        drop(alive);
        drop(ending);
        let group = ProcessGroup {
            wrapped,
            killed: false,
        };
        Ok((group, pipes))
    }

    /// Returns the number of the process, which is that of its group as well.
    pub(super) fn number(&self) -> u32 {
        lock(&self.wrapped).id()
    }

    /// Tells whether the process itself has ended; processes that it started may still hold its output open.
    pub(super) fn has_ended(&mut self) -> bool {
        matches!(lock(&self.wrapped).try_wait(), Ok(Some(_)))
    }

    /// Waits until the process itself has ended; `None` where it is still running at the deadline.
    pub(super) fn wait_until(&mut self, deadline: Instant) -> Option<ExitStatus> {
        let mut pause = Duration::from_micros(100);
        loop {
            let ended = lock(&self.wrapped).try_wait();
            match ended {
                Ok(Some(status)) => {
                    drop(goes_on());
                    return Some(status);
                }
                Ok(None) if Instant::now() < deadline => {}
                Ok(None) | Err(_) => return None,
            }
            thread::sleep(pause.min(deadline.saturating_duration_since(Instant::now())));
            pause = MAX_PAUSE.min(pause * 2);
        }
    }

    /// Kills what is left of the group.
    pub(super) fn kill(&mut self) {
        drop(goes_on());
        if std::mem::replace(&mut self.killed, true) {
            return;
        }
        // The group may be gone already, and then there is nothing left to do. What the process started lives on after
        // its own end, so a signal goes to the group in any case.
        let mut wrapped = lock(&self.wrapped);
        let _ = wrapped.start_kill();
        let _ = wrapped.wait();
    }
}

impl Drop for ProcessGroup {
    fn drop(&mut self) {
        self.kill();
    }
}
