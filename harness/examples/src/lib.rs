//! Tests as data: examples in Markdown files, compared with what a function computes.
//!
//! A file has a section for each property, and the heading of the section says the property as a sentence. What a section holds, a
//! function of the test turns into a text, which must be the one that stands in the file:
//!
//! * Blocks of code: the last one is what must come, and those above it are the inputs. The text behind the fence names an input:
//!   its last word, so that a language may stand in front (`toml a/file.toml`).
//! * A table: each row is an example, and its last cell is what must come. The other cells are inputs by the name of their column,
//!   and so are the blocks of the section. A column `for NAME` puts its cell in place of NAME in the blocks; the columns `instead of` and
//!   `write` change one place of a block.
//!
//! Blocks above the first section are inputs of every section that has none of the same name. A block whose name is in capitals is no
//! input but a part of others: it takes the place of a line that has only its name. In what must come, `…` stands for any
//! text. In a cell `⏎` is a line break, a backslash precedes a `|`, and backticks around the whole cell are left out.
//!
//! With `STICKLER_BLESS=1` a file gets what came in place of what must come; `cargo xtask bless` does so for all tests with `golden` in
//! their names. Read the difference.

mod document;

pub use document::Example;

use document::{Document, Expected};
use std::env;
use std::fmt::Write;
use std::fs;

/// Compares each example of a file with the text that `result` makes of it; `path` begins at the folder of the crate under test.
///
/// # Panics
/// Where any example differs, with the place, the heading and both texts of each; and where the file cannot be read.
#[track_caller]
pub fn check(path: &str, mut result: impl FnMut(&Example) -> String) {
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let document = Document::parse(&text).unwrap_or_else(|(line, what)| panic!("{path}:{line}: {what}"));
    let mut differing = Vec::new();
    for (example, expected) in document.examples {
        let came = result(&example);
        if !fits(&expected.text, came.trim_end()) {
            differing.push((example, expected, came.trim_end().to_owned()));
        }
    }
    if differing.is_empty() {
        return;
    }
    if env::var_os("STICKLER_BLESS").is_some() {
        let blessed = blessed(
            &text,
            differing
                .iter()
                .map(|(_, expected, came)| (expected, came.as_str())),
        );
        return fs::write(path, blessed).unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    let mut report = format!("{} examples differ\n", differing.len());
    for (example, expected, came) in differing {
        // Writing to a String cannot fail.
        let _ = writeln!(
            report,
            "\n{path}:{}: {}",
            expected.lines.start + 1,
            example.heading()
        );
        let _ = writeln!(report, "--- expected\n{}\n--- came\n{came}", expected.text);
    }
    panic!("{report}");
}

/// Returns whether a text is the expected one, in which `…` stands for any text.
fn fits(expected: &str, came: &str) -> bool {
    let mut pieces = expected.split('…');
    let first = pieces.next().unwrap_or_default();
    let Some(mut rest) = came.strip_prefix(first) else {
        return false;
    };
    let Some(last) = pieces.next_back() else {
        return rest.is_empty();
    };
    for piece in pieces {
        let Some(at) = rest.find(piece) else { return false };
        rest = &rest[at + piece.len()..];
    }
    rest.ends_with(last)
}

/// Returns the text of a file with what came in place of what was expected.
fn blessed<'d>(text: &str, differing: impl Iterator<Item = (&'d Expected, &'d str)>) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let differing: Vec<_> = differing.collect();
    // From the end, so that the numbers of the lines above stay right.
    for (expected, came) in differing.into_iter().rev() {
        let new = match expected.is_cell {
            true => vec![document::with_last_cell(&lines[expected.lines.start], came)],
            false => came.lines().map(str::to_owned).collect(),
        };
        lines.splice(expected.lines.clone(), new);
    }
    lines.join("\n") + "\n"
}

#[cfg(test)]
mod tests;
