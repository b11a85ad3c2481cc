//! The part of a run or a campaign that one of several machines does.

use std::fmt;
use std::str::FromStr;
use stickler_types::Fnv1a;

/// Part `index` of `count`, written `index/count`; `index` counts from 1.
///
/// The contents of a part depend on the part alone, so all parts together do exactly what one machine would: every case of
/// a run and every place of a campaign is in exactly one part, and the parts are of about equal size.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Shard {
    index: u32,
    count: u32,
}

/// A shard that does not exist or cannot be read.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum ShardError {
    /// The text is not two numbers with a stroke between.
    #[error("`{0}` is no shard; write it as part/of, such as 1/4")]
    Malformed(String),
    /// The part does not exist.
    #[error("there is no part {index} of {count}; parts count from 1")]
    NoSuchPart {
        /// The part that was asked for.
        index: u32,
        /// The number of parts.
        count: u32,
    },
}

impl Shard {
    /// All of the work, as one part.
    pub const WHOLE: Shard = Shard { index: 1, count: 1 };

    /// Returns part `index` (from 1) of `count`.
    ///
    /// # Errors
    /// [`ShardError::NoSuchPart`] unless `1 <= index <= count`.
    pub fn new(index: u32, count: u32) -> Result<Shard, ShardError> {
        if (1..=count).contains(&index) {
            return Ok(Shard { index, count });
        }
        Err(ShardError::NoSuchPart { index, count })
    }

    /// Returns the number of the part, from 1.
    pub const fn index(self) -> u32 {
        self.index
    }

    /// Returns the number of parts, which is at least 1.
    pub const fn count(self) -> u32 {
        self.count
    }

    /// Returns whether the case with this id and dialect belongs to this part.
    ///
    /// A hash (FNV-1a) of `id@dialect` decides, so that a case stays in its part when others come or go.
    pub fn holds_case(self, id: &str, dialect: &str) -> bool {
        let mut hash = Fnv1a::default();
        [id, "@", dialect].iter().for_each(|part| hash.write(part));
        let hash = hash.finish();
        // The low bits of FNV-1a are weak when the count is a power of two.
        let mixed = (hash ^ (hash >> 32)).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        mixed % u64::from(self.count) == u64::from(self.index - 1)
    }

    /// Returns the first place at or behind this one that belongs to this part, which has every [`count`](Shard::count)-th
    /// place of a row; `None` where numbers do not reach so far.
    pub fn first_place(self, from: u64) -> Option<u64> {
        let count = u64::from(self.count);
        let wanted = u64::from(self.index - 1);
        from.checked_add((wanted + count - from % count) % count)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    /// Reads `2/4`.
    fn from_str(text: &str) -> Result<Shard, ShardError> {
        let malformed = || ShardError::Malformed(text.to_owned());
        let (index, count) = text.split_once('/').ok_or_else(malformed)?;
        let number = |digits: &str| digits.parse().map_err(|_| malformed());
        Shard::new(number(index)?, number(count)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_in_exactly_one_part_and_the_parts_are_of_about_equal_size() {
        let shards: Vec<Shard> = (1..=4).map(|index| Shard::new(index, 4).unwrap()).collect();
        let mut sizes = [0; 4];
        for number in 0..4000 {
            let id = format!("widening/integer::assignment(SINT,INT,{number})");
            let holding: Vec<usize> = (0..4)
                .filter(|&part| shards[part].holds_case(&id, "matiec"))
                .collect();
            assert_eq!(holding.len(), 1, "{id}");
            sizes[holding[0]] += 1;
        }
        assert!(
            sizes.iter().all(|&size| (850..=1150).contains(&size)),
            "{sizes:?}"
        );
    }

    #[test]
    fn every_place_is_in_exactly_one_part() {
        for place in 0..50 {
            let holds = |index: &u32| Shard::new(*index, 7).unwrap().first_place(place) == Some(place);
            assert_eq!((1..=7).filter(holds).count(), 1, "{place}");
        }
        assert_eq!(Shard::WHOLE.first_place(17), Some(17));
        assert_eq!(Shard::new(1, 7).unwrap().first_place(u64::MAX), None);
    }

    #[test]
    fn a_case_keeps_its_part_for_ever() {
        let part = (1..=7).find(|&index| Shard::new(index, 7).unwrap().holds_case("a/b", "matiec"));
        assert_eq!(part, Some(PART_OF_A_B));
    }

    /// Written down once; a change of the hash would move cases between machines.
    const PART_OF_A_B: u32 = 1;

    #[test]
    fn a_shard_reads_back_and_says_what_is_wrong() {
        assert_eq!("2/4".parse::<Shard>().unwrap().to_string(), "2/4");
        for text in ["", "2", "2/", "/4", "a/4", "-1/4", "2/4/8"] {
            assert!(
                matches!(text.parse::<Shard>(), Err(ShardError::Malformed(_))),
                "{text}"
            );
        }
        for text in ["0/4", "5/4", "0/0"] {
            assert!(
                matches!(text.parse::<Shard>(), Err(ShardError::NoSuchPart { .. })),
                "{text}"
            );
        }
    }
}
