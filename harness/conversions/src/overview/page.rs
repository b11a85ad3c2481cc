//! The overview as a page of text: tables of results, contradictions to documents, choices of the dialects, and a legend.

use super::choices;
use super::results::{ComparedResult, DialectResults, ExpectedResult, SignatureResults};
use super::values::{CallOperands, MAX_VALUE_LEN};
use crate::functions::{dialect_list, short_names};
use crate::session::RefusalKind;
use crate::table::{Alignment, Cell, Table};
use anstyle::{AnsiColor, Style};
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::sync::Arc;
use stickler_engines::Identity;
use stickler_types::{DialectName, ElementaryType, Family, Value, join};
use stickler_types::{PrintedResult, distinct, grouped_by, shortened, sorted, wrap, wrap_within};

/// The maximum width of a table and of the lines below it, in characters.
pub(super) const WIDTH: usize = 100;

/// The number of spaces between two columns.
const GAP: usize = 2;

const BOLD: Style = Style::new().bold();
const DIM: Style = Style::new().dimmed();
const BAD: Style = AnsiColor::Red.on_default().bold();

/// The note of a cell about which no source in Stickler says anything.
const OPEN: &str = "?";

/// The mark of a cell of which two sources of one system state different values.
const DISPUTED: &str = "≠";

/// The maximum number of contradictions that are described below a table.
const MAX_TROUBLES: usize = 8;

/// The heading of the dialects' rules where other engines than the reference were asked, which need not follow the rules.
const RULES: &str = "Stickler's rule for each dialect, which an engine may or may not follow:";

/// The number of tables beyond which the page tells how to show one of them alone.
const MANY: usize = 3;

/// The magnitude from which on a real is shown with an exponent, since its digits would be too many to read.
const LARGE: f64 = 1e16;

/// The page that shows what a function gives.
pub struct OverviewPage<'p> {
    /// The results, one table for each signature.
    pub results: &'p [SignatureResults],
    /// What sources print of the function where no case holds it.
    pub printed: &'p [PrintedResult],
    /// The requested dialects that lack the function.
    pub lacking: &'p [DialectName],
    /// The engines that were asked.
    pub engines: &'p [&'p Identity],
    /// Whether no engine but the reference was asked, which follows the rules that are listed below a table; others may be recorded.
    pub only_reference: bool,
    /// Gives a basis with the publisher of its source where that is not the maker.
    pub attributed: &'p dyn Fn(&str) -> String,
}

impl OverviewPage<'_> {
    /// Writes the page.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut notes = Footnotes::default();
        for results in self.results {
            self.write_signature(results, &mut notes, out)?;
            writeln!(out)?;
        }
        self.write_printed(&mut notes, out)?;
        notes.write(self.attributed, out)?;
        let Some(first) = self.results.first() else {
            return Ok(());
        };
        let function = &first.signature.function;
        if !self.lacking.is_empty() {
            writeln!(out, "There is no {function} in {}.", dialect_list(self.lacking))?;
        }
        if self.results.len() > MANY {
            let example = first.calls.first().and_then(|call| call.first());
            writeln!(
                out,
                "{function} takes several types; a typed value, such as {}, shows one of them alone.",
                example.map_or(String::new(), ToString::to_string)
            )?;
        }
        Ok(())
    }

    /// Writes what sources print: a row for each call, a column for each source.
    fn write_printed(&self, notes: &mut Footnotes, out: &mut dyn Write) -> io::Result<()> {
        let once = |of: fn(&PrintedResult) -> &String| self.printed.iter().map(of).collect::<BTreeSet<_>>();
        let sources = once(|printed| &printed.source);
        let mut head = vec![Cell::left("printed, and no case")];
        head.extend(sources.iter().map(Cell::left));
        let mut table = Table::of_values(vec![head], 1, GAP);
        for call in once(|printed| &printed.call) {
            let mut row = vec![Cell::left(call)];
            for source in &sources {
                let is_here = |one: &&PrintedResult| one.source == **source && one.call == *call;
                let found = self.printed.iter().find(is_here);
                let cell = found.map(|one| format!("{} {}", one.result, notes.letter(&one.basis)));
                row.push(Cell::left(cell.unwrap_or_default()));
            }
            table.row(row);
        }
        if self.printed.is_empty() {
            return Ok(());
        }
        table.write(out, Some(WIDTH))?;
        writeln!(out)
    }

    fn write_signature(
        &self,
        results: &SignatureResults,
        notes: &mut Footnotes,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let signature = &results.signature;
        let engines: Vec<String> = self.engines.iter().map(|identity| title(identity)).collect();
        let name = signature.to_string();
        let on = format!("on {}", engines.join(", "));
        match name.len() + on.len() + 2 > WIDTH {
            true => writeln!(out, "{BOLD}{name}{BOLD:#}\n{}\n", wrap_within(&on, WIDTH))?,
            false => writeln!(out, "{BOLD}{name}{BOLD:#}  {on}\n")?,
        }
        let mut columns = operands(&results.calls, &signature.operands);
        // Columns of the same engine whose results are all equal are one.
        let same = |one: &&DialectResults, other: &&DialectResults| {
            one.engine == other.engine && one.results == other.results
        };
        for group in grouped_by(&results.columns, same) {
            columns.push(self.column(&group, signature.result, notes));
        }
        table(&columns, signature.operands.len()).write(out, Some(WIDTH))?;
        self.write_troubles(results, out)?;
        if choices::any(signature) {
            let dialects = sorted(results.columns.iter().map(|column| column.dialect));
            writeln!(out)?;
            if !self.only_reference || self.engines.len() > 1 {
                writeln!(out, "{RULES}")?;
            }
            choices::write(signature, &dialects, out)?;
        }
        Ok(())
    }

    /// Returns the table column of a group of dialects whose results are equal.
    fn column(&self, group: &[&DialectResults], result: ElementaryType, notes: &mut Footnotes) -> Column {
        let first = group.first();
        let engine = first.and_then(|column| match self.engines {
            [_] => None,
            // The first engine is the reference, and the others are recorded.
            _ if self.only_reference && column.engine == 0 => None,
            engines => engines.get(column.engine).map(|identity| identity.name.clone()),
        });
        let dialects: Vec<DialectName> = group.iter().map(|column| column.dialect).collect();
        let shown = |compared: &ComparedResult| NotedCell {
            value: match &compared.got {
                Ok(value) => untyped(value, result),
                Err(refusal) => refusal.kind.word().to_owned(),
            },
            note: match &compared.got {
                Err(refusal) if refusal.kind == RefusalKind::NotAsked => String::new(),
                _ => notes.of(compared),
            },
            style: match (compared.contradicts(), &compared.expected.basis) {
                (true, _) => BAD,
                (false, None) => DIM,
                (false, Some(_)) => Style::new(),
            },
        };
        Column {
            head: engine.into_iter().chain(short_names(&dialects)).collect(),
            cells: first.map_or(Vec::new(), |column| column.results.iter().map(shown).collect()),
            align: align(result),
        }
    }

    /// Writes a sentence for each result that contradicts a document or that the engine did not give, up to [`MAX_TROUBLES`].
    fn write_troubles(&self, results: &SignatureResults, out: &mut dyn Write) -> io::Result<()> {
        let name = |column: &DialectResults| match self.engines {
            [_] => column.dialect.to_string(),
            engines => engines.get(column.engine).map_or(String::new(), |identity| {
                format!("{} in {}", identity.name, column.dialect)
            }),
        };
        let function = &results.signature.function;
        let mut troubles = Vec::new();
        for column in &results.columns {
            for (call, compared) in results.calls.iter().zip(&column.results) {
                let call = format!("{function}({})", join(call.iter().map(in_words), ", "));
                if let Some(trouble) = trouble(compared) {
                    troubles.push(format!("{}: {call} {trouble}", name(column)));
                }
                let disputed = disputed(&compared.expected);
                troubles.extend(disputed.map(|disputed| format!("{}: {call} {disputed}", column.dialect)));
            }
        }
        // What two sources say of a dialect is said once, however many engines speak it.
        let troubles = distinct(troubles);
        if troubles.is_empty() {
            return Ok(());
        }
        writeln!(out)?;
        for trouble in troubles.iter().take(MAX_TROUBLES) {
            writeln!(out, "{}", wrap(trouble))?;
        }
        match troubles.len().saturating_sub(MAX_TROUBLES) {
            0 => Ok(()),
            more => writeln!(out, "... and {more} more"),
        }
    }
}

/// The content of one cell of a table.
struct NotedCell {
    value: String,
    /// The note behind the value: a letter, and a mark; may be empty.
    note: String,
    style: Style,
}

/// A column of a table: its head in one or more lines, and a cell for each row.
struct Column {
    head: Vec<String>,
    cells: Vec<NotedCell>,
    align: Alignment,
}

impl Column {
    /// Returns the cells, in which values stand below values and notes below notes.
    fn aligned(&self) -> impl Iterator<Item = Cell> {
        let width = |text: fn(&NotedCell) -> &str| {
            let cells = self.cells.iter().map(text);
            cells.map(|text| text.chars().count()).max().unwrap_or(0)
        };
        let (values, notes) = (width(|cell| &cell.value), width(|cell| &cell.note));
        self.cells.iter().map(move |NotedCell { value, note, style }| {
            let value = match self.align {
                Alignment::Left => format!("{value:values$}"),
                Alignment::Right => format!("{value:>values$}"),
            };
            let note = if notes == 0 {
                String::new()
            } else {
                format!(" {note:notes$}")
            };
            Cell::new(vec![(value + &note, *style)], self.align)
        })
    }
}

/// Returns the table of columns, of which the first `left` are operands.
fn table(columns: &[Column], left: usize) -> Table {
    let lines = columns.iter().map(|column| column.head.len()).max().unwrap_or(0);
    let head = |line: usize| {
        let text = |column: &Column| column.head.get(line).cloned().unwrap_or_default();
        let cells = columns
            .iter()
            .map(|column| Cell::new(vec![(text(column), Style::new())], column.align));
        cells.collect()
    };
    let mut table = Table::of_values((0..lines).map(head).collect(), left, GAP);
    let mut cells: Vec<_> = columns.iter().map(Column::aligned).collect();
    let rows = columns.first().map_or(0, |column| column.cells.len());
    for _ in 0..rows {
        table.row(cells.iter_mut().filter_map(Iterator::next).collect());
    }
    table
}

/// The footnotes of the page: the letters that stand for the bases of results.
#[derive(Default)]
struct Footnotes {
    bases: Vec<Arc<str>>,
    open: bool,
    contradicted: bool,
    disputed: bool,
}

impl Footnotes {
    fn of(&mut self, compared: &ComparedResult) -> String {
        let is_disputed = compared.expected.otherwise.is_some();
        let mark = match (compared.contradicts(), is_disputed) {
            (true, _) => "!",
            (false, true) => DISPUTED,
            (false, false) => "",
        };
        self.contradicted |= compared.contradicts();
        self.disputed |= is_disputed && !compared.contradicts();
        match &compared.expected.basis {
            Some(basis) => format!("{}{mark}", self.letter(basis)),
            None => {
                self.open = true;
                OPEN.to_owned()
            }
        }
    }

    fn letter(&mut self, basis: &str) -> char {
        let index = self
            .bases
            .iter()
            .position(|known| **known == *basis)
            .unwrap_or_else(|| {
                self.bases.push(basis.into());
                self.bases.len() - 1
            });
        // There are fewer documents with fewer sections than letters.
        (b'a'..=b'z').nth(index).map_or('z', char::from)
    }

    fn write(&self, attributed: &dyn Fn(&str) -> String, out: &mut dyn Write) -> io::Result<()> {
        for (letter, basis) in (b'a'..=b'z').zip(&self.bases) {
            let lines = wrap_within(&attributed(basis), WIDTH - 3).replace('\n', "\n   ");
            writeln!(out, "{}  {lines}", char::from(letter))?;
        }
        if self.open {
            writeln!(out, "{OPEN}  observed: no source in Stickler says what must come")?;
        }
        if self.contradicted {
            writeln!(out, "!  not what the source says")?;
        }
        if self.disputed {
            writeln!(out, "{DISPUTED}  not what another source of the same system says")?;
        }
        Ok(())
    }
}

fn title(identity: &Identity) -> String {
    format!("{} {}", identity.name, identity.version)
        .trim_end()
        .to_owned()
}

/// Returns the table columns of the operands.
fn operands(calls: &[CallOperands], types: &[ElementaryType]) -> Vec<Column> {
    let column = |(index, ty): (usize, &ElementaryType)| Column {
        head: vec![ty.name().to_owned()],
        cells: calls
            .iter()
            .map(|call| plain(operand(&call[index], *ty)))
            .collect(),
        align: align(*ty),
    };
    types.iter().enumerate().map(column).collect()
}

/// Returns the text of an operand. A whole real has all of its digits: `2147483648.0`, where the canonical spelling of a REAL
/// has the fewest that read back to the same bits, `2147483600.0`.
fn operand(value: &Value, ty: ElementaryType) -> String {
    match value.real() {
        Some(number) if number.abs() < LARGE && number == number.trunc() => format!("{number:.1}"),
        _ => untyped(value, ty),
    }
}

fn plain(value: String) -> NotedCell {
    NotedCell {
        value,
        note: String::new(),
        style: Style::new(),
    }
}

/// Returns the alignment of values of a type: texts at their beginning, numbers at their end.
fn align(ty: ElementaryType) -> Alignment {
    match ty.family() {
        Family::Text | Family::Character => Alignment::Left,
        _ => Alignment::Right,
    }
}

/// Returns the shortened literal of a value, without its type where that is `ty`, which the heading names.
fn untyped(value: &Value, ty: ElementaryType) -> String {
    let literal = value.to_string();
    let shown = match literal.split_once('#') {
        Some((prefix, rest)) if prefix == ty.name() => rest,
        _ => &literal,
    };
    shortened(shown, MAX_VALUE_LEN)
}

/// Returns the shortened typed literal of a value.
fn in_words(value: &Value) -> String {
    shortened(&value.to_string(), MAX_VALUE_LEN)
}

/// Returns a fragment that says how a result contradicts a document, or why there is no result; `None` where nothing is wrong.
fn trouble(compared: &ComparedResult) -> Option<String> {
    let must = match &compared.expected.basis {
        Some(basis) if compared.contradicts() => {
            format!(
                ", and must give {} by {basis}",
                in_words(&compared.expected.value)
            )
        }
        _ => String::new(),
    };
    match &compared.got {
        Ok(value) if compared.contradicts() => Some(format!("gives {}{must}", in_words(value))),
        Ok(_) => None,
        Err(refusal) if refusal.kind == RefusalKind::NotAsked => None,
        Err(refusal) => Some(format!("{} ({}){must}", refusal.kind.word(), refusal.detail)),
    }
}

/// Returns a fragment that names the two values that sources state of a result; `None` where they state one.
fn disputed(expected: &ExpectedResult) -> Option<String> {
    let (basis, other) = (expected.basis.as_ref()?, expected.otherwise.as_ref()?);
    Some(format!(
        "gives {} by {basis}, but {} by {}",
        in_words(&expected.value),
        in_words(&other.value),
        other.basis
    ))
}
