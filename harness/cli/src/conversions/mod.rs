//! What a conversion function does to values: asking engines, and showing their answers beside the documents.

mod ask;
mod block;
mod differences;
mod given;
mod inputs;
mod json;
mod names;
mod page;
mod spelling;
mod table;

pub use block::{Block, gather};
pub use given::rows;
pub use names::{Present, all, listed, present};
pub use {json::write as write_json, page::write as write_page};
