//! Tests what a watch shows for given changes; that the system reports changes is tested by the library that watches.

use super::CaseWatch;
use crate::case_folder::CaseFolder;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use stickler_engines::{Engine, Reference};
use stickler_mdtest::assert_fits;
use stickler_run::{Filter, Plan};
use stickler_workers::Cancellation;
use tempfile::TempDir;

const SUITE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/cmd/suite.in/conformance-cases"
);

/// Folder with a small suite in which the tests change case files.
struct Changing {
    folder: TempDir,
}

impl Changing {
    fn new() -> Changing {
        let folder = tempfile::tempdir().expect("a folder");
        for entry in walkdir::WalkDir::new(SUITE) {
            let entry = entry.expect("an entry");
            let below = entry.path().strip_prefix(SUITE).expect("below the suite");
            let copy = folder.path().join(below);
            match entry.file_type().is_dir() {
                true => fs::create_dir_all(copy).expect("a folder"),
                false => drop(fs::copy(entry.path(), copy).expect("a copy")),
            }
        }
        Changing { folder }
    }

    fn edit(&self, file: &str, edit: impl FnOnce(String) -> String) {
        let path = self.folder.path().join(file);
        let text = fs::read_to_string(&path).expect("a file");
        fs::write(path, edit(text)).expect("written");
    }

    /// Returns what is shown when these files have changed.
    fn step(&self, changed: &[&str], filters: &[&str]) -> String {
        let folder = CaseFolder::locate(Some(self.folder.path())).expect("a folder of cases");
        let reference = Reference::new();
        let engines: [&dyn Engine; 1] = [&reference];
        let cancel = Cancellation::new();
        let watch = CaseWatch {
            folder: &folder,
            plan: Plan {
                filters: filters.iter().map(|text| Filter::new(*text)).collect(),
                ..Plan::default()
            },
            engines: &engines,
            stores: &[None],
            failures: None,
            cancel: &cancel,
        };
        let changed: BTreeSet<PathBuf> = changed.iter().map(|file| Path::new(file).to_owned()).collect();
        let mut bytes = Vec::new();
        watch.step(&changed, &mut bytes).expect("shown");
        let text = String::from_utf8(bytes).expect("text");
        let text = anstream::adapter::strip_str(&text).to_string();
        text.replace(&self.folder.path().display().to_string(), "CASES")
    }
}

#[test]
fn the_cases_of_a_changed_file_are_run_and_no_others() {
    let suite = Changing::new();
    let shown = suite.step(&["widening/integer.toml"], &[]);
    assert_eq!(
        shown,
        "\nCASES/widening/integer.toml changed\n13 cases on reference: 13 pass\n"
    );
    let wrong = "language/wrong-on-purpose.st";
    let shown = suite.step(&[wrong], &[]);
    let start = "\nCASES/language/wrong-on-purpose.st changed\nFAIL language/wrong-on-purpose@matiec\n";
    assert!(shown.starts_with(start), "{shown}");
    assert!(shown.ends_with("\n1 case on reference: 1 fail\n"), "{shown}");
    suite.edit(wrong, |text| text.replace("sum = INT#5", "sum = INT#4"));
    let shown = suite.step(&[wrong], &[]);
    assert_fits(&shown, "… changed\n1 case on reference: 1 pass\n");
}

#[test]
fn a_broken_file_ends_no_watch() {
    let suite = Changing::new();
    let file = "widening/integer.toml";
    suite.edit(file, |text| format!("{text}\nno such key = [\n"));
    let shown = suite.step(&[file], &[]);
    assert_eq!(shown, "\nCASES/widening/integer.toml changed\nit has no case\n");
    fs::write(suite.folder.path().join(file), [0xff, 0xfe]).expect("written");
    assert!(suite.step(&[file], &[]).ends_with(" changed\nit has no case\n"));
}

#[test]
fn what_is_gone_or_selected_by_no_filter_is_said_and_other_files_are_passed_over() {
    let suite = Changing::new();
    let shown = suite.step(&["widening/integer.toml"], &["language/"]);
    assert_eq!(
        shown,
        "\nCASES/widening/integer.toml changed\nnone of its cases is selected\n"
    );
    fs::remove_file(suite.folder.path().join("language/recorded.st")).expect("removed");
    let shown = suite.step(&["language/recorded.st"], &[]);
    assert_eq!(shown, "\nCASES/language/recorded.st is gone\n");
    assert_eq!(
        suite.step(&["language/README.md", "language", ".integer.toml.swp"], &[]),
        ""
    );
    let shown = suite.step(&["sources.toml"], &[]);
    assert_fits(&shown, "…CASES/sources.toml changed; all cases may depend on it…");
}
