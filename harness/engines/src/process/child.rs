//! A process that speaks the wire protocol: its start, its end, and the last lines that it wrote to stderr.

use super::command_line::CommandLine;
use super::group::{Pipes, ProcessGroup, lock};
use super::usage::Watch;
use std::borrow::Cow;
use std::collections::VecDeque;
use std::ffi::OsStr;
use std::io::Read;
use std::process::{ChildStderr, ChildStdin, ChildStdout, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};
use stickler_types::join;

/// The time limit for a process that is done to end, and for its stderr to be read to the end.
const EXIT_TIMEOUT: Duration = Duration::from_secs(1);

/// The number of bytes of stderr that are kept, from its end.
const MAX_STDERR_LEN: usize = 4096;

/// The number of lines of stderr that a message quotes at most.
const MAX_STDERR_LINES: usize = 8;

/// A running process with all that it starts. Dropping it kills them all.
pub(super) struct Child {
    group: ProcessGroup,
    usage: Watch,
    stderr: Tail,
}

impl Child {
    /// Starts a process in a group of its own, with pipes to and from it.
    ///
    /// # Errors
    /// A fragment that says why there is no process.
    pub(super) fn start(command: &CommandLine) -> Result<(Child, ChildStdin, ChildStdout), String> {
        let (group, pipes) = ProcessGroup::start(OsStr::new(&command.program), |start| {
            start
                .args(&command.arguments)
                .stdin(Stdio::piped())
                .stdout(Stdio::piped())
                .stderr(Stdio::piped());
            if let Some(folder) = &command.folder {
                start.current_dir(folder);
            }
        })?;
        match pipes {
            Pipes {
                stdin: Some(stdin),
                stdout: Some(stdout),
                stderr: Some(stderr),
            } => {
                let stderr = Tail::of(stderr);
                let usage = Watch::new();
                let child = Child { group, usage, stderr };
                Ok((child, stdin, stdout))
            }
            _ => Err("it has no pipes".to_owned()),
        }
    }

    /// Tells whether the process itself has ended; processes that it started may still hold its output open.
    pub(super) fn has_ended(&mut self) -> bool {
        self.group.has_ended()
    }

    /// Returns the memory that the process and all that it started hold, in bytes; 0 where the system does not tell, or the
    /// last measurement was too short a time ago.
    pub(super) fn memory(&mut self) -> u64 {
        self.usage.measure(self.group.number()).unwrap_or_default().memory
    }

    /// Waits up to [`EXIT_TIMEOUT`] for the end of a process that has nothing more to say, kills what is left of it, and
    /// returns how it ended: a fragment such as `it ended (exit status: 101); its stderr ends: …`.
    pub(super) fn end(mut self) -> String {
        let status = self.group.wait_until(Instant::now() + EXIT_TIMEOUT);
        self.group.kill();
        let how = match status {
            Some(status) => format!("it ended ({status})"),
            None => "it closed its output and went on".to_owned(),
        };
        match self.stderr.text() {
            words if words.is_empty() => how,
            words => format!("{how}; its stderr ends: {words}"),
        }
    }

    /// Kills the process and returns the end of what it wrote to stderr.
    pub(super) fn kill_and_tell(mut self) -> String {
        self.group.kill();
        self.stderr.text()
    }

    /// Waits up to [`EXIT_TIMEOUT`] for a process that was told to end, then kills it. Returns whether it ended in time.
    pub(super) fn leave(mut self) -> bool {
        self.group.wait_until(Instant::now() + EXIT_TIMEOUT).is_some()
    }
}

/// The last bytes of a stream that a thread of its own reads to the end.
struct Tail {
    bytes: Arc<Mutex<VecDeque<u8>>>,
    /// The receiver whose sender is dropped once the stream has ended.
    ended: Receiver<()>,
}

impl Tail {
    fn of(mut stream: ChildStderr) -> Tail {
        let bytes = Arc::new(Mutex::new(VecDeque::with_capacity(MAX_STDERR_LEN)));
        let (sender, ended) = mpsc::channel::<()>();
        let kept = Arc::clone(&bytes);
        // The thread ends with the stream; a process that outlives its group may keep it, which costs nothing else.
        thread::spawn(move || {
            let _open = sender;
            let mut piece = [0; 1024];
            while let Ok(length @ 1..) = stream.read(&mut piece) {
                keep(&mut lock(&kept), &piece[..length]);
            }
        });
        Tail { bytes, ended }
    }

    /// Returns the last lines, joined into one; empty where there are none.
    fn text(&self) -> String {
        // The lines that have come so far are returned, whether the stream has ended or the time limit has passed.
        let _ = self.ended.recv_timeout(EXIT_TIMEOUT);
        let bytes: Vec<u8> = lock(&self.bytes).iter().copied().collect();
        last_lines(&String::from_utf8_lossy(&bytes))
    }
}

fn keep(kept: &mut VecDeque<u8>, piece: &[u8]) {
    kept.extend(piece);
    let surplus = kept.len().saturating_sub(MAX_STDERR_LEN);
    kept.drain(..surplus);
}

/// Joins the last lines that are not blank into one line, without characters that would control a terminal, and without the
/// backtraces of Rust programs, before which they say what is wrong.
pub(super) fn last_lines(text: &str) -> String {
    let text = &without_backtraces(text);
    // A flood of output may be a single line.
    let from = text.len().saturating_sub(MAX_STDERR_LEN);
    let from = (from..text.len()).find(|&at| text.is_char_boundary(at));
    let text = &text[from.unwrap_or(0)..];
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    let last = &lines[lines.len().saturating_sub(MAX_STDERR_LINES)..];
    join(last.iter().map(|line| line.trim()), " | ")
        .chars()
        .filter(|character| !character.is_control())
        .collect()
}

/// Removes the backtraces of Rust programs from a text.
fn without_backtraces(text: &str) -> Cow<'_, str> {
    const TITLE: &str = "stack backtrace:";
    if !text.contains(TITLE) {
        return Cow::Borrowed(text);
    }
    let mut inside = false;
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| {
            inside = line.trim() == TITLE || (inside && is_frame(line));
            !inside
        })
        .collect();
    Cow::Owned(lines.join("\n"))
}

/// Tells whether a line of a backtrace shows a frame (`4: 0x55 - main`) or its place (`at src/main.rs:3:5`).
fn is_frame(line: &str) -> bool {
    let line = line.trim();
    let number = line.split_once(':').map_or("", |(number, _)| number);
    line.starts_with("at ") || (!number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::{MAX_STDERR_LEN, keep, last_lines};
    use std::collections::VecDeque;

    #[test]
    fn the_last_lines_are_told_in_one_without_what_steers_a_terminal() {
        assert_eq!(
            last_lines("one\n\n  two\r\n\u{1b}[31mthree\n"),
            "one | two | [31mthree"
        );
        let many: String = (0..20).map(|number| format!("{number}\n")).collect();
        assert_eq!(last_lines(&many), "12 | 13 | 14 | 15 | 16 | 17 | 18 | 19");
        assert_eq!(last_lines(""), "");
        let frames: String = (0..20)
            .map(|number| format!("  {number}: 0x55 - main\n      at src/main.rs:3:5\n"))
            .collect();
        let panicked = format!("1: panicked\nstack backtrace:\n{frames}aborting\n2: end\n");
        assert_eq!(last_lines(&panicked), "1: panicked | aborting | 2: end");
        assert_eq!(last_lines(&"ä".repeat(1 << 20)), "ä".repeat(MAX_STDERR_LEN / 2));
    }

    #[test]
    fn only_the_end_of_a_flood_is_kept() {
        let mut kept = VecDeque::new();
        for number in 0..10_000_u32 {
            keep(&mut kept, &number.to_le_bytes());
        }
        assert_eq!(kept.len(), MAX_STDERR_LEN);
        assert!(kept.iter().rev().take(4).rev().eq(&9_999_u32.to_le_bytes()));
    }
}
