//! Reads the file of a baseline. Each error names its line.

use super::{Baseline, Entry};
use crate::{Filter, Verdict};
use jiff::civil::Date;
use semver::VersionReq;
use serde::Deserialize;
use stickler_types::{join, sorted};
use toml::{Spanned, Value};

/// The verdicts that an entry may expect; a pass, which comes first, only beside others.
const EXPECTED: [Verdict; 7] = [
    Verdict::Pass,
    Verdict::Fail,
    Verdict::Differs,
    Verdict::Crash,
    Verdict::Timeout,
    Verdict::Error,
    Verdict::Unsupported,
];

/// An error in the file of a baseline.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("{file}:{line}: {message}")]
pub struct BaselineError {
    /// The path of the file, as messages show it.
    pub file: String,
    /// The line of the error, from 1.
    pub line: u32,
    /// The description of the error.
    pub message: String,
}

/// The byte offset of an error in the file, and its description, in that order.
type BaselineMistake = (usize, String);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BaselineFile {
    engine: Option<Spanned<String>>,
    #[serde(default)]
    expected: Vec<Spanned<EntryTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EntryTable {
    case: Spanned<Value>,
    verdict: Spanned<Value>,
    reason: Spanned<String>,
    link: Option<Spanned<String>>,
    versions: Option<Spanned<String>>,
    until: Option<Spanned<Value>>,
}

impl Baseline {
    /// Reads a baseline. `file` is the path that messages show; `stem`, the file's name without its extension, names the
    /// engine where the text itself does not.
    ///
    /// # Errors
    /// [`BaselineError`]: the first mistake, with its line.
    pub fn read(text: &str, file: &str, stem: &str) -> Result<Baseline, BaselineError> {
        let file = file.to_owned();
        match read(text, stem) {
            Ok((engine, entries)) => Ok(Baseline {
                engine,
                file,
                entries,
            }),
            Err((at, message)) => {
                let line = line(text, at);
                Err(BaselineError { file, line, message })
            }
        }
    }
}

fn read(text: &str, stem: &str) -> Result<(String, Vec<Entry>), BaselineMistake> {
    let file: BaselineFile = toml::from_str(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        (at, error.message().trim_end().replace('\n', "; "))
    })?;
    let engine = match file.engine {
        Some(engine) => not_blank(engine, "engine")?,
        None => stem.to_owned(),
    };
    let entries = file.expected.into_iter().map(|table| {
        let line = line(text, table.span().start);
        entry(table.into_inner(), line)
    });
    Ok((engine, entries.collect::<Result<_, _>>()?))
}

fn entry(table: EntryTable, line: u32) -> Result<Entry, BaselineMistake> {
    Ok(Entry {
        cases: cases(&table.case)?,
        verdicts: verdicts(&table.verdict)?,
        reason: not_blank(table.reason, "reason")?,
        link: table.link.map(|link| not_blank(link, "link")).transpose()?,
        versions: table.versions.as_ref().map(versions).transpose()?,
        until: table.until.as_ref().map(until).transpose()?,
        line,
    })
}

/// Parses an id or a pattern, or a list of them.
fn cases(value: &Spanned<Value>) -> Result<Vec<Filter>, BaselineMistake> {
    let list = match value.get_ref() {
        Value::Array(list) => &list[..],
        one => std::slice::from_ref(one),
    };
    let case = |one: &Value| match one.as_str().map(str::trim) {
        Some("") => Err((value.span().start, "`case` is empty".to_owned())),
        Some(_) => Ok(Filter::new(one.as_str().unwrap_or_default())),
        None => Err((
            value.span().start,
            format!("`{one}` is neither an id nor a pattern"),
        )),
    };
    match list {
        [] => Err((value.span().start, "`case` is empty".to_owned())),
        list => list.iter().map(case).collect(),
    }
}

/// Returns the text of a key that must not be blank.
fn not_blank(text: Spanned<String>, key: &str) -> Result<String, BaselineMistake> {
    match text.get_ref().trim() {
        "" => Err((text.span().start, format!("`{key}` is empty"))),
        _ => Ok(text.into_inner()),
    }
}

/// Parses one verdict that is no pass, or a list of alternative verdicts, of which one may be a pass.
fn verdicts(value: &Spanned<Value>) -> Result<Vec<Verdict>, BaselineMistake> {
    let verdicts = match value.get_ref() {
        Value::Array(list) => {
            let verdicts = list.iter().map(|one| verdict(one, &EXPECTED));
            verdicts.collect::<Result<Vec<_>, _>>()
        }
        one => verdict(one, &EXPECTED[1..]).map(|verdict| vec![verdict]),
    };
    let is_said_once = |verdicts: &Vec<Verdict>| {
        let seen = sorted(verdicts);
        seen.len() == verdicts.len() && (seen.len() > 1 || !value.get_ref().is_array())
    };
    let verdicts = verdicts.and_then(|verdicts| match is_said_once(&verdicts) {
        true => Ok(verdicts),
        false => Err("a list of verdicts has two or more, each once".to_owned()),
    });
    verdicts.map_err(|message| (value.span().start, message))
}

fn verdict(value: &Value, allowed: &[Verdict]) -> Result<Verdict, String> {
    let named = allowed
        .iter()
        .find(|verdict| value.as_str() == Some(verdict.as_str()));
    named.copied().ok_or_else(|| {
        let names = join(allowed.iter().map(|verdict| format!("`{verdict}`")), ", ");
        let word = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        format!("`{word}` is no verdict that a baseline expects; it may be {names}")
    })
}

fn versions(text: &Spanned<String>) -> Result<VersionReq, BaselineMistake> {
    text.get_ref().parse().map_err(|error| {
        let message = format!(
            "`{}` is no range of versions, such as `<0.240` or `>=0.6, <0.8`: {error}",
            text.get_ref()
        );
        (text.span().start, message)
    })
}

/// Parses a date, with or without quotes around it.
fn until(value: &Spanned<Value>) -> Result<Date, BaselineMistake> {
    let written = match value.get_ref() {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    // jiff accepts more than a date here, such as a date with a time, which is no day.
    let day = (written.len() == "2027-01-31".len())
        .then(|| written.parse().ok())
        .flatten();
    day.ok_or_else(|| {
        let message = format!("{written} is no day, such as 2027-01-31");
        (value.span().start, message)
    })
}

fn line(text: &str, at: usize) -> u32 {
    let before = &text.as_bytes()[..at.min(text.len())];
    let breaks = before.iter().filter(|&&byte| byte == b'\n').count();
    u32::try_from(breaks).map_or(u32::MAX, |breaks| breaks.saturating_add(1))
}
