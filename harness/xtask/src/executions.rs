//! `cargo xtask count-executions`: adds to a file of counts how many inputs libFuzzer judged.
//!
//! A log is what libFuzzer printed with `-print_final_stats=1`, in a file that is named after the target, `parse.log`. The
//! nightly workflow publishes the file of counts in the branch `executions`.
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use stickler_generate::oracles::FuzzTarget;

/// The version of the form of the file.
const FORMAT: u32 = 1;

/// The file of counts.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
struct Counts {
    /// [`FORMAT`].
    format: u32,
    /// The number of inputs that all targets together judged.
    total: u64,
    /// The counts of each target, by its name.
    targets: BTreeMap<String, TargetCount>,
}

/// The counts of a target.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Serialize, Deserialize)]
struct TargetCount {
    /// The number of inputs that were judged.
    executions: u64,
    /// The number of runs in which they were.
    runs: u64,
}

impl Counts {
    /// Reads the file; counts of nothing where there is none.
    fn read(path: &Path) -> Result<Counts, String> {
        let fragment = |reason: String| format!("{}: {reason}", path.display());
        let text = match fs::read_to_string(path) {
            Ok(text) => text,
            Err(error) if error.kind() == ErrorKind::NotFound => {
                return Ok(Counts {
                    format: FORMAT,
                    total: 0,
                    targets: BTreeMap::new(),
                });
            }
            Err(error) => return Err(fragment(error.to_string())),
        };
        let counts: Counts = serde_json::from_str(&text).map_err(|error| fragment(error.to_string()))?;
        match counts.format {
            FORMAT => Ok(counts),
            other => Err(fragment(format!(
                "its format is {other}; this program knows {FORMAT}"
            ))),
        }
    }

    /// Adds a run of a target.
    fn add(&mut self, target: FuzzTarget, executions: u64) {
        let count = self.targets.entry(target.as_str().to_owned()).or_default();
        count.executions = count.executions.saturating_add(executions);
        count.runs += 1;
        self.total = self.total.saturating_add(executions);
    }
}

/// Returns the number of inputs that were judged, by what libFuzzer printed: by its statistics, or, where it was ended before it
/// could print them, by its last line of progress.
fn executions(log: &str) -> Option<u64> {
    const STATISTIC: &str = "stat::number_of_executed_units:";
    let statistic = |line: &str| line.strip_prefix(STATISTIC)?.trim().parse().ok();
    let progress = |line: &str| line.strip_prefix('#')?.split_whitespace().next()?.parse().ok();
    let last = |of: &dyn Fn(&str) -> Option<u64>| log.lines().filter_map(of).next_back();
    last(&statistic).or_else(|| last(&progress))
}

fn target_of(log: &Path) -> Result<FuzzTarget, String> {
    let name = log.file_stem().map(|name| name.to_string_lossy().into_owned());
    let target = name.as_deref().and_then(FuzzTarget::from_word);
    target.ok_or_else(|| {
        let names: Vec<&str> = FuzzTarget::ALL.iter().map(|target| target.as_str()).collect();
        format!(
            "{}: a log is named after its target: {}",
            log.display(),
            names.join(", ")
        )
    })
}

fn count(file: &Path, logs: &[PathBuf]) -> Result<Counts, String> {
    let mut counts = Counts::read(file)?;
    for log in logs {
        let target = target_of(log)?;
        let bytes = fs::read(log).map_err(|error| format!("{}: {error}", log.display()))?;
        let executions = executions(&String::from_utf8_lossy(&bytes));
        let executions = executions.ok_or_else(|| {
            format!(
                "{}: it does not say how many inputs were judged; -print_final_stats=1 does",
                log.display()
            )
        })?;
        counts.add(target, executions);
    }
    let text = serde_json::to_string_pretty(&counts).map_err(|error| error.to_string())? + "\n";
    fs::write(file, text).map_err(|error| format!("cannot write {}: {error}", file.display()))?;
    Ok(counts)
}

/// Adds what the logs say to the file, prints the total, and returns the exit code.
pub fn execute(file: &Path, logs: &[PathBuf]) -> u8 {
    match count(file, logs) {
        Ok(counts) => {
            println!("{} inputs judged in all", counts.total);
            0
        }
        Err(message) => {
            eprintln!("error: {message}");
            1
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOG: &str = "INFO: Running with entropic power schedule\n#512\tpulse  cov: 9\n#900\tDONE   cov: 9\n\
        stat::number_of_executed_units: 905\nstat::average_exec_per_sec:     90\n";

    #[test]
    fn the_statistics_count_and_without_them_the_last_progress() {
        assert_eq!(executions(LOG), Some(905));
        assert_eq!(
            executions(LOG.split("stat::").next().unwrap_or_default()),
            Some(900)
        );
        assert_eq!(executions("error: no such target"), None);
    }

    #[test]
    fn every_run_is_added() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("executions.json");
        let logs = ["parse", "literal"].map(|name| folder.path().join(format!("{name}.log")));
        logs.iter().for_each(|log| fs::write(log, LOG).unwrap());
        count(&file, &logs).unwrap();
        let counts = count(&file, &logs[..1]).unwrap();
        assert_eq!(counts.total, 3 * 905);
        let parse = TargetCount {
            executions: 2 * 905,
            runs: 2,
        };
        assert_eq!(counts.targets["parse"], parse);
        assert_eq!(Counts::read(&file).unwrap(), counts);
    }

    #[test]
    fn what_cannot_be_counted_is_named_and_changes_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("executions.json");
        let log = |name: &str, text: &str| {
            let log = folder.path().join(name);
            fs::write(&log, text).unwrap();
            count(&file, &[log]).unwrap_err()
        };
        assert!(log("pars.log", LOG).contains("named after its target: parse"));
        assert!(log("parse.log", "").contains("-print_final_stats=1"));
        assert!(!file.exists());
        fs::write(&file, "{\"format\": 9, \"total\": 0, \"targets\": {}}").unwrap();
        assert!(log("parse.log", LOG).contains("its format is 9"));
    }
}
