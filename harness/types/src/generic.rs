//! The generic data types of the standard: what a function of several types takes, and a condition of a case names.

use crate::{ElementaryType, words};

words! {
    /// A generic data type, with its name.
    ///
    /// Basis: iec-61131-3: Figure 5 (hierarchy of the generic data types).
    GenericType {
        /// `ANY`: every type, user-defined ones among them.
        Any = "ANY",
        /// `ANY_ELEMENTARY`.
        Elementary = "ANY_ELEMENTARY",
        /// `ANY_SIGNED`.
        Signed = "ANY_SIGNED",
        /// `ANY_UNSIGNED`.
        Unsigned = "ANY_UNSIGNED",
        /// `ANY_INT`.
        Int = "ANY_INT",
        /// `ANY_REAL`.
        Real = "ANY_REAL",
        /// `ANY_NUM`.
        Num = "ANY_NUM",
        /// `ANY_BIT`, with BOOL.
        Bit = "ANY_BIT",
        /// `ANY_DURATION`.
        Duration = "ANY_DURATION",
        /// `ANY_DATE`.
        Date = "ANY_DATE",
        /// `ANY_STRING`.
        String = "ANY_STRING",
        /// `ANY_CHARS`.
        Chars = "ANY_CHARS",
        /// `ANY_CHAR`.
        Char = "ANY_CHAR",
    }
}

impl GenericType {
    /// Returns whether an elementary type is of this generic type.
    #[must_use]
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
