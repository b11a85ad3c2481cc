//! For compilers that only live behind an editor, and for the plants that they program: pages of self-checking programs to be
//! pasted into the editor, and what is copied back out of it, judged as a run of any engine is.
#![forbid(unsafe_code)]

mod answers;
mod compiled_page;
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
mod program_parts;
mod reason;
mod record;
mod rename;
mod result_arrays;
#[cfg(test)]
mod round_trip;
mod unjudged;

pub use answers::ANSWERS;
pub use error::ExportError;
pub use export::{ExportPlan, Exported, export};
pub use import::{CopiedText, Export, Imported};
pub use manifest::MANIFEST;
pub use page_case::ExtraCases;
pub use reason::Reason;
