//! Compares [`implicit`] with the widening tables of the conformance cases: both state the rules of the same documents.

use std::collections::HashMap;
use std::path::Path;
use stickler_exact::implicit;
use stickler_types::{Dialect, DialectName, ElementaryType, MatrixWord};

/// The tables of elementary types, each in an assignment.
const FILES: &str = "integer integer-to-real real bit-string bool cross-family time-and-text third-edition plcnext \
    plcnext-beyond-the-table matiec strucpp rusty codesys logix control-expert iec-ed3";

type ImplicitCell = (ElementaryType, ElementaryType, DialectName);

/// Returns every cell of the tables, with its file and its word.
fn cells() -> HashMap<ImplicitCell, (&'static str, MatrixWord)> {
    let mut cells = HashMap::new();
    for file in FILES.split(' ') {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases/widening");
        let path = folder.join(file).with_extension("toml");
        let text = std::fs::read_to_string(&path).expect("the table can be read");
        let table: toml::Table = text.parse().expect("the table is TOML");
        let of_file = table.get("dialects");
        match &table["matrix"] {
            toml::Value::String(matrix) => add(&mut cells, file, matrix, of_file),
            toml::Value::Array(matrices) => {
                for matrix in matrices {
                    let text = matrix["table"].as_str().expect("a matrix is a text");
                    add(&mut cells, file, text, matrix.get("dialects").or(of_file));
                }
            }
            other => panic!("{file}: a matrix is no {other:?}"),
        }
    }
    cells
}

/// Adds one matrix: a line of columns, then a line for each row.
fn add(
    cells: &mut HashMap<ImplicitCell, (&'static str, MatrixWord)>,
    file: &'static str,
    matrix: &str,
    names: Option<&toml::Value>,
) {
    let mut lines = matrix
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    let columns: Vec<ElementaryType> = lines
        .next()
        .expect("a line of columns")
        .split_whitespace()
        .map(ty)
        .collect();
    for line in lines {
        let mut words = line.split_whitespace();
        let row = ty(words.next().expect("a row has a name"));
        // `-`: the cell stands in another matrix.
        for (&column, word) in columns.iter().zip(words).filter(|(_, word)| *word != "-") {
            let word =
                MatrixWord::from_word(word).unwrap_or_else(|| panic!("{file}: {row} {column}: {word}"));
            for dialect in dialects(names.expect("a matrix has dialects")) {
                cells.insert((row, column, dialect), (file, word));
            }
        }
    }
}

fn ty(name: &str) -> ElementaryType {
    ElementaryType::from_name(name).unwrap_or_else(|| panic!("{name} is no type"))
}

fn dialects(names: &toml::Value) -> Vec<DialectName> {
    let names = names.as_array().expect("dialects are a list");
    let of = |name: &str| match name {
        "ironplc" => DialectName::ALL[..3].to_vec(),
        "all" => DialectName::ALL.to_vec(),
        "cross-family-widening" => vec![
            DialectName::IRONPLC_RUSTY,
            variant(DialectName::IRONPLC_ED3, true),
        ],
        "no-cross-family-widening" => vec![
            DialectName::IRONPLC_ED2,
            DialectName::IRONPLC_ED3,
            variant(DialectName::IRONPLC_RUSTY, false),
        ],
        name => vec![name.parse().expect("a dialect")],
    };
    names
        .iter()
        .flat_map(|name| of(name.as_str().expect("a name")))
        .collect()
}

/// Returns a dialect with cross-family widening on or off.
fn variant(base: DialectName, on: bool) -> DialectName {
    let definition = Dialect::custom(&format!("{base:?}-widens-{on}"), base, "here")
        .stating("flags.allow-cross-family-widening", &on.to_string(), "a page")
        .expect("a flag");
    DialectName::define(definition).expect("a name of its own")
}

#[test]
fn every_cell_of_the_widening_tables_says_the_same() {
    let cells = cells();
    assert!(cells.len() > 2000, "only {} cells were found", cells.len());
    for ((from, to, dialect), (file, word)) in cells {
        // A WSTRING in IronPLC, whose page says "Not yet supported".
        if from == to && word == MatrixWord::Open {
            continue;
        }
        assert_eq!(
            implicit(from, to, dialect),
            word,
            "{file}: {from} to {to} in {dialect}"
        );
    }
}

#[test]
fn every_pair_of_types_that_a_dialect_has_is_in_a_table() {
    let cells = cells();
    for dialect in DialectName::ALL.into_iter().take(7) {
        // matiec has twenty types, and WSTRING is none of them. IronPLC documents four types of the third edition, and none for its
        // Rusty dialect.
        let has = |ty: ElementaryType| match dialect {
            DialectName::MATIEC => !ty.is_third_edition() && ty != ElementaryType::Wstring,
            DialectName::IRONPLC_ED2 | DialectName::IRONPLC_RUSTY => !ty.is_third_edition(),
            DialectName::IRONPLC_ED3 => !matches!(ty, ElementaryType::Char | ElementaryType::Wchar),
            _ => true,
        };
        let types: Vec<ElementaryType> = ElementaryType::ALL.into_iter().filter(|&ty| has(ty)).collect();
        for &from in &types {
            for &to in &types {
                assert!(
                    from == to || cells.contains_key(&(from, to, dialect)),
                    "no table has {from} to {to} in {dialect}"
                );
            }
        }
    }
}

#[test]
fn a_type_that_a_dialect_does_not_have_converts_to_nothing() {
    for dialect in [DialectName::IRONPLC_ED2, DialectName::MATIEC] {
        assert_eq!(
            implicit(ElementaryType::Time, ElementaryType::Ltime, dialect),
            MatrixWord::No
        );
    }
}
