//! `events.jsonl.gz`: the event stream itself, one JSON object a line, compressed and written while the run goes on.
//!
//! The common properties of the cases of a probe are written once, before the first of them; the line of a case refers to
//! them by a number. What a program asks is written once for the engines and dialects that are asked it one after the other. A log that
//! somebody unpacked is read as well.

mod record;

use crate::groups::{GroupNumber, Groups};
use crate::{LogError, ReportError};
use flate2::Compression;
use flate2::read::MultiGzDecoder;
use flate2::write::GzEncoder;
#[cfg(test)]
pub(crate) use record::LogLine;
use record::{AskedCase, CaseObject, Decoder, GroupLine, PassedLine, RunLine};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fs::File;
use std::io::{self, BufRead, BufReader, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use stickler_run::{Event, FORMAT, Header};

/// The JSON Schema of a line of the log, as it is published.
pub(crate) const SCHEMA: &str = include_str!("../schemas/events.schema.json");

/// The name of the log in a folder of reports.
pub const NAME: &str = "events.jsonl.gz";

/// The first bytes of a compressed file.
const GZIP: &[u8] = b"\x1f\x8b";

/// The number of bytes that are gathered before they are written.
const BATCH: usize = 1 << 16;

/// The maximum time for which an event waits for others, so that the cases of a slow engine appear in its log while it runs.
const FLUSH_INTERVAL: Duration = Duration::from_millis(250);

/// Writes the log. Only whole lines reach the file, so that a run which is cut short leaves a readable log without
/// a footer.
pub struct EventLog {
    path: PathBuf,
    file: GzEncoder<File>,
    encoder: Encoder,
    written: Instant,
}

/// An encoder that turns events into lines.
#[derive(Default)]
struct Encoder {
    groups: Groups,
    /// The question of the last object about a case.
    asked: Option<AskedCase>,
    /// The whole lines that are not written yet.
    lines: Vec<u8>,
}

impl Encoder {
    /// Adds the lines of an event, and returns the group of a case.
    fn encode(&mut self, event: &Event) -> serde_json::Result<Option<GroupNumber>> {
        match event {
            Event::Header(header) => push_line(&mut self.lines, &RunLine::Header(header))?,
            Event::Cause(cause) => push_line(&mut self.lines, &RunLine::Cause(cause))?,
            Event::Footer(footer) => push_line(&mut self.lines, &RunLine::Footer(footer))?,
            Event::Case(case) => {
                let (number, is_new) = self.groups.number(case);
                if is_new {
                    let group = Cow::Borrowed(self.groups.of_number(number));
                    push_line(&mut self.lines, &RunLine::Group(GroupLine { number, group }))?;
                }
                match PassedLine::of(case, number) {
                    Some(passed) => push_line(&mut self.lines, &passed)?,
                    None => push_line(&mut self.lines, &CaseObject::new(case, number, &mut self.asked))?,
                }
                return Ok(Some(number));
            }
        }
        Ok(None)
    }
}

fn push_line(lines: &mut Vec<u8>, record: &impl Serialize) -> serde_json::Result<()> {
    serde_json::to_writer(&mut *lines, record)?;
    lines.push(b'\n');
    Ok(())
}

impl EventLog {
    /// Creates the file, empty.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be created.
    pub fn create(path: PathBuf) -> Result<EventLog, ReportError> {
        let file = File::create(&path).map_err(ReportError::writing(&path))?;
        Ok(EventLog {
            path,
            file: GzEncoder::new(file, Compression::default()),
            encoder: Encoder::default(),
            written: Instant::now(),
        })
    }

    /// Adds one event, and returns the group of a case. The header and the footer reach the file at once, cases in batches.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written; [`ReportError::Serialise`] where the event cannot be
    /// serialised.
    pub(crate) fn take(&mut self, event: &Event) -> Result<Option<GroupNumber>, ReportError> {
        let group = self.encoder.encode(event)?;
        let due = match event {
            Event::Header(_) | Event::Footer(_) => true,
            Event::Case(_) | Event::Cause(_) => {
                self.encoder.lines.len() >= BATCH || self.written.elapsed() >= FLUSH_INTERVAL
            }
        };
        if due {
            self.flush()?;
        }
        Ok(group)
    }

    /// Returns the groups of all cases so far.
    pub(crate) const fn groups(&self) -> &Groups {
        &self.encoder.groups
    }

    /// Writes the lines that were gathered.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written.
    pub fn flush(&mut self) -> Result<(), ReportError> {
        self.file
            .write_all(&self.encoder.lines)
            .and_then(|()| self.file.flush())
            .map_err(ReportError::writing(&self.path))?;
        self.encoder.lines.clear();
        self.written = Instant::now();
        Ok(())
    }
}

/// Returns the path of the log at a path that a person names: the file itself, or the log in a folder of reports.
pub fn locate(path: &Path) -> PathBuf {
    if path.is_dir() {
        path.join(NAME)
    } else {
        path.to_owned()
    }
}

/// A reader of a log, which gives one event at a time; memory holds one line.
///
/// An incomplete last line counts as not written. After an error the reader is at its end.
pub struct Reader<R> {
    input: R,
    line: Vec<u8>,
    decoder: Decoder,
    number: u64,
    promised: u64,
    cases: u64,
    complete: bool,
    ended: bool,
}

/// The text of a log in a file, which is compressed or not.
pub type LogFile<'f> = Box<dyn BufRead + 'f>;

/// Returns the text of a log, which may be compressed.
fn unpacked<'f>(mut packed: impl BufRead + 'f) -> io::Result<LogFile<'f>> {
    match packed.fill_buf()?.starts_with(GZIP) {
        true => Ok(Box::new(BufReader::new(MultiGzDecoder::new(packed)))),
        false => Ok(Box::new(packed)),
    }
}

impl Reader<LogFile<'static>> {
    /// Opens a log.
    ///
    /// # Errors
    /// [`LogError::Read`] where the file cannot be opened.
    pub fn open(path: &Path) -> Result<Reader<LogFile<'static>>, LogError> {
        let file = BufReader::with_capacity(BATCH, File::open(path)?);
        Ok(Reader::new(unpacked(file)?))
    }
}

impl<R: BufRead> Reader<R> {
    /// Creates a reader of a log that begins at the input's position.
    pub fn new(input: R) -> Reader<R> {
        Reader {
            input,
            line: Vec::new(),
            decoder: Decoder::default(),
            number: 0,
            promised: 0,
            cases: 0,
            complete: false,
            ended: false,
        }
    }

    /// Reads the header, which comes first.
    ///
    /// # Errors
    /// [`LogError`] where the log does not begin with one.
    pub fn header(&mut self) -> Result<Header, LogError> {
        match self.next().transpose()? {
            Some(Event::Header(header)) => Ok(header),
            _ => Err(LogError::NoHeader(None)),
        }
    }

    /// Checks that the events that were read cover a whole run; meaningful only at the end.
    ///
    /// # Errors
    /// [`LogError::Truncated`] where they do not.
    pub const fn check_complete(&self) -> Result<(), LogError> {
        match self.complete {
            true => Ok(()),
            false => Err(LogError::Truncated(self.cases)),
        }
    }

    /// Returns the number of the last line that was read, from 1.
    pub(crate) const fn line(&self) -> u64 {
        self.number
    }

    fn event(&mut self) -> Result<Option<Event>, LogError> {
        while let Some(read) = self.read_line()? {
            if read.is_some() {
                return Ok(read);
            }
        }
        Ok(None)
    }

    /// Reads one line; `None` at the end, `Some(None)` where the line is no event.
    fn read_line(&mut self) -> Result<Option<Option<Event>>, LogError> {
        self.line.clear();
        match self.input.read_until(b'\n', &mut self.line) {
            // A machine that died left a compressed log without its end.
            Err(error) if error.kind() != ErrorKind::UnexpectedEof => return Err(error.into()),
            _ => {}
        }
        if self.line.is_empty() {
            return if self.number == 0 {
                Err(LogError::Empty)
            } else {
                Ok(None)
            };
        }
        self.number += 1;
        let line = self.number;
        if line == 1 {
            check_format(&self.line)?;
        }
        match self.decoder.event(&self.line, line) {
            Ok(_) if self.complete => Err(LogError::Misplaced(line)),
            Ok(Some(Event::Header(_))) if line > 1 => Err(LogError::Misplaced(line)),
            Ok(Some(Event::Case(_) | Event::Cause(_) | Event::Footer(_)) | None) if line == 1 => {
                Err(LogError::NoHeader(None))
            }
            Err(LogError::Line { source, .. }) if line == 1 => Err(LogError::NoHeader(Some(source))),
            Ok(Some(event)) => self.count(&event).map(|()| Some(Some(event))),
            Ok(None) => Ok(Some(None)),
            Err(_) if !self.line.ends_with(b"\n") => Ok(None),
            Err(error) => Err(error),
        }
    }

    fn count(&mut self, event: &Event) -> Result<(), LogError> {
        match event {
            Event::Header(header) => self.promised = header.cases,
            Event::Case(_) => self.cases += 1,
            Event::Cause(_) => {}
            Event::Footer(_) if self.cases != self.promised => {
                return Err(LogError::Miscounted {
                    promised: self.promised,
                    cases: self.cases,
                });
            }
            Event::Footer(_) => self.complete = true,
        }
        Ok(())
    }
}

impl<R: BufRead> Iterator for Reader<R> {
    type Item = Result<Event, LogError>;

    fn next(&mut self) -> Option<Result<Event, LogError>> {
        if self.ended {
            return None;
        }
        let event = self.event().transpose();
        self.ended = !matches!(event, Some(Ok(_)));
        event
    }
}

/// The beginning of the first line of a `results.json`; its format follows.
const RESULTS: &[u8] = b"{\"format\":";

/// Checks that a first line does not belong to another file or format.
///
/// # Errors
/// [`LogError::Results`], [`LogError::Earlier`] and [`LogError::Later`].
fn check_format(line: &[u8]) -> Result<(), LogError> {
    if let Some(behind) = line.strip_prefix(RESULTS) {
        let digits = behind.iter().take_while(|byte| byte.is_ascii_digit());
        let format = digits.fold(0, |number: u32, digit| {
            number.saturating_mul(10).saturating_add(u32::from(digit - b'0'))
        });
        return Err(LogError::Results(format));
    }
    // A line that is no header at all is reported when it is parsed.
    match serde_json::from_slice::<FormatVersion>(line) {
        Ok(FormatVersion { format }) if format < FORMAT => Err(LogError::Earlier(format)),
        Ok(FormatVersion { format }) if format > FORMAT => Err(LogError::Later(format)),
        _ => Ok(()),
    }
}

/// Describes a file that is a report of a run, such as `the event log of a run, of format 3`, for messages about a file that
/// is not of the wanted kind; returns `None` for other files.
pub fn recognize(file: &[u8]) -> Option<String> {
    let mut line = Vec::new();
    unpacked(file).ok()?.read_until(b'\n', &mut line).ok()?;
    match (
        check_format(&line),
        serde_json::from_slice::<FormatVersion>(&line),
    ) {
        (Err(LogError::Results(format)), _) => Some(format!("the results.json of a run, of format {format}")),
        (_, Ok(FormatVersion { format })) => Some(format!("the event log of a run, of format {format}")),
        _ => None,
    }
}

/// The version of the format, which the headers of all formats contain.
#[derive(Deserialize)]
struct FormatVersion {
    format: u32,
}

/// Returns the text of a log.
#[cfg(test)]
pub(crate) fn log_of(events: &[Event]) -> Vec<u8> {
    let mut encoder = Encoder::default();
    for event in events {
        encoder.encode(event).expect("JSON");
    }
    encoder.lines
}

#[cfg(test)]
mod tests;
