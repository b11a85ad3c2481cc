//! A program that is run once, such as a compiler: what it wrote, how it ended, and what it may take.

use super::child::told;
use super::group::{Group, Pipes};
use super::usage;
use crate::Outcome;
use std::ffi::OsStr;
use std::io::Read;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

/// How often somebody who waits looks after the process and its memory.
const LOOK: Duration = Duration::from_millis(100);

/// What one run of a program may take.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct ToolLimits {
    /// How long it may run.
    pub(crate) time: Duration,
    /// How much processor time it and all that it starts may take; only looked after on Linux.
    pub(crate) cpu: Duration,
    /// How much it may write to stdout, and to stderr, in bytes.
    pub(crate) output: u64,
    /// How much memory it and all that it starts may hold, in bytes; only looked after on Linux.
    pub(crate) memory: u64,
}

impl Default for ToolLimits {
    /// One minute, two of processor time, 16 MiB of output and 2 GiB of memory: many times what compilers of small programs
    /// take, also on a busy machine.
    fn default() -> ToolLimits {
        ToolLimits {
            time: Duration::from_secs(60),
            cpu: Duration::from_secs(120),
            output: 16 << 20,
            memory: 2 << 30,
        }
    }
}

/// What a program left behind that ended of its own accord, or by a signal that is none of ours.
#[derive(Debug)]
pub(crate) struct Ended {
    /// How it ended.
    pub(crate) status: ExitStatus,
    /// All that it wrote to stdout, with what is no UTF-8 replaced.
    pub(crate) stdout: String,
    /// The same of stderr.
    pub(crate) stderr: String,
}

impl Ended {
    /// Its exit code.
    ///
    /// # Errors
    /// [`Outcome::Crashed`] where a signal ended it.
    pub(crate) fn code(&self) -> Result<i32, Outcome> {
        self.status.code().ok_or_else(|| self.crashed())
    }

    /// Whether the processor ended it at an integer division: by zero, or of the smallest integer by -1.
    #[cfg(unix)]
    pub(crate) fn stopped_by_arithmetic(&self) -> bool {
        use std::os::unix::process::ExitStatusExt;
        /// SIGFPE. Basis: posix: `signal.h` names it; Linux, macOS and the BSDs number it 8.
        const ARITHMETIC: i32 = 8;
        self.status.signal() == Some(ARITHMETIC)
    }

    /// Elsewhere such an end looks like any other.
    #[cfg(not(unix))]
    pub(crate) fn stopped_by_arithmetic(&self) -> bool {
        false
    }

    /// The outcome that says how it ended and what it said last.
    pub(crate) fn crashed(&self) -> Outcome {
        let words = match told(&self.stderr) {
            words if words.is_empty() => told(&self.stdout),
            words => words,
        };
        let reason = match words.as_str() {
            "" => format!("it ended ({})", self.status),
            words => format!("it ended ({}); its last words: {words}", self.status),
        };
        Outcome::Crashed { reason }
    }
}

/// Which stream, what came from it, and whether that is all: no more is kept than is allowed.
type StreamEnd = (Stream, String, bool);

/// What came from both streams; `None` where one has not ended.
#[derive(Default)]
struct Gathered {
    stdout: Option<String>,
    stderr: Option<String>,
}

impl Gathered {
    fn is_whole(&self) -> bool {
        self.stdout.is_some() && self.stderr.is_some()
    }

    fn keep(&mut self, stream: Stream, text: String) {
        match stream {
            Stream::Stdout => self.stdout = Some(text),
            Stream::Stderr => self.stderr = Some(text),
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Stream {
    Stdout,
    Stderr,
}

/// Runs a program in a folder, without input, to its end.
///
/// # Errors
/// [`Outcome::TimedOut`] or [`Outcome::Crashed`] where it took more than allowed, after which it is killed with all that
/// it started; [`Outcome::Error`] where it cannot be started.
pub(crate) fn run<A: AsRef<OsStr>>(
    program: &Path,
    arguments: &[A],
    folder: &Path,
    limits: &ToolLimits,
) -> Result<Ended, Outcome> {
    run_with(program, arguments, folder, limits, |_| {})
}

/// The same, with what `prepare` does to the command before it is started.
///
/// # Errors
/// As [`run`].
pub(crate) fn run_with<A: AsRef<OsStr>>(
    program: &Path,
    arguments: &[A],
    folder: &Path,
    limits: &ToolLimits,
    prepare: impl FnOnce(&mut Command),
) -> Result<Ended, Outcome> {
    let deadline = Instant::now() + limits.time;
    let (mut group, pipes) = Group::start(program.as_os_str(), |start| {
        start
            .args(arguments)
            .current_dir(folder)
            // What it would leave behind when it is killed goes with the folder.
            .envs(["TMPDIR", "TEMP", "TMP"].map(|variable| (variable, folder)))
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        prepare(start);
    })
    .map_err(|reason| Outcome::Error {
        message: format!("`{}` could not be started: {reason}", program.display()),
    })?;
    let streams = collect(pipes, limits.output);
    let Gathered { stdout, stderr } = gather(&mut group, &streams, deadline, limits)?;
    let status = end(&mut group, deadline, limits)?;
    Ok(Ended {
        status,
        stdout: stdout.unwrap_or_default(),
        stderr: stderr.unwrap_or_default(),
    })
}

/// Reads both streams in the background.
fn collect(pipes: Pipes, most: u64) -> Receiver<StreamEnd> {
    let (sender, streams) = mpsc::channel();
    read(Stream::Stdout, pipes.stdout, most, sender.clone());
    read(Stream::Stderr, pipes.stderr, most, sender);
    streams
}

/// The thread ends with the stream; a process that outlives its group may keep it, which costs nothing else.
fn read(which: Stream, stream: Option<impl Read + Send + 'static>, most: u64, sender: Sender<StreamEnd>) {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(stream) = stream {
            // What was read before an error is what there is.
            let _ = stream.take(most.saturating_add(1)).read_to_end(&mut bytes);
        }
        let within = u64::try_from(bytes.len()).is_ok_and(|length| length <= most);
        // Nobody may be waiting any more.
        let _ = sender.send((which, text(bytes), within));
    });
}

/// Waits for the end of both streams, and looks after the process meanwhile.
fn gather(
    group: &mut Group,
    streams: &Receiver<StreamEnd>,
    deadline: Instant,
    limits: &ToolLimits,
) -> Result<Gathered, Outcome> {
    let mut gathered = Gathered::default();
    let mut orphaned = false;
    while !gathered.is_whole() {
        let left = deadline.saturating_duration_since(Instant::now());
        let looked = match streams.recv_timeout(left.min(LOOK)) {
            Ok((stream, text, within)) => {
                gathered.keep(stream, text);
                if within { Ok(()) } else { Err(flooded(limits)) }
            }
            // What the process started holds its output open: with them gone the streams end.
            Err(RecvTimeoutError::Timeout) if group.has_ended() && !orphaned => {
                orphaned = true;
                group.kill();
                Ok(())
            }
            Err(RecvTimeoutError::Timeout) if left > LOOK => within(group, limits),
            Err(_) => Err(timed_out(limits)),
        };
        if let Err(outcome) = looked {
            return Err(with_last_words(outcome, group, streams, gathered));
        }
    }
    Ok(gathered)
}

/// A crash with the last that the process wrote, which is killed for that: then its streams end.
fn with_last_words(
    outcome: Outcome,
    group: &mut Group,
    streams: &Receiver<StreamEnd>,
    mut gathered: Gathered,
) -> Outcome {
    let Outcome::Crashed { reason } = outcome else {
        return outcome;
    };
    group.kill();
    while !gathered.is_whole()
        // A process that left its group may hold them open all the same.
        && let Ok((stream, text, _)) = streams.recv_timeout(LOOK)
    {
        gathered.keep(stream, text);
    }
    let words = [gathered.stderr, gathered.stdout].into_iter().flatten();
    let words = words.map(|text| told(&text)).find(|words| !words.is_empty());
    let reason = match words {
        Some(words) => format!("{reason}; its last words: {words}"),
        None => reason,
    };
    Outcome::Crashed { reason }
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}

fn timed_out(limits: &ToolLimits) -> Outcome {
    Outcome::TimedOut {
        after_ms: u64::try_from(limits.time.as_millis()).unwrap_or(u64::MAX),
    }
}

fn flooded(limits: &ToolLimits) -> Outcome {
    Outcome::Crashed {
        reason: format!("it wrote more than {} bytes", limits.output),
    }
}

fn within(group: &Group, limits: &ToolLimits) -> Result<(), Outcome> {
    let crashed = |reason: String| Err(Outcome::Crashed { reason });
    match usage::of_group(group.number()) {
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

/// Waits for the end of a process that has closed its output, and looks after it meanwhile.
fn end(group: &mut Group, deadline: Instant, limits: &ToolLimits) -> Result<ExitStatus, Outcome> {
    loop {
        let look = deadline.min(Instant::now() + LOOK);
        if let Some(status) = group.wait_until(look) {
            return Ok(status);
        }
        if look == deadline {
            return Err(timed_out(limits));
        }
        within(group, limits)?;
    }
}

#[cfg(all(test, unix))]
mod tests;
