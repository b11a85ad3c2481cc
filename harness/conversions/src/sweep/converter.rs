//! The interface of a conversion that is compared with exact arithmetic.

use stickler_types::Value;

/// A conversion of values. The reference implements it; tests put broken conversions in its place.
pub trait Converter: Sync {
    /// Writes the raw form of the result for the raw form of each operand; called only for conversions of one operand, where
    /// neither the operand nor the result is a text. The slices are equally long.
    fn convert_all(&self, operands: &[u64], results: &mut [u64]);

    /// Returns the result for operands of any types.
    fn convert(&self, operands: &[Value]) -> Value;
}
