//! Tests sites of small runs: each folder of `golden-sites` is one, with its runs and what some of the site's files must be.
//!
//! A run is written as those of `golden`, which `golden_tests` describes. Of a page the style sheet is left out; `summary.txt` is what the
//! command line is told.

use super::{SiteError, SiteSummary};
use crate::events::{EventLog, NAME};
use crate::golden_tests::{difference, files, list, read, statements};
use crate::sample;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::slice;
use stickler_conversions::overview::Statements;
use stickler_mdtest::assert_fits;
use stickler_run::{CaseEvent, Event, Verdict};

/// Builds the site of these runs, without documents about conversions.
fn write(paths: &[PathBuf], site: &Path) -> Result<SiteSummary, SiteError> {
    super::write(paths, false, site, &Statements::default())
}

/// Writes a site of the runs in a folder of `golden-sites`; returns what the command line is told.
pub(super) fn write_golden(golden: &Path, folder: &Path) -> String {
    let runs = files(&golden.join("runs")).into_iter().map(|file| {
        let (events, has_page) = read(&golden.join("runs").join(&file));
        let run = written(&folder.join(file.with_extension("")), &events);
        if has_page {
            fs::write(run.join("index.html"), "the run's page").expect("written");
        }
        run
    });
    let statements = match golden.join("statements.toml").is_file() {
        true => statements(golden),
        false => Statements::default(),
    };
    let runs: Vec<PathBuf> = runs.collect();
    let summary = super::write(&runs, false, &folder.join("site"), &statements).expect("a site");
    format!("{summary:#?}\n").replace(&folder.display().to_string(), "RUNS")
}

#[test]
fn files_of_sites_are_their_golden_texts() {
    let all = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden-sites");
    let mut differences = Vec::new();
    for entry in fs::read_dir(all).expect("a folder").flatten() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let summary = write_golden(&entry.path(), folder.path());
        let site = folder.path().join("site");
        let golden = entry.path().join("site");
        for file in files(&golden) {
            let text = match file.to_str() {
                Some("summary.txt") => summary.clone(),
                Some("files.txt") => list(&site),
                _ => fs::read_to_string(site.join(&file)).expect("a file of the site"),
            };
            differences.extend(difference(&golden.join(file), &without_style(&text)));
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// Returns a page without its style sheet.
fn without_style(page: &str) -> String {
    let parts = page.split_once("<style>").and_then(|(before, rest)| {
        let (_, after) = rest.split_once("</style>")?;
        Some(format!("{before}{after}"))
    });
    parts.unwrap_or_else(|| page.to_owned())
}

/// Writes a run of an engine's version, started on a day of September.
fn run(folder: &Path, name: &str, day: u32, version: &str, cases: Vec<CaseEvent>) -> PathBuf {
    let mut events = sample::run_of(cases);
    let header = sample::header(&mut events);
    header.started = format!("2026-09-{day:02}T12:00:00Z");
    header.engines[0].version = version.to_owned();
    written(&folder.join(name), &events)
}

fn written(folder: &Path, events: &[Event]) -> PathBuf {
    fs::create_dir_all(folder).expect("a folder");
    let mut log = EventLog::create(folder.join(NAME)).expect("a log");
    assert!(events.iter().all(|event| log.take(event).is_ok()));
    log.flush().expect("written");
    folder.to_owned()
}

fn cases(first: Verdict, second: Verdict) -> Vec<CaseEvent> {
    vec![sample::case("first", first), sample::case("second", second)]
}

#[test]
fn a_run_is_known_from_its_log_of_any_name_alone_and_not_from_its_results() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let old = run(folder.path(), "old", 1, "1", cases(Verdict::Fail, Verdict::Pass));
    let new = run(folder.path(), "new", 2, "2", cases(Verdict::Pass, Verdict::Fail));
    let [whole, alone] = ["deep/whole", "alone"].map(|name| folder.path().join(name));
    write(&[old.clone(), new.clone()], &whole).expect("a site of folders");
    let handed_in = folder.path().join("of-a-vendor.json");
    fs::copy(old.join(NAME), &handed_in).expect("copied");
    // It lies beside the file by chance.
    fs::write(folder.path().join("index.html"), "another page").expect("written");
    write(&[handed_in, new], &alone).expect("a site of a log and a folder");
    let front = |site: &Path| fs::read_to_string(site.join("index.html")).expect("the front page");
    assert_eq!(front(&whole), front(&alone));
    assert!(!alone.join("runs/1.html").exists());
    sample::report(&old, &sample::run());
    let error = write(&[old.join("results.json")], &alone).expect_err("not the whole run");
    let error = crate::parts::describe_error(&error);
    assert_fits(&error, "…this is a results.json of format 4 and no event log…");
}

#[test]
fn an_unreadable_run_is_skipped_on_demand_unless_there_is_no_other() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let whole = run(
        folder.path(),
        "whole",
        1,
        "1",
        cases(Verdict::Pass, Verdict::Fail),
    );
    let cut = written(&folder.path().join("cut"), &sample::run()[..2]);
    let missing = folder.path().join("missing");
    let site = folder.path().join("site");
    let skipping = |paths: &[PathBuf]| super::write(paths, true, &site, &Statements::default());
    let summary = skipping(&[missing.clone(), whole, cut.clone()]).expect("a site");
    assert_eq!(summary.runs, 1);
    let [first, second] = &summary.skipped[..] else {
        panic!("{:?}", summary.skipped);
    };
    assert!(first.contains("missing: cannot read the event log"), "{first}");
    assert!(second.contains("the run was cut short"), "{second}");
    let error = skipping(&[missing, cut]).expect_err("no run");
    assert!(error.to_string().ends_with("missing"), "{error}");
}

#[test]
fn what_no_site_can_be_made_of_is_refused_with_its_place() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let site = folder.path().join("site");
    assert!(matches!(write(&[], &site), Err(SiteError::NoRun)));
    let whole = sample::run();
    let cut = written(&folder.path().join("cut"), &whole[..whole.len() - 1]);
    let refused = |run: PathBuf| {
        let error = write(&[run], &site).expect_err("no run");
        let source = error.source().map(ToString::to_string);
        format!("{error}: {}", source.unwrap_or_default())
    };
    let error = refused(cut);
    assert_fits(
        &error,
        "…cut/events.jsonl.gz: the run was cut short after 4 cases…",
    );
    assert!(refused(folder.path().join("missing")).contains("missing: cannot read the event log"));
    let error = refused(folder.path().to_owned());
    assert_fits(&error, "…events.jsonl.gz: cannot read the event log…");
    let started = |time: &str| {
        let mut events = sample::run();
        sample::header(&mut events).started = time.to_owned();
        refused(written(&folder.path().join("undated"), &events))
    };
    assert!(started("today").contains("the run began at `today`, which is no time"));
    assert!(!site.exists(), "nothing is written of a site that is refused");
    fs::write(&site, "a file").expect("written");
    let run = written(&folder.path().join("run"), &whole);
    assert!(matches!(
        write(slice::from_ref(&run), &site),
        Err(SiteError::NoFolder(_))
    ));
    assert!(matches!(
        write(slice::from_ref(&run), &run),
        Err(SiteError::RunFolder(_))
    ));
    let below = write(&[run], &site.join("below")).expect_err("a file is no folder");
    assert!(below.to_string().contains("cannot write"), "{below}");
}
