//! The overview of a conversion function: its results for a few values, engines and dialects side by side, compared with documents.
//!
//! [`calls`] chooses the values, [`gather`] asks the engines, and [`OverviewPage`] and [`write_json`] show the [`SignatureResults`].

mod choices;
mod inputs;
mod json;
mod page;
mod results;
mod table;
mod values;

pub use json::write as write_json;
pub use page::OverviewPage;
pub use results::{ComparedResult, DialectResults, SignatureResults, gather};
pub use values::{Call, ValueError, calls};
