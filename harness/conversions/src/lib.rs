//! Conversion functions: asks engines for their results, and compares the results with exact arithmetic.
//!
//! [`overview`] shows what a function gives for a few values, engines and dialects side by side. [`sweep`] takes all inputs
//! of a function, or a large sample of them, through the reference or through programs that another engine executes.
//! [`implicit`] asks which types convert without a function, and a [`recording`] keeps the answers of a compiler in a file.
//! A [`table`] is shown on a terminal. [`find_function`] and [`all_functions`] look functions up by name.
//!
//! Architecture Invariant: this crate knows no command line, and opens no engine.

pub mod contradictions;
mod functions;
pub mod implicit;
mod literals;
pub mod overview;
mod program;
pub mod recording;
mod session;
pub mod sweep;
pub mod table;
#[cfg(test)]
mod tests;

pub use functions::{
    FunctionDialects, NoSuchFunction, all_functions, dialect_list, find_function, short_names,
    swept_signatures,
};
pub use program::ConversionProgram;
pub use session::{FunctionSession, Refusal, RefusalKind};
