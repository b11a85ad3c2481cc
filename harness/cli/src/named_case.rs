//! Finds the case that a command names.

use crate::arguments::SelectionArguments;
use crate::case_folder::CaseFolder;
use crate::run_plan;
use anyhow::bail;
use std::path::Path;
use stickler_run::{Filter, Plan};
use stickler_suite::{Case, Suite};
use stickler_types::{DialectName, sorted};

/// The maximum number of ids that are suggested for an unknown one.
const MAX_SUGGESTIONS: usize = 5;

/// The maximum length of a name that is compared with ids; a longer one is no misspelt id.
const MAX_NAME_LEN: usize = 200;

/// A suite that was loaded for one case, which may be there in several dialects.
pub struct NamedCase<'n> {
    /// The suite; of its files only those were read that may have the case.
    pub suite: Suite,
    /// The plan that selects the case.
    pub plan: Plan,
    name: &'n str,
}

impl<'n> NamedCase<'n> {
    /// Loads the case of an id, with or without `@dialect`; `cases` is the folder of cases, where one was named.
    ///
    /// # Errors
    /// No folder of cases; no such case, where the error says why it was withdrawn or names similar ones.
    pub fn load(name: &'n str, cases: Option<&Path>) -> anyhow::Result<NamedCase<'n>> {
        let selection = SelectionArguments {
            cases: cases.map(Path::to_owned),
            filter: vec![name.to_owned()],
            ..SelectionArguments::default()
        };
        let plan = run_plan::plan(&selection, None);
        let dialect = Filter::new(name).dialect();
        let dialects: Vec<DialectName> = dialect.into_iter().collect();
        let folder = CaseFolder::locate(cases)?;
        let suite = folder.load_selected(&plan, &dialects, &dialects);
        let named = NamedCase { suite, plan, name };
        if named.cases().is_empty() {
            let (id, dialect) = name.split_once('@').unwrap_or((name, ""));
            if let Some(entry) = named.suite.withdrawn(id, dialect) {
                let (date, reason, instead) = (&entry.date, entry.reason.trim(), entry.instead.trim());
                bail!("the case `{name}` was withdrawn on {date}: {reason}\n  instead: {instead}");
            }
            let others = folder.load_selected(&named.plan, &dialects, &[]);
            bail!("{}", no_such_case(&others, name));
        }
        Ok(named)
    }

    /// Returns the case in each of its dialects, or in the one that was named.
    pub fn cases(&self) -> Vec<&Case> {
        let name = Filter::new(self.name);
        let cases = self.suite.cases.iter();
        cases
            .filter(|case| name.names(&case.id, case.dialect.as_str()))
            .collect()
    }
}

fn no_such_case(suite: &Suite, name: &str) -> String {
    let elsewhere = in_other_dialects(suite, name);
    if let Some((id, dialect)) = name.rsplit_once('@')
        && !elsewhere.is_empty()
    {
        return format!(
            "the case `{id}` is not in the dialect {dialect}; did you mean one of these?\n  {}",
            elsewhere.join("\n  ")
        );
    }
    let close = suggestions(suite, name);
    if close.is_empty() {
        return format!("there is no case `{name}`; `stickler list` lists all");
    }
    format!(
        "there is no case `{name}`; did you mean one of these?\n  {}",
        close.join("\n  ")
    )
}

/// Returns the keys of the case whose id stands before the `@` of a name.
fn in_other_dialects(suite: &Suite, name: &str) -> Vec<String> {
    let id = name.rsplit_once('@').map_or("", |(id, _)| id);
    let cases = suite.cases.iter().filter(|case| &*case.id == id);
    cases.map(Case::key).collect()
}

/// Returns the ids that contain the name, or else the ids with the most similar spelling.
fn suggestions<'a>(suite: &'a Suite, name: &str) -> Vec<&'a str> {
    let name = name.split('@').next().unwrap_or(name);
    let ids: Vec<&str> = sorted(suite.cases.iter().map(|case| &*case.id));
    let mut close: Vec<&str> = ids
        .iter()
        .copied()
        .filter(|id| id.contains(name))
        .take(MAX_SUGGESTIONS)
        .collect();
    if close.is_empty() && name.len() <= MAX_NAME_LEN {
        let mut near: Vec<(usize, &str)> = ids
            .iter()
            .map(|id| (strsim::levenshtein(id, name), *id))
            .filter(|(distance, id)| *distance <= id.len() / 3)
            .collect();
        near.sort_unstable();
        close = near.into_iter().map(|(_, id)| id).take(MAX_SUGGESTIONS).collect();
    }
    close
}
