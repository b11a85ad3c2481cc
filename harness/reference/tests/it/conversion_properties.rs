//! Properties that conversions have for each value: many thousand values for each property, drawn by `arbitrary` from
//! seeded bytes, so that every run draws the same.
//!
//! Each property is tested on the conversions that [`stickler_reference::conversion`] finds by their names, in every
//! dialect that has them.

mod choices;
mod draw;
mod texts;
mod values;
