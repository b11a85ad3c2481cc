//! Other spellings of the same model.

use crate::model::Program;
use crate::writer::{Style, write};

/// Writes a program in a style; `None` if that gives the canonical text.
pub(super) fn other(program: &Program, style: Style) -> Option<String> {
    let text = write(program, &style).text;
    (text != write(program, &Style::default()).text).then_some(text)
}
