//! Writes a table of values with a note behind each, in pieces that fit a terminal.

use anstyle::Style;
use std::io::{self, Write};

const BOLD: Style = Style::new().bold();

/// The maximum width of a table and of the lines below it, in characters.
pub const WIDTH: usize = 100;

/// The number of blanks between two columns.
const GAP: usize = 2;

/// The alignment of the values of a column.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Align {
    Left,
    Right,
}

/// The content of one cell.
pub struct NotedCell {
    /// The value.
    pub value: String,
    /// The note behind the value: a letter, and a mark; may be empty.
    pub note: String,
    /// The style of value and note where there is colour.
    pub style: Style,
}

/// A column of a table: its head in one or more lines, and a cell for each row.
pub struct Column {
    /// The lines of the head.
    pub head: Vec<String>,
    /// The cells, one for each row.
    pub cells: Vec<NotedCell>,
    /// The alignment of the values.
    pub align: Align,
}

impl Column {
    fn value_width(&self) -> usize {
        self.cells
            .iter()
            .map(|cell| width(&cell.value))
            .max()
            .unwrap_or(0)
    }

    fn note_width(&self) -> usize {
        let widest = self.cells.iter().map(|cell| width(&cell.note)).max();
        // A note keeps a blank between itself and its value.
        widest.map_or(0, |widest| if widest > 0 { widest + 1 } else { 0 })
    }

    fn width(&self) -> usize {
        let head = self.head.iter().map(|line| width(line)).max().unwrap_or(0);
        head.max(self.value_width() + self.note_width())
    }

    /// Returns a line of the head, padded to the width of the column.
    fn head_line(&self, index: usize) -> String {
        let text = self.head.get(index).map_or("", String::as_str);
        padded(text, self.width(), self.align)
    }

    /// Returns a cell, padded to the width of the column, and its style.
    fn cell(&self, row: usize) -> (String, Style) {
        let Some(cell) = self.cells.get(row) else {
            return (" ".repeat(self.width()), Style::new());
        };
        let value = padded(&cell.value, self.value_width(), self.align);
        let note_width = self.note_width();
        let note = match note_width {
            0 => String::new(),
            _ => format!(" {}", padded(&cell.note, note_width - 1, Align::Left)),
        };
        (
            padded(&format!("{value}{note}"), self.width(), self.align),
            cell.style,
        )
    }
}

/// Writes a table in pieces; the `left` columns are repeated in every piece.
///
/// # Errors
/// Errors of writing to `out`.
pub fn write(left: &[Column], columns: &[Column], out: &mut dyn Write) -> io::Result<()> {
    let start: usize = left.iter().map(|column| column.width() + GAP).sum();
    for (index, piece) in pieces(start, columns).into_iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        write_piece(left, piece, out)?;
    }
    Ok(())
}

/// Divides columns into pieces of at most [`WIDTH`] characters; each piece has at least one column.
fn pieces(start: usize, columns: &[Column]) -> Vec<&[Column]> {
    let mut pieces = Vec::new();
    let (mut first, mut used) = (0, start);
    for (index, column) in columns.iter().enumerate() {
        let needed = column.width() + GAP;
        if index > first && used + needed - GAP > WIDTH {
            pieces.push(&columns[first..index]);
            (first, used) = (index, start);
        }
        used += needed;
    }
    pieces.push(&columns[first..]);
    pieces
}

fn write_piece(left: &[Column], columns: &[Column], out: &mut dyn Write) -> io::Result<()> {
    let all = || left.iter().chain(columns);
    let head_lines = all().map(|column| column.head.len()).max().unwrap_or(0);
    for index in 0..head_lines {
        let cells = all().map(|column| (column.head_line(index), BOLD));
        write_line(cells.collect(), out)?;
    }
    let rows = all().map(|column| column.cells.len()).max().unwrap_or(0);
    for row in 0..rows {
        write_line(all().map(|column| column.cell(row)).collect(), out)?;
    }
    Ok(())
}

/// Writes cells as a line, without blanks at its end.
fn write_line(mut cells: Vec<(String, Style)>, out: &mut dyn Write) -> io::Result<()> {
    while cells.last().is_some_and(|(text, _)| text.trim().is_empty()) {
        cells.pop();
    }
    let last = cells.len().saturating_sub(1);
    for (index, (text, style)) in cells.iter().enumerate() {
        let text = if index == last { text.trim_end() } else { text };
        let blanks = text.len() - text.trim_start().len();
        write!(out, "{:blanks$}{style}{}{style:#}", "", &text[blanks..])?;
        if index < last {
            write!(out, "{:GAP$}", "")?;
        }
    }
    writeln!(out)
}

fn width(text: &str) -> usize {
    text.chars().count()
}

fn padded(text: &str, to: usize, align: Align) -> String {
    let missing = to.saturating_sub(width(text));
    match align {
        Align::Left => format!("{text}{:missing$}", ""),
        Align::Right => format!("{:missing$}{text}", ""),
    }
}

#[cfg(test)]
mod tests {
    use super::{Align, Column, NotedCell, write};
    use anstyle::Style;

    fn column(head: &[&str], cells: &[(&str, &str)], align: Align) -> Column {
        let cell = |(value, note): &(&str, &str)| NotedCell {
            value: (*value).to_owned(),
            note: (*note).to_owned(),
            style: Style::new(),
        };
        Column {
            head: head.iter().map(|&line| line.to_owned()).collect(),
            cells: cells.iter().map(cell).collect(),
            align,
        }
    }

    fn text(left: &[Column], columns: &[Column]) -> String {
        let mut bytes = Vec::new();
        write(left, columns, &mut bytes).unwrap();
        anstream::adapter::strip_str(&String::from_utf8(bytes).unwrap()).to_string()
    }

    #[test]
    fn numbers_stand_below_each_other_with_their_notes_behind_them() {
        let left = column(&["REAL"], &[("2.5", ""), ("-10.0", "")], Align::Right);
        let right = column(&["matiec", "plcnext"], &[("2", "a"), ("-10", "b!")], Align::Right);
        let shown = text(&[left], &[right]);
        let expected = " REAL   matiec\n       plcnext\n  2.5     2 a\n-10.0   -10 b!\n";
        assert_eq!(shown, expected);
    }

    #[test]
    fn columns_that_do_not_fit_stand_below_with_the_inputs_again() {
        let wide = || column(&["x"], &[(&"9".repeat(60), "a")], Align::Left);
        let left = column(&["in"], &[("1", "")], Align::Right);
        let shown = text(&[left], &[wide(), wide()]);
        assert_eq!(shown.matches("in").count(), 2, "{shown}");
        assert!(
            shown
                .lines()
                .all(|line| line.len() <= 100 && !line.ends_with(' ')),
            "{shown}"
        );
    }
}
