//! The overview of a conversion function: its results for a few values, engines and dialects side by side, compared with documents.
//!
//! [`calls`] chooses the values, [`gather`] asks the engines, and [`OverviewPage`] shows the [`SignatureResults`].
//! [`Statements`] are what documents say of many functions and of implicit conversion, without asking an engine.

pub(crate) mod choices;
mod inputs;
mod page;
mod recorded;
mod results;
mod statements;
mod values;

pub use choices::rules;
pub use inputs::boundaries as boundary_calls;
pub use page::OverviewPage;
pub use recorded::{ComparedAnswer, QuestionNumber, RecordedAnswers};
pub use results::{
    AnswerSource, AssertedResult, ComparedResult, DialectResults, ExpectedResult, OtherStatement,
    SignatureResults, gather,
};
pub use statements::{CaseStatement, StatedFunction, Statements, StatementsBuilder};
pub use values::{CallOperands, ValueError, calls};

#[cfg(test)]
pub(crate) use {recorded::accepted, values::read as read_operand};
