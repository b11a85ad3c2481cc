//! The options of the choices in which dialects differ, apart from those of conversions.

use crate::ElementaryType;

/// The pairs of elementary types that convert implicitly.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Widening {
    /// IronPLC's three matrices and its general rule.
    Ironplc,
    /// No pair at all.
    None,
    /// The coloured table of PLCnext Engineer's SEM1189.
    Plcnext,
    /// Every pair of numbers and bit strings: what narrows is only warned of.
    Numbers,
    /// Every pair of numbers, bit strings, durations, dates and times of day: all of them are stored as integers or reals.
    NumbersAndMoments,
    /// Integers and bit strings into those with as many bits or more, and every number and bit string into REAL and LREAL.
    NumbersUnlessNarrower,
    /// Every pair of numbers and bit strings; BOOL stands for itself alone.
    NumbersApartFromBool,
    /// Every pair of numbers and bit strings but reals into bit strings; BOOL into all of them, and nothing into BOOL.
    NumbersButNoRealAsBits,
}

/// The treatment of `.%Xn` and its kin.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PartialAccess {
    /// `.%Xn` selects a bit; the wider forms are P0003.
    BitsOnly,
    /// `.%Xn` selects a bit, `.%Bn`, `.%Wn` and `.%Dn` a byte, a word and a double word; `.%Ln` is P0003.
    UpToDoubleWords,
    /// P4033 for every form.
    Disabled,
    /// P0002 for every form.
    SyntaxError,
}

impl PartialAccess {
    /// Returns the same where it enables a form, and otherwise access to bits.
    pub(crate) const fn enabled(self) -> PartialAccess {
        match self {
            PartialAccess::BitsOnly | PartialAccess::UpToDoubleWords => self,
            PartialAccess::Disabled | PartialAccess::SyntaxError => PartialAccess::BitsOnly,
        }
    }
}

/// The types of the third edition that a dialect has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ThirdEditionTypes {
    /// LTIME, LDATE, LTOD, LDT, CHAR and WCHAR.
    All,
    /// All types of the third edition but LDATE, LTOD and LDT.
    ///
    /// Basis: twincat-builds: recordings/twincat.build.json (`prim_default_…`, `xp_…`).
    WithoutLongDates,
    /// None of them.
    None,
}

impl ThirdEditionTypes {
    /// Returns whether a type of the third edition is among them.
    pub(crate) const fn includes(self, ty: ElementaryType) -> bool {
        match self {
            ThirdEditionTypes::All => true,
            ThirdEditionTypes::WithoutLongDates => !ty.is_date_or_time(),
            ThirdEditionTypes::None => false,
        }
    }
}
