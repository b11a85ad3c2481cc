//! Tests dialects that `stickler.toml` defines, with a few tables of the real suite.

use crate::common::{STICKLER, output, text};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Output;
use stickler_report::events::{self, Completeness};
use stickler_run::{CaseEvent, Event, Verdict};
use tempfile::TempDir;

const SUITE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../conformance-cases");

/// The case files of the tests, with cases for each kind of override.
const FILES: [&str; 10] = [
    "suite.toml",
    "dialects.toml",
    "sources.toml",
    "rules.md",
    "widening/integer.toml",
    "widening/bool.toml",
    "widening/cross-family.toml",
    "conversion/real-to-integer.toml",
    "conversion/string-borderline.toml",
    "language/comments-nested.st",
];

/// A stickler.toml whose dialect has an override of each kind.
pub const MINE: &str = r#"
[dialects.mine]
extends = "ironplc-ed3"
about = "MyPLC 2.1"
source = "https://example.org/myplc"
[dialects.mine.implicit]
"INT.BOOL" = "yes"
"SINT.INT" = "no"
[dialects.mine.flags]
nested-comments = false
allow-cross-family-widening = true
[dialects.mine.conversions]
rounding = "half-away-from-zero"
out-of-range = "saturate"
text-reading = "leading-number"
"#;

/// Makes a temporary folder with the case files, the given stickler.toml, and an empty one.
pub fn folder(configuration: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for file in FILES {
        let to = folder.path().join("conformance-cases").join(file);
        fs::create_dir_all(to.parent().expect("a parent")).expect("a folder");
        fs::copy(Path::new(SUITE).join(file), to).expect("the case file is there");
    }
    fs::write(folder.path().join("stickler.toml"), configuration).expect("a file");
    fs::write(folder.path().join("empty.toml"), "").expect("a file");
    folder
}

fn reported(output: &Output) -> String {
    text(&output.stderr)
}

/// Returns the cases of the last run, by id and dialect.
fn cases(folder: &Path) -> BTreeMap<String, CaseEvent> {
    let log = fs::read(folder.join("reports/latest/events.jsonl")).expect("a report");
    let mut cases = BTreeMap::new();
    let completeness = events::read(&log[..], &mut |event| {
        if let Event::Case(case) = event {
            cases.insert(format!("{}@{}", case.id, case.dialect), case);
        }
    });
    assert_eq!(completeness.expect("a readable log"), Completeness::Complete);
    cases
}

#[test]
fn promises_of_each_kind_are_kept_by_the_reference() {
    let folder = folder(MINE);
    // Who names it twice means it once.
    let twice = ["run", "--dialect", "mine", "--dialect", "mine"];
    let output = output(folder.path(), &twice);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stdout));
    let note = "note: 1 case of ironplc-ed3 is left out of mine, because what it overrides changes it and no document says \
                how; `stickler list --dialect mine --left-out` lists it\n";
    assert_eq!(reported(&output), note);
    let summary = fs::read_to_string(folder.path().join("reports/latest/summary.md")).expect("a report");
    let line = "\n- mine (MyPLC 2.1) is ironplc-ed3, but for implicit SINT.INT = no, implicit INT.BOOL = yes, \
         allow-cross-family-widening = true, ";
    assert_eq!(summary.matches(line).count(), 1, "{summary}");
    assert!(
        summary.contains("\n- 1 case of ironplc-ed3 left out of mine: "),
        "{summary}"
    );
    let cases = cases(folder.path());
    assert!(cases.keys().all(|key| key.ends_with("@mine")));
    let stated: BTreeSet<&str> = cases
        .values()
        .filter_map(|case| case.basis.strip_prefix("mine: ")?.split(" (").next())
        .collect();
    assert_eq!(
        Vec::from_iter(stated),
        [
            "allow-cross-family-widening",
            "implicit INT.BOOL",
            "implicit SINT.INT",
            "out-of-range",
            "rounding",
            "text-reading"
        ]
    );
    let of = |id: &str| cases[&format!("{id}@mine")].basis.clone();
    assert_eq!(
        of("conversion/real-to-integer::variable(REAL,INT,2.5)"),
        "mine: rounding (stickler.toml:13; https://example.org/myplc)"
    );
    assert_eq!(
        of("widening/integer::assignment(INT,DINT,1)"),
        "ironplc-type-conversions: Integer widening"
    );
}

#[cfg(unix)]
#[test]
fn a_false_promise_fails_exactly_where_it_was_made() {
    let folder = folder(MINE);
    // Who does what the base does, and has never heard of the dialect.
    let engine = format!("cmd:'{STICKLER}' engine --config empty.toml");
    let output = output(folder.path(), &["run", "--dialect", "mine", "--engine", &engine]);
    assert_eq!(output.status.code(), Some(1), "{}", reported(&output));
    let cases = cases(folder.path());
    for (key, case) in &cases {
        let (stated, fails) = (case.basis.starts_with("mine: "), case.verdict == Verdict::Fail);
        assert!(stated || !fails, "{key} fails, and nothing was promised");
        // Of values some are the same by either choice; of types that convert or do not, none.
        let is_cell = ["mine: implicit", "mine: allow"]
            .iter()
            .any(|start| case.basis.starts_with(start));
        assert!(!is_cell || fails, "{key} is promised otherwise, and passes");
    }
    let fails = |id: &str| cases[&format!("{id}@mine")].verdict == Verdict::Fail;
    assert!(fails("conversion/real-to-integer::variable(REAL,INT,2.5)"));
    assert!(!fails("conversion/real-to-integer::variable(REAL,INT,1.0)"));
}

#[cfg(unix)]
#[test]
fn what_a_run_found_is_blessed_and_nothing_that_other_runs_are_about() {
    let engine = format!("[engines.other]\ncommand = \"'{STICKLER}' engine --config empty.toml\"\n");
    let folder = folder(&(MINE.to_owned() + &engine));
    let code = |arguments: &[&str]| {
        let output = output(folder.path(), arguments);
        let all = text(&output.stdout) + &reported(&output);
        (output.status.code(), all)
    };
    let run = ["run", "--engine", "other", "--filter", "widening/integer"];
    let in_mine = [&run[..], &["--dialect", "mine"]].concat();
    assert_eq!(code(&in_mine).0, Some(1));
    let (blessed, all) = code(&["bless"]);
    assert_eq!(blessed, Some(0), "{all}");
    let baseline =
        fs::read_to_string(folder.path().join("reports/baselines/other.toml")).expect("a baseline");
    assert!(baseline.contains("@mine\"\n"), "{baseline}");
    for again in [&in_mine[..], &run] {
        let (code, all) = code(again);
        assert_eq!(code, Some(0), "{all}");
    }
}

#[test]
fn parts_of_a_run_are_put_together_if_their_files_define_the_same() {
    let folder = folder(MINE);
    let other = folder.path().join("other.toml");
    fs::write(
        other,
        MINE.replace("\"SINT.INT\" = \"no\"", "\"SINT.INT\" = \"open\""),
    )
    .expect("a file");
    let run = |arguments: &[&str]| {
        let output = output(folder.path(), arguments);
        (output.status.code(), text(&output.stdout) + &reported(&output))
    };
    let part = |shard: &str, to: &str, file: &str| {
        let (code, all) = run(&[
            "run",
            "--dialect",
            "mine",
            "--shard",
            shard,
            "--report",
            to,
            "--config",
            file,
        ]);
        assert_eq!(code, Some(0), "{all}");
    };
    part("1/2", "one", "stickler.toml");
    part("2/2", "two", "stickler.toml");
    part("2/2", "three", "other.toml");
    let (code, all) = run(&["merge", "one", "two", "-o", "whole"]);
    assert_eq!(code, Some(0), "{all}");
    let summary = fs::read_to_string(folder.path().join("whole/summary.md")).expect("a report");
    assert!(
        summary.contains("\n- 1 case of ironplc-ed3 left out of mine: "),
        "{summary}"
    );
    let (code, all) = run(&["merge", "one", "three", "-o", "false"]);
    assert_eq!(code, Some(2), "{all}");
    assert!(
        all.contains("stickler.toml defines its dialects otherwise"),
        "{all}"
    );
}

#[test]
fn a_run_of_which_nobody_says_a_dialect_is_what_it_was() {
    let folder = folder(MINE);
    let output = |arguments: &[&str]| {
        let output = output(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(0), "{}", reported(&output));
        assert_eq!(reported(&output), "");
        text(&output.stdout)
    };
    let with = output(&["list"]);
    assert!(!with.contains("@mine"));
    assert_eq!(with, output(&["list", "--config", "empty.toml"]));
}

#[test]
fn every_command_knows_the_dialect() {
    let folder = folder(MINE);
    let program = "PROGRAM main\nVAR\n    i : INT := 5;\n    b : BOOL;\n    r : REAL := 2.5;\nEND_VAR\n    b := i;\n    \
                   i := REAL_TO_INT(r);\nEND_PROGRAM\n";
    fs::write(folder.path().join("p.st"), program).expect("a file");
    let shows = |arguments: &[&str], code: i32, part: &str| {
        let output = output(folder.path(), arguments);
        let all = text(&output.stdout) + &reported(&output);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {all}");
        assert!(all.contains(part), "{part}\nin\n{all}");
    };
    let mine = ["--dialect", "mine"];
    let with = |arguments: &[&'static str]| [arguments, &mine].concat();
    shows(&with(&["eval", "p.st"]), 0, "b = BOOL#TRUE\nr = REAL#2.5\n");
    shows(&with(&["eval", "p.st"]), 0, "i = INT#3\n");
    shows(&with(&["check", "p.st"]), 0, "");
    shows(&with(&["render", "p.st"]), 0, "b := i;");
    shows(&["check", "p.st", "--dialect", "ironplc-ed3"], 1, "P4035");
    shows(
        &with(&["conversions", "REAL_TO_INT", "2.5"]),
        0,
        "mine: rounding (stickler.toml:13; https://example.org/myplc)",
    );
    shows(&with(&["sweep", "SINT_TO_INT"]), 0, "mine");
    shows(&with(&["matrix"]), 0, "0 differ");
    shows(
        &["engines", "reference"],
        0,
        "ironplc-rusty-without-partial-access, mine",
    );
    shows(
        &["show", "widening/integer::assignment(SINT,INT)@mine"],
        0,
        "SINT to INT is `no` in mine",
    );
    shows(
        &with(&["list", "--left-out"]),
        0,
        "language/comments-nested@mine\n",
    );
    shows(
        &["list", "--filter", "*(INT,BOOL,1)@mine"],
        0,
        "widening/bool::assignment(INT,BOOL,1)@mine\n",
    );
    shows(
        &["list", "--filter", "*(INT,BOOL,1)@min*"],
        4,
        "a dialect of stickler.toml has cases where --dialect names it",
    );
    shows(
        &with(&["list", "--filter", "nothing-of-it"]),
        4,
        "`stickler list` lists them\n",
    );
    shows(&["run", "--help"], 0, "MyPLC 2.1");
    shows(
        &with(&["fuzz", "--count", "1", "--engine", "reference"]),
        2,
        "mine overrides some; --dialect ironplc-ed3 has those",
    );
    shows(
        &["eval", "p.st", "--dialect", "mien"],
        2,
        "a similar value exists: 'mine'",
    );
    shows(
        &["eval", "p.st", "--config", "empty.toml", "--dialect", "mine"],
        2,
        "invalid value 'mine'",
    );
    shows(
        &["eval", "p.st", "--dialect", "mine", "--config", "empty.toml"],
        2,
        "invalid value 'mine'",
    );
}

#[test]
fn the_matrix_has_no_word_for_types_that_are_taken_away() {
    let folder = folder("[dialects.small]\nextends = \"ironplc-ed3\"\nflags.third-edition-types = false\n");
    let file = "widening/third-edition.toml";
    let to = folder.path().join("conformance-cases").join(file);
    fs::copy(Path::new(SUITE).join(file), to).expect("the case file is there");
    let output = output(folder.path(), &["matrix", "--dialect", "small"]);
    let shown = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{shown}");
    assert!(shown.contains(" 0 differ"), "{shown}");
}

#[test]
fn a_mistake_in_the_file_is_told_before_anything_is_done() {
    let folder = folder(&MINE.replace("\"half-away-from-zero\"", "\"half-away-from-nought\""));
    let told_by = |arguments: &[&str], code: i32| {
        let output = output(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        reported(&output)
    };
    let message = "error: stickler.toml:13:12: `rounding` is not `half-away-from-nought`; there is `truncate`, `half-to-even` \
                   and `half-away-from-zero`\n";
    assert_eq!(told_by(&["run", "--dialect", "mine"], 2), message);
    assert_eq!(told_by(&["list"], 2), message);
    assert_eq!(told_by(&["run", "--help"], 0), "");
    assert_eq!(told_by(&["list", "--config", "empty.toml"], 0), "");
}

/// The file of a documented system that Stickler does not carry.
const TRIAL: &str = r#"
title   = "Trial"
about   = "A system for a test"
extends = "plcnext"
[flags]
nested-comments = false
[conversions]
rounding = "half-away-from-zero"
[implicit]
"INT.BOOL" = "yes"
[variants."trial+nested"]
about = "Trial with comments that nest"
[variants."trial+nested".flags]
nested-comments = true
"#;

/// A table that the trial and its variant judge differently, and a source that speaks for them.
const TRIAL_CASES: [(&str, &str); 2] = [
    (
        "language/trial.toml",
        "title = 'The manual of the trial'\nbasis = 'trial-manual: Conversions'\ndialects = ['trial']\n\
         columns = ['input', 'expected']\nrows = [['2.5', 'INT#3'], ['-2.5', 'INT#-3'], ['3.25', 'INT#3']]\n\
         [[probe]]\nname = 'rounds'\nobserve = 'into : INT'\nexpect = '{expected}'\nsource = \"\"\"\n\
         PROGRAM main\nVAR\n    data : REAL := {input};\n    into : INT;\n    truth : BOOL;\nEND_VAR\n    into := REAL_TO_INT(data);\n    \
         truth := into;\nEND_PROGRAM\n\"\"\"\n",
    ),
    (
        "language/trial-comments.st",
        "(*!\ntitle = \"A comment nests behind the option\"\nbasis = \"trial-manual: Options\"\ndialects = [\"trial\", \"trial+nested\"]\n*)\n\
         PROGRAM main\nVAR\n    into : INT;\nEND_VAR\n    (* (* *) *)  (*! error P0002 in trial *) (*! ok in trial+nested *)\nEND_PROGRAM\n",
    ),
];

#[test]
fn a_documented_system_is_one_file_its_source_and_its_cases() {
    let folder = folder("");
    let cases_folder = folder.path().join("conformance-cases");
    fs::create_dir_all(cases_folder.join("dialects")).expect("a folder");
    fs::write(cases_folder.join("dialects/trial.toml"), TRIAL).expect("a file");
    for (file, content) in TRIAL_CASES {
        fs::write(cases_folder.join(file), content).expect("a file");
    }
    let sources = cases_folder.join("sources.toml");
    let known = fs::read_to_string(&sources).expect("the sources");
    let source = "\n[trial-manual]\ntitle = 'Manual'\npublisher = 'Trial'\nkind = 'document'\naddress = 'https://example.org/trial'\n\
                  read = '2026-11-27'\nengines = []\ndialects = ['trial', 'trial+nested']\nsections = ['Conversions', 'Options']\n";
    fs::write(&sources, known + source).expect("a file");
    let run = output(folder.path(), &["run", "--filter", "language/trial*"]);
    assert_eq!(
        run.status.code(),
        Some(0),
        "{}{}",
        text(&run.stdout),
        reported(&run)
    );
    let verdicts: BTreeMap<String, Verdict> = cases(folder.path())
        .into_iter()
        .map(|(key, case)| (key, case.verdict))
        .collect();
    let expected = [
        "language/trial-comments@trial",
        "language/trial-comments@trial+nested",
        "language/trial::rounds(-2.5)@trial",
        "language/trial::rounds(2.5)@trial",
        "language/trial::rounds(3.25)@trial",
    ];
    assert_eq!(
        verdicts,
        expected.map(|key| (key.to_owned(), Verdict::Pass)).into()
    );
    let shows = |arguments: &[&str], part: &str| {
        let output = output(folder.path(), arguments);
        let all = text(&output.stdout) + &reported(&output);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {all}");
        assert!(all.contains(part), "{part}\nin\n{all}");
    };
    shows(
        &["conversions", "REAL_TO_INT", "2.5", "--dialect", "trial"],
        "2.5    3",
    );
    // The same with a mistake.
    let wrong = TRIAL.replace("nested-comments", "nested-coments");
    fs::write(cases_folder.join("dialects/trial.toml"), wrong).expect("a file");
    let output = output(folder.path(), &["run", "--filter", "language/trial*"]);
    let all = text(&output.stdout) + &reported(&output);
    assert_eq!(output.status.code(), Some(2), "{all}");
    assert!(
        all.contains("trial.toml:6") && all.contains("did you mean `nested-comments`?"),
        "{all}"
    );
}
