//! The language rules of a dialect: what the sources leave to a system, and what a definition overrides.
//!
//! [`crate::built_in_dialects`] is the one place where the name of a built-in dialect becomes behaviour.

use crate::definition::Flag;
pub use crate::options::{PartialAccess, ThirdEditionTypes, Widening};
use crate::{
    BitStringAsBool, BitStringText, BitsAsReal, ConversionChoices, Definition, DialectName, ElementaryType,
    MatrixWord, MomentText, MomentUnits, OutOfRange, RealText, Rounding, Stated, TextReading,
};
pub use crate::{ComparedTypes, ConstantTypes, ImplicitWarnings, OperandTypes, ResultSigns, ShiftCounts};
use std::collections::BTreeMap;

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
        let base = Dialect::built_in(name.base());
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
        assert!(Dialect::ironplc_ed2().has(ElementaryType::Time));
    }
}
