//! Reads two streams in the thread that waits for their end. The system says which of them has something to be read, so that a
//! program that runs for milliseconds needs no thread to be started for it.
//!
//! Compilers write a line in dozens of pieces, a colour or a word each. A thread that woke at each piece would take a processor
//! from the compilers, and delay them besides; so the output gathers in the pipe for a moment before it is read, unless much of
//! it comes or the stream ends.

use super::Waited;
use crate::process::group::Pipes;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use std::fs::File;
use std::io::{self, ErrorKind};
use std::os::fd::OwnedFd;
use std::time::{Duration, Instant};

/// The number of bytes that are read at a time: less than a pipe holds, so that a pipe in which output gathers is not full.
const READ_SIZE: usize = 1 << 14;

/// The time for which a program that was just started is left alone, unless its streams end: many compilers are done by then.
const START_GATHER_TIMEOUT: Duration = Duration::from_millis(16);

/// The time for which later output gathers before it is read, unless the stream ends: so short that a program that fills its
/// pipe meanwhile hardly waits.
const GATHER_TIMEOUT: Duration = Duration::from_millis(4);

/// Both streams, and the bytes that came from them so far. A process that left its group may keep one open, which costs
/// nothing else.
pub(in crate::process::tool) struct Streams {
    streams: [Stream; 2],
    most: u64,
    /// The time before something is read again; `None` where it is read as soon as it comes.
    gathers: Option<Duration>,
}

struct Stream {
    /// The open end of the pipe; `None` once the stream has ended.
    pipe: Option<File>,
    kept: Vec<u8>,
}

impl Streams {
    /// Returns streams of which no more than `most` bytes each are read.
    pub(in crate::process::tool) fn of(pipes: Pipes, most: u64) -> Streams {
        let stdout = pipes.stdout.map(OwnedFd::from);
        let stderr = pipes.stderr.map(OwnedFd::from);
        let streams = [stdout, stderr].map(|pipe| Stream {
            pipe: pipe.map(File::from),
            kept: Vec::new(),
        });
        Streams {
            streams,
            most,
            gathers: Some(START_GATHER_TIMEOUT),
        }
    }

    /// Tells whether a stream has not ended.
    pub(in crate::process::tool) fn are_open(&self) -> bool {
        self.streams.iter().any(|stream| stream.pipe.is_some())
    }

    /// Reads until a stream ends, for no longer than `limit`.
    pub(in crate::process::tool) fn wait(&mut self, limit: Duration) -> Waited {
        let deadline = Instant::now() + limit;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            let ready = match self.gathers {
                Some(time) => self.ready(PollFlags::HUP, left.min(time)),
                None => self.ready(PollFlags::IN, left),
            };
            let read: Vec<Read> = ready
                .into_iter()
                .map(|number| self.streams[number].read(self.most))
                .collect();
            let gathers = read.contains(&Read::Short) && !read.contains(&Read::Full);
            self.gathers = gathers.then_some(GATHER_TIMEOUT);
            if read.contains(&Read::Flooded) {
                return Waited::Flooded;
            }
            if read.contains(&Read::Ended) {
                return Waited::Ended;
            }
            if left.is_zero() {
                return Waited::InVain;
            }
        }
    }

    /// Returns the bytes that came so far from stdout and from stderr.
    pub(in crate::process::tool) fn bytes(&self) -> [Vec<u8>; 2] {
        let [stdout, stderr] = &self.streams;
        [stdout.kept.clone(), stderr.kept.clone()]
    }

    /// Waits for an event or the end of a stream, for no longer than `limit`. Returns the numbers of the streams that are
    /// ready.
    fn ready(&self, awaited: PollFlags, limit: Duration) -> Vec<usize> {
        let open = self.streams.iter().enumerate();
        let open: Vec<(usize, &File)> = open
            .filter_map(|(number, stream)| Some((number, stream.pipe.as_ref()?)))
            .collect();
        let mut asked: Vec<PollFd<'_>> = open.iter().map(|(_, pipe)| PollFd::new(*pipe, awaited)).collect();
        // A time that the system cannot represent is as good as no limit.
        let limit = Timespec::try_from(limit).ok();
        match poll(&mut asked, limit.as_ref()) {
            // After a signal, or where the system cannot tell just now, the next call does.
            Ok(0) | Err(_) => Vec::new(),
            Ok(_) => {
                let ready = open.iter().zip(&asked);
                let ready = ready.filter(|(_, asked)| !asked.revents().is_empty());
                ready.map(|((number, _), _)| *number).collect()
            }
        }
    }
}

/// The result of one reading.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Read {
    /// All bytes that there were.
    Short,
    /// As many bytes as are read at a time; more may wait.
    Full,
    /// More bytes than are allowed, together with those that came before.
    Flooded,
    /// The end of the stream.
    Ended,
}

impl Stream {
    /// Reads the bytes that have come, and waits for some where there are none.
    fn read(&mut self, most: u64) -> Read {
        let mut piece = [0; READ_SIZE];
        let Some(pipe) = &mut self.pipe else {
            return Read::Ended;
        };
        match io::Read::read(pipe, &mut piece) {
            Ok(length @ 1..) => {
                self.kept.extend_from_slice(&piece[..length]);
                match length {
                    _ if self.kept.len() as u64 > most => Read::Flooded,
                    READ_SIZE => Read::Full,
                    _ => Read::Short,
                }
            }
            Err(error) if error.kind() == ErrorKind::Interrupted => Read::Short,
            // After an error, the bytes that were read before it are kept.
            Ok(0) | Err(_) => {
                self.pipe = None;
                Read::Ended
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{PipeWriter, Write, pipe};

    /// Returns the streams of a program that has no stderr, and the end of its stdout to which it writes.
    fn streams(most: u64) -> (Streams, PipeWriter) {
        let (reader, writer) = pipe().unwrap();
        let pipes = Pipes {
            stdin: None,
            stdout: Some(OwnedFd::from(reader).into()),
            stderr: None,
        };
        (Streams::of(pipes, most), writer)
    }

    fn kept(streams: &Streams) -> String {
        let [stdout, _] = streams.bytes();
        String::from_utf8(stdout).unwrap()
    }

    #[test]
    fn what_is_written_gathers_before_it_is_read() {
        let (mut streams, mut writer) = streams(1 << 10);
        let mut write_and_look = |piece: &str| {
            writer.write_all(piece.as_bytes()).unwrap();
            assert_eq!(streams.wait(Duration::ZERO), Waited::InVain);
            kept(&streams)
        };
        assert_eq!(write_and_look("a"), "");
        assert_eq!(write_and_look("b"), "ab");
        assert_eq!(write_and_look("c"), "ab");
        assert_eq!(write_and_look("d"), "abcd");
        assert_eq!(write_and_look("e"), "abcd");
        drop(writer);
        assert_eq!(streams.wait(Duration::from_secs(60)), Waited::Ended);
        assert!(!streams.are_open());
        assert_eq!(kept(&streams), "abcde");
    }

    #[test]
    fn a_program_that_writes_much_is_not_held_up() {
        let (mut streams, mut writer) = streams(1 << 20);
        writer.write_all(&[b'x'; 3 * READ_SIZE]).unwrap();
        assert_eq!(streams.wait(Duration::ZERO), Waited::InVain);
        for pieces in 1..=3 {
            assert_eq!(streams.wait(Duration::ZERO), Waited::InVain);
            assert_eq!(kept(&streams).len(), pieces * READ_SIZE);
        }
    }

    #[test]
    fn what_is_more_than_allowed_is_a_flood_although_it_comes_in_short_pieces() {
        let (mut streams, mut writer) = streams(3);
        for _ in 0..4 {
            writer.write_all(b"x").unwrap();
        }
        assert_eq!(streams.wait(Duration::from_secs(60)), Waited::Flooded);
        drop(writer);
    }
}
