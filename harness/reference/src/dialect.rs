//! The one place where a dialect's name becomes behaviour.

use crate::conversion::{BitStringText, ConversionChoices, RealText, Rounding};
use stickler_types::{DialectName, ElementaryType};

/// The language rules of one documented system. Each field names a choice that the sources make differently
/// (section 8 of the design, which names the basis of each); nothing else in this crate asks for a dialect's
/// name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Dialect {
    /// Its name.
    pub name: DialectName,
    /// Which pairs of elementary types convert implicitly.
    pub widening: Widening,
    /// Bit string to strictly wider integer is implicit (`--allow-cross-family-widening`).
    pub cross_family_widening: bool,
    /// An untyped integer literal may stand for a REAL or LREAL.
    pub integer_literal_as_real: bool,
    /// An untyped integer literal may be assigned or passed to a bit string (an initializer and an operand
    /// always take one).
    pub integer_literal_as_bit_string: bool,
    /// `.n` selects a bit.
    pub bit_access: bool,
    /// What becomes of `.%Xn`, `.%Bn` …
    pub partial_access: PartialAccess,
    /// `//` begins a comment.
    pub line_comments: bool,
    /// Comments nest.
    pub nested_comments: bool,
    /// The types of the third edition: LTIME, LDATE, LTOD, LDT, CHAR, WCHAR.
    pub third_edition_types: bool,
    /// ROUND, CEIL, CEILING, FLOOR are not known.
    pub only_standard_rounding: bool,
    /// What conversion functions, and implicit conversions, do where systems differ.
    pub conversions: ConversionChoices,
}

/// Which pairs of elementary types convert implicitly.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Widening {
    /// IronPLC's three matrices and its general rule.
    Ironplc,
    /// No pair at all.
    None,
    /// The coloured table of PLCnext Engineer's SEM1189.
    Plcnext,
}

/// What a dialect makes of `.%Xn` and its kin.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PartialAccess {
    /// `.%Xn` selects a bit; the wider forms are P0003.
    BitsOnly,
    /// P4033 for every form.
    Disabled,
    /// P0002 for every form.
    SyntaxError,
}

impl Dialect {
    /// The rules of the dialect of this name.
    #[must_use]
    pub const fn of(name: DialectName) -> Dialect {
        match name {
            DialectName::IronplcEd2 => Dialect::ironplc_ed2(),
            DialectName::IronplcEd3 => Dialect::ironplc_ed3(),
            DialectName::IronplcRusty => Dialect::ironplc_rusty(),
            DialectName::Matiec => Dialect::matiec(),
            DialectName::Plcnext => Dialect::plcnext(),
        }
    }

    /// IronPLC with the second edition, its default.
    ///
    /// Basis: ironplc-type-conversions; ironplc-bit-access: Edition 3 Partial-Access Syntax (off here).
    #[must_use]
    pub const fn ironplc_ed2() -> Dialect {
        Dialect {
            name: DialectName::IronplcEd2,
            widening: Widening::Ironplc,
            cross_family_widening: false,
            integer_literal_as_real: true,
            integer_literal_as_bit_string: false,
            bit_access: true,
            partial_access: PartialAccess::Disabled,
            line_comments: false,
            nested_comments: false,
            third_edition_types: false,
            only_standard_rounding: false,
            conversions: ConversionChoices::COMMON,
        }
    }

    /// IronPLC with the third edition: the second, and its types, nested comments and `.%Xn`.
    ///
    /// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax; iec-61131-3: third edition, Table 3
    /// (nested comments), Table 10 (types).
    #[must_use]
    pub const fn ironplc_ed3() -> Dialect {
        Dialect {
            name: DialectName::IronplcEd3,
            partial_access: PartialAccess::BitsOnly,
            nested_comments: true,
            third_edition_types: true,
            ..Dialect::ironplc_ed2()
        }
    }

    /// IronPLC's rusty dialect: the second edition and the vendor extensions that RuSTy has.
    ///
    /// Basis: ironplc-type-conversions: Cross-family widening (on, integer literals too); ironplc-bit-access:
    /// Edition 3 Partial-Access Syntax (on).
    #[must_use]
    pub const fn ironplc_rusty() -> Dialect {
        Dialect {
            name: DialectName::IronplcRusty,
            cross_family_widening: true,
            integer_literal_as_bit_string: true,
            partial_access: PartialAccess::BitsOnly,
            line_comments: true,
            third_edition_types: true,
            ..Dialect::ironplc_ed2()
        }
    }

    /// matiec as the ForgeIEC page documents it; where that page is silent, as measured.
    ///
    /// Basis: forgeiec-conversion-functions: matiec conformance (no automatic widening), TRUNC vs. ROUND;
    /// stickler-design: §8 (literals, bit access, the texts of reals and bit strings, measured). That the
    /// compiler itself rounds half to even is no fact of this dialect: the page says that it truncates.
    #[must_use]
    pub const fn matiec() -> Dialect {
        Dialect {
            name: DialectName::Matiec,
            widening: Widening::None,
            cross_family_widening: false,
            integer_literal_as_real: false,
            integer_literal_as_bit_string: true,
            bit_access: false,
            partial_access: PartialAccess::SyntaxError,
            line_comments: false,
            nested_comments: false,
            third_edition_types: false,
            only_standard_rounding: true,
            conversions: ConversionChoices {
                real_text: RealText::SignificantDigits(10),
                bit_string_text: BitStringText::Shortest,
                ..ConversionChoices::COMMON
            },
        }
    }

    /// PLCnext Engineer by its table of implicit conversions; what that leaves open is accepted, and computed
    /// as IEC 60559 and two's complement suggest.
    ///
    /// Basis: implicit-conversion-table; implicit-conversion-rules; stickler-design: §8 (*open*).
    #[must_use]
    pub const fn plcnext() -> Dialect {
        Dialect {
            name: DialectName::Plcnext,
            widening: Widening::Plcnext,
            cross_family_widening: false,
            integer_literal_as_real: true,
            integer_literal_as_bit_string: true,
            bit_access: true,
            partial_access: PartialAccess::BitsOnly,
            line_comments: true,
            nested_comments: true,
            third_edition_types: true,
            only_standard_rounding: false,
            conversions: ConversionChoices::COMMON.rounding(Rounding::HalfToEven),
        }
    }

    /// Whether the dialect has this elementary type.
    #[must_use]
    pub const fn has(&self, ty: ElementaryType) -> bool {
        self.third_edition_types || !ty.is_third_edition()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_its_own_dialect() {
        for name in DialectName::ALL {
            assert_eq!(Dialect::of(name).name, name);
        }
    }

    #[test]
    fn the_second_edition_lacks_the_types_of_the_third() {
        let has = |name| Dialect::of(name).has(ElementaryType::Ltime);
        assert_eq!(DialectName::ALL.map(has), [false, true, true, false, true]);
        assert!(Dialect::ironplc_ed2().has(ElementaryType::Time));
    }
}
