//! The one place where a dialect's name becomes behaviour.

pub use crate::options::{PartialAccess, ThirdEditionTypes, Widening};
use std::collections::BTreeMap;
use stickler_types::definition::Flag;
use stickler_types::{
    BitStringAsBool, BitStringText, BitsAsReal, BuiltIn, ConversionChoices, Definition, DialectName,
    ElementaryType, MatrixWord, MomentText, MomentUnits, OutOfRange, RealText, Rounding, Stated, TextReading,
};
pub use stickler_types::{
    ComparedTypes, ConstantTypes, ImplicitWarnings, OperandTypes, ResultSigns, ShiftCounts,
};

/// The language rules of one documented system. Each field names a choice that the sources make differently
/// (conformance-cases/sources.toml and rules.md name the basis of each); nothing else in this crate asks for a dialect's
/// name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Dialect {
    /// The name.
    pub name: DialectName,
    /// The pairs of elementary types that convert implicitly.
    pub widening: Widening,
    /// The pairs of which a definition says something else.
    pub cells: Option<&'static Cells>,
    /// The implicit conversions that are accepted with a warning.
    pub implicit_warnings: ImplicitWarnings,
    /// The types in which two integers or bit strings meet.
    pub operands: OperandTypes,
    /// The pairs of numbers and bit strings that a comparison takes.
    ///
    /// Basis: omron-instructions: 135; rule: mixed-operands.
    pub compared: ComparedTypes,
    /// The types of operations on constants.
    ///
    /// Basis: twincat-builds: recordings/twincat.build.json (`cc_fp_overflow_expr`, `cc_typed_fold_…`).
    pub constant_types: ConstantTypes,
    /// The signs of what operators on bits and prefix operators give.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`uop_neg_…`, `not_result_width`); twincat-builds:
    /// recordings/twincat.build.json (`cc_bitwise_…`, `cc_not_…`, `cc_neg_…`).
    pub result_signs: ResultSigns,
    /// `<>` holds where an operand is not a number.
    ///
    /// Basis: iec-60559: Special Quantities; omron-instructions: 135, by which it does not.
    pub nan_differs: bool,
    /// An untyped integer literal may stand for a value of the same bits: 200 for a SINT of -56, -1 for a WORD of 16#FFFF. Where implicit
    /// conversions are warned of, so is this.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`bound_…`, `cc_…`); twincat-builds: recordings/twincat.build.json (the
    /// warnings).
    pub literals_by_width: bool,
    /// The bits of the count by which SHL and SHR shift.
    pub shift_counts: ShiftCounts,
    /// MIN, MAX, ABS, SHL and SHR compute integers and bit strings as operators on promoted operands do: in the type in which they meet, and with 32
    /// bits at least. Shifts and rotations take integers, too, and SHR of one with a sign keeps the sign.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`max_signed_unsigned`, `meet_mixed_sign_wider_unsigned`, `abs_values`, `shift_basic`,
    /// `shift_signed_operand`, `shift_64bit`).
    pub functions_promote: bool,
    /// A minus sign may stand before a duration.
    ///
    /// Basis: rule: mixed-operands; codesys-recording: recordings/codesys.run.json (`unary_minus_on_time`, `uop_neg_ltime`), by which it may not.
    pub negates_durations: bool,
    /// A value of an enumeration may stand where a number is expected, as an INT.
    ///
    /// Basis: twincat-builds: recordings/twincat.build.json (`cc_enum_…`).
    pub enumerations_as_integers: bool,
    /// A user-defined name of an elementary type, and a subrange of one, convert implicitly as the type does.
    ///
    /// Basis: matiec: User-defined types; rule: not-stated; implicit-conversion-rules: ANY_DATE, STRING and user defined, by which they do not.
    pub derived_types_convert: bool,
    /// The length of a text may stand in parentheses: `STRING(80)`.
    ///
    /// Basis: twincat-builds: recordings/twincat.build.json (`cc_string_…`); ironplc-problem-codes: P4042.
    pub lengths_in_parentheses: bool,
    /// `&` and `**` are operators.
    ///
    /// Basis: iec-61131-3: Table 71; twincat-builds: recordings/twincat.build.json (`cc_power_operator`, `cc_fp_op_ampersand`); codesys-recording:
    /// recordings/codesys.run.json (`ampersand_operator_rejected`).
    pub ampersand_and_power: bool,
    /// MOD of integers by zero gives 0, and is no fault.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`arithedge_…_mod_by_zero`).
    pub modulo_by_zero_is_zero: bool,
    /// `/` stops the program where a real number is divided by zero, and where a quotient of integers does not fit its type: the least DINT
    /// divided by -1.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`domain_divide_real_by_zero`, `arithedge_…_div_min_by_minus_one`).
    pub division_stops: bool,
    /// MUX with a selector outside its inputs takes the last one, and is no fault.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`mux_out_of_range`).
    pub mux_outside_takes_last: bool,
    /// Bit string to strictly wider integer is implicit (`--allow-cross-family-widening`).
    pub cross_family_widening: bool,
    /// An untyped integer literal may stand for a REAL or LREAL.
    pub integer_literal_as_real: bool,
    /// An untyped integer literal may be assigned or passed to a bit string (an initializer and an operand
    /// always take one).
    pub integer_literal_as_bit_string: bool,
    /// `.n` selects a bit.
    pub bit_access: bool,
    /// The treatment of `.%Xn`, `.%Bn` …
    pub partial_access: PartialAccess,
    /// `//` begins a comment.
    pub line_comments: bool,
    /// Comments nest.
    pub nested_comments: bool,
    /// The types of the third edition that the dialect has.
    pub third_edition_types: ThirdEditionTypes,
    /// ROUND, CEIL, CEILING, FLOOR are not known.
    pub only_standard_rounding: bool,
    /// Variables with a location (`AT %MW5`) and others stand in one section. Basis: ironplc-problem-codes: P4036; ironplc-dialects: Enabling
    /// Specific Features.
    pub mixed_locations: bool,
    /// A subrange may have a single value: `INT(0..0)`.
    ///
    /// Basis: ironplc-problem-codes: P2002, by which the lower limit is "strictly less"; nobody else speaks of it.
    pub single_value_subranges: bool,
    /// The choices of conversion functions, and of implicit conversions, where systems differ.
    pub conversions: ConversionChoices,
}

/// The choices of every documented system unless it says otherwise: truncation, wrapping, whole texts, and values written as the wire
/// protocol has them.
///
/// Basis: forgeiec-conversion-functions: Range and precision, matiec conformance; ironplc-type-conversions: Explicit Conversion
/// Functions; rule: not-stated for what is open.
pub const COMMON_CHOICES: ConversionChoices = ConversionChoices {
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

/// Replaces a choice by the one that a definition states, if it states one.
fn override_by<T: Copy>(choice: &mut T, stated: &Option<Stated<T>>) {
    if let Some(stated) = stated {
        *choice = stated.value;
    }
}

/// The statements of a definition about pairs of types: of the value, and of the target.
pub type Cells = BTreeMap<(ElementaryType, ElementaryType), Stated<MatrixWord>>;

impl Dialect {
    /// The rules of the dialect of this name.
    #[must_use]
    pub fn of(name: DialectName) -> Dialect {
        let base = match name.base() {
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
        };
        match name.definition() {
            None => base,
            Some(definition) => Dialect {
                name,
                ..base.overridden(definition)
            },
        }
    }

    /// Returns these rules with the overrides of a definition.
    fn overridden(mut self, definition: &'static Definition) -> Dialect {
        for (flag, stated) in &definition.flags {
            let on = stated.value;
            match flag {
                Flag::CrossFamilyWidening => self.cross_family_widening = on,
                Flag::PartialAccessSyntax if on => self.partial_access = self.partial_access.enabled(),
                Flag::PartialAccessSyntax => self.partial_access = PartialAccess::Disabled,
                Flag::BitAccess => self.bit_access = on,
                Flag::IntegerLiteralAsReal => self.integer_literal_as_real = on,
                Flag::IntegerLiteralAsBitString => self.integer_literal_as_bit_string = on,
                Flag::LineComments => self.line_comments = on,
                Flag::NestedComments => self.nested_comments = on,
                Flag::ThirdEditionTypes if on => self.third_edition_types = ThirdEditionTypes::All,
                Flag::ThirdEditionTypes => self.third_edition_types = ThirdEditionTypes::None,
                Flag::RoundingFunctions => self.only_standard_rounding = !on,
                Flag::LiteralsByWidth => self.literals_by_width = on,
                Flag::EnumerationsAsIntegers => self.enumerations_as_integers = on,
                Flag::LengthsInParentheses => self.lengths_in_parentheses = on,
                Flag::AmpersandAndPower => self.ampersand_and_power = on,
                Flag::ModuloByZeroIsZero => self.modulo_by_zero_is_zero = on,
                Flag::DivisionStops => self.division_stops = on,
                Flag::MuxOutsideTakesLast => self.mux_outside_takes_last = on,
                Flag::FunctionsPromote => self.functions_promote = on,
                Flag::NegatesDurations => self.negates_durations = on,
                Flag::NanDiffers => self.nan_differs = on,
                Flag::MixedLocations => self.mixed_locations = on,
                Flag::SingleValueSubranges => self.single_value_subranges = on,
            }
        }
        let operators = &definition.operators;
        override_by(&mut self.implicit_warnings, &operators.implicit_warnings);
        override_by(&mut self.operands, &operators.operands);
        override_by(&mut self.compared, &operators.compared);
        override_by(&mut self.result_signs, &operators.result_signs);
        override_by(&mut self.constant_types, &operators.constant_types);
        override_by(&mut self.shift_counts, &operators.shift_counts);
        self.cells = Some(&definition.implicit);
        self.conversions = self.conversions.overridden(definition);
        self
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

    /// Returns whether the dialect has this elementary type.
    #[must_use]
    pub const fn has(&self, ty: ElementaryType) -> bool {
        !ty.is_third_edition() || self.third_edition_types.includes(ty)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::{OutOfRange, Rounding};

    #[test]
    fn every_name_has_its_own_dialect() {
        for name in DialectName::ALL {
            assert_eq!(Dialect::of(name).name, name);
        }
    }

    #[test]
    fn the_second_edition_lacks_the_types_of_the_third() {
        let has = |name| Dialect::of(name).has(ElementaryType::Ltime);
        assert_eq!(
            DialectName::ALL.map(has),
            [
                false, true, true, false, true, true, true, true, true, true, true, true, true
            ]
        );
        assert!(Dialect::ironplc_ed2().has(ElementaryType::Time));
    }

    #[test]
    fn a_definition_overrides_its_base_and_nothing_else() {
        fn stated<T>(value: T) -> Stated<T> {
            Stated {
                value,
                basis: "mine: test".to_owned(),
            }
        }
        let flags = Flag::ALL
            .iter()
            .map(|flag| (*flag, stated(*flag == Flag::LineComments)));
        let pair = |from, to, cell| ((from, to), stated(cell));
        let name = DialectName::define(Definition {
            implicit: BTreeMap::from([
                pair(ElementaryType::Int, ElementaryType::Bool, MatrixWord::Yes),
                pair(ElementaryType::Sint, ElementaryType::Int, MatrixWord::No),
                pair(ElementaryType::Bool, ElementaryType::Int, MatrixWord::Open),
            ]),
            flags: flags.collect(),
            rounding: Some(stated(Rounding::HalfAwayFromZero)),
            out_of_range: Some(stated(OutOfRange::Saturate)),
            ..Definition::new("reference-overrides", BuiltIn::IronplcEd3, "here")
        })
        .expect("the name is free");
        let mine = Dialect::of(name);
        assert!(
            mine.line_comments && !mine.nested_comments && !mine.bit_access && mine.only_standard_rounding
        );
        assert!(!mine.integer_literal_as_real && mine.third_edition_types == ThirdEditionTypes::None);
        assert_eq!(mine.partial_access, PartialAccess::Disabled);
        assert_eq!(mine.conversions.rounding, Rounding::HalfAwayFromZero);
        assert_eq!(mine.conversions.out_of_range, OutOfRange::Saturate);
        assert_eq!(mine.conversions.real_text, RealText::Shortest);
        let accepts = |from: &str, into: &str, dialect| {
            let text =
                format!("PROGRAM main\nVAR\n a : {from};\n b : {into};\nEND_VAR\n b := a;\nEND_PROGRAM\n");
            crate::errors(&text, dialect).is_empty()
        };
        for (from, into, in_mine, in_base) in [
            ("INT", "BOOL", true, false),
            ("SINT", "INT", false, true),
            ("BOOL", "INT", true, false),
            ("INT", "DINT", true, true),
            ("DINT", "INT", false, false),
        ] {
            assert_eq!(accepts(from, into, name), in_mine, "{from} to {into}");
            assert_eq!(
                accepts(from, into, DialectName::IronplcEd3),
                in_base,
                "{from} to {into}"
            );
        }
    }
}
