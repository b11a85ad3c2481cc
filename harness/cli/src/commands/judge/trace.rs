//! Traces: the inputs and the clock of a program by scan, and the values that must come out, read from JSON or CSV.

use super::caller::Judged;
use super::result::Expected;
use super::variables::Variables;
use crate::source_file::place;
use anyhow::{Context, anyhow, bail, ensure};
use serde::Deserialize;
use serde_json::{Map, Value as Json};
use std::fs;
use std::path::Path;
use stickler_types::{ClockSetting, Setting, Value};

/// The longest trace, in scans.
const MAX_SCANS: usize = 1_000_000;

/// The start of the header of a CSV column with expected values.
const EXPECTED: &str = "expect ";

/// A trace as it is written: variables with a value for each scan, or one for all.
#[derive(Deserialize, Debug, Default)]
#[serde(deny_unknown_fields, default)]
pub(super) struct Trace {
    /// The name to show, empty where the trace has none.
    pub name: String,
    /// The values that are set once, before the first scan.
    pub start: Map<String, Json>,
    /// The values that are set before each scan.
    pub inputs: Map<String, Json>,
    /// The times since the start, as literals; none where `--cycle` says how much passes.
    pub clock: Vec<String>,
    /// The values that must come out after each scan.
    pub expected: Map<String, Json>,
    /// The greatest difference of a real number from the expected one; `None` takes that of the command line.
    pub tolerance: Option<f64>,
}

/// A trace in the terms of a program.
pub(super) struct Request {
    /// The number of scans.
    pub scans: u32,
    /// The times of the scans; none where no time passes.
    pub clock: Vec<ClockSetting>,
    /// The variables to set.
    pub set: Vec<Setting>,
    /// The values that must come out, in the order of the scans.
    pub expected: Vec<Expected>,
}

impl Trace {
    /// Returns the trace in the terms of a program; `cycle` nanoseconds pass from scan to scan where the trace has no clock.
    ///
    /// # Errors
    /// A variable that the program does not have, a value that is none of its type, and what [`Trace::scans`] and
    /// [`Trace::clock`] find.
    pub(super) fn request(
        &self,
        judged: &Judged,
        variables: &Variables,
        cycle: Option<i64>,
    ) -> anyhow::Result<Request> {
        let scans = self.scans()?;
        let mut request = Request {
            scans,
            clock: self.clock(scans, cycle)?,
            set: Vec::new(),
            expected: Vec::new(),
        };
        let setting = |before: u32| move |(name, value)| Setting { before, name, value };
        for (name, given) in &self.start {
            let found = variables.spread(judged, name, given)?;
            request.set.extend(found.into_iter().map(setting(1)));
        }
        for scan in 1..=scans {
            let of_scan = |(name, column): (&String, &Json)| {
                let given = at(column, scan)?;
                let found = variables.spread(judged, name, given);
                Some(found.with_context(|| format!("scan {scan}")))
            };
            for found in self.inputs.iter().filter_map(of_scan) {
                request.set.extend(found?.into_iter().map(setting(scan)));
            }
            for found in self.expected.iter().filter_map(of_scan) {
                request
                    .expected
                    .extend(found?.into_iter().map(|(path, value)| Expected {
                        scan,
                        name: judged.shown(&path),
                        path,
                        value,
                    }));
            }
        }
        ensure!(
            !request.expected.is_empty(),
            "the trace expects nothing: `expected`, or a column `expect NAME`, says what must come out"
        );
        Ok(request)
    }

    /// Returns the number of scans: the length of all lists, of which there must be one.
    ///
    /// # Errors
    /// No list, lists of different lengths, or one beyond [`MAX_SCANS`].
    fn scans(&self) -> anyhow::Result<u32> {
        let columns = self.inputs.iter().chain(&self.expected);
        let lists = columns.filter_map(|(name, column)| Some((name.as_str(), column.as_array()?.len())));
        let clock = Some(("clock", self.clock.len())).filter(|(_, length)| *length > 0);
        let lists: Vec<(&str, usize)> = clock.into_iter().chain(lists).collect();
        let longest = lists.iter().copied().max_by_key(|(_, length)| *length);
        let (name, scans) = longest.context("no variable has a list of values, one for each scan")?;
        // What a scan expects must not be lost because a list ends before it.
        if let Some((other, fewer)) = lists.iter().find(|(_, length)| *length < scans) {
            bail!(
                "the list of `{other}` has {fewer} values and that of `{name}` {scans}: each has one for each scan, null where there is none"
            );
        }
        ensure!(
            (1..=MAX_SCANS).contains(&scans),
            "a trace has 1 to {MAX_SCANS} scans, and not {scans}"
        );
        Ok(u32::try_from(scans)?)
    }

    /// Returns the times of the trace, or those of scans that are `cycle` nanoseconds apart.
    ///
    /// # Errors
    /// A text that is no time, or a time before the one of the scan before.
    fn clock(&self, scans: u32, cycle: Option<i64>) -> anyhow::Result<Vec<ClockSetting>> {
        if self.clock.is_empty() {
            return Ok(cycle.map_or_else(Vec::new, |cycle| ClockSetting::each(cycle, scans)));
        }
        let mut settings: Vec<ClockSetting> = Vec::with_capacity(self.clock.len());
        for (before, text) in (1..).zip(&self.clock) {
            let time = Value::parse(text).ok();
            let Some(setting) = time.and_then(|time| ClockSetting::at(before, &time)) else {
                bail!("scan {before}: the clock `{text}` is no time such as T#10ms");
            };
            let goes_back = settings
                .last()
                .is_some_and(|last| last.nanoseconds > setting.nanoseconds);
            ensure!(
                !goes_back && setting.nanoseconds >= 0,
                "scan {before}: the clock goes back to {text}; times count from the start of the program"
            );
            settings.push(setting);
        }
        Ok(settings)
    }
}

/// Returns the value of a variable for a scan, from 1: that of the list, or the one for all scans; `None` where there is none.
fn at(column: &Json, scan: u32) -> Option<&Json> {
    let value = match column {
        Json::Array(values) => values.get(scan as usize - 1)?,
        constant => constant,
    };
    (!value.is_null()).then_some(value)
}

/// Reads the traces of a file: of `.csv` one, of any other name JSON with one trace or a list of them.
///
/// # Errors
/// A file that cannot be read, or that holds no traces.
pub(super) fn read(path: &Path) -> anyhow::Result<Vec<Trace>> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let place_of = |(line, column)| format!("{}:{line}:{column}", path.display());
    let text = str::from_utf8(&bytes).map_err(|error| {
        let place = place_of(place(&bytes[..error.valid_up_to()]));
        anyhow!("{place}: a trace is text in UTF-8, and this byte is none")
    })?;
    let is_csv = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
    let read = match is_csv {
        true => table(text).map(|trace| vec![trace]),
        false if text.trim_start().starts_with('[') => serde_json::from_str(text).map_err(of_json),
        false => serde_json::from_str(text)
            .map(|trace| vec![trace])
            .map_err(of_json),
    };
    let traces = read.map_err(|(place, message)| anyhow!("{}: {message}", place_of(place)))?;
    ensure!(
        !traces.is_empty(),
        "{}: the list of traces is empty",
        path.display()
    );
    Ok(traces)
}

/// A mistake in the text of a trace: its line and column, and what is wrong there.
type Misreading = ((usize, usize), String);

fn of_json(error: serde_json::Error) -> Misreading {
    let (place, message) = ((error.line(), error.column()), error.to_string());
    let behind = format!(" at line {} column {}", place.0, place.1);
    (place, message.replace(&behind, ""))
}

fn of_csv(error: csv::Error) -> Misreading {
    let line = error.position().map_or(1, |position| position.line() as usize);
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => {
            format!("the first row has {expected_len} cells, and this one {len}")
        }
        _ => error.to_string(),
    };
    ((line, 1), message)
}

/// Reads a table with a row a scan.
fn table(text: &str) -> Result<Trace, Misreading> {
    // Spreadsheets of many countries separate the cells by semicolons.
    let head = text.lines().next().unwrap_or_default();
    let delimiter = if head.contains(';') { b';' } else { b',' };
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let names: Vec<String> = reader
        .headers()
        .map_err(of_csv)?
        .iter()
        .map(str::to_owned)
        .collect();
    let mut columns = vec![Vec::new(); names.len()];
    for row in reader.records() {
        for (column, cell) in columns.iter_mut().zip(&row.map_err(of_csv)?) {
            column.push(match cell {
                "" => Json::Null,
                cell => Json::String(cell.to_owned()),
            });
        }
    }
    let mut trace = Trace::default();
    for (name, column) in names.into_iter().zip(columns) {
        if name.eq_ignore_ascii_case("clock") {
            let cells = column.iter();
            trace.clock = cells
                .map(|cell| cell.as_str().unwrap_or_default().to_owned())
                .collect();
        } else if let Some(name) = name.strip_prefix(EXPECTED) {
            trace.expected.insert(name.trim().to_owned(), Json::Array(column));
        } else {
            trace.inputs.insert(name, Json::Array(column));
        }
    }
    Ok(trace)
}
