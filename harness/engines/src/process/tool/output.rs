//! What a program writes to stdout and stderr, read while it runs.

#[cfg(unix)]
mod polled;
#[cfg(not(unix))]
mod threaded;

use super::super::child::told;
use super::super::group::Pipes;
#[cfg(unix)]
use polled::Streams;
use std::time::Duration;
#[cfg(not(unix))]
use threaded::Streams;

/// What came of waiting for the end of a stream.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Waited {
    /// One has ended.
    Ended,
    /// More came from one than is allowed; the rest is not read.
    Flooded,
    /// None has ended.
    InVain,
}

/// Both streams of a program. A process that left its group may keep one open, which costs nothing else.
pub(super) struct Output {
    streams: Streams,
}

impl Output {
    /// Reads the streams, of each no more than `most` bytes.
    pub(super) fn of(pipes: Pipes, most: u64) -> Output {
        Output {
            streams: Streams::of(pipes, most),
        }
    }

    /// Tells whether one of them has not ended.
    pub(super) fn is_open(&self) -> bool {
        self.streams.are_open()
    }

    /// Waits so long for the end of one of them.
    pub(super) fn wait(&mut self, limit: Duration) -> Waited {
        self.streams.wait(limit)
    }

    /// Returns what came from stdout and from stderr so far, with what is no UTF-8 replaced.
    pub(super) fn texts(&self) -> (String, String) {
        let [stdout, stderr] = self.streams.bytes().map(text);
        (stdout, stderr)
    }

    /// The last lines of stderr, or of stdout where there are none.
    pub(super) fn last_words(&self) -> String {
        let (stdout, stderr) = self.texts();
        match told(&stderr) {
            words if words.is_empty() => told(&stdout),
            words => words,
        }
    }
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}
