//! A part of a run, for machines that share the work.

use std::fmt;
use std::str::FromStr;

/// Part `index` of `count`, written `index/count`, `index` from 1.
///
/// A case belongs to the part that a hash (FNV-1a) of its key `id@dialect` says, so that a case stays in its
/// part when others come or go, every case is in exactly one part, and the parts are of about equal size.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Shard {
    index: u32,
    count: u32,
}

/// What is wrong with a shard as it was written.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum ShardError {
    /// It is not two numbers with a stroke between.
    #[error("`{0}` is no shard; write it as part/of, such as 1/4")]
    Malformed(String),
    /// The part does not exist.
    #[error("there is no part {index} of {count}; parts count from 1")]
    NoSuchPart {
        /// The part.
        index: u32,
        /// Of how many.
        count: u32,
    },
}

impl Shard {
    /// Part `index` (from 1) of `count`.
    ///
    /// # Errors
    /// [`ShardError::NoSuchPart`] unless `1 <= index <= count`.
    pub fn new(index: u32, count: u32) -> Result<Shard, ShardError> {
        if (1..=count).contains(&index) {
            return Ok(Shard { index, count });
        }
        Err(ShardError::NoSuchPart { index, count })
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

    /// Whether the case with this id and dialect belongs to this part.
    #[must_use]
    pub fn holds(self, id: &str, dialect: &str) -> bool {
        let hash = [id, "@", dialect]
            .iter()
            .fold(FNV_OFFSET, |hash, part| fnv1a(hash, part.as_bytes()));
        // The low bits of FNV-1a are weak when the count is a power of two.
        let mixed = (hash ^ (hash >> 32)).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        mixed % u64::from(self.count) == u64::from(self.index - 1)
    }
}

const FNV_OFFSET: u64 = 0xCBF2_9CE4_8422_2325;

fn fnv1a(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3)
    })
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
            let holding: Vec<usize> = (0..4).filter(|&part| shards[part].holds(&id, "matiec")).collect();
            assert_eq!(holding.len(), 1, "{id}");
            sizes[holding[0]] += 1;
        }
        assert!(
            sizes.iter().all(|&size| (850..=1150).contains(&size)),
            "{sizes:?}"
        );
    }

    #[test]
    fn a_case_keeps_its_part_for_ever() {
        let part = (1..=7).find(|&index| Shard::new(index, 7).unwrap().holds("a/b", "matiec"));
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
