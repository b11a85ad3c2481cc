//! Reports: projections of the one stream of events that a run emits.
//!
//! | module | file | for |
//! |---|---|---|
//! | [`events`] | `events.jsonl.gz` | the stream itself, written while the run goes on; the only file that a run leaves when it is cut short |
//! | `results` | `results.json` | programs that want numbers and failures |
//! | `junit` | `junit.xml` | CI services |
//! | [`summary`] | `summary.md` | a CI step summary, a pull request |
//! | `page` | `index.html` | everybody: one file that a browser opens |
//! | `sarif` | `results.sarif` | code scanning services, editors |
//! | `code_quality` | `gl-code-quality-report.json` | GitLab |
//! | `badge` | `badge.json` | the first page of a compiler's project |
//! | `discrepancies` | `discrepancies/ENGINE/*.md` | the authors of a compiler |
//! | [`terminal`] | (the terminal) | the person who started the run |
//! | [`comparison`] | (the terminal) | a person who compares a run with an older one |
//! | [`site`] | (a folder of pages) | the public: several runs of several engines, and what changed between them |
//!
//! A format is a module of its own that takes [`Event`](stickler_run::Event)s by an exhaustive match, or a view of the
//! [`Overview`] that such a match gathers; a new format is a new module and a line in [`Reports`].
//!
//! *Architecture invariants.* No format has facts of its own: what is not in an event is in no report, except that the page shows
//! what documents state of conversions, which the caller hands over. [`claims`] is the
//! one place that counts claims, and [`observations`] the one that compares observations. Nothing here runs, schedules or
//! judges a case, or knows how an event came about.

pub mod annotations;
mod answers;
mod badge;
pub mod basis;
pub mod claims;
mod code_quality;
mod compared;
pub mod comparison;
pub mod diff;
mod discrepancies;
mod error;
pub mod events;
mod folder;
#[cfg(test)]
mod golden_tests;
mod groups;
mod junit;
mod listed;
mod markdown;
pub mod observations;
pub mod overview;
mod page;
pub mod parts;
mod pending;
mod results;
#[cfg(test)]
mod sample;
mod sarif;
#[cfg(test)]
mod schema_tests;
pub mod site;
pub mod summary;
pub mod terminal;
mod text;
mod unexpected;

pub use comparison::{Comparison, ComparisonError};
pub use error::{LogError, ReportError};
pub use folder::Reports;
pub use markdown::inline as markdown_text;
pub use overview::Overview;
pub use sarif::diagnostics_as_sarif;
pub use site::{escaped as html_text, page as html_page};
