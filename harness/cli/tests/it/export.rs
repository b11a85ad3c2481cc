//! Tests `stickler export` and `stickler import`; the reference stands in for the compiler behind the editor.

use crate::common::{SUITE, output, text};
use crate::dialects;
use std::fs;
use std::path::Path;

pub fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let ended = output(folder, arguments);
    (ended.status.code(), text(&ended.stdout), text(&ended.stderr))
}

/// Exports the small suite, and runs its first page.
fn exported(folder: &Path) -> String {
    let arguments = ["export", "--cases", SUITE, "--dialect", "matiec", "pages"];
    let (code, shown, _) = run(folder, &arguments);
    assert_eq!(code, Some(0), "{shown}");
    assert!(shown.contains("must be rejected by the compiler"), "{shown}");
    let page = [
        "eval",
        "pages/page-001.st",
        "--dialect",
        "matiec",
        "--scans",
        "200",
    ];
    let (code, shown, complaints) = run(folder, &page);
    assert_eq!(code, Some(0), "{complaints}");
    shown
}

#[test]
fn what_a_page_computes_is_reported_like_a_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let copied = exported(folder.path());
    fs::write(folder.path().join("pages/copied.txt"), &copied).expect("written");
    let named = [
        "--engine-name",
        "editor",
        "--engine-version",
        "3.5",
        "--report",
        "told",
    ];
    let import = [&["import", "pages/copied.txt"], &named[..]].concat();
    let (code, shown, notes) = run(folder.path(), &import);
    // One case of the small suite is wrong on purpose, and fails here too.
    assert_eq!(code, Some(1), "{shown}{notes}");
    assert!(shown.contains("FAIL language/wrong-on-purpose"), "{shown}");
    assert!(
        shown.contains("stickler export pages-again --filter 'language/wrong-on-purpose' --dialect matiec"),
        "{shown}"
    );
    assert!(shown.contains("Engine: editor 3.5"), "{shown}");
    assert!(notes.contains("differs from matiec"), "{notes}");
    for report in ["events.jsonl", "results.json", "junit.xml", "summary.md"] {
        assert!(folder.path().join("told").join(report).exists(), "{report}");
    }
    // Its baseline is found by the name of the engine, like any other's.
    fs::create_dir_all(folder.path().join("reports/baselines")).expect("a folder");
    fs::write(
        folder.path().join("reports/baselines/editor.toml"),
        "[[expected]]\ncase = \"language/wrong-on-purpose\"\nverdict = \"fail\"\nreason = \"known\"\n",
    )
    .expect("written");
    let with_cases = [&import[..], &["--cases", SUITE]].concat();
    let (code, shown, notes) = run(folder.path(), &with_cases);
    assert_eq!(code, Some(0), "{shown}{notes}");
}

#[test]
fn what_is_not_whole_is_told_and_never_taken_for_a_pass() {
    let folder = tempfile::tempdir().expect("a folder");
    let copied = exported(folder.path());
    let cut: String = copied
        .lines()
        .filter(|line| !line.starts_with("results[20]"))
        .map(|line| format!("{line}\n"))
        .collect();
    fs::write(folder.path().join("copied.txt"), cut).expect("written");
    let import = ["import", "copied.txt", "--export", "pages", "--report", "told"];
    let (code, shown, notes) = run(folder.path(), &import);
    assert_eq!(code, Some(2), "{shown}");
    assert!(shown.contains("Cut short after"), "{shown}");
    assert!(
        notes.contains("results[20] is missing") && notes.contains("not judged"),
        "{notes}"
    );
    // A run that was cut short leaves its log and nothing else.
    assert!(!folder.path().join("told/results.json").exists());
    let log = ["import", "told/events.jsonl", "--export", "pages"];
    let (code, _, notes) = run(folder.path(), &log);
    assert_eq!(code, Some(2));
    let reported =
        "told/events.jsonl is the event log of a run, of format 3; import the text that was copied out";
    assert!(notes.contains(reported), "{notes}");
    let (code, _, notes) = run(folder.path(), &["import", "copied.txt", "--no-report"]);
    assert_eq!(code, Some(2));
    assert!(notes.contains("holds no export"), "{notes}");
    let (code, _, notes) = run(folder.path(), &["import", "nothing.txt", "--export", "pages"]);
    assert_eq!(code, Some(2));
    assert!(notes.contains("cannot read nothing.txt"), "{notes}");
}

#[test]
fn a_dialect_of_stickler_toml_is_exported_and_judged_by_what_it_was() {
    let folder = dialects::folder(dialects::MINE);
    let run = |arguments: &[&str]| run(folder.path(), arguments);
    let selection = [
        "--dialect",
        "mine",
        "--filter",
        "conversion/real-to-integer",
        "--sample",
        "40",
        "--without",
        "conversion/real-to-integer::variable(REAL,INT,2.5)@mine",
        "--without",
        "x/y",
    ];
    let (code, shown, notes) = run(&[&["export", "pages"][..], &selection].concat());
    assert_eq!(code, Some(0), "{shown}{notes}");
    assert!(shown.contains(" 1 named by --without\n"), "{shown}");
    assert!(
        notes.contains("--without `x/y` leaves out nothing") && notes.matches("nothing").count() == 1,
        "{notes}"
    );
    assert!(shown.contains("40 cases in mine\n"), "{shown}");
    let copied = |dialect: &str| {
        let page = ["eval", "pages/page-001.st", "--scans", "60", "--dialect", dialect];
        let (code, shown, notes) = run(&page);
        assert_eq!(code, Some(0), "{notes}");
        fs::write(folder.path().join(dialect), shown).expect("written");
    };
    copied("mine");
    copied("ironplc-ed3");
    let import = |copied: &str, configuration: &str| {
        run(&[
            "import",
            copied,
            "--export",
            "pages",
            "--report",
            "told",
            "--config",
            configuration,
        ])
    };
    let (code, shown, notes) = import("mine", "stickler.toml");
    assert_eq!(code, Some(0), "{shown}{notes}");
    let summary = fs::read_to_string(folder.path().join("told/summary.md")).expect("a report");
    assert!(
        summary.contains("\n- mine (MyPLC 2.1) is ironplc-ed3, but for "),
        "{summary}"
    );
    // Who does what the base does breaks the promise.
    let (code, shown, _) = import("ironplc-ed3", "stickler.toml");
    assert_eq!(code, Some(1), "{shown}");
    assert!(
        shown.contains(
            "stickler export pages-again --config stickler.toml --filter 'conversion/real-to-integer"
        ),
        "{shown}"
    );
    fs::write(
        folder.path().join("other.toml"),
        dialects::MINE.replace("saturate", "wrap"),
    )
    .expect("written");
    for configuration in ["empty.toml", "other.toml"] {
        let (code, _, notes) = import("mine", configuration);
        assert_eq!(code, Some(2));
        let then = "stickler.toml does not define the dialect `mine` as it did when pages was exported: ironplc-ed3, but for ";
        assert!(notes.contains(then), "{notes}");
    }
}

/// Exports the questions of a recording whose names contain `filter`, for a compiler of a dialect.
pub fn exported_questions(folder: &Path, dialect: &str, filter: &str, pages: &str) {
    let export = [
        "export",
        "--recording",
        "--dialect",
        dialect,
        "--filter",
        filter,
        "--cases-per-page",
        "300",
        pages,
    ];
    let (code, shown, notes) = run(folder, &export);
    assert_eq!(code, Some(0), "{shown}{notes}");
    assert!(
        shown.contains("--record NAME.toml --product NAME --product-version VERSION --platform TEXT"),
        "{shown}"
    );
}

#[test]
fn what_a_page_computes_becomes_a_recording_that_conversions_shows() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    exported_questions(folder, "matiec", "SINT_TO_USINT(SINT", "values");
    let page = [
        "eval",
        "values/page-001.st",
        "--dialect",
        "matiec",
        "--scans",
        "100",
    ];
    let (_, copied, _) = run(folder, &page);
    fs::write(folder.join("results.txt"), copied).expect("written");
    exported_questions(folder, "matiec", "bits(BYTE", "bits");
    let (_, messages, complaints) = run(folder, &["check", "bits/page-001.st", "--dialect", "matiec"]);
    fs::write(folder.join("messages.txt"), messages + &complaints).expect("written");

    let of = |copied: &'static str, pages: &'static str, more: &[&'static str]| {
        let import = [
            "import",
            copied,
            "--export",
            pages,
            "--no-report",
            "--record",
            "cases/recordings/mine.toml",
        ];
        run(folder, &[&import[..], more].concat())
    };
    let origin = [
        "--product",
        "MyPLC",
        "--product-version",
        "2.1",
        "--platform",
        "a simulation",
        "--date",
        "2026-11-24",
    ];
    fs::create_dir_all(folder.join("cases/recordings")).expect("a folder");
    let (code, _, notes) = of("results.txt", "values", &origin[..4]);
    assert_eq!(code, Some(2), "{notes}");
    assert!(notes.contains("--platform <TEXT>"), "{notes}");
    let blank = [&["--product", " "], &origin[2..]].concat();
    let (code, _, notes) = of("results.txt", "values", &blank);
    assert_eq!(code, Some(2), "{notes}");
    assert!(
        notes.contains("nothing can be recorded: `product` is empty"),
        "{notes}"
    );

    let (code, shown, notes) = of("results.txt", "values", &origin);
    assert_eq!(code, Some(0), "{shown}{notes}");
    assert!(
        shown.contains("cases/recordings/mine.toml: ") && shown.contains(" answers of MyPLC 2.1\n"),
        "{shown}"
    );
    let (code, shown, notes) = of("messages.txt", "bits", &origin);
    assert_eq!(code, Some(0), "{shown}{notes}");
    assert!(
        shown.contains("answers of MyPLC 2.1, added to those that it had"),
        "{shown}"
    );
    let other = [&["--product", "Other"], &origin[2..]].concat();
    let (_, _, notes) = of("messages.txt", "bits", &other);
    assert!(
        notes.contains("is a recording of MyPLC 2.1, not of Other 2.1"),
        "{notes}"
    );

    let recording = fs::read_to_string(folder.join("cases/recordings/mine.toml")).expect("a recording");
    assert!(
        recording.contains("\"BYTE\" = { rejects = \"0 7 8 %B0 %B1 %D0 %L0 %W0 %X0 %X7 %X8\" }"),
        "{recording}"
    );
    let conversions = [
        "conversions",
        "SINT_TO_USINT",
        "-1",
        "--dialect",
        "matiec",
        "--cases",
        "cases",
    ];
    let (_, shown, notes) = run(folder, &conversions);
    assert!(
        shown.contains("MyPLC 2.1 (recorded 2026-11-24)") && shown.matches("255 a").count() == 2,
        "{shown}{notes}"
    );
}
