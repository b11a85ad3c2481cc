//! What can go wrong when a report is written or an event log is read.

use std::io;
use std::path::{Path, PathBuf};
use stickler_run::FORMAT;

/// A report that could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The folder, or a file in it, cannot be made or written.
    #[error("cannot write {}", path.display())]
    Write {
        /// What was to be written.
        path: PathBuf,
        /// Why not.
        source: io::Error,
    },
    /// An event does not serialise.
    #[error("cannot serialise an event")]
    Serialise(#[from] serde_json::Error),
}

impl ReportError {
    /// A closure for `map_err` that remembers which file it was.
    pub(crate) fn writing(path: &Path) -> impl Fn(io::Error) -> ReportError + use<> {
        let path = path.to_owned();
        move |source| ReportError::Write {
            path: path.clone(),
            source,
        }
    }
}

/// Returns what else is to be done about a file of an earlier format.
fn again(format: u32) -> &'static str {
    match format {
        0..FORMAT => {
            "; an earlier version of Stickler wrote it, so run the cases again with this version first"
        }
        _ => "",
    }
}

/// An event log that could not be read.
#[derive(Debug, thiserror::Error)]
pub enum LogError {
    /// Reading failed.
    #[error("cannot read the event log")]
    Read(#[from] io::Error),
    /// The log holds no line at all.
    #[error("the event log is empty")]
    Empty,
    /// The first line is not a header.
    #[error("line 1 of the event log is no header, so this is no event log")]
    NoHeader,
    /// A line in the middle is no event.
    #[error("line {line} of the event log is no event")]
    Line {
        /// The line, from 1.
        line: u64,
        /// What is wrong with it.
        source: serde_json::Error,
    },
    /// A case names a group that was not described.
    #[error("line {line} of the event log names a group of cases that no line before it describes")]
    Group {
        /// The line, from 1.
        line: u64,
    },
    /// Something follows the footer, or a second header.
    #[error("line {line} of the event log stands outside its header and footer")]
    Misplaced {
        /// The line, from 1.
        line: u64,
    },
    /// The header belongs to a later version of the format.
    #[error(
        "the event log has format {format}, which a later version of Stickler wrote; this one reads format {FORMAT}"
    )]
    Later {
        /// Its format.
        format: u32,
    },
    /// The header belongs to an earlier version of the format.
    #[error(
        "the event log has format {format}, which an earlier version of Stickler wrote; this one reads format {FORMAT}: run the \
         cases again with this version"
    )]
    Earlier {
        /// Its format.
        format: u32,
    },
    /// The file is a `results.json`.
    #[error(
        "this is a results.json of format {format} and no event log; name its folder, or the events.jsonl beside it{}",
        again(*format)
    )]
    Results {
        /// Its format.
        format: u32,
    },
    /// The footer is there, and cases are not.
    #[error("the event log promises {promised} cases and holds {cases}, so it is not whole")]
    Miscounted {
        /// What its header says.
        promised: u64,
        /// What is there.
        cases: u64,
    },
}
