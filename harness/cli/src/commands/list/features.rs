//! `stickler list --features`: how many cases use each feature of the language.

use super::{BOLD, DIM, json_line};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::Write;
use stickler_suite::{Case, Features};
use stickler_workers::{SpawnError, WorkerPool};

/// A feature, and the number of cases whose programs use it.
#[derive(Serialize)]
struct FeatureLine<'a> {
    key: &'a str,
    title: &'a str,
    /// The tables and rows of IEC 61131-3, by edition.
    tables: &'a BTreeMap<u8, String>,
    needs: &'a [String],
    cases: usize,
}

/// Writes each feature with the number of cases that use it, in the order of `features.toml`; as JSON with what it needs.
///
/// # Errors
/// Those of writing to `out`, and no threads.
pub(super) fn write(
    out: &mut dyn Write,
    features: &Features,
    cases: &[&Case],
    json: bool,
) -> anyhow::Result<()> {
    const CHUNK: usize = 2000;
    let count = |cases: &[&Case]| {
        let mut counted: BTreeMap<String, usize> = BTreeMap::new();
        for key in cases.iter().flat_map(|case| case.features()) {
            *counted.entry(key.into_owned()).or_default() += 1;
        }
        counted
    };
    let counted = WorkerPool::new(0).map(
        cases.chunks(CHUNK),
        || Ok::<_, SpawnError>(()),
        |(), chunk| Ok(count(chunk)),
    )?;
    let number = |key: &str| counted.iter().filter_map(|counted| counted.get(key)).sum();
    let lines = features.iter().map(|feature| FeatureLine {
        key: &feature.key,
        title: &feature.title,
        tables: &feature.tables,
        needs: &feature.needs,
        cases: number(&feature.key),
    });
    if json {
        return Ok(lines.into_iter().try_for_each(|line| json_line(out, &line))?);
    }
    let width = features
        .iter()
        .map(|feature| feature.key.len())
        .max()
        .unwrap_or_default();
    for FeatureLine {
        key,
        title,
        tables,
        cases,
        ..
    } in lines
    {
        let rows = tables
            .iter()
            .map(|(edition, rows)| format!("{rows} (edition {edition})"));
        let rows = rows.collect::<Vec<_>>().join("; ");
        writeln!(
            out,
            "{cases:>8}  {BOLD}{key:width$}{BOLD:#}  {title}  {DIM}{rows}{DIM:#}"
        )?;
    }
    Ok(())
}
