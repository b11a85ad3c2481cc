//! The function that is compared with exact arithmetic.

use stickler_types::Value;

/// A function that converts values. The reference's own conversion is one; tests put broken ones in its place.
pub trait Converter: Sync {
    /// Writes the raw form of the result for the raw form of each operand; asked only where neither the operand nor the
    /// result is a text and there is one operand. The slices are equally long.
    fn convert_all(&self, operands: &[u64], results: &mut [u64]);

    /// Returns the result for operands of any types.
    fn convert(&self, operands: &[Value]) -> Value;
}
