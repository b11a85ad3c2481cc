//! Two streams read by whoever waits for their end. The system says which of them has something to be read, so that a program
//! that runs for milliseconds needs no thread to be started for it.

use super::Waited;
use crate::process::group::Pipes;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::os::fd::OwnedFd;
use std::time::{Duration, Instant};

/// How much is read at a time, in bytes.
const PIECE: usize = 1 << 14;

/// Both streams, and what came from them so far.
pub(super) struct Streams {
    streams: [Stream; 2],
    most: u64,
}

struct Stream {
    /// `None` once it has ended.
    pipe: Option<File>,
    kept: Vec<u8>,
}

impl Streams {
    /// Streams of which no more than `most` bytes each are read.
    pub(super) fn of(pipes: Pipes, most: u64) -> Streams {
        let stdout = pipes.stdout.map(OwnedFd::from);
        let stderr = pipes.stderr.map(OwnedFd::from);
        let streams = [stdout, stderr].map(|pipe| Stream {
            pipe: pipe.map(File::from),
            kept: Vec::new(),
        });
        Streams { streams, most }
    }

    /// Whether one of them has not ended.
    pub(super) fn are_open(&self) -> bool {
        self.streams.iter().any(|stream| stream.pipe.is_some())
    }

    /// Reads until one of them ends, for no longer than this.
    pub(super) fn wait(&mut self, limit: Duration) -> Waited {
        let deadline = Instant::now() + limit;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            let mut came = None;
            for number in self.ready(left) {
                let waited = self.streams[number].read(self.most);
                if waited == Some(Waited::Flooded) {
                    return Waited::Flooded;
                }
                came = came.or(waited);
            }
            if let Some(came) = came {
                return came;
            }
            if left.is_zero() {
                return Waited::InVain;
            }
        }
    }

    /// What came so far.
    pub(super) fn bytes(&self) -> [Vec<u8>; 2] {
        let [stdout, stderr] = &self.streams;
        [stdout.kept.clone(), stderr.kept.clone()]
    }

    /// The numbers of those from which something can be read, or of which the end is reached, after this time at most.
    fn ready(&self, limit: Duration) -> Vec<usize> {
        let open = self.streams.iter().enumerate();
        let open: Vec<(usize, &File)> = open
            .filter_map(|(number, stream)| Some((number, stream.pipe.as_ref()?)))
            .collect();
        let mut asked: Vec<PollFd<'_>> = open
            .iter()
            .map(|(_, pipe)| PollFd::new(*pipe, PollFlags::IN))
            .collect();
        // A time that the system cannot count is as good as none at all.
        let limit = Timespec::try_from(limit).ok();
        match poll(&mut asked, limit.as_ref()) {
            // After a signal, or where the system cannot tell just now, the next look does.
            Ok(0) | Err(_) => Vec::new(),
            Ok(_) => {
                let told = open.iter().zip(&asked);
                let told = told.filter(|(_, asked)| !asked.revents().is_empty());
                told.map(|((number, _), _)| *number).collect()
            }
        }
    }
}

impl Stream {
    /// Reads what there is; what came of it, if it is more than a few bytes.
    fn read(&mut self, most: u64) -> Option<Waited> {
        let mut piece = [0; PIECE];
        let pipe = self.pipe.as_mut()?;
        match pipe.read(&mut piece) {
            Ok(length @ 1..) => {
                self.kept.extend_from_slice(&piece[..length]);
                (self.kept.len() as u64 > most).then_some(Waited::Flooded)
            }
            Err(error) if error.kind() == ErrorKind::Interrupted => None,
            // What was read before an error is what there is.
            Ok(0) | Err(_) => {
                self.pipe = None;
                Some(Waited::Ended)
            }
        }
    }
}
