//! `stickler list --features`: how many cases use each feature of the language.

use super::{BOLD, DIM, json_line};
use serde_json::json;
use std::collections::BTreeMap;
use std::io::Write;
use stickler_suite::{Case, Feature, Features};
use stickler_workers::{SpawnError, WorkerPool};

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
    let number = |key: &str| -> usize { counted.iter().filter_map(|counted| counted.get(key)).sum() };
    let width = features.iter().map(|feature| feature.key.len()).max();
    let width = width.unwrap_or_default();
    for Feature {
        key,
        title,
        tables,
        needs,
        ..
    } in features.iter()
    {
        let cases = number(key);
        if json {
            let line =
                json!({ "key": key, "title": title, "tables": tables, "needs": needs, "cases": cases });
            json_line(out, &line)?;
            continue;
        }
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
