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

/// Which stream, and all that came from it; `None` where that was more than allowed.
type StreamEnd = (Stream, Option<Vec<u8>>);

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
    let (stdout, stderr) = gather(&mut group, &streams, deadline, limits)?;
    let status = end(&mut group, deadline, limits)?;
    Ok(Ended {
        status,
        stdout,
        stderr,
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
        let _ = sender.send((which, within.then_some(bytes)));
    });
}

/// Waits for the end of both streams, and looks after the process meanwhile.
fn gather(
    group: &mut Group,
    streams: &Receiver<StreamEnd>,
    deadline: Instant,
    limits: &ToolLimits,
) -> Result<(String, String), Outcome> {
    let (mut stdout, mut stderr) = (None, None);
    let mut orphaned = false;
    while stdout.is_none() || stderr.is_none() {
        let left = deadline.saturating_duration_since(Instant::now());
        match streams.recv_timeout(left.min(LOOK)) {
            Ok((_, None)) => return Err(flooded(limits)),
            Ok((Stream::Stdout, Some(bytes))) => stdout = Some(text(bytes)),
            Ok((Stream::Stderr, Some(bytes))) => stderr = Some(text(bytes)),
            // What the process started holds its output open: with them gone the streams end.
            Err(RecvTimeoutError::Timeout) if group.has_ended() && !orphaned => {
                orphaned = true;
                group.kill();
            }
            Err(RecvTimeoutError::Timeout) if left > LOOK => within(group, limits)?,
            Err(_) => return Err(timed_out(limits)),
        }
    }
    Ok((stdout.unwrap_or_default(), stderr.unwrap_or_default()))
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
mod tests {
    use super::*;

    const LIMITS: ToolLimits = ToolLimits {
        time: Duration::from_secs(60),
        cpu: Duration::from_secs(60),
        output: 1 << 16,
        memory: 1 << 30,
    };

    fn shell(script: &str, limits: ToolLimits) -> Result<Ended, Outcome> {
        run(Path::new("sh"), &["-c", script], Path::new("/"), &limits)
    }

    #[test]
    fn both_streams_and_the_exit_code_are_told() {
        let ended = shell("echo out; echo err >&2; exit 3", LIMITS).unwrap();
        assert_eq!((ended.stdout.as_str(), ended.stderr.as_str()), ("out\n", "err\n"));
        assert_eq!(ended.code(), Ok(3));
    }

    #[test]
    fn a_signal_is_a_crash_with_the_last_words() {
        let outcome = shell("echo bad luck >&2; kill -ABRT $$", LIMITS)
            .unwrap()
            .code()
            .unwrap_err();
        let Outcome::Crashed { reason } = outcome else {
            panic!("no crash")
        };
        assert!(
            reason.contains("signal: 6") && reason.ends_with("bad luck"),
            "{reason}"
        );
    }

    #[test]
    fn what_takes_too_long_is_killed() {
        let time = Duration::from_millis(300);
        let hang = shell("tail -f /dev/null", ToolLimits { time, ..LIMITS });
        assert_eq!(hang.unwrap_err(), Outcome::TimedOut { after_ms: 300 });
        let silent = shell(
            "exec >/dev/null 2>&1; tail -f /dev/null",
            ToolLimits { time, ..LIMITS },
        );
        assert_eq!(silent.unwrap_err(), Outcome::TimedOut { after_ms: 300 });
    }

    #[test]
    fn what_writes_without_end_is_killed() {
        for flood in ["yes", "yes >&2"] {
            let outcome = shell(flood, LIMITS).unwrap_err();
            let reason = "it wrote more than 65536 bytes".to_owned();
            assert_eq!(outcome, Outcome::Crashed { reason });
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn what_takes_too_much_memory_is_killed() {
        let limits = ToolLimits {
            memory: 1 << 10,
            ..LIMITS
        };
        for script in ["tail -f /dev/null", "exec >/dev/null 2>&1; tail -f /dev/null"] {
            let outcome = shell(script, limits).unwrap_err();
            let reason = "it held more than 0 MiB of memory".to_owned();
            assert_eq!(outcome, Outcome::Crashed { reason }, "{script}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn the_memory_of_what_a_process_started_counts_with_its_own() {
        // Each shell alone holds less than it may.
        let limits = ToolLimits {
            memory: 8 << 20,
            ..LIMITS
        };
        let outcome = shell(
            "for each in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do sh -c 'tail -f /dev/null; :' & done; wait",
            limits,
        );
        assert!(matches!(outcome, Err(Outcome::Crashed { .. })), "{outcome:?}");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn what_computes_for_too_long_is_killed_although_its_children_did_it() {
        let limits = ToolLimits {
            cpu: Duration::from_millis(100),
            ..LIMITS
        };
        for script in ["while :; do :; done", "sh -c 'while :; do :; done' & wait"] {
            let outcome = shell(script, limits).unwrap_err();
            let reason = "it took more than 0.1 seconds of processor time".to_owned();
            assert_eq!(outcome, Outcome::Crashed { reason }, "{script}");
        }
    }

    #[test]
    fn what_ignores_the_signal_to_end_is_killed_all_the_same() {
        let time = Duration::from_millis(300);
        let stubborn = "trap '' TERM INT HUP; while :; do tail -f /dev/null; done";
        let outcome = shell(stubborn, ToolLimits { time, ..LIMITS });
        assert_eq!(outcome.unwrap_err(), Outcome::TimedOut { after_ms: 300 });
    }

    #[test]
    fn what_is_not_executable_is_an_error_that_says_so() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("compiler");
        std::fs::write(&file, "#!/bin/sh\n").unwrap();
        let nothing: [&str; 0] = [];
        let Outcome::Error { message } = run(&file, &nothing, folder.path(), &LIMITS).unwrap_err() else {
            panic!("no error")
        };
        assert!(message.contains("ermission denied"), "{message}");
    }

    #[test]
    fn the_end_is_seen_although_a_child_holds_the_output() {
        let ended = shell("tail -f /dev/null & echo done; exit 0", LIMITS).unwrap();
        assert_eq!(ended.stdout, "done\n");
        assert_eq!(ended.code(), Ok(0));
    }

    #[test]
    fn temporary_files_lie_in_the_folder_and_go_with_it() {
        let folder = tempfile::tempdir().unwrap();
        let script = "echo text >\"$TMPDIR/left.tmp\"; mktemp >name; kill -KILL $$";
        let ended = run(Path::new("sh"), &["-c", script], folder.path(), &LIMITS).unwrap();
        assert!(ended.code().is_err());
        assert!(folder.path().join("left.tmp").is_file());
        let other = std::fs::read_to_string(folder.path().join("name")).unwrap();
        assert_eq!(Path::new(other.trim()).parent(), Some(folder.path()));
    }

    #[test]
    fn what_cannot_be_started_is_an_error() {
        let nothing: [&str; 0] = [];
        let outcome = run(Path::new("/no/such/program"), &nothing, Path::new("/"), &LIMITS).unwrap_err();
        let Outcome::Error { message } = outcome else {
            panic!("no error")
        };
        assert!(message.contains("/no/such/program"), "{message}");
    }
}
