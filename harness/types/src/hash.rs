//! The one hash function of the project, for everything whose hash outlives the process: ids, names of findings, shards.

/// A 64-bit FNV-1a hash. It has no seed, so that it is the same on every machine and in every version.
///
/// The low bits alone of the hash are not mixed well; [`folded`](Fnv1a::folded) and the high half of
/// [`finish`](Fnv1a::finish) are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fnv1a(u64);

impl Default for Fnv1a {
    fn default() -> Fnv1a {
        Fnv1a(0xCBF2_9CE4_8422_2325)
    }
}

impl Fnv1a {
    /// Returns the state after these bytes.
    pub fn of(bytes: impl AsRef<[u8]>) -> Fnv1a {
        let mut hash = Fnv1a::default();
        hash.write(bytes);
        hash
    }

    /// Hashes more bytes: two parts give the same hash as both together.
    pub fn write(&mut self, bytes: impl AsRef<[u8]>) {
        for &byte in bytes.as_ref() {
            self.step(u64::from(byte));
        }
    }

    /// Hashes a part and its end, so that `ab`, `c` differs from `a`, `bc`.
    pub fn write_part(&mut self, bytes: impl AsRef<[u8]>) {
        self.write(bytes);
        // No byte is 256.
        self.step(256);
    }

    /// Returns the hash.
    pub const fn finish(self) -> u64 {
        self.0
    }

    /// Returns both halves of the hash folded into one, for names that people read.
    pub const fn folded(self) -> u32 {
        ((self.0 >> 32) ^ (self.0 & 0xFFFF_FFFF)) as u32
    }

    fn step(&mut self, number: u64) {
        self.0 = (self.0 ^ number).wrapping_mul(0x0000_0100_0000_01B3);
    }
}

#[cfg(test)]
mod tests {
    use super::Fnv1a;

    #[test]
    fn published_values_are_met() {
        for (text, hash) in [
            ("", 0xCBF2_9CE4_8422_2325),
            ("a", 0xAF63_DC4C_8601_EC8C),
            ("foobar", 0x8594_4171_F739_67E8),
        ] {
            assert_eq!(Fnv1a::of(text).finish(), hash, "{text}");
        }
    }

    #[test]
    fn parts_count_with_their_ends_and_bytes_do_not() {
        let of = |parts: [&'static str; 2], write: fn(&mut Fnv1a, &'static str)| {
            let mut hash = Fnv1a::default();
            parts.into_iter().for_each(|part| write(&mut hash, part));
            hash.finish()
        };
        assert_ne!(
            of(["ab", "c"], Fnv1a::write_part),
            of(["a", "bc"], Fnv1a::write_part)
        );
        assert_eq!(of(["ab", "c"], Fnv1a::write), of(["a", "bc"], Fnv1a::write));
    }
}
