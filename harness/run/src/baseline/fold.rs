//! Folds many cases into few entries of a baseline: a pattern where all cases that it fits are meant, otherwise ids.
//!
//! The ids of a table's cases are `file::probe(A,B,C)`. A whole probe becomes `file::probe(*`, a part of one
//! `file::probe(A,*`; no pattern is wider, so that an entry never covers cases of unrelated probes.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use stickler_types::DialectName;

/// The key of a case: its id and its dialect.
pub(super) type CaseKey<'a> = (&'a str, DialectName);

/// The id or pattern of an entry, and the number of its cases.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Folded {
    /// The id or the pattern of the entry.
    pub(super) case: String,
    /// The number of cases that the entry is about.
    pub(super) cases: usize,
}

/// All cases that an engine can be asked about: the dialects of each id.
pub(super) struct Universe<'a> {
    ids: BTreeMap<&'a str, Vec<DialectName>>,
}

impl<'a> Universe<'a> {
    pub(super) fn new(cases: impl Iterator<Item = CaseKey<'a>>) -> Universe<'a> {
        let mut ids: BTreeMap<&str, Vec<DialectName>> = BTreeMap::new();
        for (id, dialect) in cases {
            ids.entry(id).or_default().push(dialect);
        }
        Universe { ids }
    }

    /// Folds exactly these cases into few entries, sorted by id. Cases that are not in the universe are left out.
    pub(super) fn fold(&self, wanted: &HashSet<CaseKey<'_>>) -> Vec<Folded> {
        let ids: Vec<&str> = self.ids.keys().copied().collect();
        let probes = ids.chunk_by(|a, b| a[..probe(a)] == b[..probe(b)]);
        let folding = Folding {
            universe: self,
            wanted,
        };
        probes
            .flat_map(|probe_ids| folding.fold(probe_ids, probe(probe_ids[0]), None))
            .collect()
    }
}

/// Returns the length of the part of an id that all cases of its probe share: the whole id where the case comes from no
/// table.
fn probe(id: &str) -> usize {
    id.find('(').map_or(id.len(), |at| at + 1)
}

/// Returns the length of a prefix of an id that is longer than this one by one argument of the probe.
fn longer(id: &str, prefix: usize) -> usize {
    id[prefix..].find(',').map_or(id.len(), |at| prefix + at + 1)
}

struct Folding<'f> {
    universe: &'f Universe<'f>,
    wanted: &'f HashSet<CaseKey<'f>>,
}

impl Folding<'_> {
    /// Folds the ids of one prefix in one dialect or, where `only` is none, in all dialects: all of them at once, in each dialect by itself,
    /// or by longer prefixes, whichever gives the fewest entries.
    fn fold(&self, ids: &[&str], prefix: usize, only: Option<DialectName>) -> Vec<Folded> {
        let is_asked = |dialect: &DialectName| only.is_none_or(|only| only == *dialect);
        let dialects = |id: &str| self.dialects(id).iter().copied().filter(is_asked);
        let spoken = ids.iter().copied().filter(|id| dialects(id).next().is_some());
        let ids: Vec<&str> = spoken.collect();
        let all: Vec<CaseKey<'_>> = ids
            .iter()
            .flat_map(|id| dialects(id).map(move |dialect| (*id, dialect)))
            .collect();
        let wanted = all.iter().filter(|key| self.wanted.contains(key)).count();
        if wanted == 0 {
            return Vec::new();
        }
        // An entry whose dialects are all custom ones would fit no case of a run without them.
        let is_ever_there = only.is_some() || all.iter().any(|(_, dialect)| !dialect.is_custom());
        if wanted == all.len() && is_ever_there {
            let dialect = only.map_or_else(String::new, |only| format!("@{only}"));
            return vec![Folded {
                case: name(&ids, prefix) + &dialect,
                cases: wanted,
            }];
        }
        let deeper = || parts(&ids, prefix).flat_map(|(part, prefix)| self.fold(part, prefix, only));
        if only.is_some() {
            return deeper().collect();
        }
        let dialects: BTreeSet<DialectName> = all.iter().map(|(_, dialect)| *dialect).collect();
        let dialects = dialects.into_iter();
        let by_dialect: Vec<Folded> = dialects
            .flat_map(|dialect| self.fold(&ids, prefix, Some(dialect)))
            .collect();
        if ids.len() == 1 {
            return by_dialect;
        }
        let deeper: Vec<Folded> = deeper().collect();
        if by_dialect.len() < deeper.len() {
            by_dialect
        } else {
            deeper
        }
    }

    fn dialects(&self, id: &str) -> &[DialectName] {
        self.universe.ids.get(id).map_or(&[], Vec::as_slice)
    }
}

/// Returns the id where there is only one, otherwise the pattern for all ids with this prefix.
fn name(ids: &[&str], prefix: usize) -> String {
    match ids {
        [id] => (*id).to_owned(),
        _ => format!("{}*", &ids[0][..prefix]),
    }
}

/// Groups the ids by their next argument; the ids are sorted, so those with the same argument are neighbours.
fn parts<'s, 'i>(ids: &'s [&'i str], prefix: usize) -> impl Iterator<Item = (&'s [&'i str], usize)> {
    let parts = ids.chunk_by(move |a, b| a[..longer(a, prefix)] == b[..longer(b, prefix)]);
    parts.map(move |part| (part, longer(part[0], prefix)))
}
