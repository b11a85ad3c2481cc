//! `events.jsonl`: the event stream itself, one JSON object a line, written while the run goes on.

use crate::{LogError, ReportError};
use std::fmt;
use std::fs::File;
use std::io::{BufRead, Write};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use stickler_run::Event;

/// How much is gathered before it is written.
const BATCH: usize = 1 << 16;

/// How long an event waits at most for others: whoever follows the log of a slow engine sees its cases come.
const PATIENCE: Duration = Duration::from_millis(250);

/// Writes the log. Only whole lines reach the file, so that a run which is cut short leaves a readable log without
/// a footer.
pub struct EventLog {
    path: PathBuf,
    file: File,
    batch: Vec<u8>,
    written: Instant,
}

impl EventLog {
    /// Makes the file, empty.
    ///
    /// # Errors
    /// [`ReportError::Write`] where it cannot be made.
    pub fn create(path: PathBuf) -> Result<EventLog, ReportError> {
        let file = File::create(&path).map_err(ReportError::writing(&path))?;
        Ok(EventLog {
            path,
            file,
            batch: Vec::with_capacity(2 * BATCH),
            written: Instant::now(),
        })
    }

    /// Adds one event, as JSON on one line. The header and the footer reach the file at once, cases in batches.
    ///
    /// # Errors
    /// [`ReportError::Write`] where it cannot be written.
    pub fn take(&mut self, event: &Event, json: &[u8]) -> Result<(), ReportError> {
        self.batch.extend_from_slice(json);
        self.batch.push(b'\n');
        let due = match event {
            Event::Header(_) | Event::Footer(_) => true,
            Event::Case(_) => self.batch.len() >= BATCH || self.written.elapsed() >= PATIENCE,
        };
        if due { self.flush() } else { Ok(()) }
    }

    /// Writes what was gathered.
    ///
    /// # Errors
    /// [`ReportError::Write`] where that fails.
    pub fn flush(&mut self) -> Result<(), ReportError> {
        self.file
            .write_all(&self.batch)
            .map_err(ReportError::writing(&self.path))?;
        self.batch.clear();
        self.written = Instant::now();
        Ok(())
    }
}

/// Whether a log tells of a whole run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use = "a truncated run must be called truncated"]
pub enum Completeness {
    /// The footer is there.
    Complete,
    /// The footer is missing: the run was cut short after so many cases.
    Truncated {
        /// How many cases the log holds.
        cases: u64,
    },
}

impl fmt::Display for Completeness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Completeness::Complete => f.write_str("the run is complete"),
            Completeness::Truncated { cases } => {
                write!(
                    f,
                    "the run was cut short after {cases} cases: its event log has no footer"
                )
            }
        }
    }
}

/// Reads a log and hands each event on, in order.
///
/// A last line that is only partly there counts as not written. Memory holds one line at a time.
///
/// # Errors
/// [`LogError`] where the input is no event log, or a line in its middle is no event.
pub fn read(mut input: impl BufRead, sink: &mut dyn FnMut(Event)) -> Result<Completeness, LogError> {
    let mut line = Vec::new();
    let mut number = 0;
    let mut cases = 0;
    let mut complete = false;
    while input.read_until(b'\n', &mut line)? > 0 {
        number += 1;
        match serde_json::from_slice::<Event>(&line) {
            Ok(_) if complete => return Err(LogError::Misplaced { line: number }),
            Ok(Event::Header(_)) if number > 1 => return Err(LogError::Misplaced { line: number }),
            Ok(Event::Case(_) | Event::Footer(_)) | Err(_) if number == 1 => return Err(LogError::NoHeader),
            Ok(event) => {
                cases += u64::from(matches!(event, Event::Case(_)));
                complete = matches!(event, Event::Footer(_));
                sink(event);
            }
            Err(_) if !line.ends_with(b"\n") => break,
            Err(source) => return Err(LogError::Line { line: number, source }),
        }
        line.clear();
    }
    match (number, complete) {
        (0, _) => Err(LogError::Empty),
        (_, true) => Ok(Completeness::Complete),
        (_, false) => Ok(Completeness::Truncated { cases }),
    }
}

#[cfg(test)]
mod tests {
    use super::{Completeness, EventLog, read};
    use crate::{LogError, sample};
    use std::fs;
    use stickler_run::Event;

    fn written(events: &[Event]) -> Vec<u8> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("events.jsonl");
        let mut log = EventLog::create(path.clone()).expect("a log");
        for event in events {
            log.take(event, &serde_json::to_vec(event).expect("JSON"))
                .expect("taken");
        }
        log.flush().expect("flushed");
        fs::read(path).expect("the log")
    }

    fn read_back(bytes: &[u8]) -> Result<(Vec<Event>, Completeness), LogError> {
        let mut events = Vec::new();
        let completeness = read(bytes, &mut |event| events.push(event))?;
        Ok((events, completeness))
    }

    #[test]
    fn what_is_written_is_read_back() {
        let run = sample::run();
        let (events, completeness) = read_back(&written(&run)).expect("a log");
        assert_eq!(events, run);
        assert_eq!(completeness, Completeness::Complete);
    }

    #[test]
    fn a_log_without_its_footer_is_called_truncated() {
        let run = sample::run();
        let bytes = written(&run[..run.len() - 1]);
        let (events, completeness) = read_back(&bytes).expect("a log");
        assert_eq!(events.len(), run.len() - 1);
        assert_eq!(
            completeness,
            Completeness::Truncated {
                cases: run.len() as u64 - 2
            }
        );
        assert!(completeness.to_string().contains("cut short"));
    }

    #[test]
    fn a_half_written_last_line_counts_as_not_written() {
        let run = sample::run();
        let bytes = written(&run);
        let (events, completeness) = read_back(&bytes[..bytes.len() - 10]).expect("a log");
        assert_eq!(events.len(), run.len() - 1);
        assert!(matches!(completeness, Completeness::Truncated { .. }));
    }

    #[test]
    fn what_is_no_log_is_told_from_a_broken_one() {
        assert!(matches!(read_back(b""), Err(LogError::Empty)));
        assert!(matches!(read_back(b"hello\n"), Err(LogError::NoHeader)));
        let mut bytes = written(&sample::run()[..2]);
        bytes.extend_from_slice(b"{}\n");
        assert!(matches!(read_back(&bytes), Err(LogError::Line { line: 3, .. })));
        let mut twice = written(&sample::run());
        twice.extend(written(&sample::run()));
        assert!(matches!(read_back(&twice), Err(LogError::Misplaced { .. })));
    }
}
