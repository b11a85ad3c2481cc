//! The generic data types of the standard: what a function of several types takes, and a condition of a case names.

use crate::{ElementaryType, words};

words! {
    /// A generic data type, with its name. ANY takes every type, user-defined ones among them, and ANY_BIT takes BOOL.
    ///
    /// Basis: iec-61131-3: Figure 5 (hierarchy of the generic data types).
    GenericType spelled {
        Any = "ANY", Elementary = "ANY_ELEMENTARY", Signed = "ANY_SIGNED", Unsigned = "ANY_UNSIGNED",
        Int = "ANY_INT", Real = "ANY_REAL", Num = "ANY_NUM", Bit = "ANY_BIT", Duration = "ANY_DURATION",
        Date = "ANY_DATE", String = "ANY_STRING", Chars = "ANY_CHARS", Char = "ANY_CHAR",
    }
}

impl GenericType {
    /// Returns whether an elementary type is of this generic type.
    pub const fn contains(self, ty: ElementaryType) -> bool {
        match self {
            GenericType::Any | GenericType::Elementary => true,
            GenericType::Signed => ty.is_signed(),
            GenericType::Unsigned => ty.is_unsigned(),
            GenericType::Int => ty.is_integer(),
            GenericType::Real => ty.is_real(),
            GenericType::Num => ty.is_number(),
            GenericType::Bit => matches!(ty, ElementaryType::Bool) || ty.is_bit_string(),
            GenericType::Duration => ty.is_duration(),
            GenericType::Date => ty.is_date_or_time(),
            GenericType::String => ty.is_text(),
            GenericType::Chars => ty.is_text() || ty.is_character(),
            GenericType::Char => ty.is_character(),
        }
    }
}
