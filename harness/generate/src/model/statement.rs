//! The statements of a program of the model.

use super::visit::bodies;
use super::{Argument, Expression, LiteralForm, Place, Type, VariableId};
use stickler_types::{ElementaryType, Value};

/// A statement.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// `target := value;`, both of one type.
    Assign(AssignmentTarget, Expression),
    /// IF with its ELSIF branches and its ELSE branch.
    If(Vec<(Expression, Vec<Statement>)>, Option<Vec<Statement>>),
    /// CASE of an integer or enumeration; no label occurs twice.
    Case(Expression, Vec<CaseBranch>, Option<Vec<Statement>>),
    /// FOR.
    For(ForLoop),
    /// WHILE; the generator limits the number of iterations by a counter variable.
    While(Expression, Vec<Statement>),
    /// REPEAT … UNTIL.
    Repeat(Vec<Statement>, Expression),
    /// `instance(input := …, in_out := variable, output => target);`
    Invoke {
        /// The variable that holds the instance.
        instance: VariableId,
        /// The inputs; the value of an in-out is an [`super::ExpressionKind::Read`] of the same type.
        inputs: Vec<Argument>,
        /// The outputs and the places that take them, of the same type.
        outputs: Vec<(VariableId, Place)>,
    },
    /// EXIT; only in a loop.
    Exit,
    /// RETURN.
    Return,
    /// A whole statement as text that breaks a rule on purpose; the evaluator refuses it.
    Raw(String),
}

/// FOR over an integer variable that the body does not assign; the BY value is not 0, and the step after the last one
/// stays within the type. The generator assigns the variable right after the loop, because no document states which
/// value it holds then.
#[derive(Clone, PartialEq, Debug)]
pub struct ForLoop {
    /// The control variable.
    pub variable: VariableId,
    /// The first value of the control variable.
    pub from: Expression,
    /// The last value of the control variable, inclusive.
    pub to: Expression,
    /// The step, a literal; `None` for 1.
    pub by: Option<Expression>,
    /// The statements that the loop repeats.
    pub body: Vec<Statement>,
}

impl Statement {
    /// Returns whether the statement is FOR, WHILE or REPEAT.
    pub const fn is_loop(&self) -> bool {
        matches!(
            self,
            Statement::For(_) | Statement::While(..) | Statement::Repeat(..)
        )
    }
}

/// Returns the control variables of the FOR statements among these and inside them.
pub(crate) fn controlled(statements: &[Statement]) -> Vec<VariableId> {
    let mut found = Vec::new();
    let mut waiting: Vec<_> = statements.iter().collect();
    while let Some(statement) = waiting.pop() {
        if let Statement::For(parts) = statement {
            found.push(parts.variable);
        }
        waiting.extend(bodies(statement).into_iter().flatten());
    }
    found
}

/// The left side of an assignment.
#[derive(Clone, PartialEq, Debug)]
pub enum AssignmentTarget {
    /// A variable or part of one.
    Place(Place),
    /// A bit of an integer or bit string.
    Bit(Place, u32),
    /// The result of the enclosing function.
    Result,
}

/// A branch `1, 3..5: …` of a CASE.
#[derive(Clone, PartialEq, Debug)]
pub struct CaseBranch {
    /// The labels that select the branch.
    pub labels: Vec<CaseLabel>,
    /// The statements of the branch.
    pub body: Vec<Statement>,
}

/// One label of a CASE.
#[derive(Clone, PartialEq, Debug)]
pub enum CaseLabel {
    /// A single value.
    One(Expression),
    /// The range `low..high` of an integer, both inclusive.
    Range(Expression, Expression),
}

/// Creates a read of a whole variable of an elementary type.
pub(crate) fn whole(variable: VariableId, ty: ElementaryType) -> Expression {
    Expression::read(Place::whole(variable, Type::Elementary(ty)))
}

/// Creates an assignment to a whole variable of an elementary type.
pub(crate) fn assign(variable: VariableId, ty: ElementaryType, value: Expression) -> Statement {
    let place = Place::whole(variable, Type::Elementary(ty));
    Statement::Assign(AssignmentTarget::Place(place), value)
}

/// Creates a literal of an integer type, a bit string or BOOL.
pub(crate) fn integer(ty: ElementaryType, number: impl Into<i128>, form: LiteralForm) -> Expression {
    Expression::literal(ty, Value::plain(ty, ty.wrap(number.into())), form)
}
