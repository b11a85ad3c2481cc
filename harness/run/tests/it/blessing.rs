//! Tests of baselines that are rewritten from runs.

use crate::fixtures::{case, suite};
use jiff::civil::date;
use stickler_run::{
    Baseline, BaselineNote, Blessing, CaseEvent, ChangeKind, EngineHeader, EngineRun, Grade, Verdict, bless,
};
use stickler_suite::{Case, Suite};
use stickler_types::{Dialect, DialectName};

const IDS: [&str; 5] = [
    "a/one",
    "a/t::p(INT,1)",
    "a/t::p(INT,2)",
    "a/t::p(SINT,1)",
    "a/t::q(INT,1)",
];

/// Returns a suite of the cases of [`IDS`], each in two dialects that the engine supports and in one that it does not.
fn whole() -> Suite {
    let dialects = [
        DialectName::IRONPLC_ED2,
        DialectName::IRONPLC_ED3,
        DialectName::MATIEC,
    ];
    let cases = IDS
        .iter()
        .flat_map(|id| dialects.map(|dialect| Case { dialect, ..case(id) }));
    suite(cases.collect())
}

/// Returns a run in which every case passes but these: `a/one@ironplc-ed2 fail`, or with a pattern (`a/t::p( fail`).
fn ran(but: &[(&str, Verdict)]) -> EngineRun {
    let mut run = EngineRun::new(EngineHeader {
        name: "iron".to_owned(),
        version: "1.2".to_owned(),
        dialects: vec!["ironplc-ed2".to_owned(), "ironplc-ed3".to_owned()],
        strict: Grade::Code,
        rerun: String::new(),
        commands: std::collections::BTreeMap::new(),
    });
    for case in whole().cases {
        if case.dialect == DialectName::MATIEC {
            continue;
        }
        let key = format!("{}@{}", case.id, case.dialect);
        let found = but.iter().find(|(start, _)| key.starts_with(start));
        run.take(&event(
            &case.id,
            case.dialect.as_str(),
            found.map_or(Verdict::Pass, |but| but.1),
        ));
    }
    run
}

fn event(id: &str, dialect: &str, verdict: Verdict) -> CaseEvent {
    CaseEvent {
        id: id.to_owned(),
        dialect: dialect.to_owned(),
        engine: "iron".to_owned(),
        verdict,
        ..CaseEvent::default()
    }
}

fn blessed(text: &str, run: &EngineRun) -> Blessing {
    let baseline = Baseline::read(text, "b/iron.toml", "iron").unwrap();
    let blessing = bless(text, &baseline, run, &whole(), date(2026, 11, 21));
    let again = Baseline::read(&blessing.text, "b/iron.toml", "iron").unwrap();
    assert_eq!(again.entries.len(), blessing.entries, "{}", blessing.text);
    // The blessed baseline expects the actual verdicts, so blessing again changes nothing.
    let twice = bless(&blessing.text, &again, run, &whole(), date(2026, 11, 21));
    assert_eq!(
        (twice.text.as_str(), twice.changes.len()),
        (blessing.text.as_str(), 0)
    );
    blessing
}

fn cases(blessing: &Blessing) -> Vec<String> {
    let baseline = Baseline::read(&blessing.text, "b/iron.toml", "iron").unwrap();
    let reported = baseline.entries.iter();
    reported
        .map(|entry| format!("{} {}", Verdict::any_of(&entry.verdicts), entry.case.as_str()))
        .collect()
}

#[test]
fn what_did_not_pass_is_written_down_in_few_entries() {
    let run = ran(&[("a/t::p(", Verdict::Fail), ("a/one@ironplc-ed3", Verdict::Crash)]);
    let blessing = blessed("", &run);
    assert_eq!(cases(&blessing), ["crash a/one@ironplc-ed3", "fail a/t::p(*"]);
    assert!(
        blessing.text.starts_with("# What this engine"),
        "{}",
        blessing.text
    );
    assert!(!blessing.text.contains("engine ="), "the file's name says it");
    assert!(
        blessing
            .text
            .contains("reason = \"not looked into yet: seen on 2026-11-21 in iron 1.2\""),
        "{}",
        blessing.text
    );
    let reported: Vec<_> = blessing
        .changes
        .iter()
        .map(|change| (change.kind, change.why.as_str()))
        .collect();
    assert_eq!(
        reported,
        [(ChangeKind::Added, "1 case"), (ChangeKind::Added, "6 cases")]
    );
}

#[test]
fn what_is_unsupported_needs_no_entry() {
    let blessing = blessed("", &ran(&[("a/", Verdict::Unsupported)]));
    assert_eq!((blessing.entries, blessing.changes.len()), (0, 0));
}

const OLD: &str = r#"# Kept by hand.

# The tracker knows.
[[expected]]
case = "a/t::p(*" # all of them
verdict = "fail"
reason = "rounds"
link = "https://example.org/1"

[[expected]]
verdict = "crash"
case = "a/one"
reason = "dies"
"#;

#[test]
fn an_entry_that_is_still_so_stays_letter_by_letter() {
    let run = ran(&[("a/t::p(", Verdict::Fail), ("a/one", Verdict::Crash)]);
    let blessing = blessed(OLD, &run);
    assert_eq!(blessing.text, OLD);
    assert_eq!(blessing.changes, []);
}

#[test]
fn an_entry_goes_when_all_its_cases_pass_and_says_what_came() {
    let blessing = blessed(OLD, &ran(&[("a/t::p(", Verdict::Fail)]));
    assert_eq!(cases(&blessing), ["fail a/t::p(*"]);
    assert_eq!(blessing.changes.len(), 1);
    assert_eq!(
        (blessing.changes[0].kind, blessing.changes[0].why.as_str()),
        (ChangeKind::Removed, "2 now pass")
    );
}

#[test]
fn an_entry_of_which_a_part_is_still_so_is_narrowed_and_keeps_reason_link_and_comment() {
    let run = ran(&[
        ("a/t::p(INT,1)", Verdict::Fail),
        ("a/t::p(SINT,1)@ironplc-ed2", Verdict::Fail),
        ("a/one", Verdict::Crash),
    ]);
    let blessing = blessed(OLD, &run);
    let expected = OLD.replace(
        "case = \"a/t::p(*\" # all of them\nverdict = \"fail\"\nreason = \"rounds\"\nlink = \"https://example.org/1\"\n",
        "case = \"a/t::p(INT,1)\" # all of them\nverdict = \"fail\"\nreason = \"rounds\"\nlink = \"https://example.org/1\"\n\n\
         [[expected]]\ncase = \"a/t::p(SINT,1)@ironplc-ed2\" # all of them\nverdict = \"fail\"\nreason = \"rounds\"\n\
         link = \"https://example.org/1\"\n",
    );
    assert_eq!(blessing.text, expected);
    assert_eq!(
        (blessing.changes[0].kind, blessing.changes[0].why.as_str()),
        (ChangeKind::Narrowed, "3 now pass")
    );
}

#[test]
fn a_case_that_does_something_else_gets_an_entry_of_its_own_without_the_old_reason() {
    let run = ran(&[
        ("a/t::p(INT,1)", Verdict::Timeout),
        ("a/t::p(", Verdict::Fail),
        ("a/one", Verdict::Crash),
    ]);
    let blessing = blessed(OLD, &run);
    assert_eq!(
        cases(&blessing),
        [
            "fail a/t::p(INT,2)",
            "fail a/t::p(SINT,1)",
            "crash a/one",
            "timeout a/t::p(INT,1)"
        ]
    );
    assert_eq!(blessing.text.matches("reason = \"rounds\"").count(), 2);
}

#[test]
fn cases_that_were_not_run_stay_as_they_are() {
    let mut run = EngineRun::new(ran(&[]).engine().clone());
    run.take(&event("a/t::p(INT,1)", "ironplc-ed2", Verdict::Pass));
    let blessing = blessed(OLD, &run);
    assert_eq!(
        cases(&blessing),
        [
            "fail a/t::p(INT,1)@ironplc-ed3",
            "fail a/t::p(INT,2)",
            "fail a/t::p(SINT,1)",
            "crash a/one"
        ]
    );
}

#[test]
fn an_entry_of_several_verdicts_stays_while_any_of_them_comes() {
    let text = "[[expected]]\ncase = \"a/one\"\nverdict = [\"crash\", \"pass\"]\nreason = \"by chance\"\n";
    for came in [Verdict::Pass, Verdict::Crash] {
        let blessing = blessed(text, &ran(&[("a/one", came)]));
        assert_eq!((blessing.text.as_str(), blessing.changes.len()), (text, 0));
    }
    let blessing = blessed(text, &ran(&[("a/one", Verdict::Fail)]));
    assert_eq!(cases(&blessing), ["fail a/one"]);
    let removed = &blessing.changes[0];
    assert_eq!(
        (removed.kind, Verdict::any_of(&removed.verdicts)),
        (ChangeKind::Removed, "crash or pass".to_owned())
    );
}

#[test]
fn what_a_baseline_turned_is_turned_back_first() {
    let mut run = EngineRun::new(ran(&[]).engine().clone());
    for dialect in ["ironplc-ed2", "ironplc-ed3"] {
        run.take(&CaseEvent {
            baseline: Some(BaselineNote {
                at: String::new(),
                verdict: Verdict::Crash,
                others: Vec::new(),
                reason: String::new(),
                link: None,
            }),
            ..event("a/one", dialect, Verdict::Xfail)
        });
        run.take(&event("a/t::p(INT,1)", dialect, Verdict::Xpass));
    }
    let blessing = blessed(OLD, &run);
    assert_eq!(
        cases(&blessing),
        ["fail a/t::p(INT,2)", "fail a/t::p(SINT,1)", "crash a/one"]
    );
}

#[test]
fn the_comment_that_opens_the_file_stays_whichever_entry_goes() {
    let run = ran(&[("a/one", Verdict::Crash)]);
    let blessing = blessed(OLD, &run);
    assert!(
        blessing
            .text
            .starts_with("# Kept by hand.\n\n[[expected]]\nverdict = \"crash\"\ncase = \"a/one\"\n"),
        "{}",
        blessing.text
    );
    let nothing = blessed(OLD, &ran(&[]));
    assert_eq!(nothing.text, "# Kept by hand.\n");
    let again = blessed(&nothing.text, &run);
    assert!(
        again.text.starts_with("# Kept by hand.\n\n[[expected]]\n"),
        "{}",
        again.text
    );
}

#[test]
fn a_dialect_that_was_defined_has_entries_where_it_takes_part_and_keeps_them_elsewhere() {
    let defined = DialectName::define(Dialect::custom("blessed", DialectName::IRONPLC_ED3, "here")).unwrap();
    let base = DialectName::IRONPLC_ED3;
    // Of what it states itself, only it has the case.
    let with = [("a/one", base), ("a/one", defined), ("a/own(1)", defined)];
    let with = with.map(|(id, dialect)| Case { dialect, ..case(id) });
    let mut run = EngineRun::new(ran(&[]).engine().clone());
    run.take(&event("a/one", "ironplc-ed3", Verdict::Pass));
    run.take(&event("a/one", "blessed", Verdict::Fail));
    run.take(&event("a/own(1)", "blessed", Verdict::Fail));
    let nothing = Baseline::read("", "b/iron.toml", "iron").unwrap();
    let blessing = bless("", &nothing, &run, &suite(with.to_vec()), date(2026, 11, 21));
    assert_eq!(blessing.strangers, 0);
    assert_eq!(cases(&blessing), ["fail a/one@blessed", "fail a/own(1)@blessed"]);
    let elsewhere = blessed(&blessing.text, &ran(&[]));
    assert_eq!(elsewhere.text, blessing.text);
}

#[test]
fn an_entry_that_fits_no_case_goes() {
    let text = OLD.replace("a/one", "a/gone");
    let blessing = blessed(&text, &ran(&[("a/t::p(", Verdict::Fail)]));
    assert_eq!(cases(&blessing), ["fail a/t::p(*"]);
    assert_eq!(blessing.changes[0].why, "fits no case");
}

#[test]
fn an_entry_past_its_day_that_is_still_so_loses_its_day_and_nothing_else() {
    let text = OLD.replace("reason = \"dies\"", "until = 2026-11-20\nreason = \"dies\"");
    let blessing = blessed(&text, &ran(&[("a/", Verdict::Crash)]));
    assert!(
        blessing.text.contains("case = \"a/one\"\nreason = \"dies\"\n"),
        "{}",
        blessing.text
    );
    let undated = blessing
        .changes
        .iter()
        .find(|change| change.kind == ChangeKind::Undated);
    assert_eq!(undated.map(|change| change.case.as_str()), Some("a/one"));
}

#[test]
fn an_entry_about_other_versions_is_left_alone() {
    let text = OLD.replace("reason = \"dies\"", "reason = \"dies\"\nversions = \">=2\"");
    let blessing = blessed(&text, &ran(&[("a/t::p(", Verdict::Fail)]));
    assert_eq!(blessing.text, text);
}

#[test]
fn a_case_that_the_suite_no_longer_has_is_counted_and_not_written() {
    let mut run = ran(&[]);
    run.take(&event("a/old", "ironplc-ed2", Verdict::Fail));
    let blessing = blessed("", &run);
    assert_eq!((blessing.strangers, blessing.entries), (1, 0));
}

#[test]
fn a_file_that_is_not_named_after_the_engine_says_whose_it_is() {
    let run = ran(&[("a/one", Verdict::Fail)]);
    let old = Baseline {
        file: "ci/known.toml".to_owned(),
        ..Baseline::default()
    };
    let blessing = bless("", &old, &run, &whole(), date(2026, 11, 21));
    let read = Baseline::read(&blessing.text, "ci/known.toml", "known").unwrap();
    assert_eq!(read.engine, "iron");
}
