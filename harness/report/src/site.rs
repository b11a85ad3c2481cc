//! `stickler site`: a static site of several runs, with a row an engine, the history of each, and what changed.
//!
//! Each run is read as a stream and only counted; two runs are compared by [`crate::comparison`], as `stickler compare` does.

mod engine_page;
mod feed;
mod front_page;
mod history;
mod html;
mod run;
mod versions;

use crate::{ComparisonError, ReportError, RunFileError};
use crate::{events, results};
use history::History;
use run::SiteRun;
use std::fs;
use std::path::{Path, PathBuf};

/// What a site was built from.
#[derive(PartialEq, Eq, Debug)]
pub struct SiteSummary {
    /// The number of runs.
    pub runs: usize,
    /// The number of engines.
    pub engines: usize,
    /// The runs that a later run of the same version replaces, each as a sentence.
    pub replaced: Vec<String>,
}

/// An error that prevents the building of a site.
#[derive(Debug, thiserror::Error)]
pub enum SiteError {
    /// No run was named.
    #[error("a site needs a run: name the folder of reports of at least one, such as reports/latest")]
    NoRun,
    /// A run cannot be read, or is not whole.
    #[error("{}", path.display())]
    Run {
        /// The path of the run.
        path: PathBuf,
        /// The error of reading it.
        source: Box<RunFileError>,
    },
    /// The date of a run is none.
    #[error("{}: the run began at `{started}`, which is no time such as 2026-09-01T12:00:00Z", path.display())]
    Date {
        /// The path of the run.
        path: PathBuf,
        /// What stands in place of the time.
        started: String,
    },
    /// Two runs cannot be compared, for a reason that was not seen when each of them was read.
    #[error("{} and {}", old.display(), new.display())]
    Comparison {
        /// The path of the older run.
        old: PathBuf,
        /// The path of the newer run.
        new: PathBuf,
        /// The error of the comparison.
        source: Box<ComparisonError>,
    },
    /// The place of the site is a file.
    #[error("{} is a file; name a folder for the site, which is created where it is missing", .0.display())]
    NoFolder(PathBuf),
    /// The place of the site is the folder of a run.
    #[error("{} has the reports of a run, which the site would overwrite; name another folder for the site", .0.display())]
    RunFolder(PathBuf),
    /// A page cannot be written.
    #[error(transparent)]
    Write(#[from] ReportError),
}

impl SiteError {
    /// Returns a closure for `map_err` that adds the path of a run to the error of reading it.
    fn run(path: &Path) -> impl Fn(RunFileError) -> SiteError + use<> {
        let path = path.to_owned();
        move |source| SiteError::Run {
            path: path.clone(),
            source: Box::new(source),
        }
    }
}

/// Builds the site of these runs, each named by its folder of reports, its event log or its `results.json`. Equal runs give equal files; files
/// of the folder that the site does not write stay.
///
/// # Errors
/// [`SiteError`] where a run cannot be read or is not whole, or a page cannot be written.
pub fn write(paths: &[PathBuf], site: &Path) -> Result<SiteSummary, SiteError> {
    if paths.is_empty() {
        return Err(SiteError::NoRun);
    }
    if site.is_file() {
        return Err(SiteError::NoFolder(site.to_owned()));
    }
    if [events::NAME, results::NAME]
        .iter()
        .any(|name| site.join(name).is_file())
    {
        return Err(SiteError::RunFolder(site.to_owned()));
    }
    let runs = SiteRun::read_all(paths)?;
    let histories = History::of_engines(&runs)?;
    for folder in [site, &site.join("engines"), &site.join("runs")] {
        fs::create_dir_all(folder).map_err(ReportError::writing(folder))?;
    }
    for run in &runs {
        if let Some(page) = &run.page {
            let copy = site.join("runs").join(run.page_name());
            fs::copy(page, &copy).map_err(ReportError::writing(&copy))?;
        }
    }
    for history in &histories {
        write_page(
            &site.join("engines").join(&history.file),
            &engine_page::page(history),
        )?;
    }
    let feed_path = site.join(feed::NAME);
    let feed = feed::feed(&histories).map_err(ReportError::writing(&feed_path))?;
    fs::write(&feed_path, feed).map_err(ReportError::writing(&feed_path))?;
    write_page(&site.join("results.schema.json"), results::SCHEMA)?;
    write_page(&site.join("index.html"), &front_page::page(&histories))?;
    Ok(SiteSummary {
        runs: runs.len(),
        engines: histories.len(),
        replaced: histories.iter().flat_map(History::replaced).collect(),
    })
}

fn write_page(path: &Path, page: &str) -> Result<(), ReportError> {
    fs::write(path, page).map_err(ReportError::writing(path))
}

#[cfg(test)]
mod tests;
