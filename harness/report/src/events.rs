//! `events.jsonl`: the event stream itself, one JSON object a line, written while the run goes on.
//!
//! The common properties of the cases of a probe are written once, before the first of them; the line of a case refers to
//! them by a number.

mod record;

use crate::groups::{GroupNumber, Groups};
use crate::{LogError, ReportError};
use record::{CaseObject, Decoder, GroupLine, PassedLine, RunLine};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;
use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use stickler_run::{Event, FORMAT};

/// The name of the log in a folder of reports.
pub const NAME: &str = "events.jsonl";

/// The number of bytes that are gathered before they are written.
const BATCH: usize = 1 << 16;

/// The maximum time for which an event waits for others, so that the cases of a slow engine appear in its log while it runs.
const FLUSH_INTERVAL: Duration = Duration::from_millis(250);

/// Writes the log. Only whole lines reach the file, so that a run which is cut short leaves a readable log without
/// a footer.
pub struct EventLog {
    path: PathBuf,
    file: File,
    encoder: Encoder,
    written: Instant,
}

/// An encoder that turns events into lines.
#[derive(Default)]
struct Encoder {
    groups: Groups,
    /// The whole lines that are not written yet.
    lines: Vec<u8>,
}

impl Encoder {
    /// Adds the lines of an event, and returns the group of a case.
    fn encode(&mut self, event: &Event) -> serde_json::Result<Option<GroupNumber>> {
        match event {
            Event::Header(header) => self.line(&RunLine::Header(Cow::Borrowed(header)))?,
            Event::Cause(cause) => self.line(&RunLine::Cause(Box::new(Cow::Borrowed(cause))))?,
            Event::Footer(footer) => self.line(&RunLine::Footer(Cow::Borrowed(footer)))?,
            Event::Case(case) => {
                let (number, is_new) = self.groups.number(case);
                if is_new {
                    let group = &self.groups.all()[number];
                    push_line(&mut self.lines, &RunLine::Group(GroupLine::new(number, group)))?;
                }
                match PassedLine::of(case, number) {
                    Some(passed) => self.line(&passed)?,
                    None => self.line(&CaseObject::new(case, number))?,
                }
                return Ok(Some(number));
            }
        }
        Ok(None)
    }

    fn line(&mut self, record: &impl Serialize) -> serde_json::Result<()> {
        push_line(&mut self.lines, record)
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
            file,
            encoder: Encoder::default(),
            written: Instant::now(),
        })
    }

    /// Adds one event. The header and the footer reach the file at once, cases in batches.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the file cannot be written; [`ReportError::Serialise`] where the event cannot be
    /// serialised.
    pub fn take(&mut self, event: &Event) -> Result<(), ReportError> {
        self.take_case(event).map(|_| ())
    }

    /// Adds one event, and returns the group of a case.
    pub(crate) fn take_case(&mut self, event: &Event) -> Result<Option<GroupNumber>, ReportError> {
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
            .map_err(ReportError::writing(&self.path))?;
        self.encoder.lines.clear();
        self.written = Instant::now();
        Ok(())
    }
}

/// Whether a log covers a whole run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use = "a truncated run must be called truncated"]
pub enum Completeness {
    /// The log has a footer.
    Complete,
    /// The log has no footer: the run was cut short after so many cases.
    Truncated {
        /// The number of cases in the log.
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

impl Reader<BufReader<File>> {
    /// Opens a log.
    ///
    /// # Errors
    /// [`LogError::Read`] where the file cannot be opened.
    pub fn open(path: &Path) -> Result<Reader<BufReader<File>>, LogError> {
        Ok(Reader::new(BufReader::with_capacity(BATCH, File::open(path)?)))
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

    /// Returns whether the events that were read cover a whole run; meaningful only at the end.
    pub const fn completeness(&self) -> Completeness {
        match self.complete {
            true => Completeness::Complete,
            false => Completeness::Truncated { cases: self.cases },
        }
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
        if self.input.read_until(b'\n', &mut self.line)? == 0 {
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
            Ok(_) if self.complete => Err(LogError::Misplaced { line }),
            Ok(Some(Event::Header(_))) if line > 1 => Err(LogError::Misplaced { line }),
            Ok(Some(Event::Case(_) | Event::Cause(_) | Event::Footer(_)) | None) | Err(_) if line == 1 => {
                Err(LogError::NoHeader)
            }
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
pub(crate) fn check_format(line: &[u8]) -> Result<(), LogError> {
    if let Some(behind) = line.strip_prefix(RESULTS) {
        let digits = behind.iter().take_while(|byte| byte.is_ascii_digit());
        let format = digits.fold(0, |number: u32, digit| {
            number.saturating_mul(10).saturating_add(u32::from(digit - b'0'))
        });
        return Err(LogError::Results { format });
    }
    // A line that is no header at all is reported when it is parsed.
    match serde_json::from_slice::<Format>(line) {
        Ok(Format { format }) if format < FORMAT => Err(LogError::Earlier { format }),
        Ok(Format { format }) if format > FORMAT => Err(LogError::Later { format }),
        _ => Ok(()),
    }
}

/// Describes a text that is a report of a run, such as `the event log of a run, of format 3`, for messages about a file that
/// is not of the wanted kind; returns `None` for other texts.
pub fn recognize(text: &[u8]) -> Option<String> {
    let line = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    match (check_format(line), serde_json::from_slice::<Format>(line)) {
        (Err(LogError::Results { format }), _) => {
            Some(format!("the results.json of a run, of format {format}"))
        }
        (_, Ok(Format { format })) => Some(format!("the event log of a run, of format {format}")),
        _ => None,
    }
}

/// The version of the format, which the headers of all formats contain.
#[derive(Deserialize)]
struct Format {
    format: u32,
}

/// Reads a log and passes each event on, in order.
///
/// # Errors
/// [`LogError`] where the input is no event log, or a line in its middle is no event.
pub fn read(input: impl BufRead, sink: &mut dyn FnMut(Event)) -> Result<Completeness, LogError> {
    let mut reader = Reader::new(input);
    for event in &mut reader {
        sink(event?);
    }
    Ok(reader.completeness())
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
mod tests {
    use super::{Completeness, EventLog, log_of, read, recognize};
    use crate::{LogError, sample};
    use std::fs;
    use stickler_run::{CaseEvent, Event, FORMAT, Verdict};

    fn written(events: &[Event]) -> Vec<u8> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("events.jsonl");
        let mut log = EventLog::create(path.clone()).expect("a log");
        for event in events {
            log.take(event).expect("taken");
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
        assert!(matches!(read_back(&bytes), Err(LogError::Line { line: 4, .. })));
        let mut twice = written(&sample::run());
        twice.extend(written(&sample::run()));
        assert!(matches!(read_back(&twice), Err(LogError::Misplaced { .. })));
    }

    #[test]
    fn what_cases_have_in_common_is_written_once_and_a_passed_case_on_a_short_line() {
        let cases = ["a::p(1)", "a::p(2)"].map(|id| sample::case(id, Verdict::Pass));
        let text = String::from_utf8(log_of(&sample::run_of(cases.to_vec()))).expect("text");
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 5, "{text}");
        assert!(
            lines[1].starts_with(r#"{"type":"group","number":0,"group":{"id":"widening/a::p","#),
            "{text}"
        );
        assert_eq!(lines[3], r#"[0,"(2)",12,305419896]"#);
    }

    #[test]
    fn a_passed_case_that_has_more_to_tell_is_written_whole() {
        let case = sample::case("a", Verdict::Pass);
        let of_baseline = CaseEvent {
            baseline: Some(sample::baseline_note()),
            ..case.clone()
        };
        let with_line = CaseEvent {
            line: Some(7),
            ..case
        };
        let run = sample::run_of(vec![of_baseline, sample::open_case("b"), with_line]);
        assert_eq!(read_back(&log_of(&run)).expect("a log").0, run);
    }

    #[test]
    fn a_case_whose_group_is_not_described_is_no_case() {
        let text = String::from_utf8(log_of(&sample::run())).expect("text");
        let without: String = text
            .lines()
            .filter(|line| !line.contains("group\":{"))
            .map(|l| format!("{l}\n"))
            .collect();
        let error = read_back(without.as_bytes()).expect_err("no group");
        assert!(matches!(error, LogError::Group { line: 2 }), "{error}");
    }

    #[test]
    fn a_log_out_of_which_a_case_was_lost_is_broken_though_its_footer_is_there() {
        let mut events = sample::run();
        events.remove(2);
        let error = read_back(&written(&events)).expect_err("a case is missing");
        assert!(matches!(
            error,
            LogError::Miscounted {
                promised: 4,
                cases: 3
            }
        ));
    }

    #[test]
    fn a_log_of_a_later_format_is_not_guessed_at() {
        let mut events = sample::run();
        if let Event::Header(header) = &mut events[0] {
            header.format = FORMAT + 1;
        }
        let error = read_back(&written(&events)).expect_err("another format");
        assert!(matches!(error, LogError::Later { format } if format == FORMAT + 1));
    }

    #[test]
    fn an_earlier_format_and_the_wrong_file_are_named_with_what_to_do() {
        let read = |text: &str| read_back(text.as_bytes()).expect_err("no such log").to_string();
        let log = "{\"type\":\"header\",\"format\":1,\"stickler\":\"0.1.0\",\"cases\":1}\n\
                   {\"type\":\"case\",\"id\":\"a\",\"expected\":\"accepted\"}\n";
        let reported = read(log);
        assert!(
            reported.contains("format 1") && reported.ends_with("run the cases again with this version"),
            "{reported}"
        );
        let reported = read("{\"format\":1,\n\"stickler\":\"0.1.0\"}\n");
        assert!(
            reported.contains("results.json of format 1") && reported.contains("run the cases again"),
            "{reported}"
        );
        assert_eq!(
            recognize(log.as_bytes()).as_deref(),
            Some("the event log of a run, of format 1")
        );
        assert_eq!(recognize(b"results[0] := 5;\n"), None);
        let reported = read("{\"format\":2,\n\"stickler\":\"0.1.0\"}\n");
        assert!(
            reported.ends_with("name its folder, or the events.jsonl beside it"),
            "{reported}"
        );
    }
}
