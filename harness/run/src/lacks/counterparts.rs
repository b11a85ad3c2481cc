//! Counterparts: for a program that must be rejected, one without a mistake and with the same constructs.
//!
//! A rejection tells that the engine found the mistake only where the engine takes such a program.

use super::is_type;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use stickler_suite::{Acceptance, Case, FeatureKey};
use stickler_types::DialectName;

/// The features that programs use, each with the cases that use just these.
pub(super) type CasesByFeatures<'s> = BTreeMap<BTreeSet<FeatureKey>, Vec<&'s Case>>;

/// A case without a mistake, with the cases whose counterpart it is.
pub(super) type Counterpart<'s> = (&'s Case, Vec<&'s Case>);

/// Returns the counterparts of those of the `selected` cases that must be rejected: of the cases `beside` them of the same file and dialect,
/// which must be accepted, the one whose constructs differ least, elementary types aside. A case whose file has none has no counterpart.
pub(super) fn counterparts<'s>(
    selected: &CasesByFeatures<'s>,
    beside: &CasesByFeatures<'s>,
) -> Vec<Counterpart<'s>> {
    let mut accepted: HashMap<FileKey<'_>, BTreeMap<Constructs<'_>, &'s Case>> = HashMap::new();
    for (constructs, case) in by_constructs(beside) {
        let of_file = accepted.entry(file_key(case)).or_default();
        let shortest = of_file.entry(constructs).or_insert(case);
        if case.source.len() < shortest.source.len() {
            *shortest = case;
        }
    }
    let mut rejected: BTreeMap<(FileKey<'_>, Constructs<'_>), Vec<&'s Case>> = BTreeMap::new();
    let must_be = |(_, case): &(_, &Case)| case.expectation.accepted == Acceptance::Rejected;
    for (constructs, case) in by_constructs(selected).filter(must_be) {
        rejected
            .entry((file_key(case), constructs))
            .or_default()
            .push(case);
    }
    let mut found: BTreeMap<(&str, DialectName), Counterpart<'s>> = BTreeMap::new();
    for ((file, constructs), rejected) in rejected {
        let unlikeness = |(of, case): &(&Constructs<'_>, &&Case)| {
            (of.symmetric_difference(&constructs).count(), case.source.len())
        };
        let beside = accepted.get(&file).into_iter().flatten();
        if let Some((_, counterpart)) = beside.min_by_key(unlikeness) {
            let of = found.entry((&counterpart.id, counterpart.dialect));
            of.or_insert((counterpart, Vec::new())).1.extend(rejected);
        }
    }
    found.into_values().collect()
}

/// The case file and the dialect of a case.
type FileKey<'k> = (&'k str, DialectName);

fn file_key(case: &Case) -> FileKey<'_> {
    (&case.file, case.dialect)
}

/// The features that a program uses, but for the elementary types.
type Constructs<'k> = BTreeSet<&'k str>;

fn by_constructs<'k, 's>(cases: &'k CasesByFeatures<'s>) -> impl Iterator<Item = (Constructs<'k>, &'s Case)> {
    cases.iter().flat_map(|(features, cases)| {
        let constructs: Constructs<'k> = features
            .iter()
            .map(|key| &**key)
            .filter(|key| !is_type(key))
            .collect();
        cases.iter().map(move |&case| (constructs.clone(), case))
    })
}
