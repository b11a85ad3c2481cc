//! Filters over case ids, the choice of case files that a filter may select, and the selection of cases by a plan.

use crate::Plan;
use stickler_suite::{Case, FileKind};
use stickler_types::DialectName;

/// A filter over case ids. It is read in one of three ways, the first that applies:
///
/// 1. it *is* the id of a case, or its key `id@dialect`: that case alone, though other ids may contain it;
/// 2. it contains a `*`: a pattern for the whole id or key, in which only `*` is special and stands for any text;
/// 3. otherwise: every case whose key contains it.
///
/// The first reading makes the rerun command of a report exact. Basis: conformance-cases/README.md (ids).
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Filter {
    text: String,
}

impl Filter {
    /// Creates a filter from the text that a person typed.
    pub fn new(text: impl Into<String>) -> Filter {
        Filter { text: text.into() }
    }

    /// Returns the text of the filter, as it was typed.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// Returns whether the filter contains a `*`, and so is read as a pattern unless it is the id of a case.
    pub fn is_pattern(&self) -> bool {
        self.text.contains('*')
    }

    /// Returns the dialect at the end of the key, as in `*@matiec`; `None` where the filter ends in no name of a dialect.
    pub fn dialect(&self) -> Option<DialectName> {
        self.text.rsplit_once('@')?.1.parse().ok()
    }

    /// Returns whether the filter is exactly this case's id or key.
    pub fn names(&self, id: &str, dialect: &str) -> bool {
        self.text == id || is_key(&self.text, id, dialect)
    }

    /// Returns whether the filter may fit a case of a file, which is known by its id and kind alone: false only where it fits none,
    /// whatever stands in the file.
    ///
    /// A pattern is told by its beginning, and a text by what stands before its parenthesis, since an id has at most one: an id in
    /// full, or a pattern that begins with a path, needs few files. Any other text may be a part of any id of a table.
    pub fn may_fit_file(&self, id: &str, kind: FileKind) -> bool {
        let beginning = match kind {
            FileKind::Program => format!("{id}@"),
            FileKind::Table => format!("{id}::"),
        };
        if let Some((first, _)) = self.text.split_once('*') {
            return beginning.starts_with(first) || first.starts_with(&beginning);
        }
        match (self.text.split_once('('), kind) {
            (Some(_), FileKind::Program) => false,
            (Some((before, _)), FileKind::Table) => match before.rsplit_once("::") {
                Some((path, _)) => id.ends_with(path),
                None => true,
            },
            (None, _) => true,
        }
    }

    /// Returns whether the filter, as a pattern or as a part of a key, fits this case.
    pub fn fits(&self, id: &str, dialect: &str) -> bool {
        if self.is_pattern() {
            return pattern_fits(&self.text, id) || pattern_fits(&self.text, &format!("{id}@{dialect}"));
        }
        if self.text.contains('@') {
            return format!("{id}@{dialect}").contains(&self.text);
        }
        id.contains(&self.text) || dialect.contains(&self.text)
    }
}

fn is_key(text: &str, id: &str, dialect: &str) -> bool {
    text.strip_prefix(id)
        .and_then(|rest| rest.strip_prefix('@'))
        .is_some_and(|rest| rest == dialect)
}

/// Returns whether `text` consists of `pattern`'s pieces in their order, the first at the start and the last at the end.
/// Takes linear time but for the search of each piece.
pub fn pattern_fits(pattern: &str, text: &str) -> bool {
    let Some((first, rest)) = pattern.split_once('*') else {
        return pattern == text;
    };
    let Some(mut text) = text.strip_prefix(first) else {
        return false;
    };
    let (middle, last) = rest.rsplit_once('*').unwrap_or(("", rest));
    for piece in middle.split('*') {
        let Some(at) = text.find(piece) else { return false };
        text = &text[at + piece.len()..];
    }
    text.ends_with(last)
}

/// Selects the cases that fit the plan's dialects, filters and shard, and none of what it excludes, in the order of the suite. A filter
/// that is the id or the key of a case among the dialects selects that case alone.
pub fn select<'s>(plan: &Plan, cases: &'s [Case]) -> Vec<&'s Case> {
    let spoken = |case: &&Case| plan.dialects.is_empty() || plan.dialects.contains(&case.dialect);
    let mut selected: Vec<&Case> = cases.iter().filter(spoken).collect();
    for (filters, is_kept) in [(&plan.filters, true), (&plan.excluded, false)] {
        if !filters.is_empty() {
            let mut chosen = chosen_by_any(filters, &selected).into_iter();
            selected.retain(|_| chosen.next() == Some(is_kept));
        }
    }
    if let Some(shard) = plan.shard {
        selected.retain(|case| shard.holds_case(&case.id, case.dialect.as_str()));
    }
    selected
}

fn chosen_by_any(filters: &[Filter], cases: &[&Case]) -> Vec<bool> {
    let mut chosen = vec![false; cases.len()];
    for filter in filters {
        let names = |case: &&Case| filter.names(&case.id, case.dialect.as_str());
        let exact = cases.iter().any(names);
        for (mark, case) in chosen.iter_mut().zip(cases) {
            *mark |= if exact {
                names(case)
            } else {
                filter.fits(&case.id, case.dialect.as_str())
            };
        }
    }
    chosen
}
