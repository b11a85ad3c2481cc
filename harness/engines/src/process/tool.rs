//! Runs a program once, such as a compiler, within limits: its output, and how it ended.

mod output;

use super::child::last_lines;
use super::group::ProcessGroup;
use super::usage::Watch;
use super::{milliseconds, time_limit};
use crate::Outcome;
use output::{Streams, Waited};
use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// The time limit for a stream to end after its process has ended and all that it started was killed.
const EXIT_TIMEOUT: Duration = Duration::from_secs(1);

/// The interval at which a wait checks the process and its memory.
const POLL_INTERVAL: Duration = Duration::from_millis(100);

/// The limits of one run of a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct ToolLimits {
    /// The time for which the program may run.
    pub(crate) time: Duration,
    /// The processor time that the program and all that it starts may take; only checked on Linux.
    pub(crate) cpu: Duration,
    /// The number of bytes that the program may write to stdout, and to stderr.
    pub(crate) output: u64,
    /// The memory that the program and all that it starts may hold, in bytes; only checked on Linux.
    pub(crate) memory: u64,
}

impl Default for ToolLimits {
    /// Returns one minute, two of processor time, 16 MiB of output and 2 GiB of memory: many times what compilers of small
    /// programs take, also on a busy machine.
    fn default() -> ToolLimits {
        ToolLimits {
            time: Duration::from_secs(60),
            cpu: Duration::from_secs(120),
            output: 16 << 20,
            memory: 2 << 30,
        }
    }
}

/// A program that ended of its own accord, or by a signal that Stickler did not send.
#[derive(Debug)]
pub(crate) struct Ended {
    /// The exit status.
    pub(crate) status: ExitStatus,
    /// The whole of stdout, with invalid UTF-8 replaced.
    pub(crate) stdout: String,
    /// The whole of stderr, with invalid UTF-8 replaced.
    pub(crate) stderr: String,
}

impl Ended {
    /// Returns the exit code.
    ///
    /// # Errors
    /// [`Outcome::Crashed`] where a signal ended the program.
    pub(crate) fn code(&self) -> Result<i32, Outcome> {
        self.status.code().ok_or_else(|| self.crashed())
    }

    /// Tells whether the processor stopped the program at an integer division: by zero, or of the smallest integer by -1.
    #[cfg(unix)]
    pub(crate) fn stopped_by_arithmetic(&self) -> bool {
        use std::os::unix::process::ExitStatusExt;
        /// SIGFPE. Basis: posix: `signal.h` names it; Linux, macOS and the BSDs number it 8.
        const ARITHMETIC: i32 = 8;
        self.status.signal() == Some(ARITHMETIC)
    }

    /// Returns `false`: systems other than Unix do not tell such an end from any other.
    #[cfg(not(unix))]
    pub(crate) fn stopped_by_arithmetic(&self) -> bool {
        false
    }

    /// Returns the outcome that says how the program ended, with its last lines of output.
    pub(crate) fn crashed(&self) -> Outcome {
        let reason = format!("it ended ({})", self.status);
        with_last_words(Outcome::crashed(reason), &self.stdout, &self.stderr)
    }
}

/// Runs a program in a folder, without input, to its end.
///
/// # Errors
/// [`Outcome::TimedOut`] or [`Outcome::Crashed`] where the program exceeded a limit, after which it is killed with all that it
/// started; [`Outcome::Error`] where it cannot be started.
pub(crate) fn run<A: AsRef<OsStr>>(
    program: &Path,
    arguments: &[A],
    folder: &Path,
    limits: &ToolLimits,
) -> Result<Ended, Outcome> {
    run_with(program, arguments, folder, limits, |_| {})
}

/// Runs a program as [`run`] does, after `prepare` has changed its command.
///
/// # Errors
/// Fails as [`run`] does.
pub(crate) fn run_with<A: AsRef<OsStr>>(
    program: &Path,
    arguments: &[A],
    folder: &Path,
    limits: &ToolLimits,
    prepare: impl FnOnce(&mut Command),
) -> Result<Ended, Outcome> {
    let time = time_limit(limits.time);
    let limits = &ToolLimits {
        time,
        // Whoever allows more time allows a program to compute for as long, on two processors.
        cpu: if time > limits.time {
            limits.cpu.max(time * 2)
        } else {
            limits.cpu
        },
        ..*limits
    };
    let deadline = Instant::now() + time;
    let (mut group, pipes) = ProcessGroup::start(program.as_os_str(), |start| {
        start
            .args(arguments)
            .current_dir(folder)
            // Files that a killed program leaves behind are removed with the folder.
            .envs(["TMPDIR", "TEMP", "TMP"].map(|variable| (variable, folder)))
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        prepare(start);
    })
    .map_err(|reason| Outcome::Error {
        message: format!("`{}` could not be started: {reason}", program.display()),
    })?;
    let mut output = Streams::of(pipes, limits.output);
    let mut usage = Watch::new();
    let status = watch(&mut group, &mut output, &mut usage, deadline, limits)
        .and_then(|()| end(&mut group, &mut usage, deadline, limits))
        .map_err(|outcome| {
            let (stdout, stderr) = output.texts();
            with_last_words(outcome, &stdout, &stderr)
        })?;
    let (stdout, stderr) = output.texts();
    Ok(Ended {
        status,
        stdout,
        stderr,
    })
}

/// Waits for the end of both streams, and checks the limits of the process meanwhile.
fn watch(
    group: &mut ProcessGroup,
    output: &mut Streams,
    usage: &mut Watch,
    deadline: Instant,
    limits: &ToolLimits,
) -> Result<(), Outcome> {
    let mut orphaned = None;
    while output.are_open() {
        let left = deadline.saturating_duration_since(Instant::now());
        match output.wait(left.min(POLL_INTERVAL)) {
            Waited::Ended => {}
            Waited::Flooded => return Err(flooded(limits)),
            Waited::InVain if group.has_ended() => match orphaned {
                // Processes that the program started hold its output open: once they are gone the streams end.
                None => {
                    orphaned = Some(Instant::now());
                    group.kill();
                }
                // A process that left the group is not waited for.
                Some(since) if since.elapsed() > EXIT_TIMEOUT => return Ok(()),
                Some(_) => {}
            },
            Waited::InVain if left > POLL_INTERVAL => within(group, usage, limits)?,
            Waited::InVain => return Err(timed_out(limits)),
        }
    }
    Ok(())
}

/// Adds the last lines of stderr to a crash, or those of stdout where stderr is empty.
fn with_last_words(outcome: Outcome, stdout: &str, stderr: &str) -> Outcome {
    let mut texts = [stderr, stdout].map(last_lines).into_iter();
    match (outcome, texts.find(|words| !words.is_empty())) {
        (Outcome::Crashed { reason }, Some(words)) => {
            Outcome::crashed(format!("{reason}; its last words: {words}"))
        }
        (outcome, _) => outcome,
    }
}

fn timed_out(limits: &ToolLimits) -> Outcome {
    Outcome::TimedOut {
        after_ms: milliseconds(limits.time),
    }
}

fn flooded(limits: &ToolLimits) -> Outcome {
    Outcome::crashed(format!("it wrote more than {} bytes", limits.output))
}

fn within(group: &ProcessGroup, usage: &mut Watch, limits: &ToolLimits) -> Result<(), Outcome> {
    let crashed = |reason: String| Err(Outcome::Crashed { reason });
    match usage.measure(group.number()) {
        Some(usage) if usage.memory > limits.memory => {
            crashed(format!("it held more than {} MiB of memory", limits.memory >> 20))
        }
        Some(usage) if usage.cpu > limits.cpu => crashed(format!(
            "it took more than {} seconds of processor time",
            limits.cpu.as_secs_f64()
        )),
        _ => Ok(()),
    }
}

/// Waits for the end of a process that has closed its output, and checks its limits meanwhile.
fn end(
    group: &mut ProcessGroup,
    usage: &mut Watch,
    deadline: Instant,
    limits: &ToolLimits,
) -> Result<ExitStatus, Outcome> {
    loop {
        let next = deadline.min(Instant::now() + POLL_INTERVAL);
        if let Some(status) = group.wait_until(next) {
            return Ok(status);
        }
        if next == deadline {
            return Err(timed_out(limits));
        }
        within(group, usage, limits)?;
    }
}

#[cfg(all(test, unix))]
mod tests;
