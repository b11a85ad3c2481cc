//! What a program writes to stdout and stderr, read while it runs, by threads of their own.

use crate::process::child::told;
use crate::process::group::{Pipes, lock};
use std::io::Read;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// What came from a stream so far.
type Shared = Arc<Mutex<Vec<u8>>>;

/// Both streams of a program. A thread ends with its stream; a process that left its group may keep that open, which costs
/// nothing else.
pub(super) struct Output {
    stdout: Shared,
    stderr: Shared,
    /// For each stream that ends, whether it kept to its limit.
    ends: Receiver<bool>,
    open: usize,
}

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

impl Output {
    /// Reads the streams, of each no more than `most` bytes.
    pub(super) fn of(pipes: Pipes, most: u64) -> Output {
        let (sender, ends) = mpsc::channel();
        Output {
            stdout: read(pipes.stdout, most, sender.clone()),
            stderr: read(pipes.stderr, most, sender),
            ends,
            open: 2,
        }
    }

    /// Whether one of them has not ended.
    pub(super) fn is_open(&self) -> bool {
        self.open > 0
    }

    /// Waits so long for the end of one of them.
    pub(super) fn wait(&mut self, limit: Duration) -> Waited {
        match self.ends.recv_timeout(limit) {
            Ok(within) => {
                self.open -= 1;
                if within { Waited::Ended } else { Waited::Flooded }
            }
            Err(RecvTimeoutError::Timeout) => Waited::InVain,
            // Threads that are gone without a word have nothing more to read.
            Err(RecvTimeoutError::Disconnected) => {
                self.open = 0;
                Waited::Ended
            }
        }
    }

    /// What came from stdout and from stderr so far, with what is no UTF-8 replaced.
    pub(super) fn texts(&self) -> (String, String) {
        (text(&self.stdout), text(&self.stderr))
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

fn text(shared: &Shared) -> String {
    let bytes = lock(shared).clone();
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}

fn read(stream: Option<impl Read + Send + 'static>, most: u64, sender: Sender<bool>) -> Shared {
    let shared = Shared::default();
    let kept = Arc::clone(&shared);
    thread::spawn(move || {
        // Nobody may be waiting any more.
        let _ = sender.send(stream.is_none_or(|stream| keep(stream, &kept, most)));
    });
    shared
}

/// Reads a stream to its end; whether that came within the limit.
fn keep(mut stream: impl Read, kept: &Mutex<Vec<u8>>, most: u64) -> bool {
    let mut piece = vec![0; 1 << 16];
    let mut total: u64 = 0;
    // What was read before an error is what there is.
    while let Ok(length @ 1..) = stream.read(&mut piece) {
        total += u64::try_from(length).unwrap_or(u64::MAX);
        if total > most {
            return false;
        }
        lock(kept).extend_from_slice(&piece[..length]);
    }
    true
}
