//! The language rules of a dialect: what the sources leave to a system.
//!
//! The file of a dialect, `conformance-cases/dialects/NAME.toml` or a table of `stickler.toml`, states those in which it differs
//! from the [defaults](DEFAULTS) or from the dialect that it extends.

use crate::definition::Flag;
pub use crate::options::{PartialAccess, ThirdEditionTypes, Widening};
use crate::{
    BitStringAsBool, BitStringText, BitsAsReal, ConversionChoices, Definition, DialectName, ElementaryType,
    MatrixWord, MomentText, MomentUnits, OutOfRange, RealText, Rounding, Stated, TextReading,
};
pub use crate::{ComparedTypes, ConstantTypes, ImplicitWarnings, OperandTypes, ResultSigns, ShiftCounts};
use std::collections::BTreeMap;

/// The language rules of a dialect. Each field names a choice that the sources make differently (conformance-cases/sources.toml
/// and rules.md name the basis of each).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Dialect {
    /// The name.
    pub name: DialectName,
    /// The pairs of elementary types that convert implicitly.
    pub widening: Widening,
    /// The pairs of which a definition says something else.
    pub cells: &'static Cells,
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
    /// An untyped real literal may stand where an integer is expected; it converts as a value does.
    ///
    /// Basis: strucpp-architecture: Type System ("assignable to any numeric type"); ironplc-type-conversions: Integer and Real Types, by which it
    /// may not.
    pub real_literal_as_integer: bool,
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

/// The statements of a definition about pairs of types: of the value, and of the target.
pub type Cells = BTreeMap<(ElementaryType, ElementaryType), Stated<MatrixWord>>;

/// The rules of a dialect whose file states nothing: those of the third edition that most systems share, without implicit conversions.
///
/// Basis: iec-61131-3: third edition, Tables 3, 5, 10, 71; iec-60559: Operations (rounding to nearest); rule: not-stated for
/// what is open.
pub const DEFAULTS: Dialect = Dialect {
    name: DialectName::IEC_ED3,
    widening: Widening::None,
    cells: &Cells::new(),
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
};

impl Dialect {
    /// Returns the rules of a dialect.
    #[must_use]
    pub fn of(name: DialectName) -> &'static Dialect {
        name.rules()
    }

    /// Returns the rules that a definition states under a name; the defaults where it states none.
    pub(crate) fn stated(name: DialectName, definition: &'static Definition) -> Dialect {
        let mut rules = Dialect {
            name,
            cells: &definition.implicit,
            ..DEFAULTS
        };
        definition.language.apply(&mut rules);
        definition.operators.apply(&mut rules);
        let conversions = &definition.conversions;
        conversions.apply(&mut rules.conversions);
        if conversions.truncation_out_of_range.is_none() {
            rules.conversions.truncation_out_of_range = rules.conversions.out_of_range;
        }
        for (flag, stated) in &definition.flags {
            rules.switch(*flag, stated.value);
        }
        rules
    }

    /// Switches a feature of the language on or off.
    fn switch(&mut self, flag: Flag, on: bool) {
        match flag {
            Flag::CrossFamilyWidening => self.cross_family_widening = on,
            Flag::PartialAccessSyntax if on => self.partial_access = self.partial_access.enabled(),
            Flag::PartialAccessSyntax => self.partial_access = PartialAccess::Disabled,
            Flag::BitAccess => self.bit_access = on,
            Flag::IntegerLiteralAsReal => self.integer_literal_as_real = on,
            Flag::RealLiteralAsInteger => self.real_literal_as_integer = on,
            Flag::IntegerLiteralAsBitString => self.integer_literal_as_bit_string = on,
            Flag::LineComments => self.line_comments = on,
            Flag::NestedComments => self.nested_comments = on,
            Flag::ThirdEditionTypes if on => self.third_edition_types = ThirdEditionTypes::All,
            Flag::ThirdEditionTypes => self.third_edition_types = ThirdEditionTypes::None,
            Flag::RoundingFunctions => self.only_standard_rounding = !on,
            Flag::LiteralsByWidth => self.literals_by_width = on,
            Flag::EnumerationsAsIntegers => self.enumerations_as_integers = on,
            Flag::DerivedTypesConvert => self.derived_types_convert = on,
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

    /// Returns whether the dialect has this elementary type.
    #[must_use]
    pub const fn has(&self, ty: ElementaryType) -> bool {
        !ty.is_third_edition() || self.third_edition_types.includes(ty)
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
        assert_eq!(
            DialectName::ALL.map(has),
            [
                false, true, true, false, true, true, true, true, true, true, true, true, true
            ]
        );
        assert!(Dialect::of(DialectName::IRONPLC_ED2).has(ElementaryType::Time));
    }
}
