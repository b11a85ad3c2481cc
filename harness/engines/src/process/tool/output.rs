//! The output of a program on stdout and stderr, read by a thread each while the program runs.

use super::super::group::{Pipes, lock};
use std::io::{ErrorKind, Read};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

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

/// The bytes that came from a stream so far.
type SharedBytes = Arc<Mutex<Vec<u8>>>;

/// Both streams, and the bytes that came from them so far. A thread ends with its stream.
pub(super) struct Streams {
    kept: [SharedBytes; 2],
    /// The receiver of one message for each stream that ends: whether it kept to its limit.
    ends: Receiver<bool>,
    open: usize,
}

impl Streams {
    /// Returns streams of which no more than `most` bytes each are read.
    pub(super) fn of(pipes: Pipes, most: u64) -> Streams {
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
    pub(super) fn are_open(&self) -> bool {
        self.open > 0
    }

    /// Waits for the end of a stream, for no longer than `limit`.
    pub(super) fn wait(&mut self, limit: Duration) -> Waited {
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

    /// Returns what came from stdout and from stderr so far, with invalid UTF-8 replaced.
    pub(super) fn texts(&self) -> (String, String) {
        let [stdout, stderr] = &self.kept;
        (text(lock(stdout).clone()), text(lock(stderr).clone()))
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
    loop {
        match stream.read(&mut piece) {
            Ok(length @ 1..) => {
                total += length as u64;
                if total > most {
                    return false;
                }
                lock(kept).extend_from_slice(&piece[..length]);
            }
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            // After an error, the bytes that were read before it are kept.
            Ok(0) | Err(_) => return true,
        }
    }
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}
