//! Statements.

use super::{Argument, Expression, Place, VariableId};

/// A statement.
#[derive(Clone, PartialEq, Debug)]
pub struct Statement {
    /// What it is.
    pub kind: StatementKind,
}

/// The forms of a statement.
#[derive(Clone, PartialEq, Debug)]
pub enum StatementKind {
    /// `target := value;`, of one type.
    Assign(AssignmentTarget, Expression),
    /// IF with its ELSIF branches, and what stands behind ELSE.
    If(Vec<(Expression, Vec<Statement>)>, Option<Vec<Statement>>),
    /// CASE of an integer or enumeration; no label stands twice.
    Case(Expression, Vec<CaseBranch>, Option<Vec<Statement>>),
    /// FOR over a variable of an integer type that the body does not assign; the value behind BY is not 0, and the step
    /// behind the last stays within the type. The generator assigns the variable right behind the loop, for no document
    /// says what it holds then.
    For {
        /// The control variable.
        variable: VariableId,
        /// From, to and by.
        from: Expression,
        /// To, inclusive.
        to: Expression,
        /// By, a literal; 1 where it is not written.
        by: Option<Expression>,
        /// The statements.
        body: Vec<Statement>,
    },
    /// WHILE; the generator counts its turns in a variable of its own.
    While(Expression, Vec<Statement>),
    /// REPEAT … UNTIL.
    Repeat(Vec<Statement>, Expression),
    /// `instance(input := …, in_out := variable, output => target);`
    Invoke {
        /// The variable that is the instance.
        instance: VariableId,
        /// Inputs; an in-out's value is an [`super::ExpressionKind::Read`] of its own type.
        inputs: Vec<Argument>,
        /// Outputs and the places that take them, of the same type.
        outputs: Vec<(VariableId, Place)>,
    },
    /// EXIT, in a loop.
    Exit,
    /// RETURN.
    Return,
    /// A whole statement as text, put there to break a rule; the evaluator refuses it.
    Raw(String),
}

impl Statement {
    /// Returns whether the statement is FOR, WHILE or REPEAT.
    #[must_use]
    pub const fn is_loop(&self) -> bool {
        matches!(
            self.kind,
            StatementKind::For { .. } | StatementKind::While(..) | StatementKind::Repeat(..)
        )
    }
}

/// What an assignment writes to.
#[derive(Clone, PartialEq, Debug)]
pub enum AssignmentTarget {
    /// A variable or part of one.
    Place(Place),
    /// A bit of an integer or bit string.
    Bit(Place, u32),
    /// The result of the function in whose body it stands.
    Result,
}

/// `1, 3..5: …` of a CASE.
#[derive(Clone, PartialEq, Debug)]
pub struct CaseBranch {
    /// The labels.
    pub labels: Vec<CaseLabel>,
    /// The statements.
    pub body: Vec<Statement>,
}

/// One label of a CASE.
#[derive(Clone, PartialEq, Debug)]
pub enum CaseLabel {
    /// A value.
    One(Expression),
    /// `low..high` of an integer, both inclusive.
    Range(Expression, Expression),
}
