//! Raw forms of integers: how many bits of a cell count, and what the others hold.

use stickler_types::ElementaryType;

/// Brings any 64 bits to the raw form of an integer, bit string, character or BOOL: the low bits of the
/// type's width, sign-extended for a signed type and zero-extended for the others. This is the value modulo
/// 2^n. Types of 64 bits keep all bits.
#[inline]
pub const fn narrow(bits: u64, ty: ElementaryType) -> u64 {
    // A text has no bits; the mask keeps the shift in range for it, and for 64-bit types the shift is 0.
    let unused = 64_u32.wrapping_sub(ty.bits()) & 63;
    if ty.is_signed() {
        ((bits << unused).cast_signed() >> unused).cast_unsigned()
    } else {
        (bits << unused) >> unused
    }
}

#[cfg(test)]
mod tests {
    use super::narrow;
    use stickler_types::ElementaryType;

    #[test]
    fn narrowing_is_the_value_modulo_the_width() {
        let values = (0..64).flat_map(|bit| [-1, 0, 1].map(|by| (1_i64 << bit).wrapping_add(by)));
        let values: Vec<i64> = values.flat_map(|value| [value, value.wrapping_neg()]).collect();
        for ty in ElementaryType::ALL
            .into_iter()
            .filter(|ty| ty.integer_range().is_some())
        {
            for &value in &values {
                assert_eq!(
                    narrow(value.cast_unsigned(), ty),
                    ty.wrap(value.into()),
                    "{value} as {ty}"
                );
            }
        }
    }
}
