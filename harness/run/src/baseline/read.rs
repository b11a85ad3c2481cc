//! Reads the file of a baseline. Each error names its line.

use super::{Baseline, Entry};
use crate::{Filter, Verdict};
use jiff::civil::Date;
use semver::VersionReq;
use serde::Deserialize;
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
    case: Spanned<String>,
    verdict: Spanned<Value>,
    reason: Spanned<String>,
    link: Option<Spanned<String>>,
    versions: Option<Spanned<String>>,
    until: Option<Spanned<Value>>,
}

pub(super) fn baseline(text: &str, file: &str, stem: &str) -> Result<Baseline, BaselineError> {
    read(text, stem)
        .map(|(engine, entries)| Baseline {
            engine,
            file: file.to_owned(),
            entries,
        })
        .map_err(|(at, message)| BaselineError {
            file: file.to_owned(),
            line: line(text, at),
            message,
        })
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
        case: Filter::new(not_blank(table.case, "case")?),
        verdicts: verdicts(&table.verdict)?,
        reason: not_blank(table.reason, "reason")?,
        link: table.link.map(|link| not_blank(link, "link")).transpose()?,
        versions: table.versions.as_ref().map(versions).transpose()?,
        until: table.until.as_ref().map(until).transpose()?,
        line,
    })
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
        let mut seen = verdicts.clone();
        seen.sort_unstable();
        seen.dedup();
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
        let names: Vec<String> = allowed.iter().map(|verdict| format!("`{verdict}`")).collect();
        let word = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        format!(
            "`{word}` is no verdict that a baseline expects; it may be {}",
            names.join(", ")
        )
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

#[cfg(test)]
mod tests {
    use super::*;

    const WHOLE: &str = r#"# Known.
engine = "iron"

[[expected]]
case = "widening/*@ironplc-ed3"
verdict = "fail"
reason = "copied bit by bit"
link = "https://example.org/1"
versions = "<0.240"
until = 2027-01-31

[[expected]]
case = "a/b"
verdict = ["crash", "pass"]
reason = "see above"
until = "2026-12-24"
"#;

    #[test]
    fn every_key_is_read_and_each_entry_knows_its_line() {
        let baseline = baseline(WHOLE, "x/ironplc.toml", "ironplc").unwrap();
        assert_eq!(baseline.engine, "iron");
        let [first, second] = &baseline.entries[..] else {
            panic!("two entries: {baseline:?}")
        };
        assert_eq!(baseline.place(first), "x/ironplc.toml:4");
        assert_eq!((first.line, second.line), (4, 12));
        assert_eq!(first.verdicts, [Verdict::Fail]);
        assert_eq!(second.verdicts, [Verdict::Crash, Verdict::Pass]);
        assert_eq!(first.link.as_deref(), Some("https://example.org/1"));
        assert!(
            first
                .versions
                .as_ref()
                .is_some_and(|range| range.matches(&"0.239.1".parse().unwrap()))
        );
        assert_eq!(first.until, Some(jiff::civil::date(2027, 1, 31)));
        assert_eq!(second.until, Some(jiff::civil::date(2026, 12, 24)));
        assert_eq!(second.versions, None);
    }

    #[test]
    fn the_file_names_the_engine_where_its_text_does_not() {
        let baseline = baseline("", "matiec.toml", "matiec").unwrap();
        assert_eq!((baseline.engine.as_str(), baseline.entries.len()), ("matiec", 0));
    }

    #[test]
    fn a_mistake_is_told_with_its_line() {
        for (from, to, line, part) in [
            (
                "verdict = \"fail\"",
                "verdit = \"fail\"",
                6,
                "unknown field `verdit`",
            ),
            (
                "reason = \"copied bit by bit\"\n",
                "",
                4,
                "missing field `reason`",
            ),
            ("\"copied bit by bit\"", "\" \"", 7, "`reason` is empty"),
            (
                "\"fail\"",
                "\"pass\"",
                6,
                "`pass` is no verdict that a baseline expects",
            ),
            ("\"fail\"", "7", 6, "`7` is no verdict"),
            (
                "[\"crash\", \"pass\"]",
                "[\"crash\", \"xpass\"]",
                14,
                "`xpass` is no verdict that a baseline expects; it may be `pass`, `fail`",
            ),
            (
                "[\"crash\", \"pass\"]",
                "[\"pass\"]",
                14,
                "two or more, each once",
            ),
            (
                "[\"crash\", \"pass\"]",
                "[\"crash\", \"crash\"]",
                14,
                "two or more, each once",
            ),
            ("[\"crash\", \"pass\"]", "[]", 14, "two or more, each once"),
            ("\"<0.240\"", "\"0.240 or so\"", 9, "no range of versions"),
            ("2027-01-31", "2027-02-31", 10, "invalid date"),
            ("2027-01-31", "2027-01-31T00:00:00", 10, "is no day"),
            ("2027-01-31", "7", 10, "7 is no day"),
            ("\"2026-12-24\"", "\"24.12.2026\"", 16, "24.12.2026 is no day"),
            (
                "[[expected]]\ncase = \"a/b\"",
                "[[known]]\ncase = \"a/b\"",
                12,
                "unknown field `known`",
            ),
            ("case = \"a/b\"", "case = ", 13, ""),
        ] {
            let text = WHOLE.replacen(from, to, 1);
            assert_ne!(text, WHOLE, "{from}");
            let error = baseline(&text, "b.toml", "b").unwrap_err();
            let reported = error.to_string();
            assert!(
                reported.starts_with(&format!("b.toml:{line}: ")),
                "{to}: {reported}"
            );
            assert!(reported.contains(part), "{to}: {reported}");
        }
    }
}
