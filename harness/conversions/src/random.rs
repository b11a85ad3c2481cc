//! Numbers without a pattern, the same for the same seed on every machine and in every version.

/// An endless row of 64-bit numbers, any of which can be had without the ones before it (splitmix64).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Scattered {
    seed: u64,
}

impl Scattered {
    /// The row of this seed.
    #[must_use]
    pub const fn new(seed: u64) -> Scattered {
        Scattered { seed }
    }

    /// The number at this place.
    #[must_use]
    pub const fn at(self, place: u64) -> u64 {
        // Mixed once before it counts, so that the rows of neighbouring seeds do not overlap.
        let state = mixed(self.seed).wrapping_add(place.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        mixed(state)
    }

    /// A row of its own for each place.
    #[must_use]
    pub const fn row(self, place: u64) -> Scattered {
        Scattered { seed: self.at(place) }
    }
}

const fn mixed(state: u64) -> u64 {
    let state = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    state ^ (state >> 31)
}
