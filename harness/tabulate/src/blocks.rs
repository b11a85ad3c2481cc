//! The tables of `conformance-cases/blocks`: sequences of inputs of standard function blocks, scan by scan, with what must come of them.
//!
//! A row says which sequences it has, and the cell `scans` is computed: a table of scans, as the mark `scans` takes it.
//!
//! | column | cell |
//! |---|---|
//! | `kind` | the block whose rules hold: `CTU`, `TON` |
//! | `type` | the type that a counter counts |
//! | `sequences` | which sequences they are, in phrases between commas: see [`Wanted`] |

mod model;
mod side_by_side;

use crate::folder::tables_in;
use crate::table::Table;
use model::{Block, Inputs, Rule};
use side_by_side::{counting_side_by_side, side_by_side};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use stickler_types::ElementaryType;

/// The folder of the tables, seen from the folder of the case files.
const TABLES: &str = "blocks";
/// The column that is computed.
const COMPUTED: &str = "scans";
/// The times that may pass between two scans, in seconds, for a PT of 5: none, less than PT, PT, and more.
const PASSED: [i128; 4] = [0, 3, 5, 7];

/// Reads each table of sequences, ordered by name, with the text that it must have; `root` is the repository.
///
/// # Errors
/// A message, where a file cannot be read or a cell is not understood.
pub fn block_tables(root: &Path) -> Result<Vec<(PathBuf, Table, String)>, String> {
    let mut tables = tables_in(root, TABLES)?;
    tables.retain(|(_, table)| table.has_column("kind") && table.has_column(COMPUTED));
    let with_text = tables.into_iter().map(|(path, table)| {
        let rows = table.rows.iter().map(|row| computed(&table.columns, row));
        let rows = rows.collect::<Result<Vec<_>, _>>();
        let text = table.with_rows(&rows.map_err(|what| format!("{}: {what}", path.display()))?);
        Ok((path, table, text))
    });
    with_text.collect()
}

/// Returns a row with the cell that it must have.
fn computed(columns: &[String], row: &[String]) -> Result<Vec<String>, String> {
    let names = columns.iter().map(String::as_str);
    let cells: HashMap<&str, &str> = names.zip(row.iter().map(String::as_str)).collect();
    let scans = scans(&cells).map_err(|what| format!("{}: {what}", row.join(", ")))?;
    let cells = columns.iter().zip(row);
    Ok(cells
        .map(|(column, cell)| if column == COMPUTED { &scans } else { cell })
        .cloned()
        .collect())
}

/// The sequences that a row has.
#[derive(Default)]
struct Wanted {
    /// `PV 0 1`, `PT 5`: the presets by scan in turn, numbers or `least` and `greatest` of a type; times in seconds.
    presets: Vec<i128>,
    /// `after 01`: the inputs of a scan before the sequences.
    first: Vec<bool>,
    /// `stops at PV and 0`, `no edge at first`: what else holds in the dialects of the row.
    rule: Rule,
    /// `5 scans`: the number of scans of which every sequence is there.
    length: usize,
    /// `part 2/4`: which part of them the row has.
    part: (usize, usize),
    /// `passed 0 3`: instead of all of these the sequences of [`side_by_side`] with these times.
    passed: Option<Vec<i128>>,
    /// `side by side`: those of [`counting_side_by_side`].
    is_side_by_side: bool,
}

impl Wanted {
    /// Reads the phrases of a cell; `range` is that of the type.
    fn read(text: &str, (least, greatest): (i128, i128)) -> Result<Wanted, String> {
        let numbers = |words: &str| {
            let number = |word: &str| match word {
                "least" => Ok(least),
                "greatest" => Ok(greatest),
                number => number
                    .parse::<i128>()
                    .map_err(|_| format!("`{number}` is no number")),
            };
            words
                .split(' ')
                .map(number)
                .collect::<Result<Vec<i128>, String>>()
        };
        let mut wanted = Wanted {
            length: 1,
            part: (1, 1),
            ..Wanted::default()
        };
        for phrase in text.split(", ") {
            let unknown = || format!("`{phrase}` is no phrase of `sequences`");
            match phrase.split_once(' ').ok_or_else(unknown)? {
                ("PV" | "PT", presets) => wanted.presets = numbers(presets)?,
                ("after", digits) => wanted.first = digits.chars().map(|digit| digit == '1').collect(),
                ("stops", "at PV and 0") => wanted.rule = Rule::StopsAtPreset,
                ("no", "edge at first") => wanted.rule = Rule::NoFirstEdge,
                ("passed", times) => wanted.passed = Some(numbers(times)?),
                ("side", "by side") => wanted.is_side_by_side = true,
                ("part", part) => {
                    let (part, parts) = part.split_once('/').ok_or_else(unknown)?;
                    let part = part.parse().ok().zip(parts.parse().ok());
                    wanted.part = part
                        .filter(|(part, parts)| (1..=*parts).contains(part))
                        .ok_or_else(unknown)?;
                }
                (length, "scans") => wanted.length = length.parse().map_err(|_| unknown())?,
                _ => return Err(unknown()),
            }
        }
        Ok(wanted)
    }
}

/// Returns the table of scans of a row.
fn scans(cells: &HashMap<&str, &str>) -> Result<String, String> {
    let cell = |name: &str| cells.get(name).copied().unwrap_or_default();
    let block = Block::from_word(cell("kind")).ok_or("`kind` names no block")?;
    let ty = ElementaryType::from_name(cell("type")).and_then(ElementaryType::integer_range);
    let range = ty.unwrap_or_default();
    let wanted = Wanted::read(cell("sequences"), range)?;
    let presets = &wanted.presets;
    if let Some(passed) = &wanted.passed {
        return Ok(side_by_side(
            block,
            passed,
            presets.first().copied().unwrap_or_default(),
        ));
    }
    if wanted.is_side_by_side {
        return Ok(counting_side_by_side(block, wanted.rule, presets, range));
    }
    let width = block.inputs().len();
    let choices = if block.is_timer() { PASSED.len() } else { 1 };
    let first = (wanted.first.len() == width).then_some((0, wanted.first));
    let steps = every_sequence(choices << width, wanted.length, wanted.part);
    let steps = steps.into_iter().map(|symbol| {
        let bits = (0..width).map(|at| symbol >> at & 1 == 1).collect();
        (PASSED[symbol >> width], bits)
    });
    let (mut at, mut seen) = (0, Vec::new());
    for (number, (passed, bits)) in first.into_iter().chain(steps).enumerate() {
        // The first scan is that of the start.
        at += if number == 0 { 0 } else { passed };
        let turn = number % presets.len().max(1);
        let preset = presets.get(turn).copied().unwrap_or_default();
        seen.push(Inputs { at, bits, preset });
    }
    Ok(table(block, wanted.rule, &seen, range, presets.len()))
}

/// Writes the table of scans, in which a PV or PT stands where it changes.
fn table(block: Block, rule: Rule, seen: &[Inputs], range: (i128, i128), presets: usize) -> String {
    let (clock, seconds) = if block.is_timer() {
        ("clock ", "s")
    } else {
        ("", "")
    };
    let preset = if presets > 0 { " preset" } else { "" };
    let mut text = format!(
        "{clock}{}{preset} | {}\n",
        block.inputs().join(" "),
        block.outputs().join(" ")
    );
    for (scan, now) in seen.iter().enumerate() {
        let bits: Vec<&str> = now.bits.iter().map(|bit| if *bit { "1" } else { "0" }).collect();
        let time = if block.is_timer() {
            format!("{}s ", now.at)
        } else {
            String::new()
        };
        let preset = match presets {
            0 => String::new(),
            _ if scan > 0 && seen[scan - 1].preset == now.preset => " -".to_owned(),
            _ => format!(" {}{seconds}", now.preset),
        };
        let outputs = block.outputs_after(&seen[..=scan], rule, range).join(" ");
        text.push_str(&format!("{time}{}{preset} | {outputs}\n", bits.join(" ")));
    }
    text
}

/// Returns a row of symbols, each less than `symbols`, in which every sequence of `length` symbols occurs, in as few symbols as there can be:
/// each sequence begins where the one before it has its second symbol. Of several parts it returns the one of a
/// number from 1, which begins with what the one before it ends with.
pub(super) fn every_sequence(symbols: usize, length: usize, (part, parts): (usize, usize)) -> Vec<usize> {
    let mut row = Vec::new();
    extend(&mut vec![0; length + 1], 1, 1, (symbols, length), &mut row);
    let around: Vec<usize> = row.iter().take(length - 1).copied().collect();
    row.extend(around);
    let size = row.len().div_ceil(parts);
    let start = (part - 1) * size;
    let end = (start + size + length - 1).min(row.len());
    row[start.min(end)..end].to_vec()
}

/// Adds the prime words from `word[1..at]` on to a de Bruijn sequence, in the order of an alphabet.
fn extend(
    word: &mut [usize],
    at: usize,
    period: usize,
    (symbols, length): (usize, usize),
    row: &mut Vec<usize>,
) {
    if at > length {
        if length % period == 0 {
            row.extend(&word[1..=period]);
        }
        return;
    }
    word[at] = word[at - period];
    extend(word, at + 1, period, (symbols, length), row);
    for symbol in word[at - period] + 1..symbols {
        word[at] = symbol;
        extend(word, at + 1, at, (symbols, length), row);
    }
}

#[cfg(test)]
mod tests {
    use super::every_sequence;
    use std::collections::HashSet;

    #[test]
    fn every_sequence_occurs_once() {
        for (symbols, length) in [(2, 1), (2, 5), (4, 5), (8, 4), (16, 3)] {
            let row = every_sequence(symbols, length, (1, 1));
            let found: HashSet<&[usize]> = row.windows(length).collect();
            let all = symbols.pow(length as u32);
            assert_eq!((found.len(), row.len()), (all, all + length - 1));
            let parts = (1..=3).map(|part| every_sequence(symbols, length, (part, 3)));
            let parts: Vec<Vec<usize>> = parts.collect();
            let found: HashSet<&[usize]> = parts.iter().flat_map(|part| part.windows(length)).collect();
            assert_eq!(found.len(), all);
        }
    }
}
