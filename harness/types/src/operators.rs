//! The points in which documented systems differ when they compute: what operators take and give, and of what a compiler warns.
//!
//! This module names the options; the reference implementation states which of them a dialect chooses.

use crate::choice::choices_of_words;
use crate::words::words;

words! {
    /// The implicit conversions that are accepted with a warning.
    ImplicitWarnings {
        /// None of them.
        None = "none",
        /// C0195 to C0197 where the target does not hold every number of the type.
        ///
        /// Basis: codesys-implicit: classifyElementary.
        LostValues = "lost-values",
        /// S0003 for fewer bits within a category, for a real to an integer, and between signed and unsigned of one size.
        ///
        /// Basis: strucpp-architecture: Type System; strucpp-tests: tests/semantic/type-utils.test.ts.
        Narrowing = "narrowing",
        /// E067 for every type with fewer bits; a duration, a date and a time of day have 64.
        ///
        /// Basis: rusty-tests: src/validation/tests/assignment_validation_tests.rs.
        LargerTypes = "larger-types",
    }
}

words! {
    /// The types in which two integers or bit strings meet.
    OperandTypes {
        /// The type of one operand, to which the other converts.
        ///
        /// Basis: rule: mixed-operands.
        OneOfTheirs = "one-of-theirs",
        /// An integer type as wide as the wider of them, with a sign if one of them has one; it is computed with 32 bits at least, so
        /// that nothing is lost before the value is stored.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`meet_…`, `arithedge_…`, `cmp_…`); logix-manual: 541, of SINT and INT;
        /// control-expert-result-type: Control Expert Differences, where the result is stored into more bits.
        Promoted = "promoted",
        /// The type of the operand with the higher rank, to which the other converts; of two with the same rank the unsigned one. The ranks: 8 bits,
        /// 16 bits, REAL, 32 bits, LREAL, 64 bits.
        ///
        /// Basis: omron-implicit-casts: Data Type Ranking Table.
        HigherRank = "higher-rank",
    }
}

words! {
    /// The pairs of numbers and bit strings that a comparison takes, if one of the two converts to the other's type.
    ComparedTypes {
        /// Any two numbers or bit strings.
        Any = "any",
        /// Two bit strings, two integers with a sign, two without, and numbers of which one is a real.
        OfOneKind = "of-one-kind",
    }
}

words! {
    /// The types of what operators on bits and prefix operators give for integers and bit strings.
    ResultSigns {
        /// The signs of the operands.
        OfOperands = "of-operands",
        /// By operator: with a sign and 16 bits at least behind a minus sign, which a bit string may have, too; without a sign behind NOT, and where AND, OR and
        /// XOR combine an integer that has none with one of no more bits that has one.
        OfOperator = "of-operator",
    }
}

words! {
    /// The type of an operation on constants.
    ConstantTypes {
        /// The type of the operands.
        OfOperands = "of-operands",
        /// The least type, with the sign of the operands, that holds its number: `30000 + 10000` is a DINT, and no INT.
        Least = "least",
    }
}

words! {
    /// The bits of the count by which SHL and SHR shift.
    ShiftCounts {
        /// All bits of the count: a count of the width or more leaves no bit.
        All = "all-bits",
        /// The lowest five bits of the count, and the lowest six where 64 bits are shifted: a DWORD shifted by 32 stays as it is.
        ///
        /// Basis: codesys-recording: recordings/codesys.run.json (`bit_shl_…`, `shift_…`).
        LowBits = "low-bits",
    }
}

choices_of_words! { ImplicitWarnings, OperandTypes, ComparedTypes, ResultSigns, ConstantTypes, ShiftCounts, }
