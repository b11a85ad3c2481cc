//! Assigns each case to an entry of a baseline.

use super::Entry;
use super::fold::CaseKey;
use crate::Filter;
use std::collections::HashMap;

/// The assignment of cases to the entries of a baseline.
pub(super) struct Owned<'a> {
    /// The index of the entry of each case, by id and dialect.
    pub(super) owners: HashMap<CaseKey<'a>, usize>,
    /// The first id or pattern of each entry that fits no case at all; what fits cases that more exact entries own fits.
    pub(super) unfit: Vec<Option<Filter>>,
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
            unfit: vec![None; entries.len()],
        };
        for pattern in [false, true] {
            for (index, entry) in entries.iter().enumerate() {
                for filter in entry.cases.iter().filter(|filter| filter.is_pattern() == pattern) {
                    if !owned.take(index, filter, &sorted, holds(index)) {
                        owned.unfit[index].get_or_insert_with(|| filter.clone());
                    }
                }
            }
        }
        owned
    }

    /// Assigns the cases of an id or a pattern to an entry. Returns whether there are any.
    fn take(&mut self, index: usize, filter: &Filter, sorted: &[CaseKey<'a>], holds: bool) -> bool {
        let beginning = beginning(filter);
        let from = sorted.partition_point(|(id, _)| *id < beginning);
        let alike = sorted[from..]
            .iter()
            .take_while(|(id, _)| id.starts_with(beginning));
        let mut fits = false;
        for &(id, dialect) in alike {
            let is_meant = match filter.is_pattern() {
                true => filter.fits(id, dialect.as_str()),
                false => filter.names(id, dialect.as_str()),
            };
            if is_meant {
                fits = true;
                if holds {
                    self.owners.entry((id, dialect)).or_insert(index);
                }
            }
        }
        fits
    }
}

/// Returns the beginning that the ids of all cases of an id or a pattern share. An id contains neither `*` nor `@`.
fn beginning(filter: &Filter) -> &str {
    let text = filter.as_str();
    text.split(['*', '@']).next().unwrap_or(text)
}
