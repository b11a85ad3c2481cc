//! Reads a Markdown file of examples.

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
pub(crate) struct Expected {
    pub(crate) text: String,
    /// The lines of the file that hold it, from 0: those of a block, or that of a row.
    pub(crate) lines: Range<usize>,
    /// Whether it is the last cell of a row.
    pub(crate) is_cell: bool,
}

/// The examples of a file, in order.
pub(crate) struct Document {
    pub(crate) examples: Vec<(Example, Expected)>,
}

/// A mistake in a file: its line, from 1, and what is wrong.
type Mistake = (usize, String);

/// A block of code.
#[derive(Clone, Debug)]
struct Block {
    name: String,
    text: String,
    lines: Range<usize>,
}

/// A section while it is read.
#[derive(Default)]
struct Section {
    heading: String,
    line: usize,
    blocks: Vec<Block>,
    /// The rows of tables, each with its line and the names of the columns.
    rows: Vec<(usize, Vec<String>, Vec<String>)>,
}

impl Example {
    /// Returns the heading of the section.
    #[must_use]
    pub fn heading(&self) -> &str {
        &self.heading
    }

    /// Returns the name of what must come: that of the last block, or of the last column.
    #[must_use]
    pub fn wanted(&self) -> &str {
        &self.wanted
    }

    /// Returns the input of a name, if there is one.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&str> {
        let found = self.inputs.iter().find(|(known, _)| known == name);
        found.map(|(_, text)| text.as_str())
    }

    /// Returns the input of a name; an empty text if there is none.
    #[must_use]
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
    pub(crate) fn parse(text: &str) -> Result<Document, Mistake> {
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
    fn add(&mut self, section: &Section, shared: &[Block]) -> Result<(), Mistake> {
        let example = |own: &[Block], cells: Vec<(String, String)>, wanted: &str| {
            let of_file = shared
                .iter()
                .filter(|block| own.iter().all(|own| own.name != block.name));
            let blocks = own.iter().chain(of_file);
            let blocks = blocks.map(|block| (block.name.clone(), block.text.clone()));
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
            let example = example(inputs, Vec::new(), &expected.name).map_err(|what| (section.line, what))?;
            let expected = Expected {
                text: expected.text.clone(),
                lines: expected.lines.clone(),
                is_cell: false,
            };
            self.examples.push((example, expected));
        }
        for (line, columns, cells) in &section.rows {
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

/// Returns the sections of a text; the first is what stands above all others.
fn sections(text: &str) -> Result<Vec<Section>, Mistake> {
    let lines: Vec<&str> = text.lines().collect();
    let mut sections = vec![Section::default()];
    let mut columns: Option<Vec<String>> = None;
    let mut at = 0;
    while let Some(&line) = lines.get(at) {
        let number = at;
        at += 1;
        let Some(section) = sections.last_mut() else { break };
        let fence = line.len() - line.trim_start_matches('`').len();
        if fence >= 3 {
            let is_end = |line: &&str| line.len() >= fence && line.bytes().all(|byte| byte == b'`');
            let Some(len) = lines[at..].iter().position(is_end) else {
                return Err((number + 1, "the block has no end".to_owned()));
            };
            let name = line[fence..].split_whitespace().next_back().unwrap_or_default();
            section.blocks.push(Block {
                name: name.to_owned(),
                text: lines[at..at + len].join("\n"),
                lines: at..at + len,
            });
            at += len + 1;
        } else if let Some(title) = line.strip_prefix("# ") {
            section.heading = title.trim().to_owned();
        } else if line.starts_with("##") {
            sections.push(Section {
                heading: line.trim_start_matches('#').trim().to_owned(),
                line: number + 1,
                ..Section::default()
            });
        } else if line.starts_with('|') {
            let cells = cells(line);
            let is_rule =
                |cell: &String| !cell.is_empty() && cell.bytes().all(|byte| matches!(byte, b'-' | b':'));
            match &columns {
                _ if cells.iter().all(is_rule) => {}
                None => columns = Some(cells),
                Some(columns) => section.rows.push((number, columns.clone(), cells)),
            }
        }
        if !line.starts_with('|') {
            columns = None;
        }
    }
    Ok(sections)
}

/// Returns the texts of the cells of a row.
fn cells(line: &str) -> Vec<String> {
    let inside = line.trim_end().strip_suffix('|').unwrap_or(line);
    let mut cells = vec![String::new()];
    let mut characters = inside.chars().skip(1).peekable();
    while let Some(character) = characters.next() {
        match (character, cells.last_mut()) {
            ('\\', Some(cell)) if characters.peek() == Some(&'|') => {
                characters.next();
                cell.push('|');
            }
            ('|', _) => cells.push(String::new()),
            (other, Some(cell)) => cell.push(other),
            (_, None) => {}
        }
    }
    cells.iter().map(|cell| plain(cell.trim())).collect()
}

/// Returns the text of a cell without the backticks around the whole of it, and with its line breaks.
fn plain(cell: &str) -> String {
    let inside = cell.strip_prefix('`').and_then(|rest| rest.strip_suffix('`'));
    let inside = inside.filter(|inside| !inside.contains('`')).unwrap_or(cell);
    inside.replace('⏎', "\n")
}

/// Returns a row with another last cell.
pub(crate) fn with_last_cell(line: &str, text: &str) -> String {
    let text = text.replace('|', "\\|").replace('\n', "⏎");
    let inside = line.trim_end().strip_suffix('|').unwrap_or(line);
    let mut bars = inside.match_indices('|').map(|(at, _)| at);
    let last = bars.rfind(|&at| !inside[..at].ends_with('\\')).unwrap_or(0);
    format!("{}| {text} |", &inside[..last])
}
