//! Exports cases for compilers that only live behind an editor, and for the plants that they program, and imports the results.
//!
//! [`export()`] writes pages of self-checking programs, which a person pastes into the editor, and a [`MANIFEST`] that says what
//! stands where. An [`Export`] reads that back and [imports](Export::import) the [texts](CopiedText) that the person copies out of
//! the editor: arrays of results, or lists of messages of pages that are only compiled. They are judged as a run of any engine is.
//! [`export_plain`] writes cases for people who have no harness, [`write_data`] what systems do as
//! one table, and a [`ComplianceStatement`] what the standard demands to be said of a system. The behaviour of a compiler in a single case can also be noted in [`ANSWERS`]; a [`Reason`] says why a case is on no page.

mod answers;
mod compiled_page;
mod compliance;
mod data;
mod encode;
mod encoding;
mod error;
mod export;
mod import;
mod manifest;
mod messages;
mod page;
mod page_case;
mod paste;
mod plain;
mod plcopen;
mod record;
mod result_arrays;
#[cfg(test)]
mod round_trip;
mod source_line;
mod unjudged;

pub use answers::ANSWERS;
pub use compliance::{ComplianceForm, CompliancePlan, ComplianceStatement};
pub use data::{DATA, Kind, Questions, SupportData, answer_word, call_question, write_data};
pub use error::ExportError;
pub use export::{ExportPlan, Exported, export};
pub use import::{CopiedText, Export, Imported};
pub use manifest::MANIFEST;
pub use page_case::{ExtraCases, Reason};
pub use plain::{CASES, PlainExported, export_plain};
pub use plcopen::ProjectPlan;
