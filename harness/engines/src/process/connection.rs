//! Sends lines to a process and receives lines from it, each with a time limit.

use super::child::Child;
use super::command_line::CommandLine;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{ChildStdin, ChildStdout};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, SyncSender};
use std::thread;
use std::time::{Duration, Instant};

/// The number of lines that are read ahead of the requests. An engine that floods its output waits at this limit.
const MAX_LINES_AHEAD: usize = 1;

/// The default limit on the memory that a process and all that it starts may hold, in bytes: some compilers live in run-time
/// systems that take much.
pub(super) const DEFAULT_MAX_MEMORY: u64 = 4 << 30;

/// The interval at which a wait for a line checks whether the process is still running, and how much memory it holds.
const POLL_INTERVAL: Duration = Duration::from_millis(100);

/// A process and the two streams to and from it. Dropping it kills the process.
///
/// Reading and writing are done by threads of their own, since neither has a time limit otherwise: an engine that never
/// reads fills the pipe, and one that never answers leaves it empty. A thread whose pipe is held open by a process that
/// left its group stays until that one ends.
pub(crate) struct Connection {
    child: Child,
    requests: Sender<Vec<u8>>,
    replies: Receiver<Incoming>,
    /// The memory that the process may hold, in bytes.
    memory: u64,
}

/// A message from the thread that reads the output of a process.
enum Incoming {
    Line(Vec<u8>),
    /// A line that is longer than allowed; nothing is read after it.
    Flood,
}

/// The reason why there is no reply.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Failure {
    /// The output ended.
    Ended,
    /// No reply came within the time limit.
    TimedOut,
    /// The reply is longer than allowed.
    Flood,
    /// The process holds more memory than this, in bytes.
    Memory(u64),
}

impl Connection {
    /// Starts a process; `longest` is the longest line to be read from it, in bytes.
    ///
    /// # Errors
    /// A fragment that says why the process could not be started.
    pub(crate) fn open(command: &CommandLine, longest: usize) -> Result<Connection, String> {
        let (child, stdin, stdout) = Child::start(command)?;
        let (requests, lines) = mpsc::channel();
        let (sender, replies) = mpsc::sync_channel(MAX_LINES_AHEAD);
        thread::spawn(move || write(stdin, &lines));
        thread::spawn(move || read(stdout, longest, &sender));
        Ok(Connection {
            child,
            requests,
            replies,
            memory: DEFAULT_MAX_MEMORY,
        })
    }

    /// Sets the limit on the memory that the process may hold, in bytes.
    pub(super) fn within(mut self, memory: u64) -> Connection {
        self.memory = memory;
        self
    }

    /// Sends a line, its line feed included, and waits for one line in return.
    ///
    /// # Errors
    /// [`Failure`], after which the conversation is out of step, and the connection is of no use but to ask how its process
    /// ended.
    pub(crate) fn exchange(&mut self, line: Vec<u8>, limit: Duration) -> Result<Vec<u8>, Failure> {
        // A writer thread that is gone has found the pipe closed, which the reader thread reports.
        let _ = self.requests.send(line);
        let deadline = Instant::now() + limit;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.replies.recv_timeout(left.min(POLL_INTERVAL)) {
                Ok(Incoming::Line(reply)) => return Ok(reply),
                Ok(Incoming::Flood) => return Err(Failure::Flood),
                Err(RecvTimeoutError::Disconnected) => return Err(Failure::Ended),
                Err(RecvTimeoutError::Timeout) if self.child.has_ended() => return self.last_words(),
                Err(RecvTimeoutError::Timeout) if left <= POLL_INTERVAL => return Err(Failure::TimedOut),
                Err(RecvTimeoutError::Timeout) if self.child.memory() > self.memory => {
                    return Err(Failure::Memory(self.memory));
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// Receives a line that a process wrote before it ended, where another process that it started keeps its output open.
    fn last_words(&self) -> Result<Vec<u8>, Failure> {
        match self.replies.recv_timeout(POLL_INTERVAL) {
            Ok(Incoming::Line(reply)) => Ok(reply),
            Ok(Incoming::Flood) => Err(Failure::Flood),
            Err(_) => Err(Failure::Ended),
        }
    }

    /// Returns how the process ended, once its output has ended; a fragment.
    pub(crate) fn end(self) -> String {
        self.child.end()
    }

    /// Kills the process and returns the end of what it wrote to stderr.
    pub(super) fn kill(self) -> String {
        self.child.kill_and_tell()
    }

    /// Sends a last line, closes the stream, and gives the process a moment to end before it is killed. Returns whether it
    /// ended.
    pub(crate) fn leave(self, farewell: Vec<u8>) -> bool {
        // Where this fails, the process has closed its input and needs no farewell.
        let _ = self.requests.send(farewell);
        drop(self.requests);
        self.child.leave()
    }
}

/// Writes the lines until there are no more, or the process has closed the pipe; then closes the stream.
fn write(mut stream: ChildStdin, lines: &Receiver<Vec<u8>>) {
    for line in lines {
        if stream.write_all(&line).and_then(|()| stream.flush()).is_err() {
            return;
        }
    }
}

/// Reads lines until the end of the stream, a line that is too long, or the receiver is gone.
fn read(stream: ChildStdout, longest: usize, sender: &SyncSender<Incoming>) {
    let mut stream = BufReader::new(stream);
    let limit = u64::try_from(longest).unwrap_or(u64::MAX).saturating_add(1);
    loop {
        let mut line = Vec::new();
        match stream.by_ref().take(limit).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => return,
            Ok(_) => {}
        }
        let flood = line.len() > longest && line.last() != Some(&b'\n');
        let incoming = if flood {
            Incoming::Flood
        } else {
            Incoming::Line(line)
        };
        if sender.send(incoming).is_err() || flood {
            return;
        }
    }
}
