//! Parses the diagnostics that `ironplcc` writes to stderr, with colours whether or not a terminal reads them.
//!
//! Basis: ironplc: measured on version 0.239, which has errors alone and no warnings; each begins `error[P4035]: message`, and a later line `┌─ file:line:column` names
//! the place. Where the compiler does not know the place, it shows 1:1 without a file, or marks nothing there.

use crate::Diagnostic;
use crate::adapters::Compiler;
use crate::adapters::codes::{CodeMeaning, sorted};
use crate::adapters::locate::without_colours;

/// Returns all diagnostics of a text, sorted by line, column and code, each once. One whose place the compiler does not tell
/// has no line.
pub(super) fn read(stderr: &str) -> Vec<Diagnostic> {
    let codes = &Compiler::Ironplc.data().codes;
    let plain = without_colours(stderr);
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    let mut lines = plain.lines();
    while let Some(line) = lines.next() {
        if let Some(diagnostic) = heading(line) {
            diagnostics.push(diagnostic);
        } else if let (Some(place), Some(last)) = (place(line), diagnostics.last_mut())
            && last.line.is_none()
            && !(place == BEGINNING && (has_no_file(line) || marks_nothing(lines.clone())))
        {
            (last.line, last.column) = (Some(place.0), Some(place.1));
        } else if let (Some(label), Some(last)) = (label(line), diagnostics.last_mut())
            && codes.of_itself(last) == Some(&CodeMeaning::NotImplemented)
        {
            // The heading is the same for everything that is not implemented; the label tells what it is.
            last.message = format!("{}: {label}", last.message);
        } else if let (Some((file, line)), Some(last)) = (raised_at(line), diagnostics.last_mut())
            && codes.of_itself(last) == Some(&CodeMeaning::NotImplemented)
            && !last.message.contains("#L")
        {
            last.message = format!("{} at {file}#L{line}", last.message);
        }
    }
    sorted(diagnostics)
}

/// The place that the compiler shows where it knows none.
const BEGINNING: (u32, u32) = (1, 1);

/// Tells whether the line of a place names no file.
fn has_no_file(line: &str) -> bool {
    line.split_once("┌─ ")
        .is_some_and(|(_, place)| place.starts_with(':'))
}

/// Tells whether the lines below the place 1:1 mark an empty range: one mark under the beginning of a word or comment, which is
/// longer. A mistake in the first word of a program has as many marks as the word has characters.
fn marks_nothing<'l>(mut below: impl Iterator<Item = &'l str>) -> bool {
    let source = below.find_map(|line| line.strip_prefix("1 │ "));
    let marks = below.next().and_then(|line| line.split_once("│ "));
    let (Some(source), Some((_, marks))) = (source, marks) else {
        return false;
    };
    let of_a_word = |character: char| character.is_alphanumeric() || character == '_';
    let word = source.chars().take_while(|&character| of_a_word(character));
    let is_one_character = match word.count() {
        0 => {
            !["(*", "/*", "//", "{", " ", "\t"]
                .iter()
                .any(|begin| source.starts_with(begin))
                && !source.is_empty()
        }
        length => length == 1,
    };
    !is_one_character && marks.starts_with('^') && !marks.starts_with("^^")
}

/// Returns the words behind the marks of a line such as `  │  ^^^ Not implemented at codegen/src/compile.rs#L7`.
fn label(line: &str) -> Option<&str> {
    let marks = line.trim_start().strip_prefix("│ ")?;
    let (before, label) = marks.split_once("^ ")?;
    let is_marks = before
        .chars()
        .all(|character| matches!(character, ' ' | '^' | '│' | '╰' | '─'));
    Some(label.trim()).filter(|label| is_marks && !label.is_empty())
}

/// Returns the place in the compiler's own source that the address of a page names, as in `…/P9999.html?version=0.239.0&file=codegen/src/compile.rs&line=7`.
fn raised_at(line: &str) -> Option<(&str, &str)> {
    let (_, address) = line.split_once("= Learn more: ")?;
    let (_, file) = address.split_once("&file=")?;
    file.split_once("&line=")
}

/// Parses a heading such as `error[P4035]: message`.
fn heading(line: &str) -> Option<Diagnostic> {
    let (code, message) = line.strip_prefix("error[")?.split_once("]: ")?;
    Some(Diagnostic {
        code: Some(code.to_owned()),
        message: message.trim_end().to_owned(),
        ..Diagnostic::default()
    })
}

/// Parses a place such as `  ┌─ program.st:6:13`.
fn place(line: &str) -> Option<(u32, u32)> {
    let (_, place) = line.split_once("┌─ ")?;
    let mut parts = place.trim_end().rsplitn(3, ':');
    let column = parts.next()?.parse().ok()?;
    let line = parts.next()?.parse().ok()?;
    Some((line, column))
}
