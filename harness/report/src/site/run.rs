//! A run of the site: its header, and the results of each engine by area.

use super::SiteError;
use super::check::LogCheck;
use crate::LogError;
use crate::claims::{Standing, entry};
use crate::events::{self, Reader};
use crate::parts::describe_error;
use jiff::Timestamp;
use std::collections::BTreeMap;
use std::io::BufRead;
use std::path::{Path, PathBuf};
use stickler_run::{Cause, Event, Header};

/// A run, counted.
pub(super) struct SiteRun {
    /// The event log of the run.
    pub(super) log: PathBuf,
    /// The page of the run, where its folder has one.
    pub(super) page: Option<PathBuf>,
    /// The place of the run among all, from 1 for the oldest.
    pub(super) number: usize,
    pub(super) started: Timestamp,
    pub(super) header: Header,
    /// The results by engine and area.
    pub(super) standings: BTreeMap<String, BTreeMap<String, Standing>>,
    pub(super) causes: Vec<Cause>,
}

impl SiteRun {
    /// Reads the runs, and sorts them by date; runs of one date stay in the order in which they are named.
    ///
    /// With `skip_unreadable`, runs that cannot be read are left out, as long as another can be read; each is described by a sentence.
    pub(super) fn read_all(
        paths: &[PathBuf],
        skip_unreadable: bool,
    ) -> Result<(Vec<SiteRun>, Vec<String>), SiteError> {
        let mut runs = Vec::with_capacity(paths.len());
        let mut errors = Vec::new();
        for path in paths {
            match SiteRun::read(path) {
                Ok(run) => runs.push(run),
                Err(error) if skip_unreadable => errors.push(error),
                Err(error) => return Err(error),
            }
        }
        let skipped = errors
            .iter()
            .map(|error| format!("this run is left out: {}", describe_error(error)));
        let skipped = skipped.collect();
        if runs.is_empty()
            && let Some(first) = errors.into_iter().next()
        {
            return Err(first);
        }
        runs.sort_by_key(|run| run.started);
        for (at, run) in runs.iter_mut().enumerate() {
            run.number = at + 1;
        }
        Ok((runs, skipped))
    }

    fn read(path: &Path) -> Result<SiteRun, SiteError> {
        let log = events::locate(path);
        let unreadable = SiteError::run(&log);
        let mut events = Reader::open(&log).map_err(&unreadable)?;
        let header = events.header().map_err(&unreadable)?;
        let started = header.started.parse().map_err(|_| SiteError::Date {
            path: log.clone(),
            started: header.started.clone(),
        })?;
        // What lies beside a log of another name, which somebody handed in, need not be its page.
        let is_own = log.file_name().is_some_and(|name| name == events::NAME);
        let page = Some(log.with_file_name("index.html"));
        let mut run = SiteRun {
            page: page.filter(|page| is_own && page.is_file()),
            number: 0,
            started,
            header,
            standings: BTreeMap::new(),
            causes: Vec::new(),
            log,
        };
        run.take(&mut events).map_err(&unreadable)?;
        Ok(run)
    }

    /// Counts the cases of the run.
    fn take(&mut self, events: &mut Reader<impl BufRead>) -> Result<(), LogError> {
        let mut check = LogCheck::new(&self.header)?;
        while let Some(event) = events.next().transpose()? {
            match event {
                Event::Case(case) => {
                    check.case(events.line(), &case)?;
                    let areas = entry(&mut self.standings, &case.engine);
                    entry(areas, &case.area).count(&case);
                }
                Event::Cause(cause) => self.causes.push(cause),
                Event::Footer(footer) => check.footer(events.line(), &footer)?,
                // The reader rejects a second header.
                Event::Header(_) => {}
            }
        }
        events.check_complete()
    }

    /// Returns the name that the copy of the run's page has.
    pub(super) fn page_name(&self) -> String {
        format!("{}.html", self.number)
    }

    /// Returns the results of an engine in all areas.
    pub(super) fn sum(&self, engine: &str) -> Standing {
        let areas = self.standings.get(engine).into_iter();
        areas.flat_map(BTreeMap::values).sum()
    }

    /// Returns the day on which the run began, such as `2026-09-01`.
    pub(super) fn date(&self) -> String {
        self.started.strftime("%F").to_string()
    }
}
