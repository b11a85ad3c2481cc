//! Tables that are keyed by names, which compare without regard to ASCII case.
//!
//! Basis: iec-61131-3: 6.1.2 (identifiers).

use rustc_hash::FxHashMap;
use stickler_syntax::tree::CaseFolded;

/// A table of names.
pub(super) type Scope<'u, T> = FxHashMap<CaseFolded<'u>, T>;

/// A list of named things in their order, in which a name is found without regard to case: by looking through
/// it while it is short, and by a table once it is not.
#[derive(Debug)]
pub(super) struct NamedList<T> {
    list: Vec<(Box<str>, T)>,
    index: FxHashMap<Box<str>, u32>,
}

/// The most names that are looked through one by one.
const MAX_LINEAR: usize = 12;

impl<T> NamedList<T> {
    /// An empty list.
    pub(super) fn new() -> NamedList<T> {
        NamedList {
            list: Vec::new(),
            index: FxHashMap::default(),
        }
    }

    /// Adds a name behind the others, unless it is there already: then nothing happens, and it gives `false`.
    pub(super) fn push(&mut self, name: &str, value: T) -> bool {
        if self.find(name).is_some() {
            return false;
        }
        if self.list.len() == MAX_LINEAR {
            self.index = (0..)
                .zip(&self.list)
                .map(|(at, (name, _))| (fold(name), at))
                .collect();
        }
        if self.list.len() >= MAX_LINEAR {
            // Lists are bounded by the size of a source text, which has 32 bits.
            self.index
                .insert(fold(name), u32::try_from(self.list.len()).unwrap_or(u32::MAX));
        }
        self.list.push((name.into(), value));
        true
    }

    /// The thing of this name.
    pub(super) fn find(&self, name: &str) -> Option<&T> {
        let at = if self.list.len() <= MAX_LINEAR {
            self.list
                .iter()
                .position(|(other, _)| other.eq_ignore_ascii_case(name))?
        } else {
            *self.index.get(&*fold(name))? as usize
        };
        self.list.get(at).map(|(_, value)| value)
    }

    /// All of them with their names as declared.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&str, &T)> {
        self.list.iter().map(|(name, value)| (&**name, value))
    }
}

fn fold(name: &str) -> Box<str> {
    name.to_ascii_lowercase().into()
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
