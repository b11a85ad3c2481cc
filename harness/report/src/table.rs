//! A table of plain text whose columns are as wide as their widest cells.

use anstyle::Style;
use std::fmt::Display;
use std::io::{self, Write};

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

    /// Writes the table, the head in bold.
    ///
    /// # Errors
    /// Returns the error of writing to `out`.
    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let lines = || std::iter::once(&self.head).chain(&self.rows);
        let columns = lines().map(Vec::len).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns)
            .map(|column| {
                lines()
                    .filter_map(|row| row.get(column))
                    .map(Cell::width)
                    .max()
                    .unwrap_or(0)
            })
            .collect();
        for (number, row) in lines().enumerate() {
            for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
                let style = if number == 0 {
                    cell.style.bold()
                } else {
                    cell.style
                };
                let gap = if column == 0 { "" } else { "  " };
                let padding = width - cell.width();
                match cell.align {
                    Alignment::Left => write!(out, "{gap}{style}{}{style:#}{:padding$}", cell.text, "")?,
                    Alignment::Right => write!(out, "{gap}{:padding$}{style}{}{style:#}", "", cell.text)?,
                }
            }
            writeln!(out)?;
        }
        Ok(())
    }
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
        table.write(&mut bytes).expect("written");
        let text = String::from_utf8(bytes).expect("text");
        let bare = text
            .replace("\u{1b}[1m", "")
            .replace("\u{1b}[4m", "")
            .replace("\u{1b}[0m", "");
        assert_eq!(bare, "Claims     ok\na       12345\n");
    }
}
