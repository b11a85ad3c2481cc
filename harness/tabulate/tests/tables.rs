//! The generated tables are those of the folder, and the folder is sound.

use similar::TextDiff;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use stickler_suite::{Case, Suite, basis};
use stickler_tabulate::sheet::resolve;
use stickler_tabulate::{families, folder};
use stickler_types::DialectName;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn the_folder_holds_what_the_program_writes() {
    let files = folder::files().unwrap();
    let differences = folder::differences(&root().join(folder::FOLDER), &files).unwrap();
    let mut shown = String::new();
    for difference in &differences {
        let name = difference.path.file_name().unwrap_or_default().to_string_lossy();
        let diff = TextDiff::from_lines(&difference.found, &difference.wanted);
        let diff = diff.unified_diff().header("found", &name).to_string();
        // The first lines tell what it is about; whole files of new rows would not.
        shown.extend(diff.lines().take(40).flat_map(|line| [line, "\n"]));
    }
    assert!(
        shown.is_empty(),
        "{shown}\nto rewrite the tables: cargo run -p stickler-tabulate"
    );
}

#[test]
fn every_claim_names_a_section_that_there_is() {
    for table in families::all().unwrap() {
        for claim in [&table.basis]
            .into_iter()
            .chain(table.probes.iter().map(|probe| &probe.basis))
        {
            if !claim.is_empty() {
                assert!(basis::check(claim).is_ok(), "{}: {claim}", table.name);
            }
        }
        assert!(!table.rows.is_empty(), "{} has no rows", table.name);
    }
}

#[test]
fn a_table_is_small_enough_to_be_read() {
    for file in folder::files().unwrap() {
        assert!(
            file.text.len() < 300_000,
            "{}: {} bytes",
            file.name,
            file.text.len()
        );
    }
}

#[test]
fn every_function_is_called_in_every_dialect_that_differs() {
    let mut called = HashSet::new();
    for sheet in families::sheets().unwrap() {
        for probe in &sheet.probes {
            let names = if probe.dialects.is_empty() {
                &sheet.dialects
            } else {
                &probe.dialects
            };
            for dialect in resolve(names).unwrap() {
                called.extend(sheet.calls.iter().map(|call| (dialect, call.signature.clone())));
            }
        }
    }
    for dialect in [DialectName::IronplcEd3, DialectName::Matiec, DialectName::Plcnext] {
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

/// The cases of the folder.
fn cases() -> Vec<Case> {
    let mut suite = Suite::load(&root().join("conformance-cases"));
    suite.cases.retain(|case| case.area.as_ref() == "conversion");
    suite.cases
}

#[test]
fn nothing_is_asked_twice() {
    let mut seen: HashMap<(DialectName, String, Vec<String>), String> = HashMap::new();
    for case in cases() {
        let observed = case.observe.iter().map(|observed| format!("{observed:?}"));
        let program = (case.dialect, without_marks(&case.source), observed.collect());
        if let Some(first) = seen.insert(program, case.key()) {
            panic!("{} asks what {first} asks", case.key());
        }
    }
    assert!(seen.len() > 20_000, "{} cases", seen.len());
}

/// The program without its marks, which an engine does not see, and without the blanks before them.
fn without_marks(source: &str) -> String {
    let mut rest = source;
    let mut program = String::new();
    while let Some(start) = rest.find("(*!") {
        program.push_str(rest[..start].trim_end());
        rest = rest[start..]
            .find("*)")
            .map_or("", |end| &rest[start + end + 2..]);
    }
    program + rest
}

#[test]
fn the_groups_of_dialects_are_those_of_the_suite() {
    let suite = Suite::load(&root().join("conformance-cases"));
    for name in ["all", "ironplc", "matiec", "plcnext", "ironplc-ed3"] {
        let here: HashSet<DialectName> = resolve(&[name]).unwrap().into_iter().collect();
        let there: HashSet<DialectName> = suite.dialects.resolve(name).unwrap().iter().copied().collect();
        assert_eq!(here, there, "{name}");
    }
}
