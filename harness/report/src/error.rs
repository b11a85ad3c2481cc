//! The errors of writing a report and of reading an event log.

use std::io;
use std::path::{Path, PathBuf};
use stickler_run::FORMAT;

/// An error of writing a report.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The folder, or a file in it, cannot be created or written.
    #[error("cannot write {}{}", path.display(), writing_advice(source.kind()))]
    Write {
        /// The path that was to be written.
        path: PathBuf,
        /// The error of the file system.
        source: io::Error,
    },
    /// An event cannot be serialised.
    #[error("cannot serialise an event")]
    Serialise(#[from] serde_json::Error),
}

impl ReportError {
    /// Returns a closure for `map_err` that adds the path to an error.
    pub(crate) fn writing(path: &Path) -> impl Fn(io::Error) -> ReportError + use<> {
        let path = path.to_owned();
        move |source| ReportError::Write {
            path: path.clone(),
            source,
        }
    }
}

/// Returns what to do where a file or folder cannot be written for a reason of this kind; empty for other reasons.
const fn writing_advice(reason: io::ErrorKind) -> &'static str {
    use io::ErrorKind as Kind;
    match reason {
        Kind::PermissionDenied | Kind::ReadOnlyFilesystem => {
            "; make the folder writable, or name another one"
        }
        Kind::StorageFull | Kind::QuotaExceeded | Kind::FileTooLarge => "; make room, or name another folder",
        Kind::NotADirectory | Kind::AlreadyExists | Kind::IsADirectory => {
            "; name another folder, or remove what stands there"
        }
        _ => "",
    }
}

/// An error of reading an event log.
#[derive(Debug, thiserror::Error)]
pub enum LogError {
    /// The input cannot be read.
    #[error("cannot read the event log")]
    Read(#[from] io::Error),
    /// The log contains no line.
    #[error("the event log is empty")]
    Empty,
    /// The first line is not a header.
    #[error("line 1 of the event log is no header, so this is no event log")]
    NoHeader(#[source] Option<serde_json::Error>),
    /// A line before the last one is no event.
    #[error("line {line} of the event log is no event")]
    Line {
        /// The number of the line, from 1.
        line: u64,
        /// The error of parsing the line.
        source: serde_json::Error,
    },
    /// A case, on the line of this number from 1, refers to a group that was not described, or leaves out what it asks although no
    /// case before it asked anything.
    #[error("line {0} of the event log refers to what no line before it describes")]
    Reference(u64),
    /// The line of this number, from 1, follows the footer, or is a second header.
    #[error("line {0} of the event log stands outside its header and footer")]
    Misplaced(u64),
    /// The log has this later version of the format.
    #[error(
        "the event log has format {0}, which a later version of Stickler wrote; this one reads format {FORMAT}"
    )]
    Later(u32),
    /// The log has this earlier version of the format.
    #[error(
        "the event log has format {0}, which an earlier version of Stickler wrote; this one reads format {FORMAT}: run the \
         cases again with this version"
    )]
    Earlier(u32),
    /// The file is a `results.json` of this version of its format.
    #[error(
        "this is a results.json of format {0} and no event log; name its folder, or the events.jsonl.gz beside it"
    )]
    Results(u32),
    /// The log has this many cases and no footer.
    #[error("the run was cut short after {0} cases: its event log has no footer")]
    Truncated(u64),
    /// Lines of the log contradict each other, though each is as the schema says.
    #[error("line {line} of the event log: expected {expected}, found {found}")]
    Contradiction {
        /// The number of the line, from 1.
        line: u64,
        /// The description of what was expected.
        expected: String,
        /// The description of what is there.
        found: String,
    },
    /// The log has a footer, but not all of its cases.
    #[error("the event log promises {promised} cases and holds {cases}, so it is not whole")]
    Miscounted {
        /// The number of cases that the header states.
        promised: u64,
        /// The number of cases in the log.
        cases: u64,
    },
}
