//! Expressions.

use super::{ExpressionId, Initializer, Literal, Name, Prefixed};
use crate::source::Span;
use stickler_types::{ElementaryType, words};

/// An expression. Equality ignores the span: see `equality.rs`.
#[derive(Debug)]
pub struct Expression<'s> {
    /// The form.
    pub kind: ExpressionKind<'s>,
    /// From its first token to its last.
    pub span: Span,
}

impl Expression<'_> {
    /// Returns the operator and both operands of an infix operator; `None` for any other expression.
    pub const fn binary(&self) -> Option<(BinaryOperator, ExpressionId, ExpressionId)> {
        match self.kind {
            ExpressionKind::Binary {
                operator,
                left,
                right,
            } => Some((operator, left, right)),
            _ => None,
        }
    }
}

/// The forms of an expression.
#[derive(PartialEq, Debug)]
pub enum ExpressionKind<'s> {
    /// A literal.
    Literal(Literal<'s>),
    /// A variable, an enumerated value or (as a callee) a function.
    Name(Name<'s>),
    /// `TYPE#VALUE` where TYPE is not elementary: an enumerated value.
    EnumeratedValue(Prefixed<'s>),
    /// `base.field`.
    Field {
        /// The structure or function block.
        base: ExpressionId,
        /// The element.
        field: Name<'s>,
    },
    /// `base[i, j]`.
    Index {
        /// The array.
        base: ExpressionId,
        /// The subscripts.
        subscripts: Vec<ExpressionId>,
    },
    /// `base^`: what a reference or pointer leads to.
    Dereference {
        /// The reference or pointer.
        base: ExpressionId,
    },
    /// `base.3` or `base.%X3`, where the dialect has that form.
    Bit {
        /// The variable.
        base: ExpressionId,
        /// The index as written; `u64::MAX` stands for anything larger.
        index: u64,
    },
    /// `base.%B3`, `base.%W3` or `base.%D3`, where the dialect has that form.
    Part {
        /// The variable.
        base: ExpressionId,
        /// The type of the part: BYTE, WORD or DWORD.
        part: ElementaryType,
        /// The index as written; `u64::MAX` stands for anything larger.
        index: u64,
    },
    /// A call of a function, a function block, or of a name that is neither, such as `TIME()`.
    Call {
        /// The function or instance that is called.
        callee: ExpressionId,
        /// The arguments.
        arguments: Vec<Argument<'s>>,
    },
    /// A prefix operator.
    Unary {
        /// The operator.
        operator: UnaryOperator,
        /// The operand.
        operand: ExpressionId,
    },
    /// An infix operator.
    Binary {
        /// The operator.
        operator: BinaryOperator,
        /// The left operand.
        left: ExpressionId,
        /// The right operand.
        right: ExpressionId,
    },
    /// `target := value` as a value: in parentheses, and behind `:=`.
    Assigned {
        /// The variable written, whose value the expression has then.
        target: ExpressionId,
        /// The value.
        value: ExpressionId,
    },
    /// `(inner)`.
    Parenthesized(ExpressionId),
    /// `[1, 2]` or `(x := 1)` as a value.
    Aggregate(Box<Initializer<'s>>),
    /// An expression that could not be read; a diagnostic has been given, and nothing more is said about it.
    Error,
}

/// An argument of a call.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Argument<'s> {
    /// `value`.
    Positional(ExpressionId),
    /// `name := value`.
    Named {
        /// The parameter.
        name: Name<'s>,
        /// The value.
        value: ExpressionId,
    },
    /// `name => target` or `NOT name => target`.
    Output {
        /// The output parameter.
        name: Name<'s>,
        /// Whether NOT stands before the name.
        negated: bool,
        /// The variable that takes it.
        target: ExpressionId,
    },
}

words! {
    /// Prefix operators.
    UnaryOperator spelled { Negate = "-", Plus = "+", Not = "NOT", }
}

words! {
    /// Infix operators, loosest first, as in Table 71 of IEC 61131-3, third edition; those of equal precedence stand together. `&` is another
    /// spelling of AND.
    BinaryOperator spelled {
        Or = "OR", OrElse = "OR_ELSE", Xor = "XOR", And = "AND", AndThen = "AND_THEN",
        Equal = "=", NotEqual = "<>", Less = "<", Greater = ">", LessOrEqual = "<=", GreaterOrEqual = ">=",
        Add = "+", Subtract = "-", Multiply = "*", Divide = "/", Modulo = "MOD", Power = "**",
    }
}

impl BinaryOperator {
    /// The name of the standard function that computes the same, as in `ADD(a, b)`.
    ///
    /// Basis: iec-61131-3: Tables 29, 31 and 33.
    pub const fn function_name(self) -> &'static str {
        match self {
            BinaryOperator::Equal => "EQ",
            BinaryOperator::NotEqual => "NE",
            BinaryOperator::Less => "LT",
            BinaryOperator::Greater => "GT",
            BinaryOperator::LessOrEqual => "LE",
            BinaryOperator::GreaterOrEqual => "GE",
            BinaryOperator::Add => "ADD",
            BinaryOperator::Subtract => "SUB",
            BinaryOperator::Multiply => "MUL",
            BinaryOperator::Divide => "DIV",
            BinaryOperator::Power => "EXPT",
            operator => operator.as_str(),
        }
    }
}
