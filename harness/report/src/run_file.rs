//! The run that a path names: a folder of reports, an event log, or a `results.json` alone.

use crate::LogError;
use crate::events::{self, Completeness, Reader};
use crate::results::{self, ResultsError};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use stickler_run::{Event, Header};

/// The file from which a run is read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum RunFile {
    /// An event log, which tells all of a run.
    Log(PathBuf),
    /// A `results.json`, which does not tell what was expected of a case that passed.
    Results(PathBuf),
}

/// An error of reading a run.
#[derive(Debug, thiserror::Error)]
pub enum RunFileError {
    /// The file does not exist, or it cannot be read.
    #[error(
        "cannot be read; name a folder of reports, its {}, or a {}",
        events::NAME,
        results::NAME
    )]
    Read(#[from] io::Error),
    /// A folder has neither an event log nor a `results.json`.
    #[error(
        "the folder has neither {} nor {}, so it has no run",
        events::NAME,
        results::NAME
    )]
    NoRun,
    /// The event log cannot be read.
    #[error(transparent)]
    Log(#[from] LogError),
    /// The results cannot be read.
    #[error(transparent)]
    Results(#[from] ResultsError),
    /// The run was cut short.
    #[error("{0}; run its cases again, or leave it out")]
    Truncated(Completeness),
}

/// The number of bytes at the beginning of a file by which an event log is told from a `results.json`.
const START: u64 = 4096;

impl RunFile {
    /// Finds the run at a path. In a folder the event log comes before a `results.json`, since it tells more.
    ///
    /// # Errors
    /// [`RunFileError`] where nothing is there, or a folder without a run.
    pub(crate) fn locate(path: &Path) -> Result<RunFile, RunFileError> {
        if path.is_dir() {
            let [log, results] = [events::NAME, results::NAME].map(|name| path.join(name));
            return match (log.is_file(), results.is_file()) {
                (true, _) => Ok(RunFile::Log(log)),
                (false, true) => Ok(RunFile::Results(results)),
                (false, false) => Err(RunFileError::NoRun),
            };
        }
        let mut start = Vec::new();
        File::open(path)?.take(START).read_to_end(&mut start)?;
        Ok(
            match is_log(&start) || path.extension().is_some_and(|extension| extension == "jsonl") {
                true => RunFile::Log(path.to_owned()),
                false => RunFile::Results(path.to_owned()),
            },
        )
    }

    /// Returns the path of the file.
    pub(crate) fn path(&self) -> &Path {
        match self {
            RunFile::Log(path) | RunFile::Results(path) => path,
        }
    }

    /// Opens the run.
    ///
    /// # Errors
    /// [`RunFileError`] where the file cannot be read; of a `results.json` also where anything in it is not as its schema says.
    pub(crate) fn open(&self) -> Result<RunReader, RunFileError> {
        match self {
            RunFile::Log(path) => Ok(RunReader::Log(Reader::open(path)?)),
            RunFile::Results(path) => Ok(RunReader::Results(Box::new(results::read(path)?.into_events()))),
        }
    }
}

/// Returns whether a file that begins in this way is an event log: its first line is an object with a type.
fn is_log(start: &[u8]) -> bool {
    let start = start.trim_ascii_start();
    start.starts_with(b"{\"type\"")
}

/// A run that is read event by event; the header comes first.
pub trait EventSource: Iterator<Item = Result<Event, LogError>> {
    /// Returns whether the events that were read cover a whole run; meaningful only at the end.
    fn completeness(&self) -> Completeness;

    /// Reads the header.
    ///
    /// # Errors
    /// [`LogError`] where the run does not begin with one.
    fn header(&mut self) -> Result<Header, LogError> {
        match self.next().transpose()? {
            Some(Event::Header(header)) => Ok(header),
            _ => Err(LogError::NoHeader),
        }
    }
}

impl<R: BufRead> EventSource for Reader<R> {
    fn completeness(&self) -> Completeness {
        Reader::completeness(self)
    }
}

/// A reader of either file.
pub(crate) enum RunReader {
    Log(Reader<BufReader<File>>),
    /// The events of a document that was read as a whole.
    Results(Box<dyn Iterator<Item = Event>>),
}

impl Iterator for RunReader {
    type Item = Result<Event, LogError>;

    fn next(&mut self) -> Option<Result<Event, LogError>> {
        match self {
            RunReader::Log(log) => log.next(),
            RunReader::Results(events) => events.next().map(Ok),
        }
    }
}

impl EventSource for RunReader {
    fn completeness(&self) -> Completeness {
        match self {
            RunReader::Log(log) => log.completeness(),
            RunReader::Results(_) => Completeness::Complete,
        }
    }
}
