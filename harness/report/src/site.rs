//! `stickler site`: a static site of several runs, with a row an engine, the history of each, and what changed.
//!
//! Each run is read as a stream and only counted; two runs are compared by [`crate::comparison`], as `stickler compare` does.

mod engine_page;
mod feed;
mod front_page;
mod functions;
mod history;
mod html;
mod run;
mod versions;

use crate::{ComparisonError, LogError, ReportError, events, results};
use functions::Functions;
use history::History;
pub use html::{escaped, page};
use run::SiteRun;
use std::fs;
use std::path::{Path, PathBuf};
use stickler_conversions::overview::Statements;

/// The runs and recordings from which a site was built.
#[derive(PartialEq, Eq, Debug)]
pub struct SiteSummary {
    /// The number of runs.
    pub runs: usize,
    /// The number of engines.
    pub engines: usize,
    /// The number of conversion functions.
    pub functions: usize,
    /// The runs that a later run of the same version replaces, each as a sentence.
    pub replaced: Vec<String>,
    /// The runs that could not be read, each as a sentence; empty unless they are to be skipped.
    pub skipped: Vec<String>,
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
        source: LogError,
    },
    /// The start of a run is no valid time.
    #[error("{}: the run began at `{started}`, which is no time such as 2026-09-01T12:00:00Z", path.display())]
    Date {
        /// The path of the run.
        path: PathBuf,
        /// The text in place of the time.
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
    fn run(path: &Path) -> impl Fn(LogError) -> SiteError + use<> {
        let path = path.to_owned();
        move |source| SiteError::Run {
            path: path.clone(),
            source,
        }
    }
}

/// Builds the site of these runs, each named by its folder of reports or its event log. Equal runs give equal files; files
/// of the folder that the site does not write stay. `statements` are what documents state of conversions and recorded compilers answered; the pages
/// of the functions show them beside what the engines do. With `skip_unreadable`, a run that cannot be read is left out and listed in the summary, as
/// long as another can be read.
///
/// # Errors
/// [`SiteError`] where a run cannot be read or is not whole, or a page cannot be written.
pub fn write(
    paths: &[PathBuf],
    skip_unreadable: bool,
    site: &Path,
    statements: &Statements,
) -> Result<SiteSummary, SiteError> {
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
    let (runs, skipped) = SiteRun::read_all(paths, skip_unreadable)?;
    let histories = History::of_engines(&runs)?;
    let functions = Functions::gather(statements, &histories, &runs)?;
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
            engine_page::page(history, &functions),
        )?;
    }
    let feed_path = site.join(feed::NAME);
    let feed = feed::feed(&histories).map_err(ReportError::writing(&feed_path))?;
    write_page(&feed_path, feed)?;
    write_page(&site.join("events.schema.json"), events::SCHEMA)?;
    write_page(&site.join("index.html"), front_page::page(&histories, &functions))?;
    let summary = SiteSummary {
        runs: runs.len(),
        engines: histories.len(),
        functions: functions.names().len(),
        replaced: histories.iter().flat_map(History::replaced).collect(),
        skipped,
    };
    write_functions(functions, &site.join("functions"))?;
    Ok(summary)
}

/// Writes the page of all functions, if there is any, and for each function a page that leads to its part.
fn write_functions(functions: Functions<'_>, folder: &Path) -> Result<(), ReportError> {
    if functions.names().is_empty() {
        return Ok(());
    }
    fs::create_dir_all(folder).map_err(ReportError::writing(folder))?;
    for name in functions.names() {
        let address = functions::address(name);
        let page = format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta http-equiv=\"refresh\" content=\"0; url={address}\">\n\
             <title>{name}</title>\n</head>\n<body><a href=\"{address}\">{name}</a></body>\n</html>\n"
        );
        write_page(&folder.join(format!("{name}.html")), page)?;
    }
    let path = folder.join("index.html");
    let page = functions.into_page().map_err(ReportError::writing(&path))?;
    write_page(&path, page)
}

fn write_page(path: &Path, page: impl AsRef<[u8]>) -> Result<(), ReportError> {
    fs::write(path, page).map_err(ReportError::writing(path))
}

#[cfg(test)]
mod function_tests;
#[cfg(test)]
mod tests;
