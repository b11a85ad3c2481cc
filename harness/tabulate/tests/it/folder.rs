//! The tables of calls have the rows that they must have, and the folder is sound.

use crate::root;
use similar::TextDiff;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;
use stickler_suite::{Case, Suite, Wanted};
use stickler_tabulate::call::Call;
use stickler_tabulate::{blocks, folder, generate};
use stickler_types::DialectName;

#[test]
fn the_folder_holds_the_rows_that_the_program_writes() {
    let mut shown = String::new();
    for table in folder::call_tables(&root()).unwrap() {
        let wanted = table.wanted();
        let diff = TextDiff::from_lines(&table.table.text, &wanted);
        let diff = diff.unified_diff().header("found", &table.table.name).to_string();
        // The first lines tell what it is about; whole files of new rows would not.
        shown.extend(diff.lines().take(40).flat_map(|line| [line, "\n"]));
    }
    assert!(
        shown.is_empty(),
        "{shown}\nto rewrite the tables: cargo xtask tabulate"
    );
}

#[test]
fn the_sequences_of_blocks_are_those_that_the_program_writes() {
    for (path, table, wanted) in blocks::block_tables(&root()).unwrap() {
        let mut lines = table.text.lines().zip(wanted.lines());
        let first = lines.find(|(found, wanted)| found != wanted);
        assert_eq!(first, None, "{}: cargo xtask tabulate", path.display());
        assert_eq!(table.text.len(), wanted.len(), "{}", path.display());
    }
}

#[test]
fn a_table_is_small_enough_to_be_read() {
    for (path, table) in folder::tables(&root()).unwrap() {
        let length = table.text.len();
        assert!(length < 300_000, "{}: {length} bytes", path.display());
    }
}

#[test]
fn every_function_is_called_in_every_dialect_that_differs() {
    let mut called = HashSet::new();
    for table in folder::call_tables(&root()).unwrap() {
        for dialect in table.table.probes.iter().flat_map(|probe| &probe.dialects) {
            called.extend(table.calls.iter().map(|call| (*dialect, call.signature.clone())));
        }
    }
    for dialect in [DialectName::IRONPLC_ED3, DialectName::MATIEC] {
        for name in stickler_exact::functions(dialect) {
            for signature in stickler_exact::signatures(&name, dialect) {
                let shown = format!("{signature:?}");
                assert!(
                    called.contains(&(dialect, signature)),
                    "{dialect} has no case of {shown}"
                );
            }
        }
    }
}

#[test]
fn a_generated_call_that_a_table_leaves_out_stands_in_another() {
    let tables = folder::call_tables(&root()).unwrap();
    let calls = tables.iter().flat_map(|table| &table.calls);
    let standing: HashSet<String> = calls.map(Call::to_string).collect();
    let mut nowhere = Vec::new();
    for table in &tables {
        let generated = table.table.generate.iter().map(generate::calls);
        let calls = generated.flat_map(Result::unwrap).map(|call| call.to_string());
        nowhere.extend(calls.filter(|call| !standing.contains(call)));
    }
    assert!(nowhere.is_empty(), "{}", nowhere.join("\n"));
}

/// Returns the cases of the folder.
fn cases() -> Vec<Case> {
    let is_of_area = |id: &str, _| id.starts_with("conversion/");
    Suite::load_files(&root().join("conformance-cases"), Wanted::default(), is_of_area).cases
}

/// A vendor's page and a recording of its compiler may both be asked, since they can differ.
#[test]
fn nothing_is_asked_twice_for_one_source() {
    let mut seen: HashMap<(DialectName, String, Arc<str>, Vec<String>), String> = HashMap::new();
    for case in cases() {
        let observed = case.observe.iter().map(|observed| format!("{observed:?}"));
        let (source, _) = case.basis.split_once(':').expect("a source and a section");
        let program = case.without_blank_lines().source;
        let asked = (case.dialect, source.to_owned(), program, observed.collect());
        if let Some(first) = seen.insert(asked, case.key()) {
            panic!("{} asks what {first} asks", case.key());
        }
    }
    assert!(seen.len() > 20_000, "{} cases", seen.len());
}
