//! Finds names that are similar to a mistyped one, by the number of characters that have to change.

/// The most changes between similar names.
pub(super) const MAX_CHANGES: usize = 2;

/// A name that may be similar to another, and the letters in it.
#[derive(Clone, Copy)]
pub(super) struct Candidate<'n> {
    /// The name.
    pub(super) name: &'n str,
    letters: u64,
}

impl<'n> Candidate<'n> {
    /// Prepares a name for comparison.
    pub(super) fn new(name: &'n str) -> Candidate<'n> {
        // Letters count without regard to case. That some digits share the bit of a letter hides no near name.
        let bit = |byte: &u8| 1_u64 << (byte.to_ascii_lowercase() & 63);
        Candidate {
            name,
            letters: name.as_bytes().iter().map(bit).fold(0, |all, bit| all | bit),
        }
    }

    /// Returns whether so few changes can make one name of the other at all. A change takes at most one letter away and
    /// brings at most one, which turns nearly all names away without looking at the order of their letters.
    pub(super) fn may_be_similar(self, other: Candidate<'_>, changes: usize) -> bool {
        (self.letters ^ other.letters).count_ones() as usize <= 2 * changes
            && self.name.len().abs_diff(other.name.len()) <= changes
    }
}

/// Counts the characters that must be changed, added, left out, or exchanged with their neighbour to make one name of
/// another. Case does not count.
pub(super) fn distance(left: &str, right: &str) -> usize {
    strsim::osa_distance(&left.to_ascii_lowercase(), &right.to_ascii_lowercase())
}

#[cfg(test)]
mod tests {
    use super::{Candidate, MAX_CHANGES, distance};
    use crate::semantics::suggestion::STANDARD;

    #[test]
    fn no_near_name_is_turned_away_by_its_letters() {
        let mut near = 0;
        for (index, one) in STANDARD.iter().enumerate().step_by(7) {
            for other in STANDARD.iter().skip(index % 5).step_by(5) {
                let changes = distance(one.name, other.name);
                if changes <= MAX_CHANGES {
                    near += 1;
                    let may_be = one.may_be_similar(*other, changes);
                    assert!(may_be, "{} and {}", one.name, other.name);
                }
            }
        }
        assert!(near > 100, "only {near} names are near another");
        assert!(!Candidate::new("frobnicate").may_be_similar(Candidate::new("INT_TO_REAL"), 2));
        assert_eq!(distance("INT_to_dnit", "int_TO_dint"), 1);
    }
}
