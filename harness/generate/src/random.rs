//! Choices made by bytes: a thin layer over `arbitrary` that never fails.
//!
//! When the bytes have run out, every choice falls on its first possibility. So whoever chooses puts the simplest one first, and
//! what is made from few bytes is small.

use arbitrary::Unstructured;
use stickler_types::SplitMix64;

/// The bytes that make the choices.
pub struct Random<'r, 'u> {
    input: &'r mut Unstructured<'u>,
}

impl<'r, 'u> Random<'r, 'u> {
    /// Choices by these bytes, from where they stand.
    pub fn new(input: &'r mut Unstructured<'u>) -> Random<'r, 'u> {
        Random { input }
    }

    /// Whether no bytes are left, so that every choice will be the first one.
    #[must_use]
    pub fn is_exhausted(&self) -> bool {
        self.input.is_empty()
    }

    /// A number below `count`, all of them equally likely; 0 where `count` is 0.
    pub fn below(&mut self, count: usize) -> usize {
        if count <= 1 {
            return 0;
        }
        self.input.int_in_range(0..=count - 1).unwrap_or(0)
    }

    /// True so many times out of `of`, at most 256; false when the bytes have run out.
    pub fn chance(&mut self, times: u8, of: u16) -> bool {
        let drawn = usize::from(self.byte());
        drawn * usize::from(of) >= (usize::from(of) - usize::from(times)) * 256
    }

    /// One of these, the first when the bytes have run out; nothing if there is none.
    pub fn pick<'t, T>(&mut self, from: &'t [T]) -> Option<&'t T> {
        from.get(self.below(from.len()))
    }

    /// One of those that suit, all of them equally likely; nothing if there is none.
    pub fn pick_where<'t, T>(&mut self, from: &'t [T], suits: impl Fn(&T) -> bool) -> Option<&'t T> {
        let count = from.iter().filter(|one| suits(one)).count();
        let chosen = self.below(count);
        from.iter().filter(|one| suits(one)).nth(chosen)
    }

    /// A number between two, both included; the lower one when the bytes have run out.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        if low >= high {
            return low;
        }
        self.input.int_in_range(low..=high).unwrap_or(low)
    }

    /// The place of one of these weights, each as likely as it weighs; 0 when the bytes have run out.
    pub fn weighted(&mut self, weights: &[u16]) -> usize {
        let total: usize = weights.iter().map(|&weight| usize::from(weight)).sum();
        let mut drawn = self.below(total);
        for (place, &weight) in weights.iter().enumerate() {
            match drawn.checked_sub(usize::from(weight)) {
                Some(rest) => drawn = rest,
                None => return place,
            }
        }
        0
    }

    /// Any byte; 0 when the bytes have run out.
    pub fn byte(&mut self) -> u8 {
        self.input.arbitrary().unwrap_or(0)
    }

    /// Any 64 bits; 0 when the bytes have run out.
    pub fn bits(&mut self) -> u64 {
        self.input.arbitrary().unwrap_or(0)
    }
}

/// Returns so many bytes that look random, always the same for a seed.
#[must_use]
pub fn bytes(seed: u64, length: usize) -> Vec<u8> {
    SplitMix64::new(seed).bytes(length)
}
