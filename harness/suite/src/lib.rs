//! The conformance case format: case files are read, checked, and expanded into cases.
//!
//! A case file is an annotated program (`.st`) or a table (`.toml`); `conformance-cases/README.md` explains both.
//!
//! | question | answered by |
//! |---|---|
//! | which cases does a folder hold? | [`Suite::load`]; [`Suite::load_files`] reads some of its files only |
//! | what is a case? | [`Case`]: a program, a dialect and an [`Expectation`] |
//! | which dialects and groups may case files name? | [`Dialects`] |
//! | what is doubtful in the files? | [`lint`](fn@lint) |
//! | which features has the language, and which does a case use? | [`Features`], [`Case::features`] |
//! | which cases were withdrawn, and what changed between two versions? | [`Suite::withdrawn`], [`Suite::changes_since`] |
//! | which documents may a case cite, and for whom do they speak? | [`Sources`] |
//!
//! Whatever stands in a file, the rest of the suite still loads: mistakes are
//! [`CaseFileError`]s, with file, line, key and a hint. [`lint`](fn@lint) also says what only a reader of the files would notice.
//!
//! This crate must not know the reference: what a case expects comes from its file, from exact arithmetic, or from what the
//! definition of a dialect states, never from running anything.

mod assemble;
mod assembly;
mod bases;
mod changes;
mod citations;
mod condition;
mod defined;
mod dialects;
mod error;
mod features;
mod files;
mod frame;
mod ident;
mod lint;
mod mark;
mod mark_reader;
mod model;
mod observed;
mod place;
mod places;
mod program;
mod scan;
mod single;
mod sources;
mod statements;
mod suite;
mod table;
mod template;
#[cfg(test)]
mod tests;
mod timing;
mod timing_diagram;
mod toml_text;
mod unmarked;
mod withdrawn;

pub use bases::{Bases, OR};
pub use changes::{Change, Changed};
pub use citations::NOT_STATED;
pub use dialects::Dialects;
pub use error::CaseFileError;
pub use features::{Feature, FeatureKey, FeatureSupport, Features};
pub use files::{FileKind, RECORDINGS};
pub use lint::{LintFinding, LintSeverity, lint};
pub use model::{
    Case, Expectation, ExpectedDiagnostic, ExpectedFault, ExpectedText, ExpectedValue, MatrixCell,
};
pub use places::{Placement, Places, ProgramPlace, Role};
pub use sources::{CheckedQuote, QuoteResult, Source, SourceKind, Sources, ToldSymptom};
pub use statements::SourceStatement;
pub use stickler_types::Acceptance;
pub use suite::{Suite, Wanted, load_file, read_case_file};
pub use table::Generate;
pub use unmarked::without_blank_lines;
pub use withdrawn::Withdrawn;
