//! Reads the marks `scan` and `scans`, which say by scan what is set, what time it is, and what must come of it.
//!
//! Basis: conformance-cases/README.md (scans).

use crate::error::suggestion;
use rustc_hash::FxHashMap;
use stickler_syntax::names::{DeclaredKind, declared};
use stickler_syntax::tree::{CaseFolded, PouKind, TypeSpecificationKind, VariableKind};
use stickler_types::{Dialect, ElementaryType, Value};

/// The greatest number of scans that a program runs.
pub(crate) const MAX_SCANS: u32 = 1_000_000;
/// The signs that separate what is set from what is expected.
const ARROWS: [&str; 3] = ["→", "->", "|"];
/// The name that stands for the simulated time among the variables.
const CLOCK: &str = "clock";
/// What stands in a table for a variable that is not set or not looked at in a scan.
const NOTHING: &str = "-";

/// What a mark says of one scan. Literals are read when the variables of the program are known.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct ScanRow<'t> {
    /// The line of the mark's text, from 0.
    pub(crate) line: u32,
    pub(crate) scan: u32,
    /// The time since the start, before the scan.
    pub(crate) clock: Option<&'t str>,
    /// Variables that are set before the scan, with their literals.
    pub(crate) set: Vec<(&'t str, &'t str)>,
    /// Variables with the values that they must have after the scan.
    pub(crate) expected: Vec<(&'t str, &'t str)>,
}

impl<'t> ScanRow<'t> {
    /// Adds a variable with its literal.
    fn add(&mut self, is_expected: bool, name: &'t str, literal: &'t str) -> Result<(), String> {
        match (is_expected, name == CLOCK) {
            (true, true) => return Err("`clock` is set, and stands before the arrow".to_owned()),
            (true, false) => self.expected.push((name, literal)),
            (false, false) => self.set.push((name, literal)),
            (false, true) if self.clock.replace(literal).is_some() => {
                return Err(format!("the clock is set twice before scan {}", self.scan));
            }
            (false, true) => {}
        }
        Ok(())
    }
}

/// Reads the text of `scan` behind its word: `3: IN = TRUE, clock = T#150ms → Q = FALSE`.
///
/// # Errors
/// A message.
pub(crate) fn one_scan(text: &str) -> Result<ScanRow<'_>, String> {
    let usage = || "write `scan 3: IN = TRUE, clock = T#150ms → Q = FALSE`".to_owned();
    let (number, text) = text.split_once(':').ok_or_else(usage)?;
    let mut row = ScanRow {
        scan: scan_number(number.trim())?,
        ..ScanRow::default()
    };
    let arrows = ARROWS[..2].iter();
    let mut parts = arrows.map(|arrow| outside_quotes(text, arrow));
    let parts = parts.find(|parts| parts.len() > 1);
    let parts = parts.unwrap_or_else(|| vec![text]);
    if parts.len() > 2 {
        return Err(usage());
    }
    for (is_expected, part) in [false, true].into_iter().zip(parts) {
        for one in outside_quotes(part, ",")
            .into_iter()
            .filter(|one| !one.trim().is_empty())
        {
            let (name, literal) = one.split_once('=').ok_or_else(usage)?;
            if name.trim().is_empty() || literal.trim().is_empty() {
                return Err(usage());
            }
            row.add(is_expected, name.trim(), literal.trim())?;
        }
    }
    Ok(row)
}

/// Reads the block of `scans`: a line of names, and a line of literals for each scan.
///
/// # Errors
/// A message with its line of the block, from 0.
pub(crate) fn scan_table(text: &str) -> Result<Vec<ScanRow<'_>>, (u32, String)> {
    let mut lines = (0..)
        .zip(text.lines())
        .filter(|(_, line)| !line.trim().is_empty());
    let usage = "`scans` needs a line of names below it, such as `clock IN | Q ET`, and a line for each scan";
    let (first, heading) = lines.next().ok_or((0, usage.to_owned()))?;
    let columns: Vec<&str> = heading.split_whitespace().collect();
    let arrow = columns.iter().position(|column| ARROWS.contains(column));
    let arrow = arrow.ok_or((first, usage.to_owned()))?;
    let names: Vec<&str> = columns
        .into_iter()
        .filter(|column| !ARROWS.contains(column))
        .collect();
    let is_numbered = names.first() == Some(&"scan");
    let mut rows: Vec<ScanRow<'_>> = Vec::new();
    for (line, text) in lines {
        let wrong = |message: String| (line, message);
        let cells = text.split_whitespace().filter(|cell| !ARROWS.contains(cell));
        let cells: Vec<&str> = cells.collect();
        if cells.len() != names.len() {
            let message = format!(
                "{} values for {} names; `-` stands for none",
                cells.len(),
                names.len()
            );
            return Err(wrong(message));
        }
        let before = rows.last().map_or(0, |row| row.scan);
        let scan = match is_numbered {
            true => scan_number(cells[0]).map_err(wrong)?,
            false => before + 1,
        };
        if scan <= before {
            return Err(wrong(format!("scan {scan} does not come after scan {before}")));
        }
        let mut row = ScanRow {
            line,
            scan,
            ..ScanRow::default()
        };
        let named = names
            .iter()
            .zip(&cells)
            .enumerate()
            .skip(usize::from(is_numbered));
        for (at, (name, cell)) in named.filter(|(_, (_, cell))| **cell != NOTHING) {
            row.add(at >= arrow, name, cell).map_err(wrong)?;
        }
        rows.push(row);
    }
    Ok(rows)
}

/// Reads the number of a scan.
///
/// # Errors
/// A message.
pub(crate) fn scan_number(text: &str) -> Result<u32, String> {
    let number = text.parse::<u32>().ok();
    let number = number.filter(|number| (1..=MAX_SCANS).contains(number));
    number.ok_or_else(|| format!("`{text}` is no scan; scans count from 1 to {MAX_SCANS}"))
}

/// Splits a text where a sign stands in no quotes.
fn outside_quotes<'t>(text: &'t str, sign: &str) -> Vec<&'t str> {
    let (mut parts, mut start, mut quote) = (Vec::new(), 0, None);
    for (at, character) in text.char_indices() {
        match quote {
            Some(open) if open == character => quote = None,
            None if matches!(character, '\'' | '"') => quote = Some(character),
            None if text[at..].starts_with(sign) => {
                parts.push(&text[start..at]);
                start = at + sign.len();
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

/// The variables of the main program of a text and its globals, by name, with the names of their types where they have one.
pub(crate) struct Variables(FxHashMap<String, Option<String>>);

impl Variables {
    /// Returns the variables of a program.
    pub(crate) fn of(source: &str) -> Variables {
        let (unit, _) = stickler_syntax::parse(source, &Dialect::DEFAULT);
        let names = declared(&unit).into_iter().filter(|one| {
            let in_program = one.inside.is_none_or(|pou| pou.kind == PouKind::Program);
            in_program && matches!(one.kind, DeclaredKind::Variable(kind) if kind != VariableKind::Temporary)
        });
        let typed = names.map(|one| {
            let ty = one.group.and_then(|group| match &group.specification.kind {
                TypeSpecificationKind::Named(name) => Some(name.text.to_owned()),
                _ => None,
            });
            (one.name.text.to_ascii_uppercase(), ty)
        });
        Variables(typed.collect())
    }

    /// Reads a literal for a variable, which may lack the type that the variable is declared with: `TRUE`, `3`, `150ms`.
    ///
    /// # Errors
    /// A message where there is no such variable, or the literal is none of its type.
    pub(crate) fn value(&self, name: &str, literal: &str) -> Result<Value, String> {
        let base = name.split(['.', '[']).next().unwrap_or(name).trim();
        let Some(ty) = self.0.get(&base.to_ascii_uppercase()) else {
            let known = self.0.keys().map(String::as_str);
            return Err(format!(
                "no variable `{base}` in the program; {}",
                suggestion(base, known)
            ));
        };
        let ty = ty.as_deref().filter(|_| base.len() == name.len());
        value(literal, ty).map_err(|message| match ty {
            Some(ty) => format!("`{name}` is of {ty}: {message}"),
            None => message,
        })
    }
}

/// Reads a time for the clock, which may lack `T#`.
///
/// # Errors
/// A message.
pub(crate) fn time(literal: &str) -> Result<Value, String> {
    let ty = ElementaryType::Time.name();
    value(literal, (!literal.contains('#')).then_some(ty))
}

/// Reads a literal that may lack its type.
fn value(literal: &str, ty: Option<&str>) -> Result<Value, String> {
    let parse =
        |text: &str| Value::parse(text).map_err(|error| format!("`{literal}` is no such literal: {error}"));
    let prefix = literal.split_once('#').map_or("", |(prefix, _)| prefix);
    let has_type = ElementaryType::from_literal_prefix(prefix).is_some();
    match ty {
        None if literal.eq_ignore_ascii_case("TRUE") || literal.eq_ignore_ascii_case("FALSE") => {
            parse(&format!("BOOL#{literal}"))
        }
        Some(ty) if !has_type && CaseFolded(prefix) != CaseFolded(ty) => parse(&format!("{ty}#{literal}")),
        Some(ty) => match parse(literal)? {
            value
                if ElementaryType::from_name(ty).is_none()
                    || CaseFolded(value.type_name()) == CaseFolded(ty) =>
            {
                Ok(value)
            }
            value => Err(format!("`{value}` is of {}", value.type_name())),
        },
        None => parse(literal),
    }
}
