//! A table as the text of its file: aligned columns, so that a person can read down them.

use crate::table::{Probe, Table};
use std::fmt::Write;

/// The text of a table's file.
#[must_use]
pub fn text(table: &Table) -> String {
    let mut out = String::new();
    key(&mut out, 8, "title", &quoted(&table.title));
    key(&mut out, 8, "basis", &quoted(&table.basis));
    key(&mut out, 8, "dialects", &list(&table.dialects));
    if !table.summary.is_empty() {
        key(
            &mut out,
            8,
            "summary",
            &format!("\"\"\"\n{}\n\"\"\"", table.summary.trim()),
        );
    }
    line(&mut out, &format!("\ncolumns = {}", list(&table.columns)));
    line(&mut out, "rows = [");
    rows(&mut out, table);
    line(&mut out, "]");
    for probe in &table.probes {
        write_probe(&mut out, probe);
    }
    out
}

/// The rows, each cell as wide as the widest of its column.
fn rows(out: &mut String, table: &Table) {
    let rows: Vec<Vec<String>> = table
        .rows
        .iter()
        .map(|row| row.iter().map(|cell| quoted(cell)).collect())
        .collect();
    let widths: Vec<usize> = (0..table.columns.len())
        .map(|column| {
            let cells = rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        })
        .collect();
    for row in &rows {
        let mut text = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            // Writing into a String does not fail.
            let _ = write!(text, "{:<width$} ", format!("{cell},"), width = width + 1);
        }
        line(out, &format!("    [{}],", text.trim_end().trim_end_matches(',')));
    }
}

fn write_probe(out: &mut String, probe: &Probe) {
    line(out, "\n[[probe]]");
    key(out, 7, "name", &quoted(&probe.name));
    for (name, value) in [
        ("title", &probe.title),
        ("basis", &probe.basis),
        ("observe", &probe.observe),
        ("expect", &probe.expect),
        ("only", &probe.only),
    ] {
        if !value.is_empty() {
            key(out, 7, name, &quoted(value));
        }
    }
    if !probe.dialects.is_empty() {
        key(out, 7, "dialects", &list(&probe.dialects));
    }
    key(out, 7, "source", &format!("\"\"\"\n{}\"\"\"", probe.source));
}

fn key(out: &mut String, width: usize, name: &str, value: &str) {
    line(out, &format!("{name:<width$} = {value}"));
}

fn line(out: &mut String, text: &str) {
    out.push_str(text);
    out.push('\n');
}

fn list(words: &[String]) -> String {
    let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
    format!("[{}]", words.join(", "))
}

/// A TOML string on one line: between double quotes, or between single ones where that spares the reader escapes.
fn quoted(text: &str) -> String {
    let needs_escapes = text.contains(['"', '\\']);
    if needs_escapes && !text.contains('\'') {
        return format!("'{text}'");
    }
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(words: &[&str]) -> Vec<String> {
        words.iter().map(|&word| word.to_owned()).collect()
    }

    #[test]
    fn a_table_is_written_with_aligned_columns() {
        let table = Table {
            name: "example".to_owned(),
            title: "One claim".to_owned(),
            basis: "stickler-design: §8".to_owned(),
            dialects: words(&["ironplc", "matiec"]),
            summary: "\nWhy.\n".to_owned(),
            columns: words(&["input", "expected"]),
            rows: vec![words(&["1", "INT#1"]), words(&["-100", "INT#-100"])],
            probes: vec![Probe {
                name: "call".to_owned(),
                observe: "into".to_owned(),
                expect: "{expected}".to_owned(),
                dialects: words(&["matiec"]),
                source: "PROGRAM main\n    into := F({input});\nEND_PROGRAM\n".to_owned(),
                ..Probe::default()
            }],
        };
        let expected = r#"title    = "One claim"
basis    = "stickler-design: §8"
dialects = ["ironplc", "matiec"]
summary  = """
Why.
"""

columns = ["input", "expected"]
rows = [
    ["1",    "INT#1"],
    ["-100", "INT#-100"],
]

[[probe]]
name    = "call"
observe = "into"
expect  = "{expected}"
dialects = ["matiec"]
source  = """
PROGRAM main
    into := F({input});
END_PROGRAM
"""
"#;
        assert_eq!(text(&table), expected);
    }

    #[test]
    fn quotes_in_a_cell_are_kept() {
        assert_eq!(quoted("WSTRING#\"a\""), "'WSTRING#\"a\"'");
        assert_eq!(quoted("\"it's\""), "\"\\\"it's\\\"\"");
        assert_eq!(quoted("'a'"), "\"'a'\"");
    }
}
