//! Tests of the page in a browser: its parts are opened by their addresses, and what the scripts built is read.
//!
//! The tests need a Chromium: the one that `STICKLER_CHROMIUM` names, or `chromium`, `chromium-browser` or `google-chrome` on the
//! path. Where there is none, each test says so and checks nothing. The browser prints the document and ends, so no driver is needed: every part of the page has
//! an address, which is what a click leads to. `keyboard_tests` presses keys.

use super::tests;
use crate::golden_tests;
use serde::Deserialize;
use std::env;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The variable that names a browser.
const VARIABLE: &str = "STICKLER_CHROMIUM";

/// The names under which the browser is installed.
const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// Options with which the browser needs neither a screen nor the network, and prints what a script complains about.
pub(super) const OPTIONS: [&str; 10] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--enable-logging=stderr",
];

/// Options with which it ends as soon as the page is built.
const ENDING: [&str; 2] = ["--timeout=60000", "--virtual-time-budget=5000"];

/// Returns a browser; prints why the tests are skipped where there is none.
pub(crate) fn browser() -> Option<PathBuf> {
    installed(
        VARIABLE,
        &NAMES,
        "no Chromium is installed to open index.html with",
    )
}

/// Returns the program that a variable names, or the first of these names on PATH; prints why the tests are skipped where there
/// is none.
pub(super) fn installed(variable: &str, names: &[&str], missing: &str) -> Option<PathBuf> {
    let named = env::var_os(variable).map(PathBuf::from);
    let paths = env::var_os("PATH").unwrap_or_default();
    let on_path = || {
        let folders = env::split_paths(&paths);
        let mut files = folders.flat_map(|folder| names.iter().map(move |name| folder.join(name)));
        files.find(|file| file.is_file())
    };
    let found = named.or_else(on_path);
    if found.is_none() {
        // Not `eprintln`, which nobody sees when the test passes.
        let _ = writeln!(std::io::stderr(), "skipped: {missing}; {variable} names one");
    }
    found
}

/// Runs the browser on an address of the page; returns what it prints. Fails where a script complains.
pub(crate) fn open(browser: &Path, page: &Path, address: &str, option: &str) -> String {
    let profile = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new(browser)
        .args(OPTIONS)
        .args(ENDING)
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(option)
        .arg(format!("file://{}{address}", page.display()))
        .output()
        .expect("a browser that starts");
    let complaints = String::from_utf8_lossy(&output.stderr);
    let complaints: Vec<&str> = complaints
        .lines()
        .filter(|line| line.contains("CONSOLE"))
        .collect();
    assert!(complaints.is_empty(), "{address}: {complaints:?}");
    assert!(output.status.success(), "{address}: {}", output.status);
    String::from_utf8(output.stdout).expect("a document in UTF-8")
}

/// The run that the tests look at, what documents state of it, and what a browser shows at its addresses.
const GOLDEN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/golden-page");

/// Writes the page of a run with an engine that fails in each part.
pub(super) fn write(folder: &Path) -> PathBuf {
    let golden = Path::new(GOLDEN);
    let path = folder.join("index.html");
    let (events, _) = golden_tests::read(&golden.join("run.toml"));
    tests::write(&path, golden_tests::statements(golden), &events);
    path
}

/// The addresses of the page, each with what a browser must show there.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Addresses {
    page: Vec<ShownPage>,
}

/// An address of the page, with what a browser must show there.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ShownPage {
    address: String,
    #[serde(default)]
    shows: Vec<String>,
    #[serde(default)]
    row: Vec<String>,
    #[serde(default)]
    cell: Vec<ShownCell>,
}

#[derive(Deserialize)]
struct ShownCell {
    label: String,
    begins: String,
}

/// Returns the part of a text between two others.
fn between<'t>(text: &'t str, start: &str, end: &str) -> &'t str {
    let (_, rest) = text.split_once(start).expect(start);
    rest.split_once(end).expect(end).0
}

/// Asserts that every field of a document has a label, which a screen reader reads.
fn assert_labelled(document: &str) {
    for field in ["<select", "<input"] {
        for (at, _) in document.match_indices(field) {
            let before = &document[..at];
            assert!(
                before.rfind("<label") > before.rfind("</label>"),
                "{}",
                &document[at..at + 60]
            );
        }
    }
}

#[test]
fn every_part_of_the_page_opens_by_its_address() {
    let text = fs::read_to_string(Path::new(GOLDEN).join("addresses.toml")).expect("the addresses");
    let addresses: Addresses = toml::from_str(&text).expect("addresses");
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = write(folder.path());
    for shown in addresses.page {
        let address = shown.address;
        let document = open(&browser, &page, &address, "--dump-dom");
        assert!(!document.contains("An older reference"), "the run counts");
        // The data and the scripts are no part of what is seen.
        let (seen, _) = document.split_once("<script type").expect("a document");
        assert_labelled(seen);
        for part in shown.shows {
            assert!(seen.contains(&part), "{address}: {part}\n{seen}");
        }
        for part in shown.row {
            let row = between(seen, "class=\"wanted\"", "</tr>");
            assert!(row.contains(&part), "{address}: {part}\n{row}");
        }
        for ShownCell { label, begins } in shown.cell {
            let named = between(seen, &format!("aria-label=\"{label} ("), "</td>");
            let (_, inside) = named.split_once('>').expect("its inside");
            assert!(inside.starts_with(&begins), "{label}: {inside}");
        }
    }
}

#[test]
fn the_page_can_be_printed() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = write(folder.path());
    let printed = folder.path().join("printed.pdf");
    open(
        &browser,
        &page,
        "#claims",
        &format!("--print-to-pdf={}", printed.display()),
    );
    assert!(fs::read(&printed).expect("a printed page").starts_with(b"%PDF"));
}
