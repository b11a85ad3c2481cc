//! Tables that are keyed by names, which compare without regard to ASCII case.
//!
//! Basis: iec-61131-3: 6.1.2 (identifiers).

use hashbrown::HashTable;
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::hash::BuildHasher;
use stickler_syntax::tree::CaseFolded;

/// A table of names.
pub(super) type Scope<'u, T> = FxHashMap<CaseFolded<'u>, T>;

/// A list of named things in their order, in which a name is found without regard to case: by looking through
/// it while it is short, and by a table of places once it is not.
#[derive(Debug)]
pub(super) struct NamedList<T> {
    list: Vec<(Box<str>, T)>,
    places: HashTable<u32>,
}

/// The most names that are looked through one by one.
const MAX_LINEAR: usize = 12;

impl<T> NamedList<T> {
    /// An empty list.
    pub(super) fn new() -> NamedList<T> {
        NamedList {
            list: Vec::new(),
            places: HashTable::new(),
        }
    }

    /// Adds a name behind the others, unless it is there already: then nothing happens, and it gives `false`.
    pub(super) fn push(&mut self, name: &str, value: T) -> bool {
        if self.place(name).is_some() {
            return false;
        }
        self.list.push((name.into(), value));
        if self.list.len() > MAX_LINEAR {
            let list = &self.list;
            let hash = |place: &u32| hash(&list[*place as usize].0);
            // Lists are bounded by the size of a source text, which has 32 bits.
            let places = u32::try_from(self.places.len()).unwrap_or(u32::MAX)..;
            for (place, (name, _)) in places.zip(&list[self.places.len()..]) {
                self.places.insert_unique(self::hash(name), place, hash);
            }
        }
        true
    }

    /// The thing of this name.
    pub(super) fn find(&self, name: &str) -> Option<&T> {
        self.list.get(self.place(name)?).map(|(_, value)| value)
    }

    fn place(&self, name: &str) -> Option<usize> {
        let is_named = |(other, _): &(Box<str>, T)| other.eq_ignore_ascii_case(name);
        if self.list.len() <= MAX_LINEAR {
            return self.list.iter().position(is_named);
        }
        let named = |place: &u32| is_named(&self.list[*place as usize]);
        self.places.find(hash(name), named).map(|place| *place as usize)
    }

    /// All of them with their names as declared.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&str, &T)> {
        self.list.iter().map(|(name, value)| (&**name, value))
    }
}

fn hash(name: &str) -> u64 {
    FxBuildHasher.hash_one(CaseFolded(name))
}

#[cfg(test)]
mod tests {
    use super::{CaseFolded, NamedList, Scope};

    #[test]
    fn names_differ_in_more_than_case() {
        let mut scope = Scope::default();
        scope.insert(CaseFolded("Motor_Speed_1"), 1);
        assert_eq!(scope.get(&CaseFolded("MOTOR_speed_1")), Some(&1));
        assert_eq!(scope.get(&CaseFolded("Motor_Speed_2")), None);
    }

    #[test]
    fn long_lists_find_what_short_ones_find() {
        let mut list = NamedList::new();
        for number in 0..100 {
            assert!(list.push(&format!("Name{number}"), number));
            assert!(!list.push(&format!("NAME{number}"), number));
            assert_eq!(list.find(&format!("nAME{number}")), Some(&number));
            assert_eq!(list.find("Name0"), Some(&0));
        }
        assert_eq!(list.iter().count(), 100);
    }
}
