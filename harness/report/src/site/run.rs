//! A run of the site: its header, and the results of each engine by area.

use super::SiteError;
use crate::claims::{Standing, entry};
use crate::events::{self, Completeness, Reader};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use stickler_run::{Cause, Event, Header};

/// A run, counted.
pub(super) struct SiteRun {
    /// The path of the event log.
    pub(super) log: PathBuf,
    /// The page of the run, where its folder has one.
    pub(super) page: Option<PathBuf>,
    /// The place of the run among all, from 1 for the oldest.
    pub(super) number: usize,
    pub(super) header: Header,
    /// The results by engine and area.
    pub(super) standings: BTreeMap<String, BTreeMap<String, Standing>>,
    pub(super) causes: Vec<Cause>,
}

impl SiteRun {
    /// Reads the runs, and sorts them by date; runs of one date stay in the order in which they are named.
    pub(super) fn read_all(paths: &[PathBuf]) -> Result<Vec<SiteRun>, SiteError> {
        let runs: Result<Vec<SiteRun>, SiteError> = paths.iter().map(|path| SiteRun::read(path)).collect();
        let mut runs = runs?;
        runs.sort_by(|one, other| one.header.started.cmp(&other.header.started));
        for (at, run) in runs.iter_mut().enumerate() {
            run.number = at + 1;
        }
        Ok(runs)
    }

    fn read(path: &Path) -> Result<SiteRun, SiteError> {
        let log = events::locate(path);
        let unreadable = |source| SiteError::Log {
            path: log.clone(),
            source,
        };
        let mut reader = Reader::open(&log).map_err(unreadable)?;
        let mut run = SiteRun {
            page: Some(log.with_file_name("index.html")).filter(|page| page.is_file()),
            number: 0,
            header: reader.header().map_err(unreadable)?,
            standings: BTreeMap::new(),
            causes: Vec::new(),
            log: log.clone(),
        };
        for event in &mut reader {
            match event.map_err(unreadable)? {
                Event::Case(case) => {
                    let areas = entry(&mut run.standings, &case.engine);
                    entry(areas, &case.area).count(&case);
                }
                Event::Cause(cause) => run.causes.push(cause),
                Event::Header(_) | Event::Footer(_) => {}
            }
        }
        match reader.completeness() {
            Completeness::Complete => Ok(run),
            completeness => Err(SiteError::Truncated {
                path: log,
                completeness,
            }),
        }
    }

    /// Returns the name that the copy of the run's page has.
    pub(super) fn page_name(&self) -> String {
        format!("{}.html", self.number)
    }

    /// Returns the results of an engine in all areas.
    pub(super) fn sum(&self, engine: &str) -> Standing {
        let mut sum = Standing::default();
        let areas = self.standings.get(engine).into_iter().flatten();
        areas.for_each(|(_, standing)| sum.add(*standing));
        sum
    }
}
