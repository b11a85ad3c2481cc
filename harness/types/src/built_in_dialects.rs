//! The rules of each built-in dialect: the one place where the name of a dialect becomes behaviour.

use crate::dialect::{COMMON_CHOICES, Dialect};
use crate::options::{PartialAccess, ThirdEditionTypes, Widening};
use crate::{
    BitStringAsBool, BitStringText, BitsAsReal, BuiltIn, ComparedTypes, ConstantTypes, ConversionChoices,
    DialectName, ImplicitWarnings, MomentText, MomentUnits, OperandTypes, OutOfRange, RealText, ResultSigns,
    Rounding, ShiftCounts, TextReading,
};

impl Dialect {
    /// Returns the rules of a built-in dialect.
    pub(crate) const fn built_in(name: BuiltIn) -> Dialect {
        match name {
            BuiltIn::IronplcEd2 => Dialect::ironplc_ed2(),
            BuiltIn::IronplcEd3 => Dialect::ironplc_ed3(),
            BuiltIn::IronplcRusty => Dialect::ironplc_rusty(),
            BuiltIn::Matiec => Dialect::matiec(),
            BuiltIn::Plcnext => Dialect::plcnext(),
            BuiltIn::Strucpp => Dialect::strucpp(),
            BuiltIn::Rusty => Dialect::rusty(),
            BuiltIn::Codesys => Dialect::codesys(),
            BuiltIn::Twincat => Dialect::twincat(),
            BuiltIn::Logix => Dialect::logix(),
            BuiltIn::ControlExpert => Dialect::control_expert(),
            BuiltIn::Omron => Dialect::omron(),
            BuiltIn::IecEd3 => Dialect::iec_ed3(),
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
            cells: None,
            implicit_warnings: ImplicitWarnings::None,
            operands: OperandTypes::OneOfTheirs,
            compared: ComparedTypes::Any,
            constant_types: ConstantTypes::OfOperands,
            result_signs: ResultSigns::OfOperands,
            nan_differs: true,
            literals_by_width: false,
            enumerations_as_integers: false,
            derived_types_convert: true,
            lengths_in_parentheses: false,
            ampersand_and_power: true,
            modulo_by_zero_is_zero: false,
            division_stops: false,
            mux_outside_takes_last: false,
            shift_counts: ShiftCounts::All,
            functions_promote: false,
            negates_durations: true,
            cross_family_widening: false,
            integer_literal_as_real: true,
            real_literal_as_integer: false,
            integer_literal_as_bit_string: false,
            bit_access: true,
            partial_access: PartialAccess::Disabled,
            line_comments: false,
            nested_comments: false,
            third_edition_types: ThirdEditionTypes::None,
            only_standard_rounding: false,
            mixed_locations: false,
            single_value_subranges: false,
            conversions: COMMON_CHOICES,
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
            third_edition_types: ThirdEditionTypes::All,
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
            third_edition_types: ThirdEditionTypes::All,
            mixed_locations: true,
            ..Dialect::ironplc_ed2()
        }
    }

    /// matiec as the ForgeIEC page documents it; where that page is silent, as measured.
    ///
    /// Basis: forgeiec-conversion-functions: matiec conformance (no automatic widening), TRUNC vs. ROUND;
    /// literals, bit access, the texts of reals and bit strings are measured. That the
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
            third_edition_types: ThirdEditionTypes::None,
            only_standard_rounding: true,
            mixed_locations: false,
            single_value_subranges: true,
            conversions: ConversionChoices {
                real_text: RealText::SignificantDigits(10),
                bit_string_text: BitStringText::Shortest,
                ..COMMON_CHOICES
            },
            ..Dialect::ironplc_ed2()
        }
    }

    /// PLCnext Engineer by its table of implicit conversions; what that leaves open is accepted, and computed
    /// as IEC 60559 and two's complement suggest.
    ///
    /// Basis: implicit-conversion-table; implicit-conversion-rules; rule: not-stated.
    #[must_use]
    pub const fn plcnext() -> Dialect {
        Dialect {
            name: DialectName::Plcnext,
            widening: Widening::Plcnext,
            derived_types_convert: false,
            ..Dialect::with_third_edition()
        }
    }

    /// Returns the rules that the dialects with the types, comments and locations of the third edition share.
    const fn with_third_edition() -> Dialect {
        Dialect {
            cross_family_widening: false,
            integer_literal_as_real: true,
            integer_literal_as_bit_string: true,
            bit_access: true,
            partial_access: PartialAccess::BitsOnly,
            line_comments: true,
            nested_comments: true,
            third_edition_types: ThirdEditionTypes::All,
            only_standard_rounding: false,
            mixed_locations: true,
            single_value_subranges: true,
            conversions: COMMON_CHOICES.with_rounding(Rounding::HalfToEven),
            ..Dialect::ironplc_ed2()
        }
    }

    /// STruC++: numbers and bit strings stand for each other, narrowing is a warning, and a real becomes the nearest integer.
    ///
    /// Basis: strucpp-architecture: Type System; strucpp-compliance: Data Types, Language Extensions (nested comments);
    /// strucpp-tests; what they leave open is accepted.
    #[must_use]
    pub const fn strucpp() -> Dialect {
        Dialect {
            name: DialectName::Strucpp,
            widening: Widening::Numbers,
            real_literal_as_integer: true,
            implicit_warnings: ImplicitWarnings::Narrowing,
            conversions: ConversionChoices {
                rounding: Rounding::HalfAwayFromZero,
                text_reading: TextReading::LeadingNumber,
                moment_units: MomentUnits::DaysAndMilliseconds,
                ..COMMON_CHOICES
            },
            ..Dialect::with_third_edition()
        }
    }

    /// RuSTy: numbers, bit strings, durations and dates stand for each other, downcasts are a warning, a real becomes the nearest integer, and
    /// a bit string shares its bits with a real and its lowest one with a BOOL.
    ///
    /// Basis: rusty-tests: src/validation/tests/assignment_validation_tests.rs, tests/lit/single/conversion/to_num.st,
    /// libs/stdlib/tests/bit_conversion_tests.rs, libs/stdlib/tests/bit_num_conversion_tests.rs;
    /// rusty-direct-variables: Constant based Direct Access; what they leave open is accepted.
    #[must_use]
    pub const fn rusty() -> Dialect {
        Dialect {
            name: DialectName::Rusty,
            widening: Widening::NumbersAndMoments,
            implicit_warnings: ImplicitWarnings::LargerTypes,
            partial_access: PartialAccess::UpToDoubleWords,
            conversions: ConversionChoices {
                rounding: Rounding::HalfAwayFromZero,
                bits_as_real: BitsAsReal::Copy,
                bit_string_as_bool: BitStringAsBool::LowestBit,
                ..COMMON_CHOICES
            },
            ..Dialect::with_third_edition()
        }
    }

    /// CODESYS 3.5.21 with a 64-bit target, as it was recorded: an integer or bit string stands for each that is not narrower, and a real
    /// becomes the nearest integer.
    ///
    /// Basis: codesys-recording; codesys-implicit; what they leave open is accepted.
    #[must_use]
    pub const fn codesys() -> Dialect {
        Dialect {
            name: DialectName::Codesys,
            widening: Widening::NumbersUnlessNarrower,
            implicit_warnings: ImplicitWarnings::LostValues,
            operands: OperandTypes::Promoted,
            result_signs: ResultSigns::OfOperator,
            literals_by_width: true,
            enumerations_as_integers: true,
            lengths_in_parentheses: true,
            modulo_by_zero_is_zero: true,
            division_stops: true,
            mux_outside_takes_last: true,
            shift_counts: ShiftCounts::LowBits,
            functions_promote: true,
            negates_durations: false,
            ampersand_and_power: false,
            partial_access: PartialAccess::UpToDoubleWords,
            conversions: ConversionChoices {
                rounding: Rounding::HalfAwayFromZero,
                out_of_range: OutOfRange::Indefinite64,
                truncation_out_of_range: OutOfRange::Indefinite32,
                bit_string_text: BitStringText::Decimal,
                text_reading: TextReading::LeadingDigits,
                real_text: RealText::ByWidth,
                moment_text: MomentText::Components,
                moment_units: MomentUnits::Counts,
                ..COMMON_CHOICES
            },
            ..Dialect::with_third_edition()
        }
    }

    /// TwinCAT 3, which compiles as CODESYS does.
    ///
    /// Basis: codesys-implicit; twincat-builds; what they leave open is accepted.
    #[must_use]
    pub const fn twincat() -> Dialect {
        Dialect {
            name: DialectName::Twincat,
            constant_types: ConstantTypes::Least,
            third_edition_types: ThirdEditionTypes::WithoutLongDates,
            ..Dialect::codesys()
        }
    }

    /// Rockwell Logix 5000: an assignment converts every number to every other, a real becomes the nearest integer, halves the even one, and what is
    /// too large keeps its low bits; BOOL converts to nothing, and short integers are computed as DINT.
    ///
    /// Basis: logix-manual: 512, 541, 543, 544, 546; logix-help; what they leave open is accepted.
    #[must_use]
    pub const fn logix() -> Dialect {
        Dialect {
            name: DialectName::Logix,
            widening: Widening::NumbersApartFromBool,
            operands: OperandTypes::Promoted,
            ..Dialect::with_third_edition()
        }
    }

    /// Schneider Control Expert with implicit type conversion enabled: numbers and bit strings stand for each other, but a REAL for no bit string, and
    /// BOOL for all of them; a real becomes the nearest integer, halves the even one, and nothing is lost before a result is stored.
    ///
    /// Basis: control-expert-implicit; control-expert-real-to: Example; control-expert-result-type: Control Expert Differences; what they leave open is accepted.
    #[must_use]
    pub const fn control_expert() -> Dialect {
        Dialect {
            name: DialectName::ControlExpert,
            widening: Widening::NumbersButNoRealAsBits,
            operands: OperandTypes::Promoted,
            ..Dialect::with_third_edition()
        }
    }

    /// Omron NJ: numbers and bit strings meet in the type with the higher rank, and a real becomes the nearest integer.
    ///
    /// Basis: omron-implicit-casts; omron-instructions; what they leave open is accepted.
    #[must_use]
    pub const fn omron() -> Dialect {
        Dialect {
            name: DialectName::Omron,
            widening: Widening::Numbers,
            operands: OperandTypes::HigherRank,
            compared: ComparedTypes::OfOneKind,
            nan_differs: false,
            ..Dialect::with_third_edition()
        }
    }

    /// The third edition of the standard: what widens is implicit, a real becomes the nearest integer, and a bit string shares its bits with a real.
    ///
    /// Basis: iec-61131-3: Tables 22 to 26; trust-data-types; control-expert-implicit; what they leave open is accepted.
    #[must_use]
    pub const fn iec_ed3() -> Dialect {
        Dialect {
            name: DialectName::IecEd3,
            widening: Widening::Plcnext,
            partial_access: PartialAccess::UpToDoubleWords,
            conversions: ConversionChoices {
                bits_as_real: BitsAsReal::Copy,
                ..COMMON_CHOICES.with_rounding(Rounding::HalfToEven)
            },
            ..Dialect::with_third_edition()
        }
    }
}
