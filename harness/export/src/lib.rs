//! For compilers that only live behind an editor, and for the plants that they program: pages of self-checking programs to be
//! pasted into the editor, and what is copied back out of it, judged as a run of any engine is.
#![forbid(unsafe_code)]

mod answers;
mod error;
mod export;
mod gathered;
mod import;
mod look;
mod manifest;
mod messages;
mod notes;
mod page;
mod parts;
mod paste;
mod ready;
mod reason;
mod record;
mod rename;
#[cfg(test)]
mod round_trip;
mod taking_apart;

pub use answers::ANSWERS;
pub use error::ExportError;
pub use export::{ExportPlan, Exported, export};
pub use import::{Export, Imported, Source};
pub use manifest::MANIFEST;
pub use ready::With;
pub use reason::Reason;
