//! A number for a text, the same on every machine and in every version: FNV-1a.

/// Gathers texts and gives their number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fingerprint(u64);

impl Default for Fingerprint {
    fn default() -> Fingerprint {
        Fingerprint(0xCBF2_9CE4_8422_2325)
    }
}

impl Fingerprint {
    /// Adds a text, so that its end counts too.
    pub(crate) fn add(&mut self, text: &str) {
        self.add_bytes(text.as_bytes());
    }

    /// Adds bytes, so that their end counts too.
    pub(crate) fn add_bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.step(u64::from(byte));
        }
        // No byte is 256, so `ab`, `c` differs from `a`, `bc`.
        self.step(256);
    }

    /// All of the number.
    pub(crate) const fn long(self) -> u64 {
        self.0
    }

    /// Half as many digits, for names that people read.
    pub(crate) const fn short(self) -> u32 {
        // Both halves count.
        ((self.0 >> 32) ^ (self.0 & 0xFFFF_FFFF)) as u32
    }

    fn step(&mut self, number: u64) {
        self.0 = (self.0 ^ number).wrapping_mul(0x0000_0100_0000_01B3);
    }
}

#[cfg(test)]
mod tests {
    use super::Fingerprint;

    fn of(texts: &[&str]) -> u64 {
        let mut print = Fingerprint::default();
        texts.iter().for_each(|text| print.add(text));
        print.long()
    }

    #[test]
    fn it_depends_on_where_texts_end() {
        assert_ne!(of(&["ab", "c"]), of(&["a", "bc"]));
        assert_eq!(of(&["ab", "c"]), of(&["ab", "c"]));
    }
}
