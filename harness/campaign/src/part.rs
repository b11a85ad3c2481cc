//! A part of a campaign, for machines that share the work.

use std::fmt;

/// Part `index` of `count`, `index` from 1: of the programs of a seed, every `count`-th.
///
/// Which programs there are does not depend on it, so the parts together judge exactly what one machine would.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Part {
    index: u32,
    count: u32,
}

impl Part {
    /// The campaign as a whole.
    pub const WHOLE: Part = Part { index: 1, count: 1 };

    /// Part `index` (from 1) of `count`; `None` unless `1 <= index <= count`.
    #[must_use]
    pub fn new(index: u32, count: u32) -> Option<Part> {
        (1..=count).contains(&index).then_some(Part { index, count })
    }

    /// Which part, from 1.
    #[must_use]
    pub const fn index(self) -> u32 {
        self.index
    }

    /// Of how many.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.count
    }

    /// The first place at or behind this one that belongs to the part, if numbers reach so far.
    #[must_use]
    pub fn first_at(self, place: u64) -> Option<u64> {
        let count = u64::from(self.count);
        let wanted = u64::from(self.index - 1);
        let ahead = (wanted + count - place % count) % count;
        place.checked_add(ahead)
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

#[cfg(test)]
mod tests {
    use super::Part;

    #[test]
    fn every_place_is_in_exactly_one_part() {
        for place in 0..50 {
            let holding =
                (1..=7).filter(|&index| Part::new(index, 7).unwrap().first_at(place) == Some(place));
            assert_eq!(holding.count(), 1, "{place}");
        }
        assert_eq!(Part::WHOLE.first_at(17), Some(17));
        assert_eq!(Part::new(1, 7).unwrap().first_at(u64::MAX), None);
    }

    #[test]
    fn there_is_no_part_outside_the_count() {
        assert_eq!(Part::new(0, 4), None);
        assert_eq!(Part::new(5, 4), None);
        assert_eq!(Part::new(1, 0), None);
        assert_eq!(Part::new(4, 4).unwrap().to_string(), "4/4");
    }
}
