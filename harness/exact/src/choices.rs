//! The choices of each dialect in the points in which systems convert differently.

use stickler_types::{
    BitStringAsBool, BitStringText, BitsAsReal, BuiltIn, ConversionChoices, DialectName, MomentText,
    MomentUnits, OutOfRange, RealText, Rounding, TextReading,
};

/// Returns the conversion choices of a dialect.
///
/// Choices that no dialect makes describe dialects of the future, and serve to recognize the rules that a foreign compiler
/// follows.
///
/// Basis: ironplc-type-conversions: Explicit Conversion Functions and forgeiec-conversion-functions: Range and precision
/// (truncation); strucpp-tests: tests/st-validation (rounding, texts, dates); rusty-tests: libs/stdlib/tests (rounding, bits);
/// logix-help: real-to-integer and control-expert-real-to: Example (rounding);
/// rule: not-stated for all that is open. The texts of `matiec` are measured (10 digits, `16#ff`).
#[must_use]
pub fn choices_of(dialect: DialectName) -> ConversionChoices {
    let base = of_base(dialect.base());
    dialect
        .definition()
        .map_or(base, |definition| base.overridden(definition))
}

const fn of_base(base: BuiltIn) -> ConversionChoices {
    let ironplc = ConversionChoices {
        rounding: Rounding::Truncate,
        out_of_range: OutOfRange::Wrap,
        truncation_out_of_range: OutOfRange::Wrap,
        text_reading: TextReading::WholeText,
        real_text: RealText::Shortest,
        bit_string_text: BitStringText::FullWidth,
        moment_text: MomentText::Literal,
        bits_as_real: BitsAsReal::Number,
        bit_string_as_bool: BitStringAsBool::AnyBit,
        moment_units: MomentUnits::Seconds,
    };
    match base {
        BuiltIn::IronplcEd2 | BuiltIn::IronplcEd3 | BuiltIn::IronplcRusty => ironplc,
        BuiltIn::Matiec => ConversionChoices {
            real_text: RealText::SignificantDigits(10),
            bit_string_text: BitStringText::Shortest,
            ..ironplc
        },
        BuiltIn::Plcnext | BuiltIn::Logix | BuiltIn::ControlExpert | BuiltIn::Omron => ConversionChoices {
            rounding: Rounding::HalfToEven,
            ..ironplc
        },
        BuiltIn::IecEd3 => ConversionChoices {
            rounding: Rounding::HalfToEven,
            bits_as_real: BitsAsReal::Copy,
            ..ironplc
        },
        BuiltIn::Rusty => ConversionChoices {
            rounding: Rounding::HalfAwayFromZero,
            bits_as_real: BitsAsReal::Copy,
            bit_string_as_bool: BitStringAsBool::LowestBit,
            ..ironplc
        },
        BuiltIn::Codesys | BuiltIn::Twincat => ConversionChoices {
            rounding: Rounding::HalfAwayFromZero,
            out_of_range: OutOfRange::Indefinite64,
            truncation_out_of_range: OutOfRange::Indefinite32,
            bit_string_text: BitStringText::Decimal,
            text_reading: TextReading::LeadingDigits,
            real_text: RealText::ByWidth,
            moment_text: MomentText::Components,
            moment_units: MomentUnits::Counts,
            ..ironplc
        },
        BuiltIn::Strucpp => ConversionChoices {
            rounding: Rounding::HalfAwayFromZero,
            text_reading: TextReading::LeadingNumber,
            moment_units: MomentUnits::DaysAndMilliseconds,
            ..ironplc
        },
    }
}
