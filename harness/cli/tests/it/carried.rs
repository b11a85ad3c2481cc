//! Tests of the program in places where no clone is, with the cases that it carries.

use crate::common::{STICKLER, SUITE, text};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// A copy of the program outside of the clone, and an empty folder in which it runs.
struct Installed {
    folder: TempDir,
}

impl Installed {
    fn new() -> Installed {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["bin", "home", "empty"] {
            fs::create_dir(folder.path().join(name)).expect("a folder");
        }
        fs::copy(STICKLER, folder.path().join("bin/stickler")).expect("a copy");
        Installed { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs the program in the empty folder, with a home of its own.
    fn run(&self, arguments: &[&str]) -> Output {
        Command::new(self.path("bin/stickler"))
            .args(arguments)
            .env("NO_COLOR", "1")
            .env("HOME", self.path("home"))
            .env("XDG_CACHE_HOME", self.path("home/.cache"))
            .current_dir(self.path("empty"))
            .stdin(Stdio::null())
            .output()
            .expect("the command runs")
    }

    /// Returns the folders of unpacked cases.
    fn editions(&self) -> Vec<PathBuf> {
        let cases = ["home/.cache/stickler/cases", "home/Library/Caches/stickler/cases"];
        let found = cases.iter().find_map(|cases| fs::read_dir(self.path(cases)).ok());
        let entries = found.into_iter().flatten();
        let paths = entries.map(|entry| entry.expect("an entry").path());
        paths.filter(|path| path.is_dir()).collect()
    }
}

const CASE: &str = "language/comments-nested";

fn assert_code(output: &Output, code: i32) {
    assert_eq!(output.status.code(), Some(code), "{}", text(&output.stderr));
}

#[test]
fn the_program_runs_the_cases_that_it_carries() {
    let installed = Installed::new();
    let run = installed.run(&["run", "--filter", CASE]);
    assert_code(&run, 0);
    let shown = text(&run.stdout);
    assert!(shown.contains("all as expected"), "{shown}");
    let summary = fs::read_to_string(installed.path("empty/reports/latest/summary.md")).expect("a summary");
    assert!(summary.contains("inside the program"), "{summary}");
    let [edition] = &installed.editions()[..] else {
        panic!("{:?}", installed.editions());
    };
    assert_same_files(&edition.join("conformance-cases"));
}

/// The unpacked cases are those of the clone, byte for byte.
fn assert_same_files(unpacked: &Path) {
    let clone = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    for file in [
        "suite.toml",
        "rules.md",
        "language/comments-nested.st",
        "widening/contexts.toml",
    ] {
        let [there, here] = [unpacked, &clone].map(|folder| fs::read(folder.join(file)).expect(file));
        assert!(there == here, "{file}");
    }
}

#[test]
fn cases_that_are_named_or_lie_here_come_first() {
    let installed = Installed::new();
    let named = installed.run(&["list", "--cases", SUITE]);
    assert_code(&named, 0);
    let suite = Path::new(SUITE).parent().expect("a folder");
    for file in [
        "suite.toml",
        "dialects.toml",
        "sources.toml",
        "rules.md",
        "features.toml",
        "places.toml",
    ] {
        let here = installed.path("empty/conformance-cases");
        fs::create_dir_all(&here).expect("a folder");
        if let Ok(content) = fs::read(suite.join("conformance-cases").join(file)) {
            fs::write(here.join(file), content).expect("a file");
        }
    }
    let here = installed.run(&["run", "--filter", CASE]);
    assert_code(&here, 4);
    assert!(
        text(&here.stderr).contains("there are none"),
        "{}",
        text(&here.stderr)
    );
    assert!(installed.editions().is_empty(), "{:?}", installed.editions());
}

#[test]
fn files_that_were_deleted_from_the_cache_come_back() {
    let installed = Installed::new();
    assert_code(&installed.run(&["show", CASE]), 0);
    let file = installed.editions()[0]
        .join("conformance-cases")
        .join(format!("{CASE}.st"));
    fs::remove_file(&file).expect("the file is there");
    assert_code(&installed.run(&["show", CASE]), 0);
    assert!(file.is_file());
    assert_eq!(installed.editions().len(), 1);
}

#[test]
fn a_cache_folder_that_cannot_be_made_is_named() {
    let installed = Installed::new();
    fs::remove_dir(installed.path("home")).expect("an empty folder");
    fs::write(installed.path("home"), "").expect("a file");
    let run = installed.run(&["run", "--filter", CASE]);
    assert_code(&run, 2);
    let message = text(&run.stderr);
    assert!(message.contains("cannot unpack into"), "{message}");
    assert!(
        message.contains("name a folder of cases with --cases DIR"),
        "{message}"
    );
}

#[test]
fn a_finding_becomes_no_case_of_the_cache() {
    let installed = Installed::new();
    let promoted = installed.run(&["promote", "check-0"]);
    assert_code(&promoted, 2);
    let message = text(&promoted.stderr);
    assert!(
        message.contains("there is no folder of cases here or above"),
        "{message}"
    );
}
