//! Checks of a `results.json` beyond its schema: what its parts say of each other.

use super::document::{EngineResult, ResultsDocument, case_key};
use super::error::ResultsError;
use std::collections::{HashMap, HashSet};
use stickler_run::{Totals, Verdict};

/// Checks that the date is one, that engines have names of their own, that each case stands once and has an engine, that lists by dialect have
/// an element for each dialect, and that the totals are those of the listed cases. Returns the totals of each engine.
///
/// # Errors
/// [`ResultsError::Contradiction`].
pub(super) fn check(document: &ResultsDocument<'_>) -> Result<Vec<Totals>, ResultsError> {
    if document.started.parse::<jiff::Timestamp>().is_err() {
        let found = quoted(&document.started);
        return wrong("started", "a time such as 2026-09-01T12:00:00Z", found);
    }
    let mut counter = CaseCounter::new(&document.engines)?;
    for (at, case) in document.cases.iter().enumerate() {
        let path = format!("cases[{at}]");
        if case.verdict == Verdict::Pass {
            let expected = "a verdict other than pass, since the cases that passed stand in `passed`";
            return wrong(&format!("{path}.verdict"), expected, "pass");
        }
        counter.count(&path, (&case.engine, &case.dialect), &case.id, "", case.verdict)?;
    }
    for (at, probe) in document.passed.iter().enumerate() {
        for (arguments, durations) in &probe.duration_us.0 {
            let path = format!("passed[{at}].duration_us.{arguments}");
            by_dialect(&path, durations, &probe.dialects)?;
            for dialect in &probe.dialects {
                counter.count(
                    &path,
                    (&probe.engine, dialect),
                    &probe.id,
                    arguments,
                    Verdict::Pass,
                )?;
            }
        }
    }
    for (at, probe) in document.observations.iter().enumerate() {
        for (arguments, values) in &probe.values.0 {
            let path = format!("observations[{at}].values.{arguments}");
            by_dialect(&path, values, &probe.dialects)?;
        }
    }
    counter.finish(&document.engines)
}

/// Counts the cases of each engine, and notices those that stand twice.
struct CaseCounter<'d> {
    numbers: HashMap<&'d str, usize>,
    totals: Vec<Totals>,
    known: HashSet<String>,
}

impl<'d> CaseCounter<'d> {
    fn new(engines: &'d [EngineResult<'_>]) -> Result<CaseCounter<'d>, ResultsError> {
        let mut numbers = HashMap::new();
        for (number, engine) in engines.iter().enumerate() {
            let path = format!("engines[{number}].name");
            if engine.name.trim().is_empty() {
                return wrong(&path, "a name", quoted(&engine.name));
            }
            if numbers.insert(&*engine.name, number).is_some() {
                let found = format!("{} a second time", quoted(&engine.name));
                return wrong(&path, "a name that no other engine has", found);
            }
        }
        if engines.is_empty() {
            return wrong("engines", "at least one engine", "none");
        }
        Ok(CaseCounter {
            totals: vec![Totals::default(); engines.len()],
            numbers,
            known: HashSet::new(),
        })
    }

    fn count(
        &mut self,
        path: &str,
        (engine, dialect): (&str, &str),
        probe: &str,
        arguments: &str,
        verdict: Verdict,
    ) -> Result<(), ResultsError> {
        let Some(number) = self.numbers.get(engine) else {
            return wrong(path, "an engine that `engines` names", quoted(engine));
        };
        if !self.known.insert(case_key(engine, dialect, probe, arguments)) {
            let found = format!(
                "{} a second time",
                quoted(&format!("{probe}{arguments}@{dialect}"))
            );
            return wrong(path, "each case of an engine once", found);
        }
        self.totals[*number].count(verdict);
        Ok(())
    }

    fn finish(self, engines: &[EngineResult<'_>]) -> Result<Vec<Totals>, ResultsError> {
        for (number, (engine, counted)) in engines.iter().zip(&self.totals).enumerate() {
            for verdict in Verdict::ALL {
                let (counted, stated) = (counted.of(verdict), engine.totals.of(verdict));
                if counted != stated {
                    let path = format!("engines[{number}].totals.{}", verdict.as_str());
                    let expected = format!("{counted}, as many cases as the document lists");
                    return wrong(&path, &expected, stated.to_string());
                }
            }
        }
        Ok(self.totals)
    }
}

fn by_dialect<T, D>(path: &str, values: &[T], dialects: &[D]) -> Result<(), ResultsError> {
    match values.len() == dialects.len() {
        true => Ok(()),
        false => {
            let expected = format!("{} elements, one for each of `dialects`", dialects.len());
            wrong(path, &expected, values.len().to_string())
        }
    }
}

fn wrong<T>(path: &str, expected: &str, found: impl Into<String>) -> Result<T, ResultsError> {
    Err(ResultsError::Contradiction {
        path: path.to_owned(),
        expected: expected.to_owned(),
        found: found.into(),
    })
}

/// Returns a text of the document in quotes, in one line and not too long.
fn quoted(text: &str) -> String {
    let mut characters = text.chars();
    let start: String = characters.by_ref().take(80).collect();
    let rest = if characters.next().is_some() { "…" } else { "" };
    format!("{start:?}{rest}")
}
