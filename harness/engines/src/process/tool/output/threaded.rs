//! Reads two streams in threads of their own, for systems that do not say which stream has something to be read.

use super::Waited;
use crate::process::group::{Pipes, lock};
use std::io::Read;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// The bytes that came from a stream so far.
type SharedBytes = Arc<Mutex<Vec<u8>>>;

/// Both streams, and the bytes that came from them so far. A thread ends with its stream.
pub(in crate::process::tool) struct Streams {
    kept: [SharedBytes; 2],
    /// The receiver of one message for each stream that ends: whether it kept to its limit.
    ends: Receiver<bool>,
    open: usize,
}

impl Streams {
    /// Returns streams of which no more than `most` bytes each are read.
    pub(in crate::process::tool) fn of(pipes: Pipes, most: u64) -> Streams {
        let (sender, ends) = mpsc::channel();
        Streams {
            kept: [
                read(pipes.stdout, most, sender.clone()),
                read(pipes.stderr, most, sender),
            ],
            ends,
            open: 2,
        }
    }

    /// Tells whether a stream has not ended.
    pub(in crate::process::tool) fn are_open(&self) -> bool {
        self.open > 0
    }

    /// Waits for the end of a stream, for no longer than `limit`.
    pub(in crate::process::tool) fn wait(&mut self, limit: Duration) -> Waited {
        match self.ends.recv_timeout(limit) {
            Ok(within) => {
                self.open -= 1;
                if within { Waited::Ended } else { Waited::Flooded }
            }
            Err(RecvTimeoutError::Timeout) => Waited::InVain,
            // Threads that have ended without a message have nothing more to read.
            Err(RecvTimeoutError::Disconnected) => {
                self.open = 0;
                Waited::Ended
            }
        }
    }

    /// Returns the bytes that came so far from stdout and from stderr.
    pub(in crate::process::tool) fn bytes(&self) -> [Vec<u8>; 2] {
        let [stdout, stderr] = &self.kept;
        [lock(stdout).clone(), lock(stderr).clone()]
    }
}

fn read(stream: Option<impl Read + Send + 'static>, most: u64, sender: Sender<bool>) -> SharedBytes {
    let shared = SharedBytes::default();
    let kept = Arc::clone(&shared);
    thread::spawn(move || {
        // The receiver may be gone.
        let _ = sender.send(stream.is_none_or(|stream| keep(stream, &kept, most)));
    });
    shared
}

/// Reads a stream to its end. Returns whether that came within the limit.
fn keep(mut stream: impl Read, kept: &Mutex<Vec<u8>>, most: u64) -> bool {
    let mut piece = vec![0; 1 << 16];
    let mut total: u64 = 0;
    // After an error, the bytes that were read before it are kept.
    while let Ok(length @ 1..) = stream.read(&mut piece) {
        total += u64::try_from(length).unwrap_or(u64::MAX);
        if total > most {
            return false;
        }
        lock(kept).extend_from_slice(&piece[..length]);
    }
    true
}
