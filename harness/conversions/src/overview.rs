//! The overview of a conversion function: its results for a few values, engines and dialects side by side, compared with documents.
//!
//! [`calls`] chooses the values, [`gather`] asks the engines, and [`OverviewPage`] and [`write_json`] show the [`SignatureResults`].
//! [`Statements`] are what documents say of many functions and of implicit conversion, without asking an engine.

pub(crate) mod choices;
mod inputs;
mod json;
mod page;
mod recorded;
mod results;
mod statements;
mod values;

pub use inputs::boundaries as boundary_calls;
pub use json::write as write_json;
pub use page::OverviewPage;
pub use recorded::{ComparedAnswer, QuestionNumber, RecordedAnswers};
pub use results::{
    AnswerSource, AssertedResult, ComparedResult, DialectResults, ExpectedResult, OtherStatement,
    SignatureResults, gather,
};
pub use statements::{CaseStatement, Statements, StatementsBuilder};
pub use values::{CallOperands, ValueError, calls};

#[cfg(test)]
pub(crate) use {recorded::accepted, values::read as read_operand};
