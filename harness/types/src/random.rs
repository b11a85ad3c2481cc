//! The one generator of seeded random numbers.

/// The distance from one state to the next: 2^64 divided by the golden ratio, made odd.
const STEP: u64 = 0x9E37_79B9_7F4A_7C15;

/// A sequence of 64-bit numbers without a pattern (SplitMix64), the same for the same seed on every machine and in every version.
///
/// Basis: Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (OOPSLA 2014).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// Returns the sequence of a seed. Neighbouring seeds may give overlapping sequences.
    pub const fn new(seed: u64) -> SplitMix64 {
        SplitMix64 { state: seed }
    }

    /// Returns the sequence of a seed that is mixed first, so that the sequences of neighbouring seeds do not overlap.
    pub const fn separate(seed: u64) -> SplitMix64 {
        SplitMix64 { state: mixed(seed) }
    }

    /// Returns the number at a place without drawing those before it; the next number that [`draw`](SplitMix64::draw)
    /// returns has place 1.
    pub const fn at(self, place: u64) -> u64 {
        mixed(self.state.wrapping_add(place.wrapping_mul(STEP)))
    }

    /// Returns a separate sequence for each place.
    pub const fn split(self, place: u64) -> SplitMix64 {
        SplitMix64::separate(self.at(place))
    }

    /// Draws the next number.
    pub const fn draw(&mut self) -> u64 {
        self.state = self.state.wrapping_add(STEP);
        mixed(self.state)
    }

    /// Returns `length` bytes: the numbers of the sequence, the low byte first.
    pub fn bytes(self, length: usize) -> Vec<u8> {
        self.numbers().flat_map(u64::to_le_bytes).take(length).collect()
    }

    /// Returns the numbers of the sequence without end.
    pub fn numbers(mut self) -> impl Iterator<Item = u64> {
        std::iter::repeat_with(move || self.draw())
    }
}

const fn mixed(state: u64) -> u64 {
    let state = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    state ^ (state >> 31)
}

#[cfg(test)]
mod tests {
    use super::SplitMix64;

    #[test]
    fn the_first_numbers_are_those_that_the_authors_publish() {
        let numbers: Vec<u64> = SplitMix64::new(1_234_567).numbers().take(3).collect();
        assert_eq!(
            numbers,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }

    #[test]
    fn a_place_is_the_number_that_is_drawn_there() {
        let random = SplitMix64::separate(5);
        let drawn: Vec<u64> = random.numbers().take(4).collect();
        assert_eq!(drawn, [1, 2, 3, 4].map(|place| random.at(place)));
        assert_ne!(random.split(1).at(1), random.split(2).at(1));
        assert_eq!(random.bytes(9)[..8], drawn[0].to_le_bytes());
    }
}
