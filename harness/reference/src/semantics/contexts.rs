//! Decides whether a value may stand where a type is expected, and where a literal without a type may.

use super::inferred::Inferred;
use super::pointer_types::{addresses_are_numbers, fits_pointer};
use super::types::{TypeId, TypeKind, TypeTable};
use crate::conversion::{implicit, of_operand};
use stickler_types::{Code, Dialect, ElementaryType};

/// The place in a program where a value stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ValueContext {
    /// The right side of `:=` in a statement.
    Assignment,
    /// The right side of `:=` in a statement, where it is nothing but a call.
    CallResult,
    /// An initial value, an array element or a structure element in one.
    Initializer,
    /// The argument of a function, a function block or a conversion.
    Argument,
    /// One of several arguments of a standard function that have a common type.
    CommonArgument,
    /// The target of `=>`.
    Capture,
    /// The condition of IF, WHILE, REPEAT.
    Condition,
    /// A subscript, a bound of FOR.
    Integer,
    /// A label of CASE, which is a constant, so that no conversion can be suggested.
    Label,
    /// An operand, whose operator has already been found to be defined.
    Operand,
}

impl ValueContext {
    /// The code of a value that does not fit here.
    ///
    /// Basis: rule: code-of-the-context.
    pub(super) const fn code(self) -> Code {
        match self {
            ValueContext::Assignment
            | ValueContext::Capture
            | ValueContext::Integer
            | ValueContext::Label => Code::AssignmentTypeMismatch,
            ValueContext::CallResult => Code::FunctionCallReturnTypeMismatch,
            ValueContext::Initializer => Code::InitializerTypeMismatch,
            ValueContext::Argument | ValueContext::CommonArgument => Code::FunctionCallArgTypeMismatch,
            ValueContext::Condition => Code::ConditionTypeInvalid,
            ValueContext::Operand => Code::OperatorOperandTypeMismatch,
        }
    }
}

/// The answer to whether a value fits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Fit {
    /// The value fits, by an implicit conversion where the types differ, or by taking the type that is expected.
    Yes,
    /// The value does not fit.
    No,
    /// Something has been said already, about the value or about the type that is expected.
    Silent,
}

/// Returns whether a value may stand where `target` is expected, `target` being a value's type.
///
/// For elementary types the rule is [`implicit`]. Structures and arrays convert to nothing but themselves, and so do enumerations
/// that do not count as numbers.
pub(super) fn fit(
    value: Inferred,
    target: TypeId,
    context: ValueContext,
    types: &TypeTable,
    dialect: &Dialect,
) -> Fit {
    if target == TypeId::ERROR {
        return Fit::Silent;
    }
    let elementary = target.elementary();
    let fits = match value {
        Inferred::Error | Inferred::Pending => return Fit::Silent,
        // Its reading is what is wrong.
        Inferred::Known(ty) if types.is_variable_length(ty) => return Fit::Silent,
        Inferred::Nothing => false,
        Inferred::Known(ty) if ty == target || types.is_same(ty, target) => true,
        Inferred::Known(ty) if types.is_interface(target) => {
            // NULL refers to no instance.
            types.derives(ty, target) || ty == TypeId::ADDRESS
        }
        Inferred::Known(ty) if types.pointer(ty).or(types.pointer(target)).is_some() => {
            fits_pointer(ty, target, types, dialect)
        }
        Inferred::Integer(_) if types.pointer(target).is_some() => addresses_are_numbers(dialect),
        Inferred::Known(ty) => match (elementary_value(ty, types, dialect), elementary) {
            (Some(from), Some(to)) => match context {
                ValueContext::Operand | ValueContext::CommonArgument => of_operand(from, to, dialect),
                _ => implicit(from, to, dialect),
            }
            .is_some(),
            _ => false,
        },
        Inferred::Integer(_) => elementary.is_some_and(|ty| integer_fits(ty, context, dialect)),
        Inferred::Real => elementary.is_some_and(|ty| {
            // An operand's type is that of the other one, and a real literal is no integer there.
            let is_operand = matches!(context, ValueContext::Operand | ValueContext::CommonArgument);
            ty.is_real() || (dialect.real_literal_as_integer && ty.is_integer() && !is_operand)
        }),
        Inferred::Text { wide, single } => match elementary {
            Some(ElementaryType::String) => !wide,
            Some(ElementaryType::Wstring) => wide,
            Some(ElementaryType::Char) => single && !wide,
            Some(ElementaryType::Wchar) => single && wide,
            _ => false,
        },
        Inferred::Enumerated => match types.kind(target) {
            TypeKind::Enumeration(_) => true,
            // Without an enumeration around it the name is ambiguous, and that is what is to be said.
            _ => return Fit::Silent,
        },
    };
    if fits { Fit::Yes } else { Fit::No }
}

/// Returns the elementary type as which a value of a type may convert: its own, INT for a value of an enumeration that counts as a number, or
/// LWORD for an address that does.
pub(super) fn elementary_value(ty: TypeId, types: &TypeTable, dialect: &Dialect) -> Option<ElementaryType> {
    let counts = dialect.enumerations_as_integers && matches!(types.kind(ty), TypeKind::Enumeration(_));
    let is_address = || types.pointer(ty).is_some() && addresses_are_numbers(dialect);
    ty.elementary()
        .or(counts.then_some(ElementaryType::Int))
        .or_else(|| is_address().then_some(ElementaryType::Lword))
}

/// Returns whether an untyped integer literal may stand for a value of a type. Whether its number fits is looked at
/// when the literal is read. Whether it may be a bit string is up to the dialect but for initial values and operands.
///
/// Basis: rule: literal-as-operand.
fn integer_fits(ty: ElementaryType, context: ValueContext, dialect: &Dialect) -> bool {
    use ValueContext::{CommonArgument, Initializer, Operand};
    if ty.is_real() {
        dialect.integer_literal_as_real
    } else if ty.is_bit_string() {
        dialect.integer_literal_as_bit_string || matches!(context, Initializer | Operand | CommonArgument)
    } else {
        ty.is_integer() || ty == ElementaryType::Bool
    }
}
