//! The syntax tree: what the parser builds, the checker reads and the renderer writes back.
//!
//! Expressions live in one arena and are named by [`ExpressionId`], so that a chain of a million operators
//! can be built, walked along its left spine and dropped without recursion. Everything else nests no deeper
//! than the parser's nesting limit.

use crate::source::Span;

/// The name of an expression in [`SourceUnit::expressions`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ExpressionId(pub u32);

/// A whole source text.
#[derive(Debug, Default)]
pub struct SourceUnit<'s> {
    /// Declarations in the order of the text.
    pub declarations: Vec<Declaration<'s>>,
    /// Every expression of the unit; an expression's operands stand before it.
    pub expressions: Vec<Expression<'s>>,
}

/// An identifier as written; identifiers compare without regard to ASCII case (6.1.2 of the standard).
#[derive(Clone, Copy, Debug)]
pub struct Name<'s> {
    /// The identifier as written.
    pub text: &'s str,
    /// Where it stands.
    pub span: Span,
}

/// A declaration at the top level of a source text.
#[derive(Debug)]
pub enum Declaration<'s> {
    /// PROGRAM, FUNCTION or FUNCTION_BLOCK.
    Pou(Pou<'s>),
    /// TYPE … END_TYPE.
    Types(Vec<TypeDeclaration<'s>>),
    /// VAR_GLOBAL … END_VAR outside a configuration.
    Globals(VariableBlock<'s>),
    /// CONFIGURATION … END_CONFIGURATION.
    Configuration(Configuration<'s>),
}

/// The kind of a program organization unit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PouKind {
    /// PROGRAM.
    Program,
    /// FUNCTION.
    Function,
    /// FUNCTION_BLOCK.
    FunctionBlock,
}

/// A program organization unit.
#[derive(Debug)]
pub struct Pou<'s> {
    /// PROGRAM, FUNCTION or FUNCTION_BLOCK.
    pub kind: PouKind,
    /// Its name.
    pub name: Name<'s>,
    /// The result type of a function; `None` for other kinds, and for a function without a result.
    pub result: Option<TypeSpecification<'s>>,
    /// The variable sections.
    pub blocks: Vec<VariableBlock<'s>>,
    /// The statements.
    pub body: Vec<Statement>,
    /// From the first keyword to the last.
    pub span: Span,
    /// The closing keyword.
    pub end: Span,
}

/// Which section a variable is declared in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VariableKind {
    /// VAR.
    Local,
    /// VAR_TEMP.
    Temporary,
    /// VAR_INPUT.
    Input,
    /// VAR_OUTPUT.
    Output,
    /// VAR_IN_OUT.
    InOut,
    /// VAR_EXTERNAL.
    External,
    /// VAR_GLOBAL.
    Global,
}

/// One variable section, VAR … END_VAR.
#[derive(Debug)]
pub struct VariableBlock<'s> {
    /// Which section it is.
    pub kind: VariableKind,
    /// CONSTANT stands behind the section's keyword.
    pub constant: bool,
    /// RETAIN or NON_RETAIN as written; it has no effect on a run, and is kept for the renderer.
    pub retention: Option<&'s str>,
    /// The declarations.
    pub groups: Vec<VariableGroup<'s>>,
    /// From VAR… to END_VAR.
    pub span: Span,
}

/// `a, b : TYPE := initializer;`: also the fields of a structure.
#[derive(Debug)]
pub struct VariableGroup<'s> {
    /// The names declared.
    pub names: Vec<Name<'s>>,
    /// Their common type.
    pub specification: TypeSpecification<'s>,
    /// Their common initial value.
    pub initializer: Option<Initializer<'s>>,
}

/// `name : specification := initializer;` in TYPE … END_TYPE.
#[derive(Debug)]
pub struct TypeDeclaration<'s> {
    /// The new type's name.
    pub name: Name<'s>,
    /// What it stands for.
    pub specification: TypeSpecification<'s>,
    /// The default initial value.
    pub initializer: Option<Initializer<'s>>,
}

/// A type as written in a declaration.
#[derive(Debug)]
pub struct TypeSpecification<'s> {
    /// What is written.
    pub kind: TypeSpecificationKind<'s>,
    /// Where it stands.
    pub span: Span,
}

/// The forms of a type in a declaration.
#[derive(Debug)]
pub enum TypeSpecificationKind<'s> {
    /// An elementary or declared type's name, STRING and WSTRING without a length among them.
    Named(Name<'s>),
    /// `STRING[n]` or `WSTRING[n]`.
    Text {
        /// The keyword.
        name: Name<'s>,
        /// The maximum length.
        length: ExpressionId,
    },
    /// `INT(low..high)`.
    Subrange {
        /// The base type.
        base: Name<'s>,
        /// The lower and the upper limit.
        limits: (ExpressionId, ExpressionId),
    },
    /// `ARRAY[low..high, …] OF element`.
    Array {
        /// The limits of each dimension.
        dimensions: Vec<(ExpressionId, ExpressionId)>,
        /// The elements' type.
        element: Box<TypeSpecification<'s>>,
    },
    /// `(RED, GREEN := 5, BLUE)`, with a base type in front where one is written.
    Enumeration {
        /// `INT` of `INT (RED, GREEN)`.
        base: Option<Name<'s>>,
        /// The values' names and what they are given.
        values: Vec<(Name<'s>, Option<ExpressionId>)>,
    },
    /// `STRUCT … END_STRUCT`.
    Structure(Vec<VariableGroup<'s>>),
    /// Where the text could not be read, or names something that is not implemented; a diagnostic has been
    /// given, and nothing more is said about what is declared with it.
    Error,
}

/// An initial value.
#[derive(Debug)]
pub struct Initializer<'s> {
    /// What is written.
    pub kind: InitializerKind<'s>,
    /// Where it stands.
    pub span: Span,
}

/// The forms of an initial value.
#[derive(Debug)]
pub enum InitializerKind<'s> {
    /// An expression.
    Expression(ExpressionId),
    /// `[1, 2, 3(0)]`.
    Array(Vec<ArrayElement<'s>>),
    /// `(x := 1, y := 2)`.
    Structure(Vec<(Name<'s>, Initializer<'s>)>),
}

/// One entry of an array's initial value.
#[derive(Debug)]
pub struct ArrayElement<'s> {
    /// `3` of `3(0)`.
    pub repetition: Option<ExpressionId>,
    /// The value; `None` for `3()`, which leaves the default.
    pub value: Option<Initializer<'s>>,
}

/// A statement.
#[derive(Debug)]
pub struct Statement {
    /// What it does.
    pub kind: StatementKind,
    /// From its first token to its last, the semicolon left out.
    pub span: Span,
}

/// The statements of ST.
#[derive(Debug)]
pub enum StatementKind {
    /// `target := value`.
    Assignment {
        /// The variable written.
        target: ExpressionId,
        /// The value.
        value: ExpressionId,
    },
    /// A call as a statement: its expression is an [`ExpressionKind::Call`].
    Call(ExpressionId),
    /// IF … ELSIF … ELSE … END_IF.
    If {
        /// Conditions and what they guard.
        branches: Vec<(ExpressionId, Vec<Statement>)>,
        /// The ELSE branch.
        otherwise: Option<Vec<Statement>>,
    },
    /// CASE … OF … END_CASE.
    Case {
        /// The selector.
        selector: ExpressionId,
        /// The branches.
        branches: Vec<CaseBranch>,
        /// The ELSE branch.
        otherwise: Option<Vec<Statement>>,
    },
    /// FOR … END_FOR.
    For {
        /// The control variable.
        control: ExpressionId,
        /// Its first value.
        from: ExpressionId,
        /// Its limit.
        to: ExpressionId,
        /// The increment.
        by: Option<ExpressionId>,
        /// The body.
        body: Vec<Statement>,
    },
    /// WHILE … END_WHILE.
    While {
        /// Tested before each turn.
        condition: ExpressionId,
        /// The body.
        body: Vec<Statement>,
    },
    /// REPEAT … UNTIL … END_REPEAT.
    Repeat {
        /// The body.
        body: Vec<Statement>,
        /// Tested after each turn; true ends the loop.
        until: ExpressionId,
    },
    /// EXIT.
    Exit,
    /// CONTINUE.
    Continue,
    /// RETURN.
    Return,
    /// A lone semicolon.
    Empty,
}

/// One branch of a CASE statement.
#[derive(Debug)]
pub struct CaseBranch {
    /// The labels.
    pub labels: Vec<CaseLabel>,
    /// The statements.
    pub body: Vec<Statement>,
}

/// A label of a CASE branch.
#[derive(Debug)]
pub enum CaseLabel {
    /// `5` or `RED`.
    Value(ExpressionId),
    /// `1..9`.
    Range(ExpressionId, ExpressionId),
}

/// An expression.
#[derive(Debug)]
pub struct Expression<'s> {
    /// What it is.
    pub kind: ExpressionKind<'s>,
    /// From its first token to its last.
    pub span: Span,
}

/// The forms of an expression.
#[derive(Debug)]
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
    /// `base.3`, `base.%X3`, `base.%B1` …
    PartialAccess {
        /// The variable.
        base: ExpressionId,
        /// Which form is written.
        form: PartialAccessForm,
        /// The index as written; `u64::MAX` stands for anything larger.
        index: u64,
        /// The suffix from the point on.
        suffix: Span,
    },
    /// A call of a function, a function block or (as TIME()) anything that looks like one.
    Call {
        /// What is called.
        callee: ExpressionId,
        /// The arguments.
        arguments: Vec<Argument<'s>>,
    },
    /// A prefix operator.
    Unary {
        /// The operator.
        operator: UnaryOperator,
        /// Its operand.
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
    /// `(inner)`.
    Parenthesized(ExpressionId),
    /// Where the text could not be read; a diagnostic has been given, and nothing more is said about it.
    Error,
}

/// The forms of partial access.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PartialAccessForm {
    /// `.n`.
    Short,
    /// `.%Xn`.
    Bit,
    /// `.%Bn`.
    Byte,
    /// `.%Wn`.
    Word,
    /// `.%Dn`.
    DoubleWord,
    /// `.%Ln`.
    LongWord,
}

/// A word with another before its `#`. It is kept as one piece of the source, for expressions are many and must
/// be small.
#[derive(Clone, Copy, Debug)]
pub struct Prefixed<'s> {
    written: &'s str,
    start: u32,
    /// The length of what stands before the `#`.
    prefix: u32,
}

impl<'s> Prefixed<'s> {
    /// What is written as `written` and begins at byte `start`; without a `#` all of it is the prefix.
    pub(super) fn new(written: &'s str, start: u32) -> Prefixed<'s> {
        let prefix = written.find('#').unwrap_or(written.len()) as u32;
        Prefixed {
            written,
            start,
            prefix,
        }
    }

    /// The word before the `#`: `COLOR` of `COLOR#RED`.
    #[must_use]
    pub fn prefix(&self) -> Name<'s> {
        self.piece(0, self.prefix)
    }

    /// What stands behind the `#`: `RED` of `COLOR#RED`.
    #[must_use]
    pub fn value(&self) -> Name<'s> {
        self.piece(self.prefix + 1, self.written.len() as u32)
    }

    fn piece(&self, from: u32, to: u32) -> Name<'s> {
        let text = self.written.get(from as usize..to as usize).unwrap_or_default();
        Name {
            text,
            span: Span {
                start: self.start + from,
                end: self.start + to,
            },
        }
    }
}

/// A literal as written. The text is checked for its form by the lexer; its value is read where its type is
/// known, by `stickler_types::literal`.
#[derive(Clone, Copy, Debug)]
pub struct Literal<'s> {
    /// Which kind of literal it is.
    pub kind: LiteralKind,
    /// The length of what stands before the `#` of a prefix; 0 where there is no prefix.
    prefix: u16,
    start: u32,
    written: &'s str,
}

impl<'s> Literal<'s> {
    /// A literal that begins at byte `start`, with a prefix of that length in front of its `#`, or of length 0.
    pub(super) fn new(kind: LiteralKind, written: &'s str, start: u32, prefix: usize) -> Literal<'s> {
        Literal {
            kind,
            prefix: prefix as u16,
            start,
            written,
        }
    }

    /// The type in front of `#`, where one is written: `INT` of `INT#5`, `T` of `T#1s`.
    #[must_use]
    pub fn prefix(&self) -> Option<Name<'s>> {
        let end = self.start + u32::from(self.prefix);
        let text = self
            .written
            .get(..usize::from(self.prefix))
            .filter(|text| !text.is_empty())?;
        Some(Name {
            text,
            span: Span {
                start: self.start,
                end,
            },
        })
    }

    /// What stands behind the prefix, with a sign where the prefix allows one inside (`INT#-5`).
    #[must_use]
    pub fn text(&self) -> &'s str {
        let from = if self.prefix == 0 {
            0
        } else {
            usize::from(self.prefix) + 1
        };
        self.written.get(from..).unwrap_or_default()
    }
}

/// The kinds of literal, by their form.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LiteralKind {
    /// `42`, `1_000`, and with a typed prefix `-5`.
    Integer,
    /// `16#FF`, `2#1010`, `8#17`.
    BasedInteger,
    /// `1.5`, `1.0E-3`.
    Real,
    /// TRUE or FALSE.
    Boolean,
    /// `'text'`, with its quotes.
    SingleByteText,
    /// `"text"`, with its quotes.
    DoubleByteText,
    /// What stands behind `T#`, `TIME#`, `LT#`, `LTIME#`.
    Duration,
    /// What stands behind `D#`, `DATE#`, `LD#`, `LDATE#`.
    Date,
    /// What stands behind `TOD#`, `TIME_OF_DAY#`, `LTOD#` …
    TimeOfDay,
    /// What stands behind `DT#`, `DATE_AND_TIME#`, `LDT#` …
    DateAndTime,
}

/// An argument of a call.
#[derive(Debug)]
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
        /// NOT stands before the name.
        negated: bool,
        /// The variable that takes it.
        target: ExpressionId,
    },
}

/// Prefix operators.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnaryOperator {
    /// `-`.
    Negate,
    /// `+`.
    Plus,
    /// `NOT`.
    Not,
}

/// Infix operators, loosest first; each group's precedence is Table 71 of the third edition.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BinaryOperator {
    /// `OR`.
    Or,
    /// `XOR`.
    Xor,
    /// `AND`, `&`.
    And,
    /// `=`.
    Equal,
    /// `<>`.
    NotEqual,
    /// `<`.
    Less,
    /// `>`.
    Greater,
    /// `<=`.
    LessOrEqual,
    /// `>=`.
    GreaterOrEqual,
    /// `+`.
    Add,
    /// `-`.
    Subtract,
    /// `*`.
    Multiply,
    /// `/`.
    Divide,
    /// `MOD`.
    Modulo,
    /// `**`.
    Power,
}

impl BinaryOperator {
    /// The operator as the renderer and messages write it.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            BinaryOperator::Or => "OR",
            BinaryOperator::Xor => "XOR",
            BinaryOperator::And => "AND",
            BinaryOperator::Equal => "=",
            BinaryOperator::NotEqual => "<>",
            BinaryOperator::Less => "<",
            BinaryOperator::Greater => ">",
            BinaryOperator::LessOrEqual => "<=",
            BinaryOperator::GreaterOrEqual => ">=",
            BinaryOperator::Add => "+",
            BinaryOperator::Subtract => "-",
            BinaryOperator::Multiply => "*",
            BinaryOperator::Divide => "/",
            BinaryOperator::Modulo => "MOD",
            BinaryOperator::Power => "**",
        }
    }
}

/// CONFIGURATION … END_CONFIGURATION. Tasks decide when programs run; the reference runs every program
/// instance once a scan, so of a task only the name is kept.
#[derive(Debug)]
pub struct Configuration<'s> {
    /// Its name.
    pub name: Name<'s>,
    /// VAR_GLOBAL sections of the configuration and of its resources.
    pub globals: Vec<VariableBlock<'s>>,
    /// The resources; one without a name holds programs that stand directly in the configuration.
    pub resources: Vec<Resource<'s>>,
    /// From the first keyword to the last.
    pub span: Span,
}

/// RESOURCE … END_RESOURCE.
#[derive(Debug)]
pub struct Resource<'s> {
    /// Name and the type behind ON; `None` for a configuration without resources.
    pub header: Option<(Name<'s>, Name<'s>)>,
    /// `TASK name(INTERVAL := T#10ms, PRIORITY := 1);`
    pub tasks: Vec<Task<'s>>,
    /// `PROGRAM instance WITH task : type;`
    pub programs: Vec<ProgramInstance<'s>>,
}

/// A task.
#[derive(Debug)]
pub struct Task<'s> {
    /// Its name.
    pub name: Name<'s>,
    /// INTERVAL, PRIORITY, SINGLE and their values.
    pub properties: Vec<(Name<'s>, ExpressionId)>,
}

/// A program instance.
#[derive(Debug)]
pub struct ProgramInstance<'s> {
    /// The instance's name.
    pub name: Name<'s>,
    /// The task behind WITH.
    pub task: Option<Name<'s>>,
    /// The program's name.
    pub type_name: Name<'s>,
}
