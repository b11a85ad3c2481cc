//! The changes of the claims between two versions of a suite.

use rustc_hash::FxHashMap;
use stickler_types::DialectName;

use crate::{Case, Suite};

/// The way in which a case changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// The case is new.
    Added,
    /// The case expects something else than before.
    Corrected,
    /// The case was wrong and is gone, as `withdrawn.toml` says.
    Withdrawn,
    /// The case asserts something, where the older version only recorded what a compiler does.
    Asserted,
    /// The case only records what a compiler does, where the older version asserted something.
    Opened,
    /// The case expects the same as before, on the basis of another claim.
    Rebased,
    /// The case is gone: another case asks the same, or no case asks its question of the dialect any more.
    Gone,
}

/// A case that changed.
#[derive(Clone, Copy, Debug)]
pub struct Changed<'s> {
    /// The change.
    pub change: Change,
    /// The case as it was; as it is where it is new.
    pub old: &'s Case,
    /// The case as it is; as it was where it is gone.
    pub new: &'s Case,
}

impl Suite {
    /// Returns the cases that changed since an older version, by their ids and dialects: first those that this version has.
    pub fn changes_since<'s>(&'s self, older: &'s Suite) -> Vec<Changed<'s>> {
        let (olds, news) = (older.by_key(), self.by_key());
        let mut changed = Vec::new();
        for new in &self.cases {
            let old = olds.get(&(&*new.id, new.dialect)).copied();
            if let Some(change) = old.map_or(Some(Change::Added), |old| change(old, new)) {
                let old = old.unwrap_or(new);
                changed.push(Changed { change, old, new });
            }
        }
        let is_there = |case: &Case| news.contains_key(&(&*case.id, case.dialect));
        for old in older.cases.iter().filter(|case| !is_there(case)) {
            let change = match self.withdrawn(&old.id, old.dialect.as_str()) {
                Some(_) => Change::Withdrawn,
                None => Change::Gone,
            };
            changed.push(Changed {
                change,
                old,
                new: old,
            });
        }
        changed
    }

    fn by_key(&self) -> FxHashMap<(&str, DialectName), &Case> {
        let cases = self.cases.iter();
        cases.map(|case| ((&*case.id, case.dialect), case)).collect()
    }
}

fn change(old: &Case, new: &Case) -> Option<Change> {
    match (old.is_open(), new.is_open()) {
        (true, true) => None,
        (true, false) => Some(Change::Asserted),
        (false, true) => Some(Change::Opened),
        _ if !old.claims_the_same_as(new) => Some(Change::Corrected),
        _ => (old.basis != new.basis).then_some(Change::Rebased),
    }
}
