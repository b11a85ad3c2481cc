//! A run of the site: its header, and the results of each engine by area.

use super::SiteError;
use crate::LogError;
use crate::claims::{Standing, entry};
use crate::events::{self, Reader};
use crate::parts::describe_error;
use jiff::Timestamp;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::io::BufRead;
use std::path::{Path, PathBuf};
use stickler_run::{CaseEvent, Cause, Event, Footer, Header, Totals, Verdict};

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

/// Checks that engines have names of their own, that each case stands once and has an engine, and that the totals are those of the cases.
struct LogCheck {
    /// The totals that were counted of each engine.
    counted: HashMap<String, Totals>,
    known: HashSet<String>,
}

impl LogCheck {
    /// Begins the check of a run with this header.
    ///
    /// # Errors
    /// [`LogError::Contradiction`].
    fn new(header: &Header) -> Result<LogCheck, LogError> {
        let mut counted = HashMap::new();
        for engine in &header.engines {
            if engine.name.trim().is_empty() {
                return wrong(1, "an engine with a name", quoted(&engine.name));
            }
            if counted.insert(engine.name.clone(), Totals::default()).is_some() {
                let found = format!("{} a second time", quoted(&engine.name));
                return wrong(1, "engines with names of their own", found);
            }
        }
        if counted.is_empty() {
            return wrong(1, "at least one engine", "none");
        }
        let known = HashSet::new();
        Ok(LogCheck { counted, known })
    }

    /// Counts a case, which stands on this line.
    ///
    /// # Errors
    /// [`LogError::Contradiction`].
    fn case(&mut self, line: u64, case: &CaseEvent) -> Result<(), LogError> {
        let Some(totals) = self.counted.get_mut(&case.engine) else {
            return wrong(line, "an engine that the header names", quoted(&case.engine));
        };
        totals.count(case.verdict);
        let key = format!("{}\0{}\0{}", case.engine, case.dialect, case.id);
        if self.known.insert(key) {
            return Ok(());
        }
        let found = format!(
            "{} a second time",
            quoted(&format!("{}@{}", case.id, case.dialect))
        );
        wrong(line, "each case of an engine once", found)
    }

    /// Compares the totals of the footer, which stands on this line, with those that were counted.
    ///
    /// # Errors
    /// [`LogError::Contradiction`].
    fn footer(&self, line: u64, footer: &Footer) -> Result<(), LogError> {
        let mut all = Totals::default();
        for (name, counted) in &self.counted {
            let stated = footer.engines.iter().find(|engine| engine.name == *name);
            let stated = stated.map(|engine| engine.totals).unwrap_or_default();
            same(line, &format!("cases on {}", quoted(name)), *counted, stated)?;
            all += *counted;
        }
        same(line, "cases", all, footer.totals)
    }
}

fn same(line: u64, what: &str, counted: Totals, stated: Totals) -> Result<(), LogError> {
    let differing = |verdict: &Verdict| counted.of(*verdict) != stated.of(*verdict);
    match Verdict::ALL.into_iter().find(differing) {
        None => Ok(()),
        Some(verdict) => {
            let expected = format!(
                "{} {verdict} {what}, as many as the log lists",
                counted.of(verdict)
            );
            wrong(line, &expected, stated.of(verdict).to_string())
        }
    }
}

fn wrong<T>(line: u64, expected: &str, found: impl Into<String>) -> Result<T, LogError> {
    Err(LogError::Contradiction {
        line,
        expected: expected.to_owned(),
        found: found.into(),
    })
}

/// Returns a text of the log in quotes, in one line and not too long.
fn quoted(text: &str) -> String {
    format!("{:?}", stickler_types::shortened(text, 80))
}
