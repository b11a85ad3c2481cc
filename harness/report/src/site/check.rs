//! Checks of an event log that anyone hands in, beyond its schema: what its lines say of each other.

use crate::LogError;
use std::collections::{HashMap, HashSet};
use stickler_run::{CaseEvent, Footer, Header, Totals, Verdict};

/// Checks that engines have names of their own, that each case stands once and has an engine, and that the totals are those of the cases.
pub(super) struct LogCheck {
    /// The totals that were counted of each engine.
    counted: HashMap<String, Totals>,
    known: HashSet<String>,
}

impl LogCheck {
    /// Begins the check of a run with this header.
    ///
    /// # Errors
    /// [`LogError::Contradiction`].
    pub(super) fn new(header: &Header) -> Result<LogCheck, LogError> {
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
    pub(super) fn case(&mut self, line: u64, case: &CaseEvent) -> Result<(), LogError> {
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
    pub(super) fn footer(&self, line: u64, footer: &Footer) -> Result<(), LogError> {
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
