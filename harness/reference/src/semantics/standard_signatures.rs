//! The table of the standard functions that are no conversions: what each computes, and of which inputs.
//!
//! Basis: iec-61131-3: Tables 28 to 39.

use super::parameters::ParameterList;
use crate::instruction::{RealFunction, StandardFunction, TextPart};
use std::fmt::{Debug, Formatter, Result};
use stickler_syntax::tree::{BinaryOperator, UnaryOperator};
use stickler_types::dialect::TextPositions;
use stickler_types::{ElementaryType, GenericType};

/// A standard function.
pub(super) struct StandardSignature {
    /// The name in capital letters.
    pub(super) name: &'static str,
    pub(super) operation: StandardOperation,
    pub(super) parameters: ParameterList,
}

/// The computation of a standard function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum StandardOperation {
    /// One that the machine knows, of inputs whose common type is of a generic type.
    Function(StandardFunction, GenericType),
    /// The operation of an infix operator, done between each input and the one before it. The types that it takes are those of the
    /// operator.
    Operator(BinaryOperator),
    /// The operation of a prefix operator.
    Prefix(UnaryOperator),
    /// The operation of an infix operator on a duration of the type and a number.
    Scaled(BinaryOperator, ElementaryType),
    /// A moment of the type, of the numbers that it consists of.
    Compose(ElementaryType),
    /// None: the result is the input.
    Move,
    /// None: the result is the number of nanoseconds by which a moment is stored. For the functions that are written in `library`.
    Nanoseconds,
}

/// The types that an input of a standard function takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum StandardInput {
    /// A value of the type that all such inputs have in common.
    Common,
    /// A BOOL.
    Gate,
    /// An integer of any type: a selector, a number of places, a length or a position.
    Integer,
}

const ONE: ParameterList = ParameterList::exactly(&["IN"]);
const TWO: ParameterList = ParameterList::exactly(&["IN1", "IN2"]);
const SEVERAL: ParameterList = ParameterList {
    fixed: &[],
    more: Some(("IN", 1)),
    least: 2,
};
const CHOSEN: ParameterList = ParameterList {
    fixed: &["K"],
    more: Some(("IN", 0)),
    least: 2,
};
const GATED: ParameterList = ParameterList::exactly(&["G", "IN0", "IN1"]);
const LIMITED: ParameterList = ParameterList::exactly(&["MN", "IN", "MX"]);
const POINT: ParameterList = ParameterList::exactly(&["Y", "X"]);
const COUNTED: ParameterList = ParameterList::exactly(&["IN", "N"]);
const LENGTH: ParameterList = ParameterList::exactly(&["IN", "L"]);
const RANGE: ParameterList = ParameterList::exactly(&["IN", "L", "P"]);
const TWO_AND_POSITION: ParameterList = ParameterList::exactly(&["IN1", "IN2", "P"]);
const TWO_AND_RANGE: ParameterList = ParameterList::exactly(&["IN1", "IN2", "L", "P"]);
const DATE_FIELDS: ParameterList = ParameterList::exactly(&["YEAR", "MONTH", "DAY"]);
const TIME_FIELDS: ParameterList = ParameterList::exactly(&["HOUR", "MINUTE", "SECOND", "MILLISECOND"]);
const DATE_AND_TIME_FIELDS: ParameterList =
    ParameterList::exactly(&["YEAR", "MONTH", "DAY", "HOUR", "MINUTE", "SECOND", "MILLISECOND"]);

/// All standard functions that are no conversions, but for those that are written in Structured Text in `library`.
pub(super) static STANDARD_FUNCTIONS: [StandardSignature; 66] = {
    use BinaryOperator as Operator;
    use ElementaryType::{Date, Dt, Ldate, Ldt, Ltime, Ltod, Time, Tod};
    use GenericType::{Any, Bit, Elementary, Num, Real, String};
    use StandardFunction as Function;
    [
        function("ABS", Function::Abs, Num, ONE),
        real("SQRT", RealFunction::SquareRoot, ONE),
        real("LN", RealFunction::NaturalLogarithm, ONE),
        real("LOG", RealFunction::Logarithm, ONE),
        real("EXP", RealFunction::Exponential, ONE),
        real("SIN", RealFunction::Sine, ONE),
        real("COS", RealFunction::Cosine, ONE),
        real("TAN", RealFunction::Tangent, ONE),
        real("ASIN", RealFunction::ArcSine, ONE),
        real("ACOS", RealFunction::ArcCosine, ONE),
        real("ATAN", RealFunction::ArcTangent, ONE),
        real("ATAN2", RealFunction::ArcTangent2, POINT),
        operator(Operator::Add, SEVERAL),
        operator(Operator::Multiply, SEVERAL),
        operator(Operator::Subtract, TWO),
        operator(Operator::Divide, TWO),
        operator(Operator::Modulo, TWO),
        operator(Operator::Power, TWO),
        row("MOVE", StandardOperation::Move, ONE),
        function("SHL", Function::Shl, Bit, COUNTED),
        function("SHR", Function::Shr, Bit, COUNTED),
        function("ROL", Function::Rol, Bit, COUNTED),
        function("ROR", Function::Ror, Bit, COUNTED),
        operator(Operator::And, SEVERAL),
        operator(Operator::Or, SEVERAL),
        operator(Operator::Xor, SEVERAL),
        row("NOT", StandardOperation::Prefix(UnaryOperator::Not), ONE),
        function("SEL", Function::Sel, Any, GATED),
        function("MUX", Function::Mux, Any, CHOSEN),
        function("MIN", Function::Min, Elementary, SEVERAL),
        function("MAX", Function::Max, Elementary, SEVERAL),
        function("LIMIT", Function::Limit, Elementary, LIMITED),
        operator(Operator::Greater, SEVERAL),
        operator(Operator::GreaterOrEqual, SEVERAL),
        operator(Operator::Equal, SEVERAL),
        operator(Operator::LessOrEqual, SEVERAL),
        operator(Operator::Less, SEVERAL),
        operator(Operator::NotEqual, TWO),
        function("LEN", Function::Len, String, ONE),
        function("CONCAT", Function::Concat, String, SEVERAL),
        text("LEFT", TextPart::Left, LENGTH),
        text("RIGHT", TextPart::Right, LENGTH),
        text("MID", TextPart::Mid, RANGE),
        text("INSERT", TextPart::Insert, TWO_AND_POSITION),
        text("DELETE", TextPart::Delete, RANGE),
        text("REPLACE", TextPart::Replace, TWO_AND_RANGE),
        function("FIND", Function::Find, String, TWO),
        scaled("MULTIME", Operator::Multiply, Time),
        scaled("MUL_TIME", Operator::Multiply, Time),
        scaled("MUL_LTIME", Operator::Multiply, Ltime),
        scaled("DIVTIME", Operator::Divide, Time),
        scaled("DIV_TIME", Operator::Divide, Time),
        scaled("DIV_LTIME", Operator::Divide, Ltime),
        composed("CONCAT_DATE", Date, DATE_FIELDS),
        composed("CONCAT_LDATE", Ldate, DATE_FIELDS),
        composed("CONCAT_TOD", Tod, TIME_FIELDS),
        composed("CONCAT_LTOD", Ltod, TIME_FIELDS),
        composed("CONCAT_DT", Dt, DATE_AND_TIME_FIELDS),
        composed("CONCAT_LDT", Ldt, DATE_AND_TIME_FIELDS),
        function("TO_BIG_ENDIAN", Function::SwapBytes, Bit, ONE),
        function("FROM_BIG_ENDIAN", Function::SwapBytes, Bit, ONE),
        row("TO_LITTLE_ENDIAN", StandardOperation::Move, ONE),
        row("FROM_LITTLE_ENDIAN", StandardOperation::Move, ONE),
        function("IS_VALID", Function::IsValid, Real, ONE),
        function("IS_VALID_BCD", Function::IsValidBcd, Bit, ONE),
        row("STICKLER_NANOSECONDS", StandardOperation::Nanoseconds, ONE),
    ]
};

const fn row(
    name: &'static str,
    operation: StandardOperation,
    parameters: ParameterList,
) -> StandardSignature {
    StandardSignature {
        name,
        operation,
        parameters,
    }
}

const fn function(
    name: &'static str,
    function: StandardFunction,
    of: GenericType,
    parameters: ParameterList,
) -> StandardSignature {
    row(name, StandardOperation::Function(function, of), parameters)
}

const fn real(name: &'static str, of: RealFunction, parameters: ParameterList) -> StandardSignature {
    function(name, StandardFunction::Real(of), GenericType::Real, parameters)
}

const fn text(name: &'static str, part: TextPart, parameters: ParameterList) -> StandardSignature {
    let part = StandardFunction::Part(part, TextPositions::Clipped);
    function(name, part, GenericType::String, parameters)
}

const fn scaled(name: &'static str, operator: BinaryOperator, duration: ElementaryType) -> StandardSignature {
    row(name, StandardOperation::Scaled(operator, duration), TWO)
}

const fn composed(name: &'static str, of: ElementaryType, parameters: ParameterList) -> StandardSignature {
    row(name, StandardOperation::Compose(of), parameters)
}

const fn operator(operator: BinaryOperator, parameters: ParameterList) -> StandardSignature {
    let operation = StandardOperation::Operator(operator);
    row(operator.function_name(), operation, parameters)
}

/// Finds the standard function of a name.
pub(super) fn standard_function(name: &str) -> Option<&'static StandardSignature> {
    let longest = "STICKLER_NANOSECONDS".len();
    if !(2..=longest).contains(&name.len()) {
        return None;
    }
    STANDARD_FUNCTIONS
        .iter()
        .find(|function| function.name.eq_ignore_ascii_case(name))
}

/// Returns a number that grows with the place of an input of a standard function, by its name in any case. Of a function that is written in
/// Structured Text it is the number in the name, such as that of `IN1`. `None` where there is no such input.
pub fn place_of_input(function: &str, input: &str) -> Option<usize> {
    match standard_function(function) {
        Some(known) => known.parameters.position(input),
        None => input.to_ascii_uppercase().strip_prefix("IN")?.parse().ok(),
    }
}

/// Returns what the machine computes for a standard function of one operand; `None` for other functions.
pub(crate) fn unary_function(name: &str) -> Option<StandardFunction> {
    match standard_function(name)?.operation {
        StandardOperation::Function(function, _) => Some(function),
        _ => None,
    }
}

impl StandardSignature {
    /// Returns what the input at a position takes, of which its name tells.
    pub(super) fn input(&self, position: usize) -> StandardInput {
        match self.parameters.fixed.get(position) {
            Some(&"G") => StandardInput::Gate,
            Some(&("K" | "N" | "L" | "P")) => StandardInput::Integer,
            _ => StandardInput::Common,
        }
    }

    /// Returns the arguments whose types meet, of all in their order.
    pub(super) fn common<T: Copy>(&self, arguments: &[T]) -> Vec<T> {
        let all = arguments.iter().enumerate();
        all.filter(|&(position, _)| self.input(position) == StandardInput::Common)
            .map(|(_, &argument)| argument)
            .collect()
    }
}

impl Debug for StandardSignature {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        formatter.write_str(self.name)
    }
}
