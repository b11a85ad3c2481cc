//! Where baselines are, and reading them.

use anyhow::{Context, bail};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use stickler_run::Baseline;

/// Returns the path of the baseline of an engine for which no file is named. `root` is the folder in which `reports/` stands.
pub fn place(root: &Path, engine: &str) -> PathBuf {
    root.join("reports")
        .join("baselines")
        .join(Baseline::file_name(engine))
}

/// The text of a file and the baseline that it is; `None` where there is no file.
///
/// # Errors
/// A file that cannot be read, or a mistake in it, with its line.
pub fn read(path: &Path) -> anyhow::Result<Option<(String, Baseline)>> {
    let shown = path.display().to_string();
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error).with_context(|| format!("cannot read {shown}")),
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let baseline = Baseline::read(&text, &shown, &stem)?;
    Ok(Some((text, baseline)))
}

/// The baselines of these engines: the files that are named, and for every other engine its file in `reports/baselines`,
/// where there is one.
///
/// # Errors
/// A file that cannot be read or has a mistake; one that is named and about no engine of the run, or about the same as
/// another; one that stands where that of another engine is sought.
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
/// Returns an error where the file says that it is about another engine than this.
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
