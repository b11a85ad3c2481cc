//! Configurations, resources and tasks.

use super::{ExpressionId, Name, VariableBlock};
use crate::source::Span;

/// CONFIGURATION … END_CONFIGURATION. Tasks decide when programs run; the reference runs every program
/// instance once a scan, so of a task only the name is kept.
#[derive(Debug)]
pub struct Configuration<'s> {
    /// The name.
    pub name: Name<'s>,
    /// VAR_GLOBAL sections of the configuration and of its resources.
    pub globals: Vec<VariableBlock<'s>>,
    /// The resources; one without a name holds programs that stand directly in the configuration.
    pub resources: Vec<Resource<'s>>,
    /// The VAR_CONFIG sections: each name is the path from a program instance to a variable, with the location or the initial value
    /// that the variable has there.
    pub configured: Vec<VariableBlock<'s>>,
    /// From the first keyword to the last.
    pub span: Span,
}

/// RESOURCE … END_RESOURCE.
#[derive(PartialEq, Default, Debug)]
pub struct Resource<'s> {
    /// Name and the type behind ON; `None` for a configuration without resources.
    pub header: Option<(Name<'s>, Name<'s>)>,
    /// `TASK name(INTERVAL := T#10ms, PRIORITY := 1);`
    pub tasks: Vec<Task<'s>>,
    /// `PROGRAM instance WITH task : type;`
    pub programs: Vec<ProgramInstance<'s>>,
}

/// A task.
#[derive(PartialEq, Debug)]
pub struct Task<'s> {
    /// The name.
    pub name: Name<'s>,
    /// INTERVAL, PRIORITY, SINGLE and their values.
    pub properties: Vec<(Name<'s>, ExpressionId)>,
}

/// A program instance.
#[derive(PartialEq, Debug)]
pub struct ProgramInstance<'s> {
    /// The instance's name.
    pub name: Name<'s>,
    /// The task behind WITH.
    pub task: Option<Name<'s>>,
    /// The program's name.
    pub type_name: Name<'s>,
}
