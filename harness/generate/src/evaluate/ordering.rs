//! The order of two values of one type.
//!
//! Basis: iec-61131-3: Table 33 (comparison); the table comparison of the cases states it type by type.

use super::cell::MemoryCell;
use std::cmp::Ordering;
use stickler_types::ElementaryType;

/// Compares two values of a type; `None` if one of them is NaN or not of that type.
///
/// Unsigned integers and bit strings compare as unsigned numbers, texts by their characters; -0.0 equals 0.0.
pub(super) fn compare(ty: ElementaryType, a: &MemoryCell, b: &MemoryCell) -> Option<Ordering> {
    match (a, b) {
        (MemoryCell::Text(a), MemoryCell::Text(b)) => Some(a.cmp(b)),
        (MemoryCell::Plain(a), MemoryCell::Plain(b)) => match (ty.real_value(*a), ty.real_value(*b)) {
            (Some(a), Some(b)) => a.partial_cmp(&b),
            _ => Some(ty.integer_value(*a).cmp(&ty.integer_value(*b))),
        },
        _ => None,
    }
}
