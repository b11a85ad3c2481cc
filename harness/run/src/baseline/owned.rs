//! Assigns each case to an entry of a baseline.

use super::Entry;
use super::fold::CaseKey;
use std::collections::HashMap;

/// The assignment of cases to the entries of a baseline.
pub(super) struct Owned<'a> {
    /// The index of the entry of each case, by id and dialect.
    pub(super) owners: HashMap<CaseKey<'a>, usize>,
    /// Whether each entry is about any case at all, even where more exact entries own all of these cases.
    pub(super) fits: Vec<bool>,
}

impl<'a> Owned<'a> {
    /// Assigns each case to one of the entries for which `holds` is true: an id goes before a pattern, and of several of a
    /// kind the first counts.
    ///
    /// There may be thousands of entries and a hundred thousand cases. Therefore the cases are sorted, and an entry is
    /// compared only with those that share its beginning.
    pub(super) fn of(entries: &[Entry], cases: &[CaseKey<'a>], holds: impl Fn(usize) -> bool) -> Owned<'a> {
        let mut sorted = cases.to_vec();
        sorted.sort_unstable();
        let mut owned = Owned {
            owners: HashMap::new(),
            fits: vec![false; entries.len()],
        };
        for pattern in [false, true] {
            for (index, entry) in entries.iter().enumerate() {
                if entry.case.is_pattern() == pattern {
                    owned.take(index, entry, &sorted, holds(index));
                }
            }
        }
        owned
    }

    fn take(&mut self, index: usize, entry: &Entry, sorted: &[CaseKey<'a>], holds: bool) {
        let beginning = beginning(entry);
        let from = sorted.partition_point(|(id, _)| *id < beginning);
        let alike = sorted[from..]
            .iter()
            .take_while(|(id, _)| id.starts_with(beginning));
        for &(id, dialect) in alike {
            if entry.covers(id, dialect.as_str()) {
                self.fits[index] = true;
                if holds {
                    self.owners.entry((id, dialect)).or_insert(index);
                }
            }
        }
    }
}

/// Returns the beginning that the ids of all cases of an entry share. An id contains neither `*` nor `@`.
fn beginning(entry: &Entry) -> &str {
    let text = entry.case.as_str();
    text.split(['*', '@']).next().unwrap_or(text)
}
