//! `stickler compare`: the differences between two runs of a compiler.

use crate::arguments::CompareArguments;
use crate::exit::Exit;
use anyhow::Context;
use std::io::Write;
use std::path::{Path, PathBuf};
use stickler_report::Comparison;
use stickler_report::comparison::{self, ComparisonError};
use stickler_report::events::{self, LogFile, Reader};

/// Shows the cases that were fixed, that broke, that crash, and that are new or gone.
///
/// # Errors
/// A log that cannot be read or was cut short; runs that have no engine in common.
pub fn execute(arguments: &CompareArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let (old_path, old) = open(&arguments.old)?;
    let (new_path, new) = open(&arguments.new)?;
    let comparison = Comparison::of(old, new).map_err(|error| {
        let path = match &error {
            ComparisonError::Old(_) => Some(&old_path),
            ComparisonError::New(_) => Some(&new_path),
            ComparisonError::NoEngine { .. } | ComparisonError::Parts { .. } => None,
        };
        let named = path.map(|path| path.display().to_string());
        let error = anyhow::Error::new(error);
        match named {
            Some(path) => error.context(path),
            None => error,
        }
    })?;
    if arguments.json {
        comparison::write_json(out, &comparison)?;
    } else {
        comparison::write(out, &comparison)?;
    }
    Ok(exit(&comparison))
}

/// Opens the event log of a run; returns its path and its reader.
fn open(path: &Path) -> anyhow::Result<(PathBuf, Reader<LogFile<'static>>)> {
    let path = events::locate(path);
    let reader = Reader::open(&path).with_context(|| path.display().to_string())?;
    Ok((path, reader))
}

fn exit(comparison: &Comparison) -> Exit {
    if comparison.is_worse() {
        return Exit::Failures;
    }
    if comparison.same == 0 && comparison.changes.is_empty() {
        return Exit::NothingTested;
    }
    Exit::AsExpected
}
