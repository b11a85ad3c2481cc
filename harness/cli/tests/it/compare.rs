//! Tests `stickler compare` with two runs, and `stickler merge` with the parts of a run.

use crate::common::{SUITE, output, text};
use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;
use stickler_report::events::{self, Completeness, EventLog};
use stickler_run::{Event, Fact, Totals, Verdict};
use stickler_types::Value;

/// Runs the small suite and writes its reports to a folder.
fn run(folder: &Path, report: &str, arguments: &[&str]) {
    let common = ["run", "--cases", SUITE, "--report", report];
    output(folder, &[&common, arguments].concat());
}

/// Writes the log of a run that differs from another in one way.
fn edited(folder: &Path, from: &str, to: &str, edit: impl Fn(&mut Event)) {
    let mut events = Vec::new();
    let log = File::open(folder.join(from).join(events::NAME)).expect("a log");
    let whole = events::read(BufReader::new(log), &mut |event| events.push(event)).expect("a readable log");
    assert_eq!(whole, Completeness::Complete);
    events.iter_mut().for_each(edit);
    write(&folder.join(to), &events);
}

fn write(folder: &Path, events: &[Event]) {
    fs::create_dir_all(folder).expect("a folder");
    let mut log = EventLog::create(folder.join(events::NAME)).expect("a log");
    for event in events {
        log.take(event).expect("written");
    }
    log.flush().expect("written");
}

/// Turns a run into that of a later version of the reference: one case is fixed, one breaks, one crashes, one gives another
/// result where nothing is asserted.
fn later(event: &mut Event) {
    let value = |literal| Value::parse(literal).expect("a typed literal");
    let into = |literal| Fact::Value {
        name: "into".to_owned(),
        value: value(literal),
    };
    let case = match event {
        Event::Header(header) => return header.engines[0].version = "0.2.0".to_owned(),
        Event::Case(case) => case,
        Event::Cause(_) => return,
        Event::Footer(footer) => {
            let totals = Totals {
                fail: 1,
                crash: 1,
                pass: footer.totals.pass - 1,
                ..footer.totals
            };
            footer.engines[0].totals = totals;
            return footer.totals = totals;
        }
    };
    match (&*case.id, &*case.dialect) {
        ("language/wrong-on-purpose", _) => {
            case.verdict = Verdict::Pass;
            case.got.clear();
            case.expected.clear();
        }
        ("widening/integer::assignment(INT,INT,-128)", "ironplc-ed2") => {
            case.verdict = Verdict::Fail;
            case.expected = vec![into("INT#-128")];
            case.got = vec![into("INT#128")];
        }
        ("widening/integer::assignment(SINT,SINT,-128)", "matiec") => {
            case.verdict = Verdict::Crash;
            case.expected = vec![into("SINT#-128")];
            case.got = vec![Fact::Crashed {
                reason: "signal 11".to_owned(),
            }];
        }
        ("language/recorded", _) => case.observations[0].value.push('0'),
        _ => {}
    }
}

#[test]
fn a_newer_version_is_shown_with_what_it_fixed_and_broke() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    run(folder.path(), "old", &[]);
    edited(folder.path(), "old", "new", later);
    let compared = output(folder.path(), &["compare", "old", "new/events.jsonl"]);
    let page = text(&compared.stdout);
    assert_eq!(
        compared.status.code(),
        Some(1),
        "{page}{}",
        text(&compared.stderr)
    );
    for part in [
        "old  reference 0.1.0; suite ",
        "new  reference 0.2.0; suite ",
        "CRASHED widening/integer::assignment(SINT,SINT,-128)@matiec: pass → crash\n",
        "     old      - into = SINT#-128\n     new      + crashed: signal 11\n",
        "BROKEN widening/integer::assignment(INT,INT,-128)@ironplc-ed2: pass → fail\n",
        "     old      - into = INT#-128\n     new      + into = INT#128\n",
        "FIXED language/wrong-on-purpose@matiec: fail → pass\n",
        "OTHERWISE language/recorded@matiec: pass as before, and not the same\n",
        "\n16 cases: 1 crashed, 1 broken, 1 fixed, 1 otherwise; 12 as before.\n",
    ] {
        assert!(page.contains(part), "{part}\n{page}");
    }
    let back = output(folder.path(), &["compare", "new", "old"]);
    assert_eq!(back.status.code(), Some(1), "{}", text(&back.stdout));
    let same = output(folder.path(), &["compare", "old", "old"]);
    assert_eq!(same.status.code(), Some(0));
    assert!(
        text(&same.stdout).ends_with("16 cases: all as before.\n"),
        "{}",
        text(&same.stdout)
    );
}

#[test]
fn other_programs_get_every_change_as_json() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    run(folder.path(), "old", &["--filter", "widening/"]);
    run(folder.path(), "all", &[]);
    edited(folder.path(), "all", "new", later);
    let compared = output(folder.path(), &["compare", "old", "new", "--json"]);
    assert_eq!(compared.status.code(), Some(1));
    let document: serde_json::Value = serde_json::from_slice(&compared.stdout).expect("JSON");
    let expected = serde_json::json!({
        "crashed": 1, "broken": 1, "fixed": 0, "otherwise": 0, "added": 3, "gone": 0, "same": 11
    });
    assert_eq!(document["counts"], expected);
    assert_eq!(document["changes"][0]["kind"], "broken");
    assert_eq!(document["changes"][0]["detail"]["old"], "into = INT#-128");
    assert_eq!(document["changes"][0]["detail"]["new"], "into = INT#128");
    let gone = output(folder.path(), &["compare", "all", "old"]);
    assert_eq!(gone.status.code(), Some(0), "fewer cases are no worse compiler");
    assert!(
        text(&gone.stdout).contains("3 cases are gone: 2 pass, 1 fail\n"),
        "{}",
        text(&gone.stdout)
    );
}

#[test]
fn what_cannot_be_compared_is_said_with_its_place() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    run(folder.path(), "old", &[]);
    run(folder.path(), "part", &["--shard", "1/2"]);
    edited(folder.path(), "old", "cut", |_| {});
    let log = fs::read_to_string(folder.path().join("cut/events.jsonl")).expect("a log");
    let footer = log.trim_end().rfind('\n').expect("lines") + 1;
    fs::write(folder.path().join("cut/events.jsonl"), &log[..footer]).expect("a log");
    fs::create_dir(folder.path().join("first")).expect("a folder");
    let format = log.replace(r#""format":3"#, r#""format":1"#);
    fs::write(folder.path().join("first/events.jsonl"), format).expect("a log");
    for (old, new, reason) in [
        (
            "old",
            "cut",
            "cut/events.jsonl: the newer run cannot be compared: the run was cut short after 16 cases",
        ),
        (
            "cut",
            "old",
            "cut/events.jsonl: the older run cannot be compared: the run was cut short",
        ),
        (
            "old",
            "part",
            "the older run is whole and the newer one part 1/2; `stickler merge` makes a whole",
        ),
        (
            "first",
            "old",
            "first/events.jsonl: the older run cannot be compared: the event log has format 1, which an earlier version",
        ),
        (
            "old",
            "old/results.json",
            "old/results.json: the newer run cannot be compared: this is a results.json of format 3 and no event log",
        ),
        ("old", "nowhere", "nowhere: cannot read the event log"),
        (
            "old",
            "old/summary.md",
            "old/summary.md: the newer run cannot be compared: line 1 of the event log is no header",
        ),
    ] {
        let compared = output(folder.path(), &["compare", old, new]);
        let said = text(&compared.stderr);
        assert_eq!(compared.status.code(), Some(2), "{said}");
        assert!(said.contains(reason), "{reason}\n{said}");
        assert_eq!(text(&compared.stdout), "");
    }
}

#[test]
fn the_parts_of_a_run_are_put_together_to_all_reports_of_the_whole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    run(folder.path(), "whole", &[]);
    run(folder.path(), "one", &["--shard", "1/2"]);
    run(folder.path(), "two", &["--shard", "2/2"]);
    let merged = output(
        folder.path(),
        &["merge", "--cases", SUITE, "two", "one", "-o", "merged"],
    );
    assert_eq!(merged.status.code(), Some(1), "{}", text(&merged.stderr));
    assert!(
        text(&merged.stdout).contains("1 of 16 cases not as expected (1 fail)"),
        "{}",
        text(&merged.stdout)
    );
    for file in [
        "events.jsonl",
        "results.json",
        "junit.xml",
        "summary.md",
        "results.sarif",
        "gl-code-quality-report.json",
        "badge.json",
        "index.html",
    ] {
        assert!(folder.path().join("merged").join(file).exists(), "{file}");
    }
    let same = output(folder.path(), &["compare", "whole", "merged"]);
    assert!(
        text(&same.stdout).ends_with("16 cases: all as before.\n"),
        "{}",
        text(&same.stdout)
    );
}

#[test]
fn parts_that_are_not_all_of_them_are_never_called_the_whole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    run(folder.path(), "one", &["--shard", "1/2"]);
    for (parts, reason) in [
        (&["one"][..], "note: part 2/2 is missing"),
        (
            &["one", "two"],
            "note: two cannot be read: cannot read the event log",
        ),
        (
            &["one", "one"],
            "note: part 1/2 is there more than once: one and one",
        ),
    ] {
        let arguments = [&["merge", "--cases", SUITE, "-o", "merged"], parts].concat();
        let merged = output(folder.path(), &arguments);
        let (page, said) = (text(&merged.stdout), text(&merged.stderr));
        assert_eq!(merged.status.code(), Some(2), "{page}{said}");
        assert!(said.contains(reason), "{said}");
        assert!(page.contains("Cut short after"), "{page}");
        let left: Vec<_> = fs::read_dir(folder.path().join("merged"))
            .expect("the folder")
            .collect();
        assert_eq!(left.len(), 1, "only the log");
    }
    let own = output(folder.path(), &["merge", "one", "-o", "one"]);
    assert_eq!(own.status.code(), Some(2));
    assert!(
        text(&own.stderr).contains("one is one of the parts; name another folder"),
        "{}",
        text(&own.stderr)
    );
    assert!(
        folder
            .path()
            .join("one/events.jsonl")
            .metadata()
            .is_ok_and(|log| log.len() > 0),
        "the part is still there"
    );
}

#[test]
fn a_site_is_built_of_two_versions_and_refused_without_a_run() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    run(folder.path(), "old", &[]);
    edited(folder.path(), "old", "new", later);
    let site = |arguments: &[&str]| output(folder.path(), &[&["site", "--cases", SUITE], arguments].concat());
    let built = site(&["old", "new", "-o", "site"]);
    assert_eq!(built.status.code(), Some(0), "{}", text(&built.stderr));
    assert_eq!(
        text(&built.stdout),
        "2 runs of 1 engine, 0 conversion functions: site/index.html\n"
    );
    let front = fs::read_to_string(folder.path().join("site/index.html")).expect("the front page");
    assert!(front.contains("1 fixed, 1 broken, 1 crashed"), "{front}");
    assert!(folder.path().join("site/runs/1.html").is_file());
    for (arguments, message) in [
        (&["-o", "none"][..], "error: a site needs a run: name the folder"),
        (
            &["missing", "-o", "none"],
            "error: missing: cannot read the event log: ",
        ),
        (&["old/index.html", "-o", "none"], "error: old/index.html: "),
        (
            &["old", "-o", "site/index.html"],
            "error: site/index.html is a file; name a folder",
        ),
    ] {
        let refused = site(arguments);
        let said = text(&refused.stderr);
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(said.starts_with(message), "{said}");
    }
    let twice = site(&["old", "old", "-o", "twice"]);
    let said = text(&twice.stderr);
    assert!(
        said.starts_with("note: old/events.jsonl does not count for reference 0.1.0: the later run of "),
        "{said}"
    );
}
