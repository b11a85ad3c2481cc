//! The output of a program on stdout and stderr, read while the program runs.

#[cfg(unix)]
mod polled;
#[cfg(not(unix))]
mod threaded;

use super::super::child::last_lines;
use super::super::group::Pipes;
#[cfg(unix)]
use polled::Streams;
use std::time::Duration;
#[cfg(not(unix))]
use threaded::Streams;

/// The result of waiting for the end of a stream.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Waited {
    /// One stream has ended.
    Ended,
    /// One stream gave more than is allowed; the rest is not read.
    Flooded,
    /// No stream has ended.
    InVain,
}

/// Both output streams of a program. A process that left its group may keep one open, which costs nothing else.
pub(super) struct Output {
    streams: Streams,
}

impl Output {
    /// Starts to read the streams, of each no more than `most` bytes.
    pub(super) fn of(pipes: Pipes, most: u64) -> Output {
        Output {
            streams: Streams::of(pipes, most),
        }
    }

    /// Tells whether a stream has not ended.
    pub(super) fn is_open(&self) -> bool {
        self.streams.are_open()
    }

    /// Waits for the end of a stream, for no longer than `limit`.
    pub(super) fn wait(&mut self, limit: Duration) -> Waited {
        self.streams.wait(limit)
    }

    /// Returns what came from stdout and from stderr so far, with invalid UTF-8 replaced.
    pub(super) fn texts(&self) -> (String, String) {
        let [stdout, stderr] = self.streams.bytes().map(text);
        (stdout, stderr)
    }

    /// Returns the last lines of stderr, or of stdout where stderr is empty.
    pub(super) fn last_words(&self) -> String {
        let (stdout, stderr) = self.texts();
        match last_lines(&stderr) {
            words if words.is_empty() => last_lines(&stdout),
            words => words,
        }
    }
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}
