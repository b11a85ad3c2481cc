//! The output of a program on stdout and stderr, read while the program runs.

#[cfg(unix)]
mod polled;
#[cfg(not(unix))]
mod threaded;

use super::super::child::last_lines;
#[cfg(unix)]
pub(super) use polled::Streams;
#[cfg(not(unix))]
pub(super) use threaded::Streams;

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

impl Streams {
    /// Returns what came from stdout and from stderr so far, with invalid UTF-8 replaced.
    pub(super) fn texts(&self) -> (String, String) {
        let [stdout, stderr] = self.bytes().map(text);
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
