//! Examples in Markdown files, compared with the texts that a function makes of them.
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

use crate::markdown::{Fence, Mistake, Row, Section, sections, with_last_cell};
use std::env;
use std::fs;
use std::ops::Range;

/// One example: its inputs, by name.
#[derive(Clone, Debug, Default)]
pub struct Example {
    heading: String,
    wanted: String,
    inputs: Vec<(String, String)>,
}

/// What must come of an example.
#[derive(Clone, Debug)]
struct Expected {
    text: String,
    /// The lines of the file that hold it, from 0: those of a block, or that of a row.
    lines: Range<usize>,
    /// Whether it is the last cell of a row.
    is_cell: bool,
}

/// The examples of a file, in order.
struct Document {
    examples: Vec<(Example, Expected)>,
}

impl Example {
    /// Returns the heading of the section.
    pub fn heading(&self) -> &str {
        &self.heading
    }

    /// Returns the name of what must come: that of the last block, or of the last column.
    pub fn wanted(&self) -> &str {
        &self.wanted
    }

    /// Returns the input of a name, if there is one.
    pub fn get(&self, name: &str) -> Option<&str> {
        let found = self.inputs.iter().find(|(known, _)| known == name);
        found.map(|(_, text)| text.as_str())
    }

    /// Returns the input of a name; an empty text if there is none.
    pub fn text(&self, name: &str) -> &str {
        self.get(name).unwrap_or_default()
    }

    /// Returns the inputs with their names: cells before blocks, blocks of the section before those of the file.
    pub fn inputs(&self) -> impl Iterator<Item = (&str, &str)> {
        let inputs = self.inputs.iter();
        inputs.map(|(name, text)| (name.as_str(), text.as_str()))
    }
}

impl Document {
    fn parse(text: &str) -> Result<Document, Mistake> {
        let mut sections = sections(text)?;
        let head = sections.remove(0);
        let mut document = Document { examples: Vec::new() };
        if !head.rows.is_empty() {
            document.add(&head, &[])?;
        }
        sections
            .iter()
            .try_for_each(|section| document.add(section, &head.blocks))?;
        Ok(document)
    }

    /// Adds the examples of a section; `shared` are the blocks of the whole file.
    fn add(&mut self, section: &Section, shared: &[Fence]) -> Result<(), Mistake> {
        let example = |own: &[Fence], cells: Vec<(String, String)>, wanted: &str| {
            let of_file = shared
                .iter()
                .filter(|block| own.iter().all(|own| own.name() != block.name()));
            let blocks = own.iter().chain(of_file);
            let blocks = blocks.map(|block| (block.name().to_owned(), block.text.clone()));
            changed(with_fragments(blocks.collect()), cells).map(|inputs| Example {
                heading: section.heading.clone(),
                wanted: wanted.to_owned(),
                inputs,
            })
        };
        if section.rows.is_empty() {
            let Some((expected, inputs)) = section.blocks.split_last() else {
                return Err((section.line, "the section has no example".to_owned()));
            };
            let example =
                example(inputs, Vec::new(), expected.name()).map_err(|what| (section.line, what))?;
            let expected = Expected {
                text: expected.text.clone(),
                lines: expected.lines.clone(),
                is_cell: false,
            };
            self.examples.push((example, expected));
        }
        for Row { line, columns, cells } in &section.rows {
            if cells.len() != columns.len() {
                return Err((
                    line + 1,
                    format!("{} cells for {} columns", cells.len(), columns.len()),
                ));
            }
            let (Some((wanted, columns)), Some((expected, cells))) =
                (columns.split_last(), cells.split_last())
            else {
                continue;
            };
            let cells = columns.iter().cloned().zip(cells.iter().cloned()).collect();
            let example = example(&section.blocks, cells, wanted).map_err(|what| (line + 1, what))?;
            let expected = Expected {
                text: expected.clone(),
                lines: *line..line + 1,
                is_cell: true,
            };
            self.examples.push((example, expected));
        }
        Ok(())
    }
}

/// Puts the blocks that are named in capitals in place of the lines that have only their names.
fn with_fragments(blocks: Vec<(String, String)>) -> Vec<(String, String)> {
    let is_fragment = |name: &str| !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_uppercase());
    let (fragments, mut blocks): (Vec<_>, Vec<_>) =
        blocks.into_iter().partition(|(name, _)| is_fragment(name));
    for (_, text) in &mut blocks {
        let line = |line| {
            let fragment = fragments.iter().find(|(name, _)| name == line);
            fragment.map_or(line, |(_, text)| text.as_str())
        };
        *text = text.split('\n').map(line).collect::<Vec<_>>().join("\n");
    }
    blocks
}

/// Changes the blocks as the columns `for NAME`, and `instead of` and `write`, say, and returns them behind the cells.
fn changed(
    mut blocks: Vec<(String, String)>,
    cells: Vec<(String, String)>,
) -> Result<Vec<(String, String)>, String> {
    let cell = |wanted: &str| {
        cells
            .iter()
            .find(|(name, _)| name == wanted)
            .map(|(_, text)| text)
    };
    for (name, text) in &cells {
        if let Some(placeholder) = name.strip_prefix("for ") {
            let mut known = false;
            for (_, block) in &mut blocks {
                known |= block.contains(placeholder);
                *block = block.replace(placeholder, text);
            }
            if !known {
                return Err(format!("no block has `{placeholder}`"));
            }
        }
    }
    if let (Some(from), Some(to)) = (cell("instead of"), cell("write")) {
        let Some((_, block)) = blocks.iter_mut().find(|(_, block)| block.contains(from)) else {
            return Err(format!("no block has `{from}`"));
        };
        *block = block.replacen(from, to, 1);
    }
    Ok(cells.into_iter().chain(blocks).collect())
}

/// Compares each example of a file with the text that `result` makes of it; `path` begins at the folder of the crate under test.
///
/// # Panics
/// Where any example differs, with the place, the heading and both texts of each; and where the file cannot be read.
#[track_caller]
pub fn check_examples(path: &str, mut result: impl FnMut(&Example) -> String) {
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
        report.push_str(&format!(
            "\n{path}:{}: {}\n",
            expected.lines.start + 1,
            example.heading()
        ));
        report.push_str(&format!("--- expected\n{}\n--- came\n{came}\n", expected.text));
    }
    panic!("{report}");
}

/// Returns whether a text is the expected one, in which `…` stands for any text.
pub fn fits(expected: &str, came: &str) -> bool {
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

/// Asserts that a text is the expected one, in which `…` stands for any text.
///
/// # Panics
/// Where it is another one, with both.
#[track_caller]
pub fn assert_fits(came: &str, expected: &str) {
    assert!(fits(expected, came), "expected {expected}\n     got {came}");
}

/// Returns the text of a file with what came in place of what was expected.
fn blessed<'d>(text: &str, differing: impl Iterator<Item = (&'d Expected, &'d str)>) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let differing: Vec<_> = differing.collect();
    // From the end, so that the numbers of the lines above stay right.
    for (expected, came) in differing.into_iter().rev() {
        let new = match expected.is_cell {
            true => vec![with_last_cell(&lines[expected.lines.start], came)],
            false => came.lines().map(str::to_owned).collect(),
        };
        lines.splice(expected.lines.clone(), new);
    }
    lines.join("\n") + "\n"
}

#[cfg(test)]
#[path = "examples_tests.rs"]
mod tests;
