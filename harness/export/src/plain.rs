//! Writes cases without a harness: one line of JSON for each case, and for each that can be tried by hand a file of Structured
//! Text whose variables `CHECK_1`, `CHECK_2` … become TRUE.

mod program;
#[cfg(test)]
mod tests;

use crate::ExportError;
use crate::export::is_occupied;
use crate::source_line::source_line;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;
use stickler_suite::{Acceptance, Case, ExpectedDiagnostic, Sources};

/// The file of the cases.
pub const CASES: &str = "cases.jsonl";

/// The file with the JSON Schema of a line of [`CASES`].
const SCHEMA: &str = "cases.schema.json";

/// The folder of the programs.
const PROGRAMS: &str = "programs";

/// The greatest length of a file's name, in bytes.
const MAX_NAME: usize = 120;

/// The result of an export without a harness.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct PlainExported {
    /// The number of cases.
    pub cases: usize,
    /// The number of files of Structured Text.
    pub programs: usize,
    /// The number of cases that have no such file, by the reason.
    pub without: BTreeMap<&'static str, usize>,
}

/// Writes cases into a folder, which is empty, does not exist yet, or has an earlier export of this kind, which is replaced.
///
/// # Errors
/// [`ExportError::Occupied`] before anything is written; [`ExportError::Write`].
pub fn export_plain(cases: &[&Case], sources: &Sources, folder: &Path) -> Result<PlainExported, ExportError> {
    let (schema, programs) = (folder.join(SCHEMA), folder.join(PROGRAMS));
    if is_occupied(folder)? && !schema.is_file() {
        let other = format!(" and holds no earlier export of cases (there is no {SCHEMA} in it)");
        return Err(ExportError::Occupied(folder.to_owned(), other));
    }
    if programs.is_dir() {
        fs::remove_dir_all(&programs).map_err(writing(&programs))?;
    }
    create(folder)?;
    fs::write(&schema, include_str!("plain/cases.schema.json")).map_err(writing(&schema))?;
    let lines = folder.join(CASES);
    let mut out = BufWriter::new(File::create(&lines).map_err(writing(&lines))?);
    let mut exported = PlainExported::default();
    let mut taken = BTreeSet::new();
    for case in cases {
        let file = match program::text(case, sources) {
            Ok(text) => {
                let name = file_name(case, &mut taken);
                let path = folder.join(&name);
                path.parent().map_or(Ok(()), create)?;
                fs::write(&path, text).map_err(writing(&path))?;
                exported.programs += 1;
                Some(name)
            }
            Err(reason) => {
                *exported.without.entry(reason).or_default() += 1;
                None
            }
        };
        exported.cases += 1;
        writeln!(out, "{}", line(case, sources, file)).map_err(writing(&lines))?;
    }
    out.flush().map_err(writing(&lines))?;
    Ok(exported)
}

/// Returns the line of a case, by which its file of Structured Text is found, if it has one. The schema says what the keys mean.
fn line(case: &Case, sources: &Sources, file: Option<String>) -> Value {
    let set = case.set.iter().map(|setting| {
        json!({ "before": setting.before, "name": setting.name, "value": setting.value.to_string() })
    });
    let clock = case.clock.iter();
    let clock = clock.map(|time| json!({ "before": time.before, "nanoseconds": time.nanoseconds }));
    json!({
        "id": case.id,
        "dialect": case.dialect.as_str(),
        "title": case.title,
        "question": case.question.as_ref().map(ToString::to_string),
        "features": case.features(),
        "program": case.source,
        "scans": case.scans,
        "set": set.collect::<Vec<_>>(),
        "clock": clock.collect::<Vec<_>>(),
        "expected": expected(case),
        "source": source_line(&case.basis, sources),
        "file": file,
    })
}

/// Returns what must come of a case.
fn expected(case: &Case) -> Value {
    let expectation = &*case.expectation;
    let lines = |all: &[ExpectedDiagnostic]| {
        let line = |one: &ExpectedDiagnostic| json!({ "line": one.line, "code": one.code.as_str() });
        all.iter().map(line).collect::<Value>()
    };
    let values = expectation
        .values
        .iter()
        .map(|value| json!({ "name": value.name, "after": value.after, "value": value.value.to_string() }));
    let is_asserted = |name: &str| expectation.values.iter().any(|value| &*value.name == name);
    let recorded = case.observe.iter().map(|observe| &*observe.name);
    let fault = expectation.fault;
    let rendered = expectation.rendered.as_ref();
    json!({
        "program": match expectation.accepted {
            Acceptance::Required => "accepted",
            Acceptance::Rejected => "rejected",
            Acceptance::Observed => "open",
        },
        "errors": lines(&expectation.diagnostics),
        "warnings": lines(&expectation.warnings),
        "values": values.collect::<Vec<_>>(),
        "recorded": recorded.filter(|name| !is_asserted(name)).collect::<Vec<_>>(),
        "fault": fault.map(|fault| json!({ "kind": fault.fault.to_string(), "line": fault.line })),
        "rendered": rendered.map(|text| &text.lines),
    })
}

fn create(folder: &Path) -> Result<(), ExportError> {
    fs::create_dir_all(folder).map_err(writing(folder))
}

fn writing(path: &Path) -> impl Fn(std::io::Error) -> ExportError + '_ {
    move |error| ExportError::Write(path.to_owned(), error)
}

/// Returns the path of the file of a case below the folder, with forward slashes: its dialect and its id, in characters that every
/// system takes.
fn file_name(case: &Case, taken: &mut BTreeSet<String>) -> String {
    let mut name = format!("{PROGRAMS}/{}/", case.dialect);
    let (probe, arguments) = case.id.split_at(case.id.find('(').unwrap_or(case.id.len()));
    for letter in (probe.replace("::", "/") + &arguments.replace('/', "_")).chars() {
        let is_plain = letter.is_ascii_alphanumeric() || matches!(letter, '/' | '-' | '.');
        name.push(if is_plain { letter } else { '_' });
    }
    let start = name.rfind('/').map_or(0, |slash| slash + 1);
    name.truncate(start + MAX_NAME);
    let stem = name.clone();
    let mut number = 1;
    // Some systems tell no capitals apart.
    while !taken.insert(name.to_ascii_lowercase()) {
        number += 1;
        name = format!("{stem}-{number}");
    }
    name + ".st"
}
