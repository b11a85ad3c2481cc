//! The conversion functions of the site: the page of a run, with what the newest run of each engine gave and without cases.

use super::SiteError;
use super::history::History;
use super::run::SiteRun;
use crate::answers::answer_of;
use crate::events::Reader;
use crate::overview;
use crate::page::{self, PageAnswers};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use stickler_conversions::overview::{ComparedAnswer, QuestionNumber, Statements};
use stickler_run::Event;

/// The functions of the site, and what engines and recorded compilers give.
pub(super) struct Functions<'s> {
    statements: &'s Statements,
    answers: PageAnswers,
    /// The newest runs of the engines, as the scripts of a page read the header of a run.
    runs: Value,
    /// By engine and function, the calls that give something else than sources state.
    departures: BTreeMap<&'s str, BTreeMap<&'s str, BTreeSet<QuestionNumber>>>,
}

impl<'s> Functions<'s> {
    /// Reads the newest run of each engine again. Recordings of an engine that ran are left out.
    ///
    /// # Errors
    /// [`SiteError`] where a run can no longer be read.
    pub(super) fn gather(
        statements: &'s Statements,
        histories: &'s [History<'s>],
        runs: &'s [SiteRun],
    ) -> Result<Functions<'s>, SiteError> {
        let sources = runs.iter().rev().flat_map(|run| &run.header.sources);
        let mut by_key = BTreeMap::new();
        for source in sources {
            by_key.entry(source.key.as_str()).or_insert(source);
        }
        let mut functions = Functions {
            statements,
            answers: PageAnswers::default(),
            runs: json!({
                "header": {
                    "engines": histories.iter().map(newest_run).collect::<Vec<_>>(),
                    // Those of all runs, each as the newest run has it.
                    "sources": by_key.into_values().collect::<Vec<_>>(),
                },
                // The page has no cases.
                "claims": [],
            }),
            departures: BTreeMap::new(),
        };
        if !statements.function_names().is_empty() {
            for history in histories {
                functions.read(history)?;
            }
            let engines: Vec<&str> = histories.iter().map(|history| history.name).collect();
            functions.answers.add_recordings(statements, &engines);
        }
        Ok(functions)
    }

    /// Takes the answers of the run that counts for an engine's newest version.
    fn read(&mut self, history: &History<'s>) -> Result<(), SiteError> {
        let log = &history.newest().run.log;
        let unreadable = SiteError::run(log);
        for event in Reader::open(log).map_err(&unreadable)? {
            let Event::Case(case) = event.map_err(&unreadable)? else {
                continue;
            };
            let Some(question) = self.statements.question(&case.id) else {
                continue;
            };
            if case.engine != history.name {
                continue;
            }
            self.answers.take(&case, question, None);
            if let Some(ComparedAnswer::Other(_)) = answer_of(&case)
                && let Some(function) = self.statements.function_of(question)
            {
                let departures = self.departures.entry(history.name).or_default();
                departures.entry(function).or_default().insert(question);
            }
        }
        Ok(())
    }

    /// Returns the names of the functions.
    pub(super) fn names(&self) -> BTreeSet<&'s str> {
        self.statements.function_names()
    }

    /// Returns the functions for which an engine has other answers than sources state, each with the number of calls.
    pub(super) fn departures(&self, engine: &str) -> Vec<(&'s str, usize)> {
        let departures = self.departures.get(engine).into_iter().flatten();
        departures.map(|(name, calls)| (*name, calls.len())).collect()
    }

    /// Returns the page of all functions.
    ///
    /// # Errors
    /// Returns the error of serde_json.
    pub(super) fn into_page(self) -> io::Result<Vec<u8>> {
        let mut text = Vec::new();
        page::write(
            &mut text,
            &self.runs,
            (self.statements, self.answers),
            None::<&()>,
        )?;
        Ok(text)
    }
}

/// Returns the newest run of an engine, with the address of the copy of its page, if it has one.
fn newest_run(history: &History<'_>) -> Value {
    let newest = history.newest();
    let engine = overview::named(&newest.run.header.engines, history.name);
    let page = newest.run.page.is_some();
    json!({
        "name": history.name,
        "version": newest.version,
        "dialects": engine.map_or(&[][..], |engine| &engine.dialects),
        "page": page.then(|| format!("../runs/{}", newest.run.page_name())),
    })
}

/// Returns the address of a function's part of the page, in the folder of the page.
pub(super) fn address(function: &str) -> String {
    format!("index.html#{function}")
}
