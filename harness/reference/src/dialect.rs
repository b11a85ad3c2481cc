//! The one place where a dialect's name becomes behaviour.

use stickler_types::DialectName;

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
    /// TRUNC_INT, TRUNC_LINT, TRUNC_DINT, BCD_TO_INT and so on as the ForgeIEC page documents them.
    pub real_to_integer: RealToInteger,
}

/// How REAL becomes an integer in a conversion function that is not TRUNC.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RealToInteger {
    /// Toward zero.
    Truncate,
    /// To nearest, ties to even (IEC 60559).
    HalfToEven,
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
