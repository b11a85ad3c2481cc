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
mod sequences;
mod side_by_side;

use model::{Block, Inputs, Rule};
use sequences::every_sequence;
use serde::Deserialize;
use side_by_side::side_by_side;
use std::collections::HashMap;
use std::fmt::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use stickler_types::ElementaryType;
use toml::Spanned;

/// The folder of the tables, seen from the root of the repository.
const TABLES: &str = "conformance-cases/blocks";
/// The column that is computed.
const COMPUTED: &str = "scans";
/// The times that may pass between two scans, in seconds, for a PT of 5: none, less than PT, PT, and more.
const PASSED: [i128; 4] = [0, 3, 5, 7];

/// A table of sequences.
#[derive(Clone, Debug)]
pub struct BlockTable {
    /// The path of the file.
    pub path: PathBuf,
    /// The text that the file has.
    pub text: String,
    /// The text that it must have.
    pub wanted: String,
}

/// The keys of a case file that matter here; the suite checks all of them.
#[derive(Deserialize)]
struct TableKeys {
    #[serde(default)]
    columns: Vec<String>,
    rows: Option<Spanned<Vec<Vec<String>>>>,
}

/// Reads each table of sequences and computes its rows, ordered by name; `root` is the repository.
///
/// # Errors
/// A message, where a file cannot be read or a cell is not understood.
pub fn block_tables(root: &Path) -> Result<Vec<BlockTable>, String> {
    let folder = root.join(TABLES);
    let entries = std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    let mut tables = Vec::new();
    for path in paths {
        let fail = |what: String| format!("{}: {what}", path.display());
        let text = std::fs::read_to_string(&path).map_err(|error| fail(error.to_string()))?;
        if let Some(wanted) = wanted(&text).map_err(fail)? {
            tables.push(BlockTable { path, text, wanted });
        }
    }
    Ok(tables)
}

/// Returns the text that a table must have; `None` where its columns are not those of sequences.
fn wanted(text: &str) -> Result<Option<String>, String> {
    let keys: TableKeys = toml::from_str(text).map_err(|error| error.to_string())?;
    let is_computed = ["kind", COMPUTED]
        .iter()
        .all(|name| keys.columns.iter().any(|column| column == name));
    let (Some(rows), true) = (keys.rows, is_computed) else {
        return Ok(None);
    };
    let Range { start, end } = rows.span();
    let mut written = String::from("[\n");
    for row in rows.get_ref() {
        let cells: HashMap<&str, &str> = keys
            .columns
            .iter()
            .map(String::as_str)
            .zip(row.iter().map(String::as_str))
            .collect();
        let scans = scans(&cells).map_err(|what| format!("{}: {what}", row.join(", ")))?;
        let cells: Vec<String> = keys
            .columns
            .iter()
            .zip(row)
            .map(|(column, cell)| match &**column {
                COMPUTED => format!("\"\"\"\n{scans}\"\"\""),
                _ => format!("\"{cell}\""),
            })
            .collect();
        // Writing into a String does not fail.
        let _ = writeln!(written, "    [{}],", cells.join(", "));
    }
    Ok(Some(format!("{}{written}]{}", &text[..start], &text[end..])))
}

/// The sequences that a row has.
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
            presets: Vec::new(),
            first: Vec::new(),
            rule: Rule::Standard,
            length: 1,
            part: (1, 1),
            passed: None,
        };
        for phrase in text.split(", ") {
            let unknown = || format!("`{phrase}` is no phrase of `sequences`");
            match phrase.split_once(' ').ok_or_else(unknown)? {
                ("PV" | "PT", presets) => wanted.presets = numbers(presets)?,
                ("after", digits) => wanted.first = digits.chars().map(|digit| digit == '1').collect(),
                ("stops", "at PV and 0") => wanted.rule = Rule::StopsAtPreset,
                ("no", "edge at first") => wanted.rule = Rule::NoFirstEdge,
                ("passed", times) => wanted.passed = Some(numbers(times)?),
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
    let block = Block::named(cell("kind")).ok_or("`kind` names no block")?;
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
        // Writing into a String does not fail.
        let _ = writeln!(text, "{time}{}{preset} | {outputs}", bits.join(" "));
    }
    text
}
