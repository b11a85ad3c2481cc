//! Choices made by bytes: a thin layer over `arbitrary` that never fails.
//!
//! When the bytes have run out, every choice falls on its first possibility. A caller therefore puts the simplest
//! possibility first, and few bytes make a small program.

use arbitrary::Unstructured;
use stickler_types::SplitMix64;

/// A source of choices that consumes bytes.
pub struct Random<'r, 'u> {
    input: &'r mut Unstructured<'u>,
}

impl<'r, 'u> Random<'r, 'u> {
    /// Creates a source that continues where `input` stands.
    pub fn new(input: &'r mut Unstructured<'u>) -> Random<'r, 'u> {
        Random { input }
    }

    /// Returns whether no bytes are left, so that every further choice is the first possibility.
    pub fn is_exhausted(&self) -> bool {
        self.input.is_empty()
    }

    /// Returns a number below `count`, all equally likely; 0 if `count` is 0.
    pub fn below(&mut self, count: usize) -> usize {
        if count <= 1 {
            return 0;
        }
        self.input.int_in_range(0..=count - 1).unwrap_or(0)
    }

    /// Returns `true` in `times` of `of` cases (`of` at most 256); `false` when the bytes have run out.
    pub fn chance(&mut self, times: u8, of: u16) -> bool {
        let drawn = usize::from(self.byte());
        drawn * usize::from(of) >= (usize::from(of) - usize::from(times)) * 256
    }

    /// Picks an element of a slice; the first when the bytes have run out, `None` if the slice is empty.
    pub fn pick<'t, T>(&mut self, from: &'t [T]) -> Option<&'t T> {
        from.get(self.below(from.len()))
    }

    /// Picks an element that satisfies a predicate, all equally likely; `None` if there is none.
    pub fn pick_where<'t, T>(&mut self, from: &'t [T], suits: impl Fn(&T) -> bool) -> Option<&'t T> {
        let count = from.iter().filter(|one| suits(one)).count();
        let chosen = self.below(count);
        from.iter().filter(|one| suits(one)).nth(chosen)
    }

    /// Returns a number between two limits, both inclusive; the lower one when the bytes have run out.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        if low >= high {
            return low;
        }
        self.input.int_in_range(low..=high).unwrap_or(low)
    }

    /// Picks an index with a probability proportional to its weight; 0 when the bytes have run out.
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

    /// Returns the next byte; 0 when the bytes have run out.
    pub fn byte(&mut self) -> u8 {
        self.input.arbitrary().unwrap_or(0)
    }

    /// Returns the next 64 bits; 0 when the bytes have run out.
    pub fn bits(&mut self) -> u64 {
        self.input.arbitrary().unwrap_or(0)
    }
}

/// Returns `length` pseudorandom bytes, always the same for a seed.
pub fn bytes(seed: u64, length: usize) -> Vec<u8> {
    SplitMix64::new(seed).bytes(length)
}
