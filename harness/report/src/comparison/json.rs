//! Writes a comparison as one JSON object, for other programs.

use super::{Change, Comparison, Kind, UnmatchedCase};
use serde::Serialize;
use std::io::{self, Write};
use stickler_run::Header;

/// The version of the JSON format.
const FORMAT: u32 = 1;

#[derive(Serialize)]
struct ComparisonDocument<'c> {
    format: u32,
    old: &'c Header,
    new: &'c Header,
    engines: Vec<EnginePair<'c>>,
    counts: ChangeCounts,
    changes: &'c [Change],
    added: &'c [UnmatchedCase],
    gone: &'c [UnmatchedCase],
}

/// The name of an engine in each run.
#[derive(Serialize)]
struct EnginePair<'c> {
    old: &'c str,
    new: &'c str,
}

/// The number of cases of each kind of change.
#[derive(Serialize)]
struct ChangeCounts {
    crashed: usize,
    broken: usize,
    fixed: usize,
    otherwise: usize,
    added: usize,
    gone: usize,
    same: u64,
}

/// Writes the object and a line feed. All changes are in it, the first [`MAX_DETAILED`](super::MAX_DETAILED) of each kind
/// with their expected and actual texts.
///
/// # Errors
/// Returns the error of writing to `out`.
pub fn write_json(out: &mut dyn Write, comparison: &Comparison) -> io::Result<()> {
    let count = |kind| comparison.of_kind(kind).count();
    let document = ComparisonDocument {
        format: FORMAT,
        old: &comparison.old,
        new: &comparison.new,
        engines: comparison
            .engines
            .iter()
            .map(|(old, new)| EnginePair { old, new })
            .collect(),
        counts: ChangeCounts {
            crashed: count(Kind::Crashed),
            broken: count(Kind::Broken),
            fixed: count(Kind::Fixed),
            otherwise: count(Kind::Otherwise),
            added: comparison.added.len(),
            gone: comparison.gone.len(),
            same: comparison.same,
        },
        changes: &comparison.changes,
        added: &comparison.added,
        gone: &comparison.gone,
    };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out)
}
