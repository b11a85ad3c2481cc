//! Reads a Markdown file: its sections, with their fenced blocks and the rows of their tables.

use std::ops::Range;

/// A mistake in a file: its line, from 1, and what is wrong.
pub type Mistake = (usize, String);

/// A fenced block of a file.
#[derive(Clone, Debug)]
pub struct Fence {
    /// What stands behind the fence.
    pub info: String,
    /// The text between the fences, without its last line feed.
    pub text: String,
    /// The lines of the text, from 0.
    pub(crate) lines: Range<usize>,
}

impl Fence {
    /// Returns the last word behind the fence, before which a language may stand.
    pub(crate) fn name(&self) -> &str {
        self.info.split_whitespace().next_back().unwrap_or_default()
    }
}

/// What stands below a heading, up to the next.
#[derive(Default)]
pub struct Section {
    /// The number of signs before the heading.
    pub level: usize,
    /// The heading.
    pub heading: String,
    /// The line of the heading, from 1.
    pub line: usize,
    /// The fenced blocks.
    pub blocks: Vec<Fence>,
    /// The rows of the tables.
    pub rows: Vec<Row>,
}

/// A row of a table.
pub struct Row {
    /// The line of the row, from 0.
    pub line: usize,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The texts of the cells; `\|` is no end of a cell.
    pub cells: Vec<String>,
}

/// Returns the sections of a text; the first is that of the title, if there is one, with what stands above it.
///
/// # Errors
///
/// Where a block has no end: its line and what is wrong.
pub fn sections(text: &str) -> Result<Vec<Section>, Mistake> {
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
            section.blocks.push(Fence {
                info: line[fence..].trim().to_owned(),
                text: lines[at..at + len].join("\n"),
                lines: at..at + len,
            });
            at += len + 1;
        } else if line.starts_with("# ") || line.starts_with("##") {
            let text = line.trim_start_matches('#');
            let level = line.len() - text.len();
            if section.level > 0 || level > 1 {
                sections.push(Section::default());
            }
            if let Some(section) = sections.last_mut() {
                (section.level, section.line) = (level, number + 1);
                section.heading = text.trim().to_owned();
            }
        } else if line.starts_with('|') {
            let cells = cells(line);
            let is_rule =
                |cell: &String| !cell.is_empty() && cell.bytes().all(|byte| matches!(byte, b'-' | b':'));
            match &columns {
                _ if cells.iter().all(is_rule) => {}
                None => columns = Some(cells),
                Some(columns) => section.rows.push(Row {
                    line: number,
                    columns: columns.clone(),
                    cells,
                }),
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
