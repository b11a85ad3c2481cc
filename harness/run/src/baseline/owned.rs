//! Which entry of a baseline each case belongs to.

use super::Entry;
use super::fold::Key;
use std::collections::HashMap;

/// Which entry each case belongs to.
pub(super) struct Owned<'a> {
    /// The index of the entry, by id and dialect.
    pub(super) owners: HashMap<Key<'a>, usize>,
    /// Whether each entry is about any case at all, also where a more exact one takes all of them.
    pub(super) fits: Vec<bool>,
}

impl<'a> Owned<'a> {
    /// Gives each case to the entry that it belongs to, among those that `holds` lets take part: an id goes before a pattern,
    /// and of several of a kind the first counts.
    ///
    /// There may be thousands of entries and a hundred thousand cases. So the cases are sorted, and an entry meets only those
    /// that begin as it does.
    pub(super) fn of(entries: &[Entry], cases: &[Key<'a>], holds: impl Fn(usize) -> bool) -> Owned<'a> {
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

    fn take(&mut self, index: usize, entry: &Entry, sorted: &[Key<'a>], holds: bool) {
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

/// How the id of each case begins that an entry is about. An id holds neither `*` nor `@`.
fn beginning(entry: &Entry) -> &str {
    let text = entry.case.as_str();
    text.split(['*', '@']).next().unwrap_or(text)
}
