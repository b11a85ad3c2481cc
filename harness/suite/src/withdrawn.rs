//! The cases that were withdrawn, from `withdrawn.toml`: what was claimed, why it was wrong, and what came instead.

use serde::Deserialize;
use toml::Spanned;

use crate::Suite;
use crate::error::{CaseFileError, Mistake};
use crate::files::{self, Root};
use crate::place::Lines;
use crate::toml_text::Strings;

/// The file of the withdrawn cases, below the root of a suite.
const WITHDRAWN: &str = "withdrawn.toml";
/// The page of the changes between versions of the suite, below its root.
const CHANGES: &str = "CHANGES.md";

/// Cases that were wrong and are gone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Withdrawn {
    /// The id of a case, of all cases of a probe (`folder/file::probe`), of those with the same first arguments (`folder/file::probe(INT,BOOL`)
    /// or of a file; with `@dialect` those of one dialect.
    pub id: String,
    /// The date of the withdrawal, `2026-11-28`.
    pub date: String,
    /// The reason why they were wrong.
    pub reason: String,
    /// What is asked or claimed instead.
    pub instead: String,
    /// The file, as messages show it, and the line.
    place: (String, u32),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WithdrawnFile {
    #[serde(default)]
    withdrawn: Vec<WithdrawnTable>,
}

/// A table of the file: one reason for one id or for several.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WithdrawnTable {
    id: Spanned<Strings>,
    date: String,
    reason: String,
    instead: String,
}

impl WithdrawnTable {
    /// Returns an entry for each id, and one without an id, which is a mistake, where the list is empty.
    fn entries(self, shown: &str, lines: &Lines) -> Vec<Withdrawn> {
        let start = self.id.span();
        let mut ids = self.id.into_inner().0;
        if ids.is_empty() {
            ids.push(Spanned::new(start, String::new()));
        }
        let entry = |id: Spanned<String>| Withdrawn {
            place: (shown.to_owned(), lines.line(id.span().start)),
            id: id.into_inner(),
            date: self.date.clone(),
            reason: self.reason.clone(),
            instead: self.instead.clone(),
        };
        ids.into_iter().map(entry).collect()
    }
}

impl Withdrawn {
    fn covers(&self, id: &str, dialect: &str) -> bool {
        let (own, of) = self.id.split_once('@').unwrap_or((&self.id, dialect));
        let rest = id.strip_prefix(own);
        let is_of = of == dialect || dialect.is_empty();
        is_of && rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['(', ':', ',', ')']))
    }

    /// Returns what is wrong with the entry.
    fn mistake(&self) -> Option<&'static str> {
        let is_fit = |(at, c): (usize, char)| [4, 7].contains(&at) == (c == '-') && !c.is_alphabetic();
        let texts = [&self.id, &self.reason, &self.instead];
        if self.date.len() != 10 || !self.date.char_indices().all(is_fit) {
            return Some("`date` is no date: write `2026-11-28`");
        }
        let is_empty = texts.iter().any(|text| text.trim().is_empty());
        is_empty.then_some("`id`, `reason` or `instead` is empty")
    }

    fn wrong(&self, message: impl Into<String>, hint: &str) -> CaseFileError {
        let mistake = Mistake::new(self.place.1, message).key(self.id.clone());
        mistake.hint(hint).in_file(&self.place.0)
    }
}

impl Suite {
    /// Returns the entry by which a case was withdrawn; `dialect` is empty where all dialects are meant.
    pub fn withdrawn(&self, id: &str, dialect: &str) -> Option<&Withdrawn> {
        let mut entries = self.withdrawn.iter();
        entries.find(|entry| entry.covers(id, dialect))
    }

    /// Returns a mistake for each entry of which a case is still there.
    pub(crate) fn withdrawn_and_there(&self) -> Vec<CaseFileError> {
        let mistake = |entry: &Withdrawn| {
            let mut cases = self.cases.iter();
            let case = cases.find(|case| entry.covers(&case.id, case.dialect.as_str()))?;
            let (key, file, line) = (case.key(), &case.file, case.line);
            let message = format!("it is withdrawn and still there: `{key}`, {file}:{line}");
            Some(entry.wrong(message, "take the case out, or the entry"))
        };
        self.withdrawn.iter().filter_map(mistake).collect()
    }

    /// Reads the withdrawn cases; a suite without the file has withdrawn none.
    pub(crate) fn read_withdrawn(&mut self, root: &Root) {
        let shown = root.shown(WITHDRAWN);
        let changes = files::read(&root.path().join(CHANGES)).unwrap_or_default();
        let (entries, errors) = root.read_toml(WITHDRAWN, |file: WithdrawnFile, lines| {
            let tables = file.withdrawn.into_iter();
            let entries = tables.flat_map(|table| table.entries(&shown, lines));
            (entries.collect::<Vec<Withdrawn>>(), Vec::new())
        });
        self.errors.extend(errors);
        for entry in &entries {
            if let Some(message) = entry.mistake() {
                self.errors
                    .push(entry.wrong(message, "see \"Withdrawn cases\" in conformance-cases/README.md"));
            } else if !changes.contains(&format!("`{}`", entry.id)) {
                let message = format!(
                    "{CHANGES} does not name it, so that no version of the suite had it or the page is to be written anew"
                );
                let hint = "`stickler changes OLD -o CHANGES.md` names those that the older version has";
                self.remarks.push(entry.wrong(message, hint));
            }
        }
        self.withdrawn = entries;
    }
}
