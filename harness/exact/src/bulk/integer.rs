//! Conversions among integers, bit strings, BOOL and characters.

use super::each;
use stickler_types::ElementaryType;

/// Reduction of a number modulo 2^64 to the raw form of a type: keeps the low bits, and extends the sign where the type is
/// signed.
#[derive(Clone, Copy)]
pub struct Narrow {
    mask: u64,
    sign: u64,
}

impl Narrow {
    /// Returns the reduction for an integer, a bit string, BOOL or a character.
    pub const fn to(ty: ElementaryType) -> Narrow {
        // A text has no bits, and never comes here.
        let bits = if ty.bits() == 0 { 1 } else { ty.bits() };
        Narrow {
            mask: u64::MAX >> (64 - bits),
            sign: if ty.is_signed() { 1 << (bits - 1) } else { 0 },
        }
    }

    /// Returns the raw form.
    #[inline(always)]
    pub const fn of(self, bits: u64) -> u64 {
        // Flipping the sign's bit adds its weight or takes it away; taking it away again leaves -2^(n-1) … 2^(n-1)-1.
        ((bits & self.mask) ^ self.sign).wrapping_sub(self.sign)
    }
}

/// Computes each number modulo 2^n.
pub fn modulo(operands: &[u64], results: &mut [u64], to: ElementaryType) {
    let narrow = Narrow::to(to);
    each(operands, results, |operand| narrow.of(operand));
}

/// Converts characters to CHAR, with `?` for a character that CHAR does not have.
pub fn replaced(operands: &[u64], results: &mut [u64]) {
    each(operands, results, |operand| match u8::try_from(operand) {
        Ok(narrow) => narrow.into(),
        Err(_) => b'?'.into(),
    });
}

/// Computes whether each number is not zero.
pub fn truth(operands: &[u64], results: &mut [u64]) {
    each(operands, results, |operand| u64::from(operand != 0));
}
