//! Other spellings of the same model.

use crate::model::Program;
use crate::writer::{Style, write};

/// The text of a program in this style; `None` where it is the text in the canonical one.
pub(super) fn other(program: &Program, style: Style) -> Option<String> {
    let text = write(program, &style).text;
    (text != write(program, &Style::default()).text).then_some(text)
}
