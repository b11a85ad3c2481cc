//! The options of the choices in which dialects differ, apart from those of conversions.

use stickler_types::ElementaryType;

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

/// The implicit conversions that are accepted with a warning.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ImplicitWarnings {
    /// None of them.
    None,
    /// C0195 to C0197 where the target does not hold every number of the type.
    ///
    /// Basis: codesys-implicit: classifyElementary.
    LostValues,
    /// S0003 for fewer bits within a category, for a real to an integer, and between signed and unsigned of one size.
    ///
    /// Basis: strucpp-architecture: Type System; strucpp-tests: tests/semantic/type-utils.test.ts.
    Narrowing,
    /// E067 for every type with fewer bits; a duration, a date and a time of day have 64.
    ///
    /// Basis: rusty-tests: src/validation/tests/assignment_validation_tests.rs.
    LargerTypes,
}

/// The types in which two integers or bit strings meet.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OperandTypes {
    /// The type of one operand, to which the other converts.
    ///
    /// Basis: rule: mixed-operands.
    OneOfTheirs,
    /// An integer type as wide as the wider of them, with a sign if one of them has one; it is computed with 32 bits at least, so
    /// that nothing is lost before the value is stored.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`meet_…`, `arithedge_…`, `cmp_…`); logix-manual: 541, of SINT and INT;
    /// control-expert-result-type: Control Expert Differences, where the result is stored into more bits.
    Promoted,
    /// The type of the operand with the higher rank, to which the other converts; of two with the same rank the unsigned one. The ranks: 8 bits,
    /// 16 bits, REAL, 32 bits, LREAL, 64 bits.
    ///
    /// Basis: omron-implicit-casts: Data Type Ranking Table.
    HigherRank,
}

/// The pairs of numbers and bit strings that a comparison takes, if one of the two converts to the other's type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ComparedTypes {
    /// Any two.
    Any,
    /// Two bit strings, two integers with a sign, two without, and numbers of which one is a real.
    OfOneKind,
}

/// The types of what operators on bits and prefix operators give for integers and bit strings.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ResultSigns {
    /// Those of the operands.
    OfOperands,
    /// With a sign and 16 bits at least behind a minus sign, which a bit string may have, too; without a sign behind NOT, and where AND, OR and
    /// XOR combine an integer that has none with one of no more bits that has one.
    OfOperator,
}

/// The type of an operation on constants.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConstantTypes {
    /// That of its operands.
    OfOperands,
    /// The least, with the sign of the operands, that holds its number: `30000 + 10000` is a DINT, and no INT.
    Least,
}

/// The bits of the count by which SHL and SHR shift.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ShiftCounts {
    /// All of them: a count of the width or more leaves no bit.
    All,
    /// The lowest five, and for 64 bits the lowest six: a DWORD shifted by 32 stays as it is.
    ///
    /// Basis: codesys-recording: recordings/codesys.run.json (`bit_shl_…`, `shift_…`).
    LowBits,
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
    /// The same but for LDATE, LTOD and LDT.
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
