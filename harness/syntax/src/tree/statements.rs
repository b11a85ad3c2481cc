//! Statements.

use super::ExpressionId;
use crate::source::Span;

/// A statement.
#[derive(Debug)]
pub struct Statement {
    /// The form.
    pub kind: StatementKind,
    /// From its first token to its last, the semicolon left out.
    pub span: Span,
}

/// The statements of ST.
#[derive(PartialEq, Debug)]
pub enum StatementKind {
    /// `target := value`.
    Assignment {
        /// The variable written.
        target: ExpressionId,
        /// The value.
        value: ExpressionId,
    },
    /// `target REF= value`: binds a reference to a variable.
    Binding {
        /// The reference.
        target: ExpressionId,
        /// The variable, or a reference that is bound to it.
        value: ExpressionId,
    },
    /// A call as a statement: its expression is an [`ExpressionKind::Call`](super::ExpressionKind::Call).
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
        /// The first value.
        from: ExpressionId,
        /// The limit.
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
    /// `JMP name`: its expression is an [`ExpressionKind::Name`](super::ExpressionKind::Name), which names a label.
    Jump(ExpressionId),
    /// `name:` before a statement.
    Label(ExpressionId),
    /// A lone semicolon.
    Empty,
}

impl StatementKind {
    /// Returns whether the statement has an END_… of its own, so that what follows it does not make it doubtful.
    pub const fn is_block(&self) -> bool {
        use StatementKind::{Case, For, If, Repeat, While};
        matches!(
            self,
            If { .. } | Case { .. } | For { .. } | While { .. } | Repeat { .. }
        )
    }
}

/// One branch of a CASE statement.
#[derive(PartialEq, Debug)]
pub struct CaseBranch {
    /// The labels.
    pub labels: Vec<CaseLabel>,
    /// The statements.
    pub body: Vec<Statement>,
}

/// A label of a CASE branch.
#[derive(PartialEq, Debug)]
pub enum CaseLabel {
    /// `5` or `RED`.
    Value(ExpressionId),
    /// `1..9`.
    Range(ExpressionId, ExpressionId),
}
