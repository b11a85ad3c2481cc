//! Definitions of dialects in `stickler.toml`: the overrides of a dialect that extends another one, and their keywords.
//!
//! The meaning of an override is implemented twice, independently: by the reference and by exact arithmetic.

use crate::words::words;
use crate::{
    BitStringAsBool, BitStringText, BitsAsReal, BuiltIn, ComparedTypes, ConstantTypes, ElementaryType,
    ImplicitWarnings, MatrixWord, MomentText, MomentUnits, OperandTypes, OutOfRange, RealText, ResultSigns,
    Rounding, ShiftCounts, TextReading,
};
use std::collections::BTreeMap;

/// A user-defined dialect: another dialect with some rules overridden.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Definition {
    /// The name of the dialect.
    pub name: String,
    /// The dialect of a documented system whose rules apply where the definition states nothing.
    pub base: BuiltIn,
    /// A description of the dialect, for people.
    pub about: Option<String>,
    /// Whether the dialect is a variant of a documented system that the suite itself defines: its documents say what a compiler option
    /// does, and case files name the variant. Otherwise the dialect takes over the cases of its base.
    pub is_variant: bool,
    /// The file and line of the definition, such as `stickler.toml:3`.
    pub place: String,
    /// The pairs of types, of the value and of the target, for which the definition states whether they convert implicitly.
    pub implicit: BTreeMap<(ElementaryType, ElementaryType), Stated<MatrixWord>>,
    /// The language features that the definition enables or disables.
    pub flags: BTreeMap<Flag, Stated<bool>>,
    /// The rounding of real numbers to integers.
    pub rounding: Option<Stated<Rounding>>,
    /// The result for a real number that lies outside the integer.
    pub out_of_range: Option<Stated<OutOfRange>>,
    /// The result of TRUNC and its kin for such a number, where it is another one.
    pub truncation_out_of_range: Option<Stated<OutOfRange>>,
    /// The part of a text that must be a number.
    pub text_reading: Option<Stated<TextReading>>,
    /// The digits in which a real number is written as text.
    pub real_text: Option<Stated<RealText>>,
    /// The form in which a bit string is written as text.
    pub bit_string_text: Option<Stated<BitStringText>>,
    /// The form in which a duration, date or time of day is written as text.
    pub moment_text: Option<Stated<MomentText>>,
    /// The meaning of the bits of a bit string as a real of the same width.
    pub bits_as_real: Option<Stated<BitsAsReal>>,
    /// The bits of a bit string that decide whether it converts to TRUE.
    pub bit_string_as_bool: Option<Stated<BitStringAsBool>>,
    /// The unit in which a number counts a duration, date or time of day.
    pub moment_units: Option<Stated<MomentUnits>>,
    /// The choices of operators.
    pub operators: OperatorOverrides,
}

/// The choices of operators that a definition states.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct OperatorOverrides {
    /// The implicit conversions that are warned of.
    pub implicit_warnings: Option<Stated<ImplicitWarnings>>,
    /// The types in which two integers or bit strings meet.
    pub operands: Option<Stated<OperandTypes>>,
    /// The pairs of numbers and bit strings that a comparison takes.
    pub compared: Option<Stated<ComparedTypes>>,
    /// The signs of what operators on bits and prefix operators give.
    pub result_signs: Option<Stated<ResultSigns>>,
    /// The types of operations on constants.
    pub constant_types: Option<Stated<ConstantTypes>>,
    /// The bits of the count of a shift.
    pub shift_counts: Option<Stated<ShiftCounts>>,
}

impl OperatorOverrides {
    /// Returns the overrides in the notation of `stickler.toml`: `operands = promoted`.
    fn written(&self) -> Vec<String> {
        [
            word(
                "implicit-warnings",
                &self.implicit_warnings,
                ImplicitWarnings::as_str,
            ),
            word("operands", &self.operands, OperandTypes::as_str),
            word("compared", &self.compared, ComparedTypes::as_str),
            word("result-signs", &self.result_signs, ResultSigns::as_str),
            word("constant-types", &self.constant_types, ConstantTypes::as_str),
            word("shift-counts", &self.shift_counts, ShiftCounts::as_str),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// Returns a stated choice in the notation of `stickler.toml`.
fn word<T: Copy>(
    key: &str,
    stated: &Option<Stated<T>>,
    as_str: impl Fn(T) -> &'static str,
) -> Option<String> {
    stated
        .as_ref()
        .map(|stated| format!("{key} = {}", as_str(stated.value)))
}

/// A statement of a definition, with its basis.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stated<T> {
    /// The stated value.
    pub value: T,
    /// The basis of an expectation that follows from the statement, in the form of a case file: `mine: rounding
    /// (stickler.toml:9)`.
    pub basis: String,
}

/// The error of a name under which no dialect can be defined, because another dialect has it.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("there is a dialect `{0}` already")]
pub struct TakenName(pub String);

impl Definition {
    /// Returns a definition that overrides nothing.
    pub fn new(name: &str, base: BuiltIn, place: &str) -> Definition {
        Definition {
            name: name.to_owned(),
            base,
            about: None,
            is_variant: false,
            place: place.to_owned(),
            implicit: BTreeMap::new(),
            flags: BTreeMap::new(),
            rounding: None,
            out_of_range: None,
            truncation_out_of_range: None,
            text_reading: None,
            real_text: None,
            bit_string_text: None,
            moment_text: None,
            bits_as_real: None,
            bit_string_as_bool: None,
            moment_units: None,
            operators: OperatorOverrides::default(),
        }
    }

    /// Returns the stated value of a flag; `None` if the definition does not state it.
    pub fn flag(&self, flag: Flag) -> Option<bool> {
        self.flags.get(&flag).map(|stated| stated.value)
    }

    /// Returns the overrides in the notation of `stickler.toml`: `implicit INT.BOOL = yes`.
    pub fn overrides(&self) -> Vec<String> {
        // The flag stands for these.
        let cross_family = self
            .flags
            .get(&Flag::CrossFamilyWidening)
            .map(|stated| &stated.basis);
        let cells = self
            .implicit
            .iter()
            .filter(|(_, stated)| Some(&stated.basis) != cross_family);
        let cells =
            cells.map(|((from, to), stated)| format!("implicit {from}.{to} = {}", stated.value.as_str()));
        let flags = self
            .flags
            .iter()
            .map(|(flag, stated)| format!("{} = {}", flag.as_str(), stated.value));
        let choices = [
            word("rounding", &self.rounding, Rounding::as_str),
            word("out-of-range", &self.out_of_range, OutOfRange::as_str),
            word(
                "truncation-out-of-range",
                &self.truncation_out_of_range,
                OutOfRange::as_str,
            ),
            word("text-reading", &self.text_reading, TextReading::as_str),
            self.real_text.as_ref().map(|stated| match stated.value {
                RealText::Shortest => "real-text = shortest".to_owned(),
                RealText::ByWidth => "real-text = by-width".to_owned(),
                RealText::SignificantDigits(digits) => format!("real-text = {digits}"),
            }),
            word("bit-string-text", &self.bit_string_text, BitStringText::as_str),
            word("moment-text", &self.moment_text, MomentText::as_str),
            word("bits-as-real", &self.bits_as_real, BitsAsReal::as_str),
            word(
                "bit-string-as-bool",
                &self.bit_string_as_bool,
                BitStringAsBool::as_str,
            ),
            word("moment-units", &self.moment_units, MomentUnits::as_str),
        ];
        let choices = choices.into_iter().flatten();
        cells
            .chain(flags)
            .chain(choices)
            .chain(self.operators.written())
            .collect()
    }

    /// Returns the statement about a pair of types; `None` if there is none.
    pub fn implicit(&self, from: ElementaryType, to: ElementaryType) -> Option<&Stated<MatrixWord>> {
        self.implicit.get(&(from, to))
    }
}

words! {
    /// A language feature that a dialect has or lacks, named like the compiler option where the documents name one.
    Flag {
        /// A bit string converts implicitly to every strictly wider integer, or to none.
        /// Basis: ironplc-type-conversions: Cross-family widening.
        CrossFamilyWidening = "allow-cross-family-widening",
        /// `.%Xn` selects a bit, and its wider forms are not supported; or every form is P4033.
        /// Basis: ironplc-bit-access: Edition 3 Partial-Access Syntax.
        PartialAccessSyntax = "allow-partial-access-syntax",
        /// `.n` selects a bit.
        BitAccess = "bit-access",
        /// An untyped integer literal may stand for a REAL or LREAL.
        IntegerLiteralAsReal = "integer-literal-as-real",
        /// An untyped integer literal may be assigned or passed to a bit string.
        IntegerLiteralAsBitString = "integer-literal-as-bit-string",
        /// `//` begins a comment.
        LineComments = "line-comments",
        /// Comments nest.
        NestedComments = "nested-comments",
        /// LTIME, LDATE, LTOD, LDT, CHAR and WCHAR.
        ThirdEditionTypes = "third-edition-types",
        /// ROUND, CEIL, CEILING and FLOOR.
        RoundingFunctions = "rounding-functions",
        /// An untyped integer literal may stand for a value of the same bits: 200 for a SINT of -56.
        LiteralsByWidth = "literals-by-width",
        /// A value of an enumeration may stand where a number is expected, as an INT.
        EnumerationsAsIntegers = "enumerations-as-integers",
        /// The length of a text may stand in parentheses: `STRING(80)`.
        LengthsInParentheses = "lengths-in-parentheses",
        /// `&` and `**` are operators.
        AmpersandAndPower = "ampersand-and-power",
        /// MOD of promoted integers by zero gives 0, and is no fault.
        ModuloByZeroIsZero = "modulo-by-zero-is-zero",
        /// `/` stops the program where a real number is divided by zero, and where a quotient of integers does not fit its type.
        DivisionStops = "division-stops",
        /// MUX with a selector outside its inputs takes the last one, and is no fault.
        MuxOutsideTakesLast = "mux-outside-takes-last",
        /// MIN, MAX, ABS, SHL and SHR compute integers and bit strings with 32 bits at least, and shifts take integers.
        FunctionsPromote = "functions-promote",
        /// A minus sign may stand before a duration.
        NegatesDurations = "negates-durations",
        /// `<>` holds where an operand is not a number.
        NanDiffers = "nan-differs",
        /// Variables with a location and others may stand in one section.
        MixedLocations = "mixed-locations",
        /// A subrange may have a single value.
        SingleValueSubranges = "single-value-subranges",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_read_back() {
        for flag in Flag::ALL {
            assert_eq!(Flag::from_word(flag.as_str()), Some(*flag));
        }
    }

    #[test]
    fn a_new_definition_says_nothing() {
        let definition = Definition::new("mine", BuiltIn::Plcnext, "stickler.toml:1");
        assert_eq!(definition.flag(Flag::BitAccess), None);
        assert_eq!(
            definition.implicit(ElementaryType::Int, ElementaryType::Bool),
            None
        );
        assert!(definition.overrides().is_empty());
    }
}
