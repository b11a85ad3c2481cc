//! The overview of a run for people, gathered once for the terminal and the Markdown summary.

use crate::claims::{Claims, entry};
use crate::listed::ListedCases;
use crate::observations::Observations;
use std::collections::BTreeMap;
use stickler_run::{
    CaseEvent, Cause, EngineHeader, Event, Footer, Grade, Header, OutdatedEntry, Source, Totals, Verdict,
    clip_facts,
};
use stickler_types::sorted;

/// The maximum number of lines that are kept of each text of a failing case.
const MAX_KEPT_LINES: usize = 100;

/// The overview of a run: its totals, claims, failures and observations.
#[derive(Debug, Default)]
pub struct Overview {
    /// The header of the run; `None` before it came.
    pub header: Option<Header>,
    /// The claims of the run and their results.
    pub claims: Claims,
    /// The verdict counts by engine, dialect and area.
    pub totals: BTreeMap<String, BTreeMap<String, BTreeMap<String, Totals>>>,
    /// The number of all cases that did not come out as expected.
    pub failed: u64,
    /// The cases that did not pass and that reports list whole.
    pub(crate) listed: ListedCases,
    /// The number of values and acceptances that were recorded where no document states what they must be.
    pub observations: u64,
    /// The observations of all engines.
    pub observed: Observations,
    /// The causes of failing cases, those that explain most cases first; none where they were not searched for.
    pub causes: Vec<Cause>,
    /// The features that engines lack, those for which most cases wait first.
    pub lacks: Vec<Cause>,
    /// The footer of the run; `None` where the run was cut short.
    pub footer: Option<Footer>,
}

impl Overview {
    /// Adds one event.
    pub fn take(&mut self, event: &Event) {
        match event {
            Event::Header(header) => self.header = Some(header.clone()),
            Event::Case(case) => self.take_case(case),
            Event::Cause(cause) if cause.is_lack() => self.lacks.push(cause.clone()),
            Event::Cause(cause) => self.causes.push(cause.clone()),
            Event::Footer(footer) => self.footer = Some(footer.clone()),
        }
    }

    fn take_case(&mut self, case: &CaseEvent) {
        self.claims.take(case);
        self.observations += case.observations.len() as u64;
        self.observed.take(case);
        let dialects = entry(&mut self.totals, &case.engine);
        let areas = entry(dialects, &case.dialect);
        entry(areas, &case.area).count(case.verdict);
        if case.verdict != Verdict::Pass {
            self.listed.take(case);
        }
        if !case.verdict.is_as_expected() {
            self.failed += 1;
        }
    }

    /// Returns the number of features that engines lack although a source that binds them promises these.
    pub fn lacking(&self) -> u64 {
        self.lacks.iter().filter(|lack| lack.is_failing_lack()).count() as u64
    }

    /// Returns the causes of cases that are not as expected, those that explain most of these cases first: those whose programs were
    /// made small, and the others, most of which show one of these.
    pub(crate) fn unexpected_causes(&self) -> (Vec<&Cause>, Vec<&Cause>) {
        let mut causes: Vec<&Cause> = self
            .causes
            .iter()
            .filter(|cause| cause.unexpected() > 0)
            .collect();
        causes.sort_by_key(|cause| std::cmp::Reverse(cause.unexpected()));
        causes.into_iter().partition(|cause| !cause.is_partly_reduced())
    }

    /// Returns the listed cases that did not come out as expected.
    pub(crate) fn failures(&self) -> impl Iterator<Item = &CaseEvent> {
        let listed = self.listed.iter();
        listed.filter(|case| !case.verdict.is_as_expected())
    }

    /// Returns the listed failing cases that no cause explains: no cause is searched for what passed unexpectedly, and of some
    /// engines none is known.
    pub(crate) fn unexplained_failures(&self) -> impl Iterator<Item = &CaseEvent> {
        self.failures().filter(|case| {
            let is_known = |cause: &Cause| cause.engine == case.engine;
            case.verdict == Verdict::Xpass || !self.causes.iter().any(is_known)
        })
    }

    /// Returns the names of the engines, in the order of the run.
    pub fn engines(&self) -> Vec<&str> {
        let engines = self.header.iter().flat_map(|header| &header.engines);
        engines.map(|engine| engine.name.as_str()).collect()
    }

    /// Returns the sources that the header names.
    pub(crate) fn sources(&self) -> &[Source] {
        self.header.as_ref().map_or(&[], |header| &header.sources)
    }

    /// Returns a source by its key, where the header names it.
    pub(crate) fn source(&self, key: &str) -> Option<&Source> {
        self.sources().iter().find(|source| source.key == key)
    }

    /// Returns the engine with this name, where the header names it.
    pub(crate) fn engine(&self, name: &str) -> Option<&EngineHeader> {
        named(&self.header.as_ref()?.engines, name)
    }

    /// Returns the entries of baselines that are out of date; a run with any of them is not as expected.
    pub fn outdated(&self) -> impl Iterator<Item = &OutdatedEntry> {
        let baselines = self.header.iter().flat_map(|header| &header.baselines);
        baselines.flat_map(|baseline| &baseline.outdated)
    }

    /// Returns every area of the run, sorted.
    pub fn areas(&self) -> Vec<&str> {
        let of_dialects = self.totals.values().flat_map(BTreeMap::values);
        sorted(of_dialects.flat_map(BTreeMap::keys).map(String::as_str))
    }

    /// Returns the verdict counts of the whole run.
    pub fn sum(&self) -> Totals {
        let areas = self.totals.values().flat_map(BTreeMap::values);
        areas.flat_map(BTreeMap::values).sum()
    }
}

/// Copies a case with no more of its texts than any view shows, since the texts of a foreign engine may have any length.
pub(crate) fn kept(case: &CaseEvent) -> CaseEvent {
    CaseEvent {
        expected: clip_facts(&case.expected, MAX_KEPT_LINES),
        got: clip_facts(&case.got, MAX_KEPT_LINES),
        ..case.clone()
    }
}

/// Returns the engine with this name, where the header names it.
pub(crate) fn named<'h>(engines: &'h [EngineHeader], name: &str) -> Option<&'h EngineHeader> {
    engines.iter().find(|engine| engine.name == name)
}

/// Returns the worst grade of a rejection by an engine that still passed; [`Grade::Code`] for an engine that the header does
/// not name.
pub(crate) fn strictness(engine: Option<&EngineHeader>) -> Grade {
    engine.map_or(Grade::Code, |engine| engine.strict)
}

/// Returns the command that runs a case again; empty for an engine that the header does not name.
pub(crate) fn rerun(engine: Option<&EngineHeader>, case: &CaseEvent) -> String {
    engine.map_or_else(String::new, |engine| engine.rerun(&case.id, &case.dialect))
}

#[cfg(test)]
mod tests {
    use super::Overview;
    use crate::sample;
    use stickler_run::{CaseEvent, Verdict};

    fn overview(cases: Vec<CaseEvent>) -> Overview {
        sample::overview(&sample::run_of(cases))
    }

    #[test]
    fn what_is_as_expected_is_counted_and_only_what_is_not_is_kept() {
        let overview = overview(Verdict::ALL.map(|verdict| sample::case("a", verdict)).to_vec());
        assert_eq!((overview.failed, overview.failures().count()), (5, 5));
        assert_eq!(overview.sum().all(), 10);
        assert_eq!(overview.areas(), ["widening"]);
    }
}
