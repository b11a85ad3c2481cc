//! The generic data types of the standard: what a function of several types takes, and a condition of a case names.

use crate::ElementaryType;

/// A generic data type.
///
/// Basis: iec-61131-3: Figure 5 (hierarchy of the generic data types).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GenericType {
    /// `ANY`: every type, user-defined ones among them.
    Any,
    /// `ANY_ELEMENTARY`.
    Elementary,
    /// `ANY_SIGNED`.
    Signed,
    /// `ANY_UNSIGNED`.
    Unsigned,
    /// `ANY_INT`.
    Int,
    /// `ANY_REAL`.
    Real,
    /// `ANY_NUM`.
    Num,
    /// `ANY_BIT`, with BOOL.
    Bit,
    /// `ANY_DURATION`.
    Duration,
    /// `ANY_DATE`.
    Date,
    /// `ANY_STRING`.
    String,
    /// `ANY_CHARS`.
    Chars,
    /// `ANY_CHAR`.
    Char,
}

impl GenericType {
    /// Returns the generic data type of a name in capital letters.
    #[must_use]
    pub fn from_name(name: &str) -> Option<GenericType> {
        Some(match name {
            "ANY" => GenericType::Any,
            "ANY_ELEMENTARY" => GenericType::Elementary,
            "ANY_SIGNED" => GenericType::Signed,
            "ANY_UNSIGNED" => GenericType::Unsigned,
            "ANY_INT" => GenericType::Int,
            "ANY_REAL" => GenericType::Real,
            "ANY_NUM" => GenericType::Num,
            "ANY_BIT" => GenericType::Bit,
            "ANY_DURATION" => GenericType::Duration,
            "ANY_DATE" => GenericType::Date,
            "ANY_STRING" => GenericType::String,
            "ANY_CHARS" => GenericType::Chars,
            "ANY_CHAR" => GenericType::Char,
            _ => return None,
        })
    }

    /// Returns whether an elementary type is of this generic type.
    #[must_use]
    pub const fn contains(self, ty: ElementaryType) -> bool {
        match self {
            GenericType::Any | GenericType::Elementary => true,
            GenericType::Signed => ty.is_signed(),
            GenericType::Unsigned => ty.is_unsigned(),
            GenericType::Int => ty.is_integer(),
            GenericType::Real => ty.is_real(),
            GenericType::Num => ty.is_integer() || ty.is_real(),
            GenericType::Bit => matches!(ty, ElementaryType::Bool) || ty.is_bit_string(),
            GenericType::Duration => ty.is_duration(),
            GenericType::Date => ty.is_date_or_time(),
            GenericType::String => ty.is_text(),
            GenericType::Chars => ty.is_text() || ty.is_character(),
            GenericType::Char => ty.is_character(),
        }
    }
}
