//! What a dialect's file states: the choices in which it differs from the dialect that it extends, or from the defaults.
//!
//! The meaning of a choice is implemented twice, independently: by the reference and by exact arithmetic.

use crate::choices::Choice;
use crate::dialect::{PartialAccess, ThirdEditionTypes, Widening};
use crate::documents::Documents;
use crate::words::words;
use crate::{
    BitStringAsBool, BitStringText, BitsAsReal, ComparedTypes, ConstantTypes, ConversionChoices, Dialect,
    DialectName, ElementaryType, ImplicitWarnings, MatrixWord, MomentText, MomentUnits, OperandTypes,
    OutOfRange, RealText, ResultSigns, Rounding, ShiftCounts, TextReading,
};
use std::collections::BTreeMap;

/// The kind of a dialect, which says whose cases it has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DialectKind {
    /// A documented system, which case files name.
    Documented,
    /// A documented system with compiler options on or off, which case files name; it takes over no cases.
    Variant,
    /// A dialect of `stickler.toml`, which takes over the cases of its base.
    Custom,
}

/// The content of a dialect's file, together with that of the files that it extends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Definition {
    /// The name of the dialect.
    pub name: String,
    /// The name of the system, for people.
    pub title: String,
    /// The documented system that it is, or whose rules apply where the definition states nothing.
    pub base: DialectName,
    /// A description of the dialect, for people.
    pub about: Option<String>,
    /// The kind of the dialect.
    pub kind: DialectKind,
    /// The file and line of the definition, such as `stickler.toml:3`.
    pub place: String,
    /// Whether the sources say single things of the system, pairs of types and values, and not what its language is: only tables
    /// that name it speak for it, and no programs are generated in it.
    pub is_known_in_part: bool,
    /// What the documents of the system say, in the words by which exact arithmetic and the generator know them.
    pub documents: Documents,
    /// The pairs of types, of the value and of the target, for which the definition states whether they convert implicitly.
    pub implicit: BTreeMap<(ElementaryType, ElementaryType), Stated<MatrixWord>>,
    /// The language features that the definition enables or disables.
    pub flags: BTreeMap<Flag, Stated<bool>>,
    /// The choices of the language.
    pub language: LanguageOverrides,
    /// The choices of conversion functions.
    pub conversions: ConversionOverrides,
    /// The choices of operators.
    pub operators: OperatorOverrides,
}

/// A statement of a definition.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stated<T> {
    /// The stated value.
    pub value: T,
    /// The basis of an expectation that follows from the statement, in the form of a case file: `mine: rounding
    /// (stickler.toml:9)`. `None` in the file of a documented system, whose documents are the basis.
    pub basis: Option<String>,
}

/// The error of a name under which no dialect can be defined, because another dialect has it.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("there is a dialect `{0}` already")]
pub struct TakenName(pub String);

/// Declares the choices of a table of a dialect's file, each with the key by which the file states it.
macro_rules! overrides {
    ($(#[$about:meta])* $name:ident of $target:ty {
        $($(#[$said:meta])* $field:ident : $choice:ty = $key:literal,)*
    }) => {
        $(#[$about])*
        #[derive(Clone, PartialEq, Eq, Default, Debug)]
        pub struct $name {
            $($(#[$said])* pub $field: Option<Stated<$choice>>,)*
        }

        impl $name {
            /// The keys of the table, in the order of the declaration.
            pub const KEYS: &'static [&'static str] = &[$($key),*];

            /// Sets the choice of a key to a word. The error lists the words that the key may have.
            ///
            /// Returns `None` for an unknown key.
            pub(crate) fn set(
                &mut self,
                key: &str,
                word: &str,
                basis: Option<String>,
            ) -> Option<Result<(), Vec<&'static str>>> {
                match key {
                    $($key => Some(match <$choice>::read(word) {
                        Some(value) => {
                            self.$field = Some(Stated { value, basis });
                            Ok(())
                        }
                        None => Err(<$choice>::known()),
                    }),)*
                    _ => None,
                }
            }

            /// Makes the stated choices in `target`.
            pub(crate) fn apply(&self, target: &mut $target) {
                $(if let Some(stated) = &self.$field {
                    target.$field = stated.value;
                })*
            }

            /// Returns the statements with a basis in the notation of the file: `operands = promoted`.
            fn written(&self) -> Vec<String> {
                let mut written = Vec::new();
                $(if let Some(stated) = self.$field.as_ref().filter(|stated| stated.basis.is_some()) {
                    written.push(format!("{} = {}", $key, stated.value.written()));
                })*
                written
            }

            /// Returns the statements as those of a dialect of another name.
            fn renamed(&self, name: &str) -> $name {
                $name { $($field: self.$field.as_ref().map(|stated| stated.renamed(name)),)* }
            }
        }
    };
}

overrides! {
    /// The choices of the language that a definition states.
    LanguageOverrides of Dialect {
        /// The pairs of types that convert implicitly.
        widening: Widening = "implicit",
        /// The forms of partial access.
        partial_access: PartialAccess = "partial-access",
        /// The types of the third edition.
        third_edition_types: ThirdEditionTypes = "third-edition-types",
    }
}

overrides! {
    /// The choices of conversion functions that a definition states.
    ConversionOverrides of ConversionChoices {
        /// The rounding of real numbers to integers.
        rounding: Rounding = "rounding",
        /// The result for a real number that lies outside the integer.
        out_of_range: OutOfRange = "out-of-range",
        /// The result of TRUNC and its kin for such a number, where it is another one.
        truncation_out_of_range: OutOfRange = "truncation-out-of-range",
        /// The part of a text that must be a number.
        text_reading: TextReading = "text-reading",
        /// The digits in which a real number is written as text.
        real_text: RealText = "real-text",
        /// The form in which a bit string is written as text.
        bit_string_text: BitStringText = "bit-string-text",
        /// The form in which a duration, date or time of day is written as text.
        moment_text: MomentText = "moment-text",
        /// The meaning of the bits of a bit string as a real of the same width.
        bits_as_real: BitsAsReal = "bits-as-real",
        /// The bits of a bit string that decide whether it converts to TRUE.
        bit_string_as_bool: BitStringAsBool = "bit-string-as-bool",
        /// The unit in which a number counts a duration, date or time of day.
        moment_units: MomentUnits = "moment-units",
    }
}

overrides! {
    /// The choices of operators that a definition states.
    OperatorOverrides of Dialect {
        /// The implicit conversions that are warned of.
        implicit_warnings: ImplicitWarnings = "implicit-warnings",
        /// The types in which two integers or bit strings meet.
        operands: OperandTypes = "operands",
        /// The pairs of numbers and bit strings that a comparison takes.
        compared: ComparedTypes = "compared",
        /// The signs of what operators on bits and prefix operators give.
        result_signs: ResultSigns = "result-signs",
        /// The types of operations on constants.
        constant_types: ConstantTypes = "constant-types",
        /// The bits of the count of a shift.
        shift_counts: ShiftCounts = "shift-counts",
    }
}

impl<T: Copy> Stated<T> {
    /// Returns the statement as one of a dialect of another name.
    fn renamed(&self, name: &str) -> Stated<T> {
        let rename = |basis: &String| {
            let rest = basis.split_once(':').map_or("", |(_, rest)| rest);
            format!("{name}:{rest}")
        };
        Stated {
            value: self.value,
            basis: self.basis.as_ref().map(rename),
        }
    }
}

impl Definition {
    /// Returns the definition of a dialect that extends another one and overrides nothing.
    pub fn new(name: &str, base: DialectName, place: &str) -> Definition {
        Definition::extending(base.statements(), name, place)
    }

    /// Returns the definition of a documented system that states nothing.
    pub(crate) fn documented(name: &str, own: DialectName, place: &str) -> Definition {
        Definition {
            name: name.to_owned(),
            title: String::new(),
            base: own,
            about: None,
            kind: DialectKind::Documented,
            place: place.to_owned(),
            is_known_in_part: false,
            documents: Documents::default(),
            implicit: BTreeMap::new(),
            flags: BTreeMap::new(),
            language: LanguageOverrides::default(),
            conversions: ConversionOverrides::default(),
            operators: OperatorOverrides::default(),
        }
    }

    /// Returns what another definition states under the name of a custom dialect that extends it.
    pub(crate) fn extending(other: &Definition, name: &str, place: &str) -> Definition {
        Definition {
            name: name.to_owned(),
            about: None,
            kind: DialectKind::Custom,
            place: place.to_owned(),
            implicit: other
                .implicit
                .iter()
                .map(|(pair, stated)| (*pair, stated.renamed(name)))
                .collect(),
            flags: other
                .flags
                .iter()
                .map(|(flag, stated)| (*flag, stated.renamed(name)))
                .collect(),
            language: other.language.renamed(name),
            conversions: other.conversions.renamed(name),
            operators: other.operators.renamed(name),
            ..other.clone()
        }
    }

    /// Returns what the definition states of a flag beside the documents of its base; `None` if it states nothing.
    pub fn flag(&self, flag: Flag) -> Option<bool> {
        let stated = self.flags.get(&flag).filter(|stated| stated.basis.is_some());
        stated.map(|stated| stated.value)
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
        let flags = self.flags.iter().filter(|(_, stated)| stated.basis.is_some());
        let flags = flags.map(|(flag, stated)| format!("{} = {}", flag.as_str(), stated.value));
        cells
            .chain(flags)
            .chain(self.language.written())
            .chain(self.conversions.written())
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
        /// An untyped real literal may stand where an integer is expected; it converts as a value does.
        RealLiteralAsInteger = "real-literal-as-integer",
        /// A user-defined name of an elementary type, and a subrange of one, convert implicitly as the type does.
        DerivedTypesConvert = "derived-types-convert",
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
        let definition = Definition::new("mine", DialectName::PLCNEXT, "stickler.toml:1");
        assert_eq!(definition.flag(Flag::BitAccess), None);
        assert_eq!(
            definition.implicit(ElementaryType::Int, ElementaryType::Bool),
            None
        );
        assert!(definition.overrides().is_empty());
    }
}
