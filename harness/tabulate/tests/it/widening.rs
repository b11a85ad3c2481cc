//! Compares [`implicit`] with the widening tables of the conformance cases: both state the rules of the same documents.

use crate::root;
use std::collections::HashMap;
use stickler_exact::implicit;
use stickler_suite::{Case, Suite, Wanted};
use stickler_types::{DialectName, ElementaryType, MatrixWord};

/// The tables of elementary types, each in an assignment.
const FILES: &str = "integer integer-to-real real bit-string bool cross-family time-and-text third-edition plcnext \
    plcnext-beyond-the-table matiec strucpp rusty codesys logix control-expert iec-ed3";

/// Returns the word of every cell of the tables, with its file.
fn cells() -> HashMap<(ElementaryType, ElementaryType, DialectName), (String, MatrixWord)> {
    let file = |id: &str| id.strip_prefix("widening/").map(str::to_owned);
    let is_wanted = |id: &str, _| file(id).is_some_and(|file| FILES.split(' ').any(|known| known == file));
    let wanted = Wanted {
        with_repeats: true,
        ..Wanted::default()
    };
    let suite = Suite::load_files(&root().join("conformance-cases"), wanted, is_wanted);
    assert_eq!(suite.errors, []);
    let cell = |case: &Case| {
        let cell = case.cell.as_ref()?;
        let [from, to] = [&cell.row, &cell.column].map(|name| ElementaryType::from_name(name));
        Some(((from?, to?, case.dialect), (case.id.to_string(), cell.word)))
    };
    suite.cases.iter().filter_map(cell).collect()
}

#[test]
fn every_cell_of_the_widening_tables_says_the_same() {
    let cells = cells();
    assert!(cells.len() > 2000, "only {} cells were found", cells.len());
    for ((from, to, dialect), (case, word)) in cells {
        // A WSTRING in IronPLC, whose page says "Not yet supported".
        if from != to || word != MatrixWord::Open {
            assert_eq!(
                implicit(from, to, dialect),
                word,
                "{case}: {from} to {to} in {dialect}"
            );
        }
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
