//! The signature of a conversion: the function's name, its types, and its operation; and the pairs of types that have one.

use std::fmt;
use stickler_types::{ConversionChoices, ElementaryType, Family, Rounding, Value, join};

/// One conversion function together with the types of its arguments and of its result.
///
/// A name that takes or gives several types has one signature for each combination: `BCD_TO_INT` has four.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Signature {
    /// The function's name in upper case.
    pub function: String,
    /// The types of the arguments in their order: two for `CONCAT_…`, one for all others.
    pub operands: Vec<ElementaryType>,
    /// The type of the result.
    pub result: ElementaryType,
    /// The operation of the function.
    pub operation: Operation,
}

impl Signature {
    /// Returns whether the operands are of the types of the signature, in their order.
    pub fn takes(&self, operands: &[Value]) -> bool {
        let types = operands.iter().map(Value::elementary);
        types.eq(self.operands.iter().map(|&ty| Some(ty)))
    }
}

/// Writes the function with its types, as recordings and pages name it: `REAL_TO_INT(REAL) : INT`.
impl fmt::Display for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let operands = join(self.operands.iter().map(|ty| ty.name()), ", ");
        write!(f, "{}({operands}) : {}", self.function, self.result)
    }
}

/// The operation of a conversion function.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Operation {
    /// The value in the other type, by the rule for the pair of types: `<SRC>_TO_<DST>`, `TO_<DST>`.
    Convert,
    /// The integer next to a real number toward zero: `TRUNC` and its kin.
    Truncate,
    /// The integer nearest to a real number, ties to even: `ROUND`.
    Round,
    /// The least integer not below a real number: `CEIL`, `CEILING`.
    Ceiling,
    /// The greatest integer not above a real number: `FLOOR`.
    Floor,
    /// The number that binary-coded decimal digits spell.
    FromBcd,
    /// A number as binary-coded decimal digits.
    ToBcd,
    /// A date and a time of day as one moment: `CONCAT_DATE_TOD` and its kin.
    Concatenate,
    /// A standard function of one operand: ABS, NOT, LEN, SQRT and the other functions of real numbers.
    Elementary,
}

impl Operation {
    /// Returns the choices by which the operation converts: those of the dialect, but for the rounding and the range of a
    /// function that has its own.
    pub(crate) const fn choices(self, choices: &ConversionChoices) -> ConversionChoices {
        match self {
            Operation::Convert
            | Operation::FromBcd
            | Operation::ToBcd
            | Operation::Concatenate
            | Operation::Elementary => *choices,
            Operation::Round => choices.with_rounding(Rounding::HalfToEven),
            Operation::Ceiling => choices.with_rounding(Rounding::Up),
            Operation::Floor => choices.with_rounding(Rounding::Down),
            Operation::Truncate => choices.of_truncation(),
        }
    }
}

/// Returns whether a value of one type has a meaning in the other; a type has one in itself.
///
/// Numbers in this table are integers, bit strings, reals and BOOL.
///
/// | from | to |
/// |---|---|
/// | a number, a duration, a date, a time of day, both together | all of these |
/// | a character | integers, bit strings, characters; and these convert to characters |
/// | a text | everything; and everything to a text |
///
/// Basis: ironplc-type-conversions: Explicit Conversion Functions ("for all type pairs"), as far as a pair makes sense;
/// forgeiec-conversion-functions: The naming pattern; codesys-recording: fixtures/conversions/explicit-pairs.ts.
pub(crate) const fn has_meaning(from: ElementaryType, to: ElementaryType) -> bool {
    use Family::{Character, Text};
    match (from.family(), to.family()) {
        (Text, _) | (_, Text) | (Character, Character) => true,
        (Character, _) => to.is_whole(),
        (_, Character) => from.is_whole(),
        _ => true,
    }
}
