//! The answers as a page for a person: tables, what contradicts a document, what differs, and a legend.

use super::ask::Got;
use super::block::{Block, Cell, Column};
use super::given::Operands;
use super::table::{self, Align, Shown};
use super::{differences, names, spelling};
use crate::engines::{Named, REFERENCE};
use crate::output;
use anstyle::{AnsiColor, Style};
use std::io::{self, Write};
use stickler_types::{DialectName, ElementaryType, Family, Value};

const BOLD: Style = Style::new().bold();
const DIM: Style = Style::new().dimmed();
const BAD: Style = AnsiColor::Red.on_default().bold();

/// The note of a cell about which no document says anything.
const OPEN: &str = "?";

/// How many contradictions of a table are told in words.
const MOST: usize = 8;

/// What is said above the rules where somebody else than the reference was asked, who need not follow them.
const RULES: &str = "Stickler's rule for each dialect, which an engine may or may not follow:";

/// From how many tables on it is said how to see one of them.
const MANY: usize = 3;

/// Writes the page.
///
/// # Errors
/// Those of `out`.
pub fn write(
    blocks: &[Block],
    lacking: &[DialectName],
    engines: &[Named],
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut notes = Notes::default();
    for block in blocks {
        write_block(block, engines, &mut notes, out)?;
        writeln!(out)?;
    }
    notes.write(out)?;
    if let Some(block) = blocks.first() {
        let function = &block.signature.function;
        if !lacking.is_empty() {
            writeln!(out, "There is no {function} in {}.", names::listed(lacking))?;
        }
        if blocks.len() > MANY {
            writeln!(
                out,
                "{function} takes several types; a typed value, such as {}, shows one of them alone.",
                block
                    .calls
                    .first()
                    .and_then(|call| call.first())
                    .map_or(String::new(), ToString::to_string)
            )?;
        }
    }
    Ok(())
}

/// Which letter stands for which basis, on the whole page.
#[derive(Default)]
struct Notes {
    bases: Vec<&'static str>,
    open: bool,
    contradicted: bool,
}

impl Notes {
    fn of(&mut self, cell: &Cell) -> String {
        let mark = if cell.contradicts() { "!" } else { "" };
        self.contradicted |= cell.contradicts();
        match cell.expected.basis {
            Some(basis) => format!("{}{mark}", self.letter(basis)),
            None => {
                self.open = true;
                OPEN.to_owned()
            }
        }
    }

    fn letter(&mut self, basis: &'static str) -> char {
        let index = self
            .bases
            .iter()
            .position(|known| *known == basis)
            .unwrap_or_else(|| {
                self.bases.push(basis);
                self.bases.len() - 1
            });
        // There are fewer documents with fewer sections than letters.
        (b'a'..=b'z').nth(index).map_or('z', char::from)
    }

    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        for (letter, basis) in (b'a'..=b'z').zip(&self.bases) {
            writeln!(out, "{}  {basis}", char::from(letter))?;
        }
        if self.open {
            writeln!(out, "{OPEN}  observed: no document says what must come")?;
        }
        if self.contradicted {
            writeln!(out, "!  not what the document says")?;
        }
        Ok(())
    }
}

fn write_block(block: &Block, engines: &[Named], notes: &mut Notes, out: &mut dyn Write) -> io::Result<()> {
    let signature = &block.signature;
    let named: Vec<String> = engines.iter().map(engine_name).collect();
    let types = super::inputs::types(signature);
    writeln!(
        out,
        "{BOLD}{}({types}) : {}{BOLD:#}  on {}\n",
        signature.function,
        signature.result,
        named.join(", ")
    )?;
    let groups = groups(&block.columns);
    let left = operands(&block.calls, &signature.operands);
    let several = engines.len() > 1;
    let columns: Vec<table::Column> = groups
        .iter()
        .map(|group| results(group, several.then_some(engines), signature.result, notes))
        .collect();
    table::write(&left, &columns, out)?;
    write_troubles(block, engines, out)?;
    if differences::any(signature) {
        let mut dialects: Vec<DialectName> = block.columns.iter().map(|column| column.dialect).collect();
        dialects.sort_unstable();
        dialects.dedup();
        writeln!(out)?;
        if engines.iter().any(|named| named.asked_for != REFERENCE) {
            writeln!(out, "{RULES}")?;
        }
        differences::write(signature, &dialects, out)?;
    }
    Ok(())
}

fn engine_name(named: &Named) -> String {
    let identity = named.identity();
    format!("{} {}", identity.name, identity.version)
        .trim_end()
        .to_owned()
}

/// Columns of one engine that agree in every cell, together.
fn groups(columns: &[Column]) -> Vec<Vec<&Column>> {
    let mut groups: Vec<Vec<&Column>> = Vec::new();
    for column in columns {
        let same = |group: &&mut Vec<&Column>| {
            group
                .first()
                .is_some_and(|first| first.engine == column.engine && first.cells == column.cells)
        };
        match groups.iter_mut().find(same) {
            Some(group) => group.push(column),
            None => groups.push(vec![column]),
        }
    }
    groups
}

/// The columns of the operands.
fn operands(calls: &[Operands], types: &[ElementaryType]) -> Vec<table::Column> {
    let column = |(index, ty): (usize, &ElementaryType)| table::Column {
        head: vec![ty.name().to_owned()],
        cells: calls
            .iter()
            .map(|call| plain(operand(&call[index], *ty)))
            .collect(),
        align: align(*ty),
    };
    types.iter().enumerate().map(column).collect()
}

/// An operand as programs have it.
fn operand(value: &Value, ty: ElementaryType) -> String {
    match ty.is_real() {
        true => spelling::literal(value),
        false => untyped(value, ty),
    }
}

fn plain(value: String) -> Shown {
    Shown {
        value,
        note: String::new(),
        style: Style::new(),
    }
}

/// The column of dialects that agree.
fn results(
    group: &[&Column],
    engines: Option<&[Named]>,
    result: ElementaryType,
    notes: &mut Notes,
) -> table::Column {
    let first = group.first();
    let engine = engines
        .zip(first)
        .and_then(|(engines, column)| engines.get(column.engine));
    let engine = engine.map(|named| named.identity().name.clone());
    let dialects: Vec<DialectName> = group.iter().map(|column| column.dialect).collect();
    let shown = |cell: &Cell| Shown {
        value: match &cell.got {
            Got::Value(value) => untyped(value, result),
            Got::None { word, .. } => (*word).to_owned(),
        },
        note: notes.of(cell),
        style: match (cell.contradicts(), cell.expected.basis) {
            (true, _) => BAD,
            (false, None) => DIM,
            (false, Some(_)) => Style::new(),
        },
    };
    table::Column {
        head: engine.into_iter().chain(names::short(&dialects)).collect(),
        cells: first.map_or(Vec::new(), |column| column.cells.iter().map(shown).collect()),
        align: align(result),
    }
}

/// Texts begin below each other, numbers end so.
fn align(ty: ElementaryType) -> Align {
    match ty.family() {
        Family::Text | Family::Character => Align::Left,
        _ => Align::Right,
    }
}

/// The literal without its type, where that is the one which the heading names; long ones in part.
fn untyped(value: &Value, ty: ElementaryType) -> String {
    let literal = value.to_string();
    spelling::shortened(match literal.split_once('#') {
        Some((prefix, rest)) if prefix == ty.name() => rest,
        _ => &literal,
    })
}

/// What contradicts a document, in words, and why an engine gave no value.
fn write_troubles(block: &Block, engines: &[Named], out: &mut dyn Write) -> io::Result<()> {
    let name = |column: &Column| match engines {
        [_] => column.dialect.to_string(),
        _ => engines.get(column.engine).map_or(String::new(), |named| {
            format!("{} in {}", named.identity().name, column.dialect)
        }),
    };
    let function = &block.signature.function;
    let troubles: Vec<String> = block
        .columns
        .iter()
        .flat_map(|column| {
            block
                .calls
                .iter()
                .zip(&column.cells)
                .map(move |(call, cell)| (column, call, cell))
        })
        .filter_map(|(column, call, cell)| {
            let operands: Vec<String> = call.iter().map(in_words).collect();
            let call = format!("{}: {function}({})", name(column), operands.join(", "));
            trouble(cell).map(|trouble| format!("{call} {trouble}"))
        })
        .collect();
    if troubles.is_empty() {
        return Ok(());
    }
    writeln!(out)?;
    for trouble in troubles.iter().take(MOST) {
        writeln!(out, "{}", output::wrap(trouble))?;
    }
    match troubles.len().saturating_sub(MOST) {
        0 => Ok(()),
        more => writeln!(out, "... and {more} more"),
    }
}

/// A value with its type, long ones in part.
fn in_words(value: &Value) -> String {
    spelling::shortened(&value.to_string())
}

fn trouble(cell: &Cell) -> Option<String> {
    let must = match cell.expected.basis {
        Some(_) if cell.contradicts() => format!(", and must give {}", in_words(&cell.expected.value)),
        _ => String::new(),
    };
    match &cell.got {
        Got::Value(value) if cell.contradicts() => Some(format!("gives {}{must}", in_words(value))),
        Got::Value(_) => None,
        Got::None { word, detail } => Some(format!("{word} ({detail}){must}")),
    }
}
