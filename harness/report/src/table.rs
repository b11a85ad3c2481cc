//! A table of plain text whose columns are as wide as their widest cells.

use anstyle::Style;
use std::fmt::Display;
use std::io::{self, Write};
use std::ops::Range;
use stickler_types::shortened;

/// The number of spaces between two columns.
const GAP: usize = 2;

/// The minimum width to which the first column is shortened.
const MIN_FIRST: usize = 24;

/// The alignment of a cell in its column.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Alignment {
    Left,
    Right,
}

/// A cell of a table.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    text: String,
    style: Style,
    align: Alignment,
}

impl Cell {
    /// Creates a cell with text, aligned left.
    pub(crate) fn left(text: impl Display) -> Cell {
        Cell {
            text: text.to_string(),
            style: Style::new(),
            align: Alignment::Left,
        }
    }

    /// Creates a cell with a number, aligned right.
    pub(crate) fn plain(text: impl Display) -> Cell {
        Cell::styled(text, Style::new())
    }

    /// Creates a cell with a number in a style, aligned right.
    pub(crate) fn styled(text: impl Display, style: Style) -> Cell {
        Cell {
            text: text.to_string(),
            style,
            align: Alignment::Right,
        }
    }

    fn width(&self) -> usize {
        self.text.chars().count()
    }
}

/// A table: a head and rows; a row may be shorter than the head.
pub(crate) struct AlignedTable {
    head: Vec<Cell>,
    rows: Vec<Vec<Cell>>,
}

impl AlignedTable {
    /// Creates a table without rows.
    pub(crate) fn new(head: Vec<Cell>) -> AlignedTable {
        AlignedTable {
            head,
            rows: Vec::new(),
        }
    }

    /// Adds a column with this head.
    pub(crate) fn head(&mut self, cell: Cell) {
        self.head.push(cell);
    }

    /// Adds a row.
    pub(crate) fn row(&mut self, cells: Vec<Cell>) {
        self.rows.push(cells);
    }

    /// Writes the table, the head in bold. A table that is wider than `columns` gets a shorter first column, and where that is not
    /// enough, stands in several pieces, which all begin with the first column.
    ///
    /// # Errors
    /// Returns the error of writing to `out`.
    pub(crate) fn write(&self, out: &mut dyn Write, columns: Option<usize>) -> io::Result<()> {
        let mut widths = self.widths();
        let columns = columns.unwrap_or(usize::MAX);
        if let [first, rest @ ..] = &mut widths[..] {
            let others: usize = rest.iter().map(|width| GAP + width).sum();
            let room = columns.saturating_sub(others).max(MIN_FIRST);
            *first = room.min(*first);
        }
        for (number, piece) in pieces(&widths, columns).into_iter().enumerate() {
            if number > 0 {
                writeln!(out)?;
            }
            self.write_piece(out, &widths, piece)?;
        }
        Ok(())
    }

    fn lines(&self) -> impl Iterator<Item = &Vec<Cell>> {
        std::iter::once(&self.head).chain(&self.rows)
    }

    /// Returns the width of each column: of its widest cell.
    fn widths(&self) -> Vec<usize> {
        let columns = self.lines().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let cells = self.lines().filter_map(|row| row.get(column));
            cells.map(Cell::width).max().unwrap_or(0)
        };
        (0..columns).map(width).collect()
    }

    /// Writes the first column and a range of the others.
    fn write_piece(&self, out: &mut dyn Write, widths: &[usize], piece: Range<usize>) -> io::Result<()> {
        for (number, row) in self.lines().enumerate() {
            for column in [0].into_iter().chain(piece.clone()) {
                let (Some(cell), Some(width)) = (row.get(column), widths.get(column)) else {
                    continue;
                };
                let style = if number == 0 {
                    cell.style.bold()
                } else {
                    cell.style
                };
                let gap = if column == 0 { 0 } else { GAP };
                let text = shortened(&cell.text, *width);
                let padding = width - text.chars().count();
                match cell.align {
                    Alignment::Left => write!(out, "{:gap$}{style}{text}{style:#}{:padding$}", "", "")?,
                    Alignment::Right => write!(out, "{:gap$}{:padding$}{style}{text}{style:#}", "", "")?,
                }
            }
            writeln!(out)?;
        }
        Ok(())
    }
}

/// Divides the columns after the first into ranges that fit beside it; a column that is too wide stands alone.
fn pieces(widths: &[usize], columns: usize) -> Vec<Range<usize>> {
    let first = widths.first().copied().unwrap_or(0);
    let mut pieces = Vec::new();
    let (mut start, mut used) = (1, first);
    for (column, width) in widths.iter().enumerate().skip(1) {
        if used + GAP + width > columns && column > start {
            pieces.push(start..column);
            (start, used) = (column, first);
        }
        used += GAP + width;
    }
    pieces.push(start..widths.len());
    pieces
}

#[cfg(test)]
mod tests {
    use super::{AlignedTable, Cell};
    use anstyle::Style;

    #[test]
    fn columns_are_as_wide_as_their_widest_cell_and_styles_take_no_room() {
        let mut table = AlignedTable::new(vec![Cell::left("Claims"), Cell::plain("ok")]);
        table.row(vec![
            Cell::left("a"),
            Cell::styled(12345, Style::new().underline()),
        ]);
        let mut bytes = Vec::new();
        table.write(&mut bytes, None).expect("written");
        let text = String::from_utf8(bytes).expect("text");
        let bare = text
            .replace("\u{1b}[1m", "")
            .replace("\u{1b}[4m", "")
            .replace("\u{1b}[0m", "");
        assert_eq!(bare, "Claims     ok\na       12345\n");
    }
    #[test]
    fn a_table_that_is_too_wide_shortens_its_first_column_and_then_stands_in_pieces() {
        let mut table = AlignedTable::new(vec![Cell::left("Claims")]);
        for head in ["one", "two", "three"] {
            table.head(Cell::plain(head));
        }
        let name = "a-name-of-thirty-characters-ab";
        table.row(
            [Cell::left(name)]
                .into_iter()
                .chain([1, 2, 3].map(Cell::plain))
                .collect(),
        );
        let shown = |columns| {
            let mut bytes = Vec::new();
            table.write(&mut bytes, columns).expect("written");
            anstream::adapter::strip_str(&String::from_utf8(bytes).expect("text")).to_string()
        };
        assert!(
            shown(Some(47)).contains("characters-ab    1    2      3\n"),
            "{}",
            shown(Some(47))
        );
        assert!(
            shown(Some(45)).contains("a-name-of-thirty-characters…    1    2      3\n"),
            "{}",
            shown(Some(45))
        );
        let narrow = "\
Claims                    one  two
a-name-of-thirty-charac…    1    2

Claims                    three
a-name-of-thirty-charac…      3
";
        assert_eq!(shown(Some(35)), narrow);
    }
}
