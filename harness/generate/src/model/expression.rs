//! The expressions of a program of the model, and the places that it reads and writes.

use super::{Type, VariableId};
use stickler_exact::Signature;
use stickler_types::{ElementaryType, Value, words};

/// An expression with its type.
#[derive(Clone, PartialEq, Debug)]
pub struct Expression {
    /// The type of the value, after every implicit conversion.
    pub ty: Type,
    /// The form of the expression, with its operands.
    pub kind: ExpressionKind,
}

impl Expression {
    /// Creates an expression of any type.
    pub const fn new(ty: Type, kind: ExpressionKind) -> Expression {
        Expression { ty, kind }
    }

    /// Creates an expression of an elementary type.
    pub const fn elementary(ty: ElementaryType, kind: ExpressionKind) -> Expression {
        Expression::new(Type::Elementary(ty), kind)
    }

    /// Creates a literal of an elementary type.
    pub const fn literal(ty: ElementaryType, value: Value, form: LiteralForm) -> Expression {
        Expression::elementary(ty, ExpressionKind::Literal(value, form))
    }

    /// Creates the value of a variable, or of a part of one.
    pub fn read(place: Place) -> Expression {
        Expression::new(place.ty.clone(), ExpressionKind::Read(place))
    }

    /// Creates an operation with one operand.
    pub fn unary(operator: UnaryOperator, operand: Expression) -> Expression {
        Expression::new(
            operand.ty.clone(),
            ExpressionKind::Unary(operator, Box::new(operand)),
        )
    }

    /// Creates an implicit conversion.
    pub fn widened(ty: Type, operand: Expression) -> Expression {
        Expression::new(ty, ExpressionKind::Widen(Box::new(operand)))
    }

    /// Creates a value of an enumeration.
    pub fn enumerated(ty: &Type, value: usize) -> Expression {
        Expression::new(ty.clone(), ExpressionKind::Enumerated(value))
    }

    /// Creates a call of a standard function whose result has an elementary type.
    pub const fn standard(function: StandardFunction, arguments: Vec<Self>, result: ElementaryType) -> Self {
        Expression::elementary(result, ExpressionKind::Standard(function, arguments))
    }

    /// Creates an operation with two operands whose result has an elementary type.
    pub fn binary(operator: BinaryOperator, left: Self, right: Self, result: ElementaryType) -> Self {
        let kind = ExpressionKind::Binary(operator, Box::new(left), Box::new(right));
        Expression::elementary(result, kind)
    }
}

/// The forms of an expression.
#[derive(Clone, PartialEq, Debug)]
pub enum ExpressionKind {
    /// A literal of an elementary type.
    Literal(Value, LiteralForm),
    /// An enumerated value: its index in the list of values of its type ([`Expression::ty`] is [`Type::Declared`]).
    Enumerated(usize),
    /// The value of a variable, an element or a field.
    Read(Place),
    /// A bit of an integer or bit string, as BOOL; written `.n` or `.%Xn`.
    Bit(Place, u32),
    /// A reference to a place: `REF(place)`.
    Reference(Place),
    /// An operator with one operand of the same type.
    Unary(UnaryOperator, Box<Expression>),
    /// An operator with two operands of one type; a comparison gives BOOL, any other operator that same type (except for
    /// durations and dates, which the generator uses only in comparisons and in sums of two durations).
    Binary(BinaryOperator, Box<Expression>, Box<Expression>),
    /// An implicit conversion, granted by the documents of the dialect, from the elementary type of the operand to
    /// [`Expression::ty`].
    Widen(Box<Expression>),
    /// A call of a type conversion function; the result of the signature is the type of this expression.
    Convert(Signature, Box<Expression>),
    /// A call of a function of the program, by its index, with an argument for each input; an input without an argument has
    /// its initial value.
    Call(usize, Vec<Argument>),
    /// A call of a standard function with positional arguments.
    Standard(StandardFunction, Vec<Expression>),
    /// Text that stands for an expression of this type and breaks a rule on purpose; the evaluator refuses it.
    Raw(String),
}

/// The spelling of a literal: with or without the prefix of its type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LiteralForm {
    /// `INT#5`, `REAL#0.5`, `TIME#5ms`.
    Typed,
    /// `5`, `0.5`, `TRUE`, `T#5ms`: only where the context determines the type.
    Untyped,
}

/// An argument in a call.
#[derive(Clone, PartialEq, Debug)]
pub struct Argument {
    /// The parameter that takes the argument.
    pub parameter: VariableId,
    /// The value of the argument, of the type of the parameter.
    pub value: Expression,
}

/// A variable, or a part of one: an element, a field or an output.
#[derive(Clone, PartialEq, Debug)]
pub struct Place {
    /// The variable, in the POU that contains the place.
    pub variable: VariableId,
    /// The selectors that lead from the variable to the part, outermost first.
    pub path: Vec<PlaceSelector>,
    /// The type of the selected part.
    pub ty: Type,
}

impl Place {
    /// Creates the place of a whole variable.
    pub const fn whole(variable: VariableId, ty: Type) -> Place {
        Place {
            variable,
            path: Vec::new(),
            ty,
        }
    }
}

/// A selection of a part of a variable.
#[derive(Clone, PartialEq, Debug)]
pub enum PlaceSelector {
    /// `[i, j]`, one subscript a dimension, each of an integer type.
    Index(Vec<Expression>),
    /// `.field` of a structure, by the index of the field.
    Field(usize),
    /// `.output` of a function block instance.
    Output(VariableId),
    /// `^`, behind a reference: the place that it leads to.
    Followed,
}

/// Prefix operators.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnaryOperator {
    /// `-`, of signed integers, reals and durations.
    Negate,
    /// `NOT`, of BOOL and bit strings.
    Not,
}

words! {
    /// Infix operators.
    BinaryOperator spelled {
        Add = "+", Subtract = "-", Multiply = "*", Divide = "/", Modulo = "MOD", And = "AND", Or = "OR", Xor = "XOR",
        Equal = "=", NotEqual = "<>", Less = "<", LessOrEqual = "<=", Greater = ">", GreaterOrEqual = ">=",
    }
}

impl BinaryOperator {
    /// Returns whether the operator compares its operands.
    pub const fn is_comparison(self) -> bool {
        use BinaryOperator as B;
        matches!(
            self,
            B::Equal | B::NotEqual | B::Less | B::LessOrEqual | B::Greater | B::GreaterOrEqual
        )
    }
}

words! {
    /// Standard functions other than conversions.
    StandardFunction {
        /// `ABS(IN)`
        Abs = "ABS",
        /// `SEL(G, IN0, IN1)`
        Sel = "SEL",
        /// `MUX(K, IN0, …)`
        Mux = "MUX",
        /// `MIN(IN1, IN2)`
        Min = "MIN",
        /// `MAX(IN1, IN2)`
        Max = "MAX",
        /// `LIMIT(MN, IN, MX)`
        Limit = "LIMIT",
        /// `SHL(IN, N)`
        Shl = "SHL",
        /// `SHR(IN, N)`
        Shr = "SHR",
        /// `ROL(IN, N)`
        Rol = "ROL",
        /// `ROR(IN, N)`
        Ror = "ROR",
        /// `LEN(IN)`
        Len = "LEN",
        /// `CONCAT(IN1, IN2)`
        Concat = "CONCAT",
        /// `LEFT(IN, L)`
        Left = "LEFT",
        /// `RIGHT(IN, L)`
        Right = "RIGHT",
        /// `FIND(IN1, IN2)`
        Find = "FIND",
        /// `SQRT(IN)`
        SquareRoot = "SQRT",
    }
}
