//! A table of plain text whose columns are as wide as their widest cells, in pieces that fit a terminal.

use anstyle::Style;
use std::fmt::Display;
use std::io::{self, Write};
use std::ops::Range;
use stickler_types::shortened;

/// The number of spaces between two columns, where nothing else is asked for.
const GAP: usize = 2;

/// The minimum width to which the first column is shortened.
const MIN_FIRST: usize = 24;

/// The alignment of a cell in its column.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Alignment {
    /// The text stands at the beginning.
    Left,
    /// The text stands at the end, as numbers do.
    Right,
}

/// A cell of a table.
#[derive(Clone, Debug)]
pub struct Cell {
    /// The parts of the text, each with its style.
    pieces: Vec<(String, Style)>,
    align: Alignment,
}

impl Cell {
    /// Creates a cell with pieces of text, each in a style of its own.
    pub const fn new(pieces: Vec<(String, Style)>, align: Alignment) -> Cell {
        Cell { pieces, align }
    }

    /// Creates a cell with text, aligned left.
    pub fn left(text: impl Display) -> Cell {
        Cell::new(vec![(text.to_string(), Style::new())], Alignment::Left)
    }

    /// Creates a cell with a number, aligned right.
    pub fn plain(text: impl Display) -> Cell {
        Cell::styled(text, Style::new())
    }

    /// Creates a cell with a number in a style, aligned right.
    pub fn styled(text: impl Display, style: Style) -> Cell {
        Cell::new(vec![(text.to_string(), style)], Alignment::Right)
    }

    fn is_blank(&self) -> bool {
        self.pieces.iter().all(|(text, _)| text.trim().is_empty())
    }

    fn width(&self) -> usize {
        self.pieces.iter().map(|(text, _)| text.chars().count()).sum()
    }
}

/// A table: lines of a head, and rows; a row may be shorter than the head.
pub struct Table {
    head: Vec<Vec<Cell>>,
    rows: Vec<Vec<Cell>>,
    /// The number of columns that are repeated in every piece.
    left: usize,
    gap: usize,
    /// Whether the first column may be shortened.
    is_elastic: bool,
}

impl Table {
    /// Creates a table without rows, whose first column is shortened where the table is too wide.
    pub fn new(head: Vec<Cell>) -> Table {
        Table {
            is_elastic: true,
            ..Table::of_values(vec![head], 1, GAP)
        }
    }

    /// Creates a table without rows from the lines of its head. Every piece of it begins with the `left` first columns, which are not
    /// shortened; `gap` is the number of spaces between two columns.
    pub const fn of_values(head: Vec<Vec<Cell>>, left: usize, gap: usize) -> Table {
        Table {
            head,
            rows: Vec::new(),
            left,
            gap,
            is_elastic: false,
        }
    }

    /// Adds a column with this head.
    pub fn head(&mut self, cell: Cell) {
        if let Some(line) = self.head.last_mut() {
            line.push(cell);
        }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: Vec<Cell>) {
        self.rows.push(cells);
    }

    /// Writes the table, the head in bold. A table that is wider than `columns` stands in several pieces, which all begin with the first
    /// columns.
    ///
    /// # Errors
    /// Returns the error of writing to `out`.
    pub fn write(&self, out: &mut dyn Write, columns: Option<usize>) -> io::Result<()> {
        let mut widths = self.widths();
        let columns = columns.unwrap_or(usize::MAX);
        if let ([first, rest @ ..], true) = (&mut widths[..], self.is_elastic) {
            let others: usize = rest.iter().map(|width| self.gap + width).sum();
            let room = columns.saturating_sub(others).max(MIN_FIRST);
            *first = room.min(*first);
        }
        for (number, piece) in self.pieces(&widths, columns).into_iter().enumerate() {
            if number > 0 {
                writeln!(out)?;
            }
            // A line of the head may be about other columns only.
            let is_shown = |line: &&Vec<Cell>| {
                self.columns(&piece, &widths)
                    .any(|column| line.get(column).is_some_and(|cell| !cell.is_blank()))
            };
            for line in self.head.iter().filter(is_shown) {
                self.write_line(out, line, (&widths, &piece), Style::bold)?;
            }
            for row in &self.rows {
                self.write_line(out, row, (&widths, &piece), |style| style)?;
            }
        }
        Ok(())
    }

    /// Returns the width of each column: of its widest cell.
    fn widths(&self) -> Vec<usize> {
        let lines = || self.head.iter().chain(&self.rows);
        let columns = lines().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let cells = lines().filter_map(|row| row.get(column));
            cells.map(Cell::width).max().unwrap_or(0)
        };
        (0..columns).map(width).collect()
    }

    /// Divides the columns after the first ones into ranges that fit beside these; a column that is too wide stands alone.
    fn pieces(&self, widths: &[usize], columns: usize) -> Vec<Range<usize>> {
        let left = self.left.min(widths.len());
        let beside: usize = widths[..left].iter().map(|width| width + self.gap).sum();
        let mut pieces = Vec::new();
        let (mut start, mut used) = (left, beside);
        for (column, width) in widths.iter().enumerate().skip(left) {
            if used + width > columns && column > start {
                pieces.push(start..column);
                (start, used) = (column, beside);
            }
            used += width + self.gap;
        }
        pieces.push(start..widths.len());
        pieces
    }

    /// Returns the columns of a piece: the first ones and a range of the others.
    fn columns(&self, piece: &Range<usize>, widths: &[usize]) -> impl Iterator<Item = usize> + use<> {
        (0..self.left.min(widths.len())).chain(piece.clone())
    }

    /// Writes the first columns and a range of the others, without blanks at the end of the line.
    fn write_line(
        &self,
        out: &mut dyn Write,
        row: &[Cell],
        (widths, piece): (&[usize], &Range<usize>),
        styled: fn(Style) -> Style,
    ) -> io::Result<()> {
        // Blanks are written before the text that follows them.
        let mut blanks = 0;
        for (number, column) in self.columns(piece, widths).enumerate() {
            blanks += if number == 0 { 0 } else { self.gap };
            let width = widths[column];
            let Some(cell) = row.get(column) else {
                blanks += width;
                continue;
            };
            let padding = width.saturating_sub(cell.width());
            blanks += if cell.align == Alignment::Right {
                padding
            } else {
                0
            };
            for (text, style) in &cell.pieces {
                let text = shortened(text, width);
                let end = text.trim_end();
                if !end.is_empty() {
                    let style = styled(*style);
                    write!(out, "{:blanks$}{style}{end}{style:#}", "")?;
                    blanks = 0;
                }
                blanks += text.chars().count() - end.chars().count();
            }
            blanks += if cell.align == Alignment::Left { padding } else { 0 };
        }
        writeln!(out)
    }
}
