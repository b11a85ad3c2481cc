//! Plans runs: which cases are selected, when the run begins, where its reports go, and how a case of it is run again.

use crate::arguments::SelectionArguments;
use crate::{engines, shell};
use jiff::tz::TimeZone;
use jiff::{Timestamp, Unit};
use std::path::{Path, PathBuf};
use stickler_run::{Filter, Plan};
use stickler_workers::Shard;

/// Returns the time of now, to the second.
pub fn now() -> Timestamp {
    let now = Timestamp::now();
    // Rounding a time to seconds fails only at the end of time.
    now.round(Unit::Second).unwrap_or(now)
}

/// Returns the plan of a run that begins now and selects the requested cases.
pub fn plan(selection: &SelectionArguments, shard: Option<Shard>) -> Plan {
    let filters = |texts: &[String]| texts.iter().map(Filter::new).collect();
    Plan {
        filters: filters(&selection.filter),
        excluded: filters(&selection.exclude),
        dialects: selection.dialect.clone(),
        shard,
        rerun_prefix: format!("{} run{}", shell::program(), places(selection.cases.as_deref())),
        today: now().to_zoned(TimeZone::UTC).date(),
        started: now().to_string(),
        command: shell::command_line(),
        ..Plan::default()
    }
}

/// Returns the folder of a run's reports: the one that is named, or `reports/latest` in the folder that contains `reports/`.
pub fn report_folder(named: Option<&Path>, root: &Path) -> PathBuf {
    named.map_or_else(|| root.join("reports").join("latest"), Path::to_owned)
}

/// Returns the options with which another command reads the same cases and the same stickler.toml.
pub fn places(cases: Option<&Path>) -> String {
    let named = [("--cases", cases), ("--config", engines::config_file())];
    let option = |(name, path): (&str, Option<&Path>)| {
        path.map(|path| format!(" {name} {}", shell::quote(&path.to_string_lossy())))
    };
    named.into_iter().filter_map(option).collect()
}
