//! Finds and reads baselines.

use crate::source_file;
use anyhow::bail;
use std::path::{Path, PathBuf};
use stickler_run::Baseline;

/// Returns the default path of an engine's baseline. `root` is the folder that contains `reports/`.
pub fn place(root: &Path, engine: &str) -> PathBuf {
    root.join("reports")
        .join("baselines")
        .join(Baseline::file_name(engine))
}

/// Reads the text of a file and the baseline in it; `None` where there is no file.
///
/// # Errors
/// A file that cannot be read, or that has a mistake; the error names its line.
pub fn read(path: &Path) -> anyhow::Result<Option<(String, Baseline)>> {
    let shown = path.display().to_string();
    let Some(text) = source_file::text_if_any(path)? else {
        return Ok(None);
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let baseline = Baseline::read(&text, &shown, &stem)?;
    Ok(Some((text, baseline)))
}

/// Loads the baselines of the given engines: the named files, and for every other engine its file in `reports/baselines`,
/// where there is one.
///
/// # Errors
/// A file that cannot be read or has a mistake; a named file about no engine of the run, or about the same engine as
/// another; a default file that is about another engine than its name says.
pub fn load(named: &[PathBuf], root: &Path, engines: &[&str]) -> anyhow::Result<Vec<Baseline>> {
    let mut baselines: Vec<Baseline> = Vec::new();
    for path in named {
        let Some((_, baseline)) = read(path)? else {
            bail!("there is no file {}", path.display())
        };
        if !engines.contains(&baseline.engine.as_str()) {
            bail!(
                "{} is the baseline of `{}`, which takes no part; a file is about the engine that its key `engine`, or else \
                 its own name, says",
                baseline.file,
                baseline.engine
            );
        }
        if let Some(other) = baselines.iter().find(|other| other.engine == baseline.engine) {
            bail!(
                "{} and {} are both the baseline of `{}`",
                other.file,
                baseline.file,
                baseline.engine
            );
        }
        baselines.push(baseline);
    }
    for engine in engines {
        if baselines.iter().any(|baseline| baseline.engine == *engine) {
            continue;
        }
        if let Some((_, baseline)) = read(&place(root, engine))? {
            check_engine(&baseline, engine)?;
            baselines.push(baseline);
        }
    }
    Ok(baselines)
}

/// # Errors
/// A baseline that is about another engine.
pub fn check_engine(baseline: &Baseline, engine: &str) -> anyhow::Result<()> {
    if baseline.engine != engine {
        bail!(
            "{} says that it is the baseline of `{}`, and stands where that of `{engine}` does",
            baseline.file,
            baseline.engine
        );
    }
    Ok(())
}
