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
/// another; `None` where that is more than [`MAX_CHANGES`]. Case does not count.
pub(super) fn distance(left: &str, right: &str) -> Option<usize> {
    // Of the table whose lines are the characters of one name and whose columns those of the other, only the places near its
    // diagonal can lie on a way with so few changes. VariablePlace `p` of a line stands for the column `line + p - MAX_CHANGES`.
    const PLACES: usize = 2 * MAX_CHANGES + 1;
    const FAR: usize = MAX_CHANGES + 1;
    let (left, right) = without_common_ends(left.as_bytes(), right.as_bytes());
    let end = (right.len() + MAX_CHANGES).checked_sub(left.len())?;
    let mut before = [FAR; PLACES];
    let mut above: [usize; PLACES] =
        std::array::from_fn(|place| place.checked_sub(MAX_CHANGES).unwrap_or(FAR));
    for (line, byte) in (1..).zip(left) {
        let mut row = [FAR; PLACES];
        for place in 0..PLACES {
            let Some(column) = (line + place).checked_sub(MAX_CHANGES) else {
                continue;
            };
            row[place] = match column.checked_sub(1).map(|at| right.get(at)) {
                None => line,
                Some(None) => FAR,
                Some(Some(other)) => {
                    let replaced = above[place] + usize::from(!byte.eq_ignore_ascii_case(other));
                    let left_out = above.get(place + 1).map_or(FAR, |changes| changes + 1);
                    let added = place.checked_sub(1).map_or(FAR, |place| row[place] + 1);
                    let exchanged = line > 1
                        && column > 1
                        && byte.eq_ignore_ascii_case(&right[column - 2])
                        && other.eq_ignore_ascii_case(&left[line - 2]);
                    let exchange = if exchanged { before[place] + 1 } else { FAR };
                    replaced.min(left_out).min(added).min(exchange)
                }
            };
        }
        if row.iter().all(|changes| *changes > MAX_CHANGES) {
            return None;
        }
        (before, above) = (above, row);
    }
    above.get(end).copied().filter(|changes| *changes <= MAX_CHANGES)
}

/// Two names without what they begin and end with alike, which takes no change: nearly all of two near names.
fn without_common_ends<'n>(left: &'n [u8], right: &'n [u8]) -> (&'n [u8], &'n [u8]) {
    let same = |(one, other): &(&u8, &u8)| one.eq_ignore_ascii_case(other);
    let front = left.iter().zip(right).take_while(same).count();
    let (left, right) = (&left[front..], &right[front..]);
    let back = left.iter().rev().zip(right.iter().rev()).take_while(same).count();
    (&left[..left.len() - back], &right[..right.len() - back])
}

#[cfg(test)]
mod tests {
    use super::{Candidate, MAX_CHANGES, distance};
    use crate::semantics::suggestion::STANDARD;

    /// Counts the changes by trying every first step, in which a name is as long as it is.
    fn by_trial(left: &[u8], right: &[u8], most: usize) -> Option<usize> {
        let ([one, rest @ ..], [other, others @ ..]) = (left, right) else {
            return Some(left.len() + right.len()).filter(|changes| *changes <= most);
        };
        if one.eq_ignore_ascii_case(other) {
            return by_trial(rest, others, most);
        }
        let most = most.checked_sub(1)?;
        let exchanged = match (rest, others) {
            ([second, rest @ ..], [another, others @ ..])
                if one.eq_ignore_ascii_case(another) && second.eq_ignore_ascii_case(other) =>
            {
                by_trial(rest, others, most)
            }
            _ => None,
        };
        let steps = [
            by_trial(rest, others, most),
            by_trial(rest, right, most),
            by_trial(left, others, most),
            exchanged,
        ];
        steps.into_iter().flatten().min().map(|changes| changes + 1)
    }

    #[test]
    fn near_names_are_those_that_trial_finds() {
        let mut near = 0;
        for (index, one) in STANDARD.iter().enumerate().step_by(7) {
            for other in STANDARD.iter().skip(index % 5).step_by(5) {
                let changes = by_trial(one.name.as_bytes(), other.name.as_bytes(), MAX_CHANGES);
                assert_eq!(
                    distance(one.name, other.name),
                    changes,
                    "{} and {}",
                    one.name,
                    other.name
                );
                if let Some(changes) = changes {
                    near += 1;
                    assert!(
                        one.may_be_similar(*other, changes),
                        "{} and {}",
                        one.name,
                        other.name
                    );
                }
            }
        }
        assert!(near > 100, "only {near} names are near another");
        assert!(!Candidate::new("frobnicate").may_be_similar(Candidate::new("INT_TO_REAL"), 2));
    }

    #[test]
    fn distance_counts_changes() {
        for (left, right, changes) in [
            ("limit", "limit", Some(0)),
            ("limt", "limit", Some(1)),
            ("sle", "sel", Some(1)),
            ("int_to_dnit", "int_to_dint", Some(1)),
            ("INT_to_dnit", "int_TO_dint", Some(1)),
            ("abcd", "badc", Some(2)),
            ("aab", "ab", Some(1)),
            ("abab", "ab", Some(2)),
            ("xay", "xbcy", Some(2)),
            ("", "ab", Some(2)),
            ("", "abs", None),
            ("abcdef", "fedcba", None),
            ("abcdef", "xbcyez", None),
        ] {
            assert_eq!(distance(left, right), changes, "{left} and {right}");
            assert_eq!(distance(right, left), changes, "{right} and {left}");
        }
    }
}
