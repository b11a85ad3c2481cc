//! The folder of a run's reports: every file is opened before the run, and each event goes to all of them.

use crate::ReportError;
use crate::discrepancies::Discrepancies;
use crate::events::{self, EventLog};
use crate::junit::Junit;
use crate::overview::Overview;
use crate::page::Page;
use crate::pending::PendingFile;
use crate::{badge, code_quality, results, sarif, summary};
use std::fs;
use std::path::Path;
use stickler_conversions::overview::Statements;
use stickler_run::Event;

/// The overview of a run while it goes on, and its reports, where they are wanted.
pub struct Reports {
    overview: Overview,
    files: Option<ReportFiles>,
    /// The error after which the reports are no longer written.
    broken: Option<ReportError>,
}

/// The files of a run's reports.
struct ReportFiles {
    events: EventLog,
    junit: Junit,
    discrepancies: Discrepancies,
    page: Page,
    /// The files of [`OF_OVERVIEW`].
    of_overview: Vec<PendingFile>,
}

/// Returns the content of a report that is made of the overview alone.
type Content = fn(&Overview) -> serde_json::Result<Vec<u8>>;

/// The reports that are made of the overview of a whole run, by the names of their files. A run that was cut short gets none of them, since
/// they could not show what is missing, and services take what is missing for mended.
const OF_OVERVIEW: [(&str, Content); 5] = [
    (results::NAME, results::json),
    ("badge.json", badge::json),
    ("results.sarif", sarif::json),
    ("gl-code-quality-report.json", code_quality::json),
    ("summary.md", |overview| {
        Ok(summary::markdown(overview).into_bytes())
    }),
];

impl Reports {
    /// Creates the folder where one is wanted and missing, and opens every file in it. The files of an earlier run are removed, so that
    /// all files of a folder belong to one run. `statements` are what documents state about the conversions that the cases are about;
    /// the page shows them beside what the engines do. Pages of causes have no text of a program where they are `prose`.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the folder or a file cannot be made: before the run, not after it.
    pub fn create(folder: Option<&Path>, statements: Statements, prose: bool) -> Result<Self, ReportError> {
        let files = folder.map(|folder| ReportFiles::create(folder, statements, prose));
        Ok(Reports {
            overview: Overview::default(),
            files: files.transpose()?,
            broken: None,
        })
    }

    /// Adds one event. Returns whether it could be reported; after the first that could not, the reports get no more events.
    pub fn take(&mut self, event: &Event) -> bool {
        self.overview.take(event);
        if self.broken.is_none()
            && let Some(files) = &mut self.files
        {
            self.broken = files.take(event).err();
        }
        self.broken.is_none()
    }

    /// Returns the overview of the events so far.
    pub const fn overview(&self) -> &Overview {
        &self.overview
    }

    /// Completes the reports, and returns the overview. For a run that was cut short, only the event log stays.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written, or could not be.
    pub fn finish(self) -> Result<Overview, ReportError> {
        if let Some(error) = self.broken {
            return Err(error);
        }
        if let Some(files) = self.files {
            files.finish(&self.overview)?;
        }
        Ok(self.overview)
    }
}

impl ReportFiles {
    fn create(folder: &Path, statements: Statements, prose: bool) -> Result<ReportFiles, ReportError> {
        fs::create_dir_all(folder).map_err(ReportError::writing(folder))?;
        Ok(ReportFiles {
            events: EventLog::create(folder.join(events::NAME))?,
            junit: Junit::create(folder.join("junit.xml"))?,
            discrepancies: Discrepancies::create(folder, prose)?,
            page: Page::create(folder.join("index.html"), statements)?,
            of_overview: OF_OVERVIEW
                .iter()
                .map(|(name, _)| PendingFile::create(folder.join(name)))
                .collect::<Result<_, _>>()?,
        })
    }

    fn take(&mut self, event: &Event) -> Result<(), ReportError> {
        let group = self.events.take(event)?;
        self.junit.take(event, group);
        self.discrepancies.take(event);
        self.page.take(event, group);
        Ok(())
    }

    fn finish(mut self, overview: &Overview) -> Result<(), ReportError> {
        self.events.flush()?;
        let groups = self.events.groups();
        self.junit.finish(overview, groups)?;
        self.discrepancies.finish(overview)?;
        self.page.finish(overview, groups)?;
        if overview.footer.is_some() {
            for (file, (_, content)) in self.of_overview.into_iter().zip(OF_OVERVIEW) {
                file.fill(&content(overview)?)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Reports;
    use crate::ReportError;
    use crate::sample::{self, report as write};
    use std::fs;
    use stickler_conversions::overview::Statements;

    #[test]
    fn a_run_that_is_cut_short_leaves_only_its_log_also_where_an_earlier_run_left_more() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        write(folder.path(), &sample::run());
        let events = sample::run();
        write(folder.path(), &events[..events.len() - 1]);
        assert_eq!(sample::names(folder.path()), ["events.jsonl.gz"]);
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_an_error_that_names_it() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let blocked = folder.path().join("file");
        fs::write(&blocked, "").expect("a file in the way");
        let Err(ReportError::Write { path, .. }) =
            Reports::create(Some(&blocked.join("latest")), Statements::default(), false)
        else {
            panic!("a file is no folder");
        };
        assert!(path.starts_with(&blocked));
    }
}
