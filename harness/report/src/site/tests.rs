//! Tests sites of small runs.

use super::{SiteError, SiteSummary};
use crate::events::{EventLog, NAME};
use crate::sample;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::slice;
use stickler_conversions::overview::Statements;
use stickler_run::{CaseEvent, Event, Verdict};

/// Builds the site of these runs, without documents about conversions.
fn write(paths: &[PathBuf], site: &Path) -> Result<SiteSummary, SiteError> {
    super::write(paths, false, site, &Statements::default())
}

/// Writes a run of an engine's version, started on a day of September.
fn run(folder: &Path, name: &str, day: u32, version: &str, cases: Vec<CaseEvent>) -> PathBuf {
    let mut events = sample::run_of(cases);
    let header = sample::header(&mut events);
    header.started = format!("2026-09-{day:02}T12:00:00Z");
    header.engines[0].version = version.to_owned();
    written(&folder.join(name), &events)
}

pub(super) fn written(folder: &Path, events: &[Event]) -> PathBuf {
    fs::create_dir_all(folder).expect("a folder");
    let mut log = EventLog::create(folder.join(NAME)).expect("a log");
    events.iter().for_each(|event| log.take(event).expect("written"));
    log.flush().expect("written");
    folder.to_owned()
}

fn cases(first: Verdict, second: Verdict) -> Vec<CaseEvent> {
    vec![sample::case("first", first), sample::case("second", second)]
}

#[test]
fn a_site_shows_the_newest_run_and_what_changed_since_the_version_before() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let new = run(
        folder.path(),
        "new",
        9,
        "2",
        [
            cases(Verdict::Pass, Verdict::Fail),
            vec![sample::open_case("open"), sample::case("third", Verdict::Pass)],
        ]
        .concat(),
    );
    fs::write(new.join("index.html"), "the run's page").expect("written");
    let old = run(folder.path(), "old", 1, "1", cases(Verdict::Fail, Verdict::Pass));
    let site = folder.path().join("deep/site");
    let summary = write(&[new, old], &site).expect("a site");
    assert_eq!(
        summary,
        SiteSummary {
            skipped: Vec::new(),
            runs: 2,
            engines: 1,
            functions: 0,
            replaced: Vec::new()
        }
    );
    let front = fs::read_to_string(site.join("index.html")).expect("the front page");
    for part in [
        "<a href=\"engines/reference.html\">reference</a></th><td>2</td><td>2026-09-09</td>",
        "<th scope=\"col\">widening</th>",
        "2 of 3<span class=\"bar\"><span style=\"width: 66.6%\">",
        "2026-09-09: <a href=\"engines/reference.html\">reference</a> from 1 to 2: 1 fixed, 1 broken, 0 crashed",
    ] {
        assert!(front.contains(part), "{part}\n{front}");
    }
    let engine = fs::read_to_string(site.join("engines/reference.html")).expect("the engine's page");
    for part in [
        "points=\"0,50.0 600,33.4\"",
        "<h3>Broken</h3>\n<details><summary>ironplc-type-conversions: Integer widening: 1 case</summary><ul>\n<li><code>widening/second@ironplc-ed2</code>: pass → fail",
        "<code>widening/first@ironplc-ed2</code>: fail → pass",
        "<a href=\"../runs/2.html\">its page</a>",
        "without a page",
    ] {
        assert!(engine.contains(part), "{part}\n{engine}");
    }
    let copy = fs::read_to_string(site.join("runs/2.html")).expect("the copied page");
    assert_eq!(copy, "the run's page");
}

#[test]
fn of_two_runs_of_one_version_the_newer_counts_and_the_other_is_listed_and_named() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let paths = [
        run(folder.path(), "late", 2, "1", cases(Verdict::Pass, Verdict::Pass)),
        run(
            folder.path(),
            "early",
            1,
            "1",
            cases(Verdict::Fail, Verdict::Fail),
        ),
    ];
    let site = folder.path().join("site");
    let summary = write(&paths, &site).expect("a site");
    assert_eq!(summary.replaced.len(), 1);
    assert!(summary.replaced[0].contains("early"), "{summary:?}");
    let front = fs::read_to_string(site.join("index.html")).expect("the front page");
    assert!(front.contains("2 of 2<span") && front.contains("No engine has runs of two versions yet."));
    let engine = fs::read_to_string(site.join("engines/reference.html")).expect("the engine's page");
    let reason = "does not count: the later run of 2026-09-02 counts, with 2 cases";
    assert!(
        engine.contains("0 of 2<span") && engine.contains(reason),
        "{engine}"
    );
}

#[test]
fn a_small_late_run_does_not_hide_a_large_one_of_the_same_version() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let many = |verdict, number: usize| -> Vec<CaseEvent> {
        (0..number)
            .map(|number| sample::case(&format!("t::a({number})"), verdict))
            .collect()
    };
    let paths = [
        run(folder.path(), "large", 1, "1", many(Verdict::Pass, 20)),
        run(folder.path(), "alike", 2, "1", many(Verdict::Fail, 18)),
        run(folder.path(), "small", 3, "1", many(Verdict::Fail, 17)),
    ];
    let site = folder.path().join("site");
    let summary = write(&paths, &site).expect("a site");
    let engine = fs::read_to_string(site.join("engines/reference.html")).expect("the engine's page");
    let reason = "it has 17 cases, and the run of 2026-09-02 counts, with 18 cases";
    assert!(
        engine.contains(reason) && summary.replaced[1].contains(reason),
        "{summary:?}"
    );
    let reason = "the later run of 2026-09-02 counts, with 18 cases";
    assert!(
        engine.contains(reason) && summary.replaced[0].contains(reason),
        "{summary:?}"
    );
    let front = fs::read_to_string(site.join("index.html")).expect("the front page");
    assert!(front.contains("0 of 18<span"), "{front}");
}

#[test]
fn an_old_version_that_is_handed_in_late_is_old_all_the_same() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let paths = [
        run(
            folder.path(),
            "new",
            1,
            "0.10",
            cases(Verdict::Pass, Verdict::Pass),
        ),
        run(
            folder.path(),
            "old",
            2,
            "0.9",
            cases(Verdict::Pass, Verdict::Fail),
        ),
    ];
    let site = folder.path().join("site");
    write(&paths, &site).expect("a site");
    let front = fs::read_to_string(site.join("index.html")).expect("the front page");
    assert!(front.contains("from 0.9 to 0.10: 1 fixed, 0 broken"), "{front}");
}

#[test]
fn a_run_is_known_from_its_log_of_any_name_alone_and_not_from_its_results() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let old = run(folder.path(), "old", 1, "1", cases(Verdict::Fail, Verdict::Pass));
    let new = run(folder.path(), "new", 2, "2", cases(Verdict::Pass, Verdict::Fail));
    let [whole, alone] = ["whole", "alone"].map(|name| folder.path().join(name));
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
    assert!(
        error.contains("this is a results.json of format 3 and no event log"),
        "{error}"
    );
}

#[test]
fn a_feed_has_an_entry_for_each_new_version_that_keeps_its_id_whatever_the_engine_is_called() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let named = |name: &str, day: u32, version: &str| {
        let mut events = sample::run_on(&["a <b>&\u{1}"], Vec::new());
        let header = sample::header(&mut events);
        header.started = format!("2026-09-{day:02}T12:00:00Z");
        header.engines[0].version = version.to_owned();
        written(&folder.path().join(name), &events)
    };
    let [old, new, newest] = [("old", 1, "1"), ("new", 2, "2"), ("newest", 3, "3")]
        .map(|(name, day, version)| named(name, day, version));
    let feed_of = |runs: &[PathBuf]| {
        let site = folder.path().join("site");
        write(runs, &site).expect("a site");
        fs::read_to_string(site.join("feed.xml")).expect("a feed")
    };
    let id = "<id>urn:x-stickler:change:a%20%3Cb%3E%26%01:1:2</id>";
    let first = feed_of(&[old.clone(), new.clone()]);
    let later = feed_of(&[old.clone(), new, newest]);
    assert!(first.contains(id) && later.contains(id), "{first}");
    assert_eq!(later.matches("<entry>").count(), 2);
    for part in [
        "<feed xmlns=\"http://www.w3.org/2005/Atom\">",
        "<updated>2026-09-03T12:00:00Z</updated>",
        "<author><name>Stickler</name></author>",
        "<title>a &lt;b&gt;&amp;\\u{1} 3: not compared, since no case is in both runs</title>",
        "<link rel=\"alternate\" href=\"engines/a--b---.html\"/>",
    ] {
        assert!(later.contains(part), "{part}\n{later}");
    }
    let mut reader = quick_xml::Reader::from_str(&later);
    while !matches!(reader.read_event().expect("XML"), quick_xml::events::Event::Eof) {}
    assert_eq!(feed_of(&[old]).matches("<entry>").count(), 0);
    let front = fs::read_to_string(folder.path().join("site/index.html")).expect("the front page");
    assert!(front.contains("<link rel=\"alternate\" type=\"application/atom+xml\""));
}

#[test]
fn what_an_engine_says_of_itself_stays_text() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut events = sample::run_on(&["a/b", "a:b", "<b>", ".."], Vec::new());
    sample::header(&mut events).engines[0].version = "<script>alert(1)</script>".to_owned();
    let run = written(&folder.path().join("run"), &events);
    let site = folder.path().join("site");
    write(&[run], &site).expect("a site");
    let front = fs::read_to_string(site.join("index.html")).expect("the front page");
    assert!(front.contains("&lt;script&gt;alert") && !front.contains("<script") && !front.contains("<b>"));
    assert_eq!(
        sample::names(&site.join("engines")),
        ["-..html", "-b-.html", "a-b-2.html", "a-b.html"]
    );
}

#[test]
fn a_long_list_says_what_it_leaves_out() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let of = |verdict| -> Vec<CaseEvent> {
        (0..25)
            .map(|number| sample::case(&format!("t::a({number})"), verdict))
            .collect()
    };
    let paths = [
        run(folder.path(), "old", 1, "1", of(Verdict::Pass)),
        run(folder.path(), "new", 2, "2", of(Verdict::Crash)),
    ];
    let site = folder.path().join("site");
    write(&paths, &site).expect("a site");
    let engine = fs::read_to_string(site.join("engines/reference.html")).expect("the engine's page");
    assert!(engine.contains("<h3>Crashed</h3>") && engine.contains("and 5 more, which are not listed here"));
}

#[test]
fn versions_without_a_case_in_common_are_not_said_to_be_equal() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let of = |id| vec![sample::case(id, Verdict::Pass)];
    let paths = [
        run(folder.path(), "old", 1, "1", of("first")),
        run(folder.path(), "new", 2, "2", of("second")),
    ];
    let site = folder.path().join("site");
    write(&paths, &site).expect("a site");
    let front = fs::read_to_string(site.join("index.html")).expect("the front page");
    assert!(
        front.contains("from 1 to 2: not compared, since no case is in both runs"),
        "{front}"
    );
}

#[test]
fn equal_runs_give_an_equal_site() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let paths = [
        run(folder.path(), "old", 1, "1", cases(Verdict::Fail, Verdict::Pass)),
        run(folder.path(), "new", 2, "2", cases(Verdict::Pass, Verdict::Fail)),
    ];
    for site in ["one", "other"] {
        write(&paths, &folder.path().join(site)).expect("a site");
    }
    for page in ["index.html", "engines/reference.html"] {
        let read = |site: &str| fs::read(folder.path().join(site).join(page)).expect("a page");
        assert_eq!(read("one"), read("other"));
    }
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
    assert!(
        error.contains("cut/events.jsonl: the run was cut short after 4 cases"),
        "{error}"
    );
    assert!(refused(folder.path().join("missing")).contains("missing: cannot read the event log"));
    let error = refused(folder.path().to_owned());
    assert!(
        error.contains("events.jsonl: cannot read the event log"),
        "{error}"
    );
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
