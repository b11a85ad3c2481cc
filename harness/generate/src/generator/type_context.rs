//! The places in which an expression gets its type in different ways.

/// The way in which the place of an expression determines its type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum TypeContext {
    /// An operand of something that takes several types: the text alone must determine the type.
    Exact,
    /// The other operand of an operator whose first operand determines the type.
    Operand,
    /// The right side of an assignment.
    Assigned,
    /// An argument of a parameter.
    Argument,
    /// An initial value.
    Initial,
}
