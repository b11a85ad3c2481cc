//! Parsers and canonical writers of the standard's literals: of the part after the `#` of a typed literal.
//!
//! All parsers take time linear in the length of their text, never panic, and set no limit to that length. All writers
//! produce the one canonical spelling; each parser reads what the writer of the same file produces. Offsets in errors count
//! bytes from the start of the parsed text.

pub mod date;
pub mod duration;
mod error;
pub mod number;
pub mod real;
pub mod text;

pub use date::{
    date, date_and_time, time_of_day, with_seconds, write_date, write_date_and_time, write_time_of_day,
};
pub use duration::{UNITS as DURATION_UNITS, duration, wide_duration, write_milliseconds, write_nanoseconds};
pub use error::LiteralError;
pub use number::{integer, unsigned_integer};
pub use real::{real, write_real};
pub use text::{characters, text, write_text};
