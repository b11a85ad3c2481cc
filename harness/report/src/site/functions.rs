//! The conversion functions of the site: what documents state of them, what the newest run of each engine gave, and what was recorded.

use super::SiteError;
use super::history::History;
use super::run::SiteRun;
use crate::answers::answer_of;
use crate::events::Reader;
use std::collections::{BTreeMap, HashMap};
use stickler_conversions::overview::{
    ComparedAnswer, FunctionCall, FunctionTable, QuestionNumber, Statements,
};
use stickler_run::{Event, SourceHeader};

/// The functions of the site, and the columns of their tables.
pub(super) struct Functions<'s> {
    /// The tables of each function, by its name, in the order of the names.
    pub(super) tables: BTreeMap<&'s str, Vec<FunctionTable<'s>>>,
    pub(super) columns: Vec<FunctionColumn<'s>>,
    /// The sources of all runs, by key.
    pub(super) sources: BTreeMap<&'s str, &'s SourceHeader>,
}

/// The answers of an engine, or of a recorded compiler, in one dialect.
pub(super) struct FunctionColumn<'s> {
    /// The name of the engine or of the product.
    pub(super) name: &'s str,
    pub(super) version: &'s str,
    pub(super) dialect: String,
    pub(super) origin: AnswerOrigin<'s>,
    pub(super) answers: HashMap<QuestionNumber, ComparedAnswer>,
}

/// The origin of the answers of a column.
#[derive(Clone, Copy)]
pub(super) enum AnswerOrigin<'s> {
    /// A run of the site.
    Run(&'s SiteRun),
    /// A recording, made on this day.
    Recording(&'s str),
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
        let mut tables: BTreeMap<&str, Vec<FunctionTable<'_>>> = BTreeMap::new();
        for table in statements.functions() {
            tables.entry(table.name).or_default().push(table);
        }
        let mut columns = Vec::new();
        if !tables.is_empty() {
            // Compilers stand before Stickler's own reference.
            let (own, others): (Vec<_>, Vec<_>) =
                histories.iter().partition(|history| history.name == "reference");
            for history in others.iter().chain(&own) {
                columns.extend(of_engine(history, statements)?);
            }
            columns.extend(recorded(statements, histories));
        }
        let sources = runs.iter().rev().flat_map(|run| &run.header.sources);
        let mut by_key = BTreeMap::new();
        for source in sources {
            by_key.entry(source.key.as_str()).or_insert(source);
        }
        Ok(Functions {
            tables,
            columns,
            sources: by_key,
        })
    }

    /// Returns the functions for which an engine has other answers than sources state, each with the number of calls.
    pub(super) fn departures(&self, engine: &str) -> Vec<(&'s str, usize)> {
        let of_run = self.columns.iter().filter(|column| column.is_of_run());
        let columns: Vec<&FunctionColumn<'_>> = of_run.filter(|column| column.name == engine).collect();
        let departing = |(name, tables): (&&'s str, &Vec<FunctionTable<'s>>)| {
            let calls = tables.iter().flat_map(|table| &table.calls);
            let number = calls.filter(|call| columns.iter().any(|column| column.departs(call)));
            let number = number.count();
            (number > 0).then_some((*name, number))
        };
        self.tables.iter().filter_map(departing).collect()
    }
}

impl FunctionColumn<'_> {
    /// Returns whether the answers are of a run of the site.
    pub(super) const fn is_of_run(&self) -> bool {
        matches!(self.origin, AnswerOrigin::Run(_))
    }

    /// Returns whether the answer to a call is another one than its source states.
    pub(super) fn departs(&self, call: &FunctionCall<'_>) -> bool {
        matches!(self.answers.get(&call.question), Some(ComparedAnswer::Other(_)))
    }
}

/// Returns the file name of a function's page.
pub(super) fn file(function: &str) -> String {
    format!("{function}.html")
}

/// Returns the columns of an engine, one for each dialect, from the run that counts for its newest version.
fn of_engine<'s>(
    history: &'s History<'s>,
    statements: &Statements,
) -> Result<Vec<FunctionColumn<'s>>, SiteError> {
    let newest = history.newest();
    let log = &newest.run.log;
    let unreadable = SiteError::run(log);
    let mut by_dialect: BTreeMap<String, HashMap<QuestionNumber, ComparedAnswer>> = BTreeMap::new();
    for event in Reader::open(log).map_err(&unreadable)? {
        let Event::Case(case) = event.map_err(&unreadable)? else {
            continue;
        };
        if case.engine == history.name
            && let Some(question) = statements.question(&case.id)
            && let Some(answer) = answer_of(&case)
        {
            let answers = by_dialect.entry(case.dialect).or_default();
            let known = answers.entry(question).or_insert_with(|| answer.clone());
            if answer > *known {
                *known = answer;
            }
        }
    }
    let columns = by_dialect.into_iter().map(|(dialect, answers)| FunctionColumn {
        name: history.name,
        version: newest.version,
        dialect,
        origin: AnswerOrigin::Run(newest.run),
        answers,
    });
    Ok(columns.collect())
}

/// Returns the columns of the recorded compilers that are no engine of the site.
fn recorded<'s>(
    statements: &'s Statements,
    histories: &[History<'_>],
) -> impl Iterator<Item = FunctionColumn<'s>> {
    let others = statements.recorded().iter();
    let others = others.filter(|recorded| !histories.iter().any(|history| recorded.is_of(history.name)));
    others.map(|recorded| FunctionColumn {
        name: &recorded.origin.product,
        version: &recorded.origin.version,
        dialect: recorded.dialect.as_str().to_owned(),
        origin: AnswerOrigin::Recording(&recorded.origin.date),
        answers: recorded.answers.iter().cloned().collect(),
    })
}
