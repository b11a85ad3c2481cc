//! Merges the parts of a divided run into the stream of events of the whole run.
//!
//! Missing parts are reported in sentences, and then the stream has no footer: every reader calls it truncated, and nobody
//! takes it for the whole. The parts are read side by side; memory holds one event of each.

use crate::LogError;
use crate::events::Reader;
use std::io::BufRead;
use stickler_run::{CaseEvent, Cause, EngineHeader, EngineTotals, Event, Footer, Header};
use stickler_types::join;
use stickler_workers::Shard;

/// The event log of one part of a run, with the name that messages use for it.
pub struct RunPart<R> {
    /// The name of the part, such as its folder's.
    pub name: String,
    /// The unread log of the part, or the error of opening it.
    pub log: Result<Reader<R>, LogError>,
}

/// Merges the parts of a run, and passes each event on. Cases come by file, in the order of the suite; the cases of one file
/// come part by part.
///
/// Merging never fails: everything that is missing, cut short or unreadable is described by a sentence of the returned list.
/// Where there is any, the stream has no footer, and where no part can be read it is empty. `command` becomes the command in
/// the header.
#[must_use = "what is missing must be said"]
pub fn merge<R: BufRead>(parts: Vec<RunPart<R>>, command: &str, sink: &mut dyn FnMut(Event)) -> Vec<String> {
    let mut missing = Vec::new();
    let (whole, mut streams) = open(parts, &mut missing);
    let Some(header) = whole else {
        return missing;
    };
    let cases = streams.iter().map(|stream| stream.header.cases).sum();
    let started = streams.iter().map(|stream| stream.header.started.as_str()).min();
    let mut defined = header.defined.clone();
    for dialect in &mut defined {
        let of_parts = streams.iter().flat_map(|stream| &stream.header.defined);
        let same = of_parts.filter(|other| other.name == dialect.name);
        dialect.left_out = same.map(|other| other.left_out).sum();
    }
    sink(Event::Header(Header {
        cases,
        defined,
        started: started.unwrap_or_default().to_owned(),
        command: command.to_owned(),
        shard: None,
        ..header.clone()
    }));
    streams.iter_mut().for_each(PartReader::advance);
    while let Some(next) = first_by_file(&mut streams) {
        if let Some(case) = next.case.take() {
            sink(Event::Case(case));
        }
        next.advance();
    }
    missing.extend(streams.iter().filter_map(|stream| stream.trouble.clone()));
    for cause in causes(&mut streams) {
        sink(Event::Cause(cause));
    }
    if missing.is_empty() {
        sink(Event::Footer(footer(&header, &streams)));
    }
    missing
}

/// Opens the parts, and returns the header that all of them share but for the part, and those parts that belong to that run,
/// each once, in their order.
fn open<R: BufRead>(
    parts: Vec<RunPart<R>>,
    missing: &mut Vec<String>,
) -> (Option<Header>, Vec<PartReader<R>>) {
    let mut first: Option<(Header, u32, String)> = None;
    let mut streams: Vec<PartReader<R>> = Vec::with_capacity(parts.len());
    for RunPart { name, log } in parts {
        let read = log.and_then(|mut reader| reader.header().map(|header| (reader, header)));
        let (reader, header) = match read {
            Ok(read) => read,
            Err(error) => {
                missing.push(format!("{name} cannot be read: {}", describe_error(&error)));
                continue;
            }
        };
        let shard = match shard(&header) {
            Ok(shard) => shard,
            Err(reason) => {
                missing.push(format!("{name} {reason}"));
                continue;
            }
        };
        let (whole, count, named) =
            first.get_or_insert_with(|| (header.clone(), shard.count(), name.clone()));
        if let Some(difference) = difference((whole, *count), (&header, shard.count())) {
            missing.push(format!(
                "{name} is no part of the same run as {named}: {difference}"
            ));
        } else if let Some(other) = streams.iter().find(|other| other.shard == shard) {
            missing.push(format!(
                "part {shard} is there more than once: {} and {name}",
                other.name
            ));
        } else {
            streams.push(PartReader {
                name,
                reader,
                shard,
                header,
                case: None,
                causes: Vec::new(),
                footer: None,
                trouble: None,
            });
        }
    }
    streams.sort_by_key(|stream| stream.shard.index());
    let there: Vec<u32> = streams.iter().map(|stream| stream.shard.index()).collect();
    let count = first.as_ref().map_or(0, |(_, count, _)| *count);
    absent(&there, count, missing);
    (first.map(|(header, ..)| header), streams)
}

/// Formats an error and its causes in one line.
pub(crate) fn describe_error(error: &dyn std::error::Error) -> String {
    let causes = std::iter::successors(Some(error), |error| error.source());
    join(causes, ": ")
}

/// A part of a run while it is read.
struct PartReader<R> {
    name: String,
    reader: Reader<R>,
    shard: Shard,
    header: Header,
    /// The next case of the part.
    case: Option<CaseEvent>,
    /// The causes that the part found.
    causes: Vec<Cause>,
    footer: Option<Footer>,
    /// The reason why the part is incomplete.
    trouble: Option<String>,
}

impl<R> PartReader<R> {
    /// Returns the file of the next case.
    fn file(&self) -> Option<&str> {
        self.case.as_ref().map(|case| case.file.as_str())
    }
}

impl<R: BufRead> PartReader<R> {
    /// Reads the next case, or to the end.
    fn advance(&mut self) {
        let name = format!("part {} ({})", self.shard, self.name);
        loop {
            match self.reader.next() {
                Some(Ok(Event::Case(case))) => {
                    if !self.shard.holds_case(&case.id, &case.dialect) {
                        self.trouble = Some(format!("{name} holds {}, which is another part's", case.id));
                    }
                    self.case = Some(case);
                    return;
                }
                Some(Ok(Event::Cause(cause))) => self.causes.push(cause),
                Some(Ok(Event::Footer(footer))) => self.footer = Some(footer),
                // The reader rejects a second header.
                Some(Ok(Event::Header(_))) => {}
                Some(Err(error)) => {
                    self.trouble = Some(format!(
                        "{name} cannot be read to its end: {}",
                        describe_error(&error)
                    ));
                    return;
                }
                None => {
                    if let Err(truncated) = self.reader.check_complete() {
                        self.trouble.get_or_insert_with(|| format!("{name}: {truncated}"));
                    }
                    return;
                }
            }
        }
    }
}

/// Returns the part whose next case comes first; the suite is sorted by file. Of parts at the same file the first is
/// returned.
fn first_by_file<R>(streams: &mut [PartReader<R>]) -> Option<&mut PartReader<R>> {
    let waiting = streams.iter_mut().filter(|stream| stream.case.is_some());
    waiting.min_by(|one, other| one.file().cmp(&other.file()))
}

/// Merges the causes of all parts, those that explain most cases first.
fn causes<R>(streams: &mut [PartReader<R>]) -> Vec<Cause> {
    let mut whole: Vec<Cause> = Vec::new();
    for cause in streams.iter_mut().flat_map(|stream| stream.causes.drain(..)) {
        match whole.iter_mut().find(|one| one.is_same(&cause)) {
            Some(one) => one.merge(cause),
            None => whole.push(cause),
        }
    }
    whole.sort_by_key(|cause| std::cmp::Reverse(cause.number()));
    whole
}

/// Adds the footers up. Parts run side by side, so the whole run took as long as the longest of them.
fn footer<R>(header: &Header, streams: &[PartReader<R>]) -> Footer {
    let mut whole = Footer {
        engines: header
            .engines
            .iter()
            .map(|engine| EngineTotals {
                name: engine.name.clone(),
                ..EngineTotals::default()
            })
            .collect(),
        ..Footer::default()
    };
    for part in streams.iter().filter_map(|stream| stream.footer.as_ref()) {
        whole.totals += part.totals;
        whole.duration_ms = whole.duration_ms.max(part.duration_ms);
        whole.causes_ms = whole.causes_ms.max(part.causes_ms);
        for engine in &mut whole.engines {
            let same = part.engines.iter().find(|other| other.name == engine.name);
            engine.totals += same.map(|other| other.totals).unwrap_or_default();
        }
    }
    whole
}

#[cfg(test)]
mod tests;

/// The maximum number of missing parts that are named one by one.
const MAX_NAMED: usize = 20;

/// Returns the part of a run that a header describes.
///
/// # Errors
/// Returns the rest of a sentence about the part where its header describes none.
fn shard(header: &Header) -> Result<Shard, String> {
    match &header.shard {
        None => Err("is a whole run, and no part of one".to_owned()),
        Some(text) => text.parse().map_err(|error| format!("cannot be used: {error}")),
    }
}

/// Describes the first difference between two parts, each given with the number of parts; `None` where they belong to one
/// run.
fn difference((one, parts): (&Header, u32), (other, other_parts): (&Header, u32)) -> Option<String> {
    let differs = |what: &str, here: &str, there: &str| {
        (here != there).then(|| format!("its {what} is {there}, and that of the other {here}"))
    };
    differs("number of parts", &parts.to_string(), &other_parts.to_string())
        .or_else(|| differs("version of Stickler", &one.stickler, &other.stickler))
        .or_else(|| differs("version of the suite", &one.suite, &other.suite))
        .or_else(|| differs("list of engines", &engines(one), &engines(other)))
        .or_else(|| differs("--filter", &list(&one.filters), &list(&other.filters)))
        .or_else(|| differs("--dialect", &list(&one.dialects), &list(&other.dialects)))
        .or_else(|| {
            (one.broken_files != other.broken_files).then(|| "other case files are broken in it".to_owned())
        })
        .or_else(|| {
            (rules(one) != rules(other)).then(|| "stickler.toml defines its dialects otherwise".to_owned())
        })
        .or_else(|| {
            (one.baselines != other.baselines).then(|| "its baselines are not those of the other".to_owned())
        })
}

/// Returns the definitions of custom dialects without the numbers of dropped cases, which may differ from part to part.
fn rules(header: &Header) -> Vec<(&str, &str, &[String])> {
    let defined = header.defined.iter();
    defined
        .map(|dialect| (&*dialect.name, &*dialect.extends, &*dialect.overrides))
        .collect()
}

fn engines(header: &Header) -> String {
    let named = |engine: &EngineHeader| {
        format!(
            "{} {} judged by {}, in {}",
            engine.name,
            engine.version,
            engine.strict,
            engine.dialects.join(" ")
        )
    };
    join(header.engines.iter().map(named), "; ")
}

fn list(words: &[String]) -> String {
    match words {
        [] => "not given".to_owned(),
        words => words.join(", "),
    }
}

/// Describes the missing parts of so many.
fn absent(there: &[u32], count: u32, missing: &mut Vec<String>) {
    let mut absent = (1..=count).filter(|part| !there.contains(part));
    for part in absent.by_ref().take(MAX_NAMED) {
        missing.push(format!("part {part}/{count} is missing"));
    }
    // A hostile number of parts must not make as many sentences.
    if let Some(part) = absent.next() {
        missing.push(format!("part {part}/{count} is missing, and so may be others"));
    }
}
