//! Tests of baselines that are applied to runs.

use crate::fixtures::{Puppet, executed, expecting, suite, values};
use stickler_engines::{Engine, Outcome, RunRequest};
use stickler_run::{Baseline, CaseEvent, Event, Filter, Header, Plan, RunSummary, Verdict, run};
use stickler_suite::{Case, Suite};
use stickler_types::{Dialect, DialectName};
use stickler_workers::Cancellation;

fn cases(ids: &[&str]) -> Suite {
    let case = |id: &&str| Case {
        source: (*id).into(),
        id: (*id).into(),
        ..expecting(values(&["q = INT#1"]))
    };
    suite(ids.iter().map(case).collect())
}

/// Returns an engine that passes cases whose ids end in `good`, crashes over those in `bad`, does not support those in
/// `odd`, and fails the rest.
fn engine() -> Puppet {
    let answer = |request: &RunRequest<'_>| match request.source {
        good if good.ends_with("good") => executed(&["q = INT#1"]),
        bad if bad.ends_with("bad") => Outcome::Crashed {
            reason: "dead".to_owned(),
        },
        odd if odd.ends_with("odd") => Outcome::Unsupported {
            reason: "cannot".to_owned(),
        },
        _ => executed(&["q = INT#2"]),
    };
    Puppet::new("iron", answer)
}

fn baseline(text: &str) -> Baseline {
    Baseline::read(text, "b/iron.toml", "iron").unwrap()
}

/// Returns an entry of a baseline, with more keys after its reason.
fn entry(case: &str, verdict: &str, more: &str) -> String {
    format!("[[expected]]\ncase = \"{case}\"\nverdict = \"{verdict}\"\nreason = \"why\"\n{more}\n")
}

struct JudgedRun {
    header: Header,
    cases: Vec<CaseEvent>,
    summary: RunSummary,
}

impl JudgedRun {
    fn verdicts(&self) -> Vec<Verdict> {
        self.cases.iter().map(|case| case.verdict).collect()
    }

    fn outdated(&self) -> Vec<String> {
        let outdated = self.header.baselines.iter().flat_map(|held| &held.outdated);
        outdated
            .map(|entry| format!("{} {}: {}", entry.at, entry.case, entry.why))
            .collect()
    }
}

fn go(plan: Plan, suite: &Suite, engine: &dyn Engine) -> JudgedRun {
    let mut events = Vec::new();
    let mut sink = |event| events.push(event);
    let summary = run(&plan, suite, &[engine], &mut sink, &Cancellation::new()).unwrap();
    let mut ended = JudgedRun {
        header: Header::default(),
        cases: Vec::new(),
        summary,
    };
    for event in events {
        match event {
            Event::Header(header) => ended.header = header,
            Event::Case(case) => ended.cases.push(case),
            Event::Cause(_) | Event::Footer(_) => {}
        }
    }
    ended
}

fn held(text: &str, ids: &[&str]) -> JudgedRun {
    let plan = Plan {
        baselines: vec![baseline(text)],
        today: jiff::civil::date(2026, 11, 21),
        ..Plan::default()
    };
    go(plan, &cases(ids), &engine())
}

#[test]
fn of_several_verdicts_each_may_come() {
    let text = "[[expected]]\ncase = \"*\"\nverdict = [\"fail\", \"pass\"]\nreason = \"by chance\"\n";
    let ended = held(text, &["a/bad", "a/good", "a/odd", "a/x"]);
    let verdicts = [
        Verdict::Crash,
        Verdict::Pass,
        Verdict::Unsupported,
        Verdict::Xfail,
    ];
    assert_eq!(ended.verdicts(), verdicts);
    let came = ended
        .cases
        .iter()
        .map(CaseEvent::actual_verdict)
        .collect::<Vec<_>>();
    assert_eq!(came[3], Verdict::Fail);
    assert_eq!(came[..3], verdicts[..3]);

    let text = text.replace("fail", "timeout").replace("pass", "crash");
    let ended = held(&text, &["a/bad", "a/good"]);
    assert_eq!(ended.verdicts(), [Verdict::Xfail, Verdict::Xpass]);
    // The actual verdict comes first, so that a reader of a single verdict gets the right one.
    let note = ended.cases[0].baseline.as_ref().unwrap();
    assert_eq!(note.verdicts(), [Verdict::Crash, Verdict::Timeout]);
    assert_eq!(ended.cases[0].actual_verdict(), Verdict::Crash);
}

#[test]
fn what_is_expected_to_fail_fails_as_expected_and_says_why() {
    let text = entry("a/x", "fail", "link = \"https://example.org/7\"") + &entry("a/bad", "crash", "");
    let ended = held(&text, &["a/bad", "a/good", "a/x"]);
    assert_eq!(ended.verdicts(), [Verdict::Xfail, Verdict::Pass, Verdict::Xfail]);
    let note = ended.cases[2].baseline.as_ref().unwrap();
    assert_eq!(
        (note.at.as_str(), note.verdict, note.reason.as_str()),
        ("b/iron.toml:1", Verdict::Fail, "why")
    );
    assert_eq!(note.link.as_deref(), Some("https://example.org/7"));
    assert_eq!(ended.cases[1].baseline, None);
    assert_eq!(ended.outdated(), [""; 0]);
    assert_eq!(
        (ended.summary.outdated, ended.summary.totals.unexpected()),
        (0, 0)
    );
}

#[test]
fn a_pass_that_is_not_expected_and_a_worse_failure_than_expected_are_seen() {
    let text = entry("a/*", "fail", "");
    let ended = held(&text, &["a/bad", "a/good", "a/odd", "a/x"]);
    assert_eq!(
        ended.verdicts(),
        [
            Verdict::Crash,
            Verdict::Xpass,
            Verdict::Unsupported,
            Verdict::Xfail
        ]
    );
    assert_eq!(ended.summary.totals.unexpected(), 2);
}

#[test]
fn what_is_expected_to_be_unsupported_may_not_pass_unseen() {
    let text = entry("a/*", "unsupported", "");
    let ended = held(&text, &["a/good", "a/odd", "a/x"]);
    assert_eq!(
        ended.verdicts(),
        [Verdict::Xpass, Verdict::Unsupported, Verdict::Fail]
    );
}

#[test]
fn the_id_of_a_case_goes_before_a_pattern_and_the_first_of_two_patterns_counts() {
    let text = entry("a/b*", "fail", "") + &entry("a/*", "crash", "") + &entry("a/bad", "crash", "");
    let ended = held(&text, &["a/b", "a/bad", "a/c-bad"]);
    assert_eq!(ended.verdicts(), [Verdict::Xfail; 3]);
    assert_eq!(ended.cases[1].baseline.as_ref().unwrap().at, "b/iron.toml:11");
}

#[test]
fn an_entry_may_name_a_dialect() {
    let mut suite = cases(&["a/x", "a/x"]);
    suite.cases[1].dialect = DialectName::PLCNEXT;
    let plan = Plan {
        baselines: vec![baseline(&entry("a/x@plcnext", "fail", ""))],
        ..Plan::default()
    };
    assert_eq!(
        go(plan, &suite, &engine()).verdicts(),
        [Verdict::Fail, Verdict::Xfail]
    );
}

#[test]
fn an_entry_that_fits_no_case_of_the_suite_is_out_of_date() {
    // A filter without a `*` is an id, never a part of one.
    let text = entry("b/*", "fail", "") + &entry("a/", "fail", "");
    let ended = held(&text, &["a/good"]);
    assert_eq!(
        ended.outdated(),
        [
            "b/iron.toml:1 b/*: fits no case that the engine could be asked",
            "b/iron.toml:6 a/: is no case that the engine could be asked; a pattern has a `*`"
        ]
    );
    assert_eq!(ended.summary.outdated, 2);
}

#[test]
fn a_filter_makes_no_entry_stale_and_a_dialect_that_the_engine_does_not_speak_does() {
    let plan = |case: &str| Plan {
        baselines: vec![baseline(&entry(case, "fail", ""))],
        filters: vec![Filter::new("a/good")],
        ..Plan::default()
    };
    let suite = cases(&["a/good", "a/x"]);
    assert_eq!(go(plan("a/x"), &suite, &engine()).summary.outdated, 0);
    let other = plan("a/x@plcnext");
    assert_eq!(go(other, &suite, &engine()).summary.outdated, 1);
}

#[test]
fn of_a_dialect_that_was_defined_and_takes_no_part_nothing_is_called_stale() {
    let define =
        |name: &str| DialectName::define(Dialect::custom(name, DialectName::MATIEC, "here")).unwrap();
    let defined = define("holds-beside");
    let plan = |case: &str| Plan {
        baselines: vec![baseline(&entry(case, "fail", ""))],
        ..Plan::default()
    };
    let outdated = |plan, suite: &Suite| go(plan, suite, &engine()).summary.outdated;
    let mut suite = cases(&["a/good"]);
    assert_eq!(outdated(plan("a/gone@holds-beside"), &suite), 0);
    let taken_over = suite.cases[0].clone();
    suite.cases.push(Case {
        dialect: defined,
        ..taken_over
    });
    assert_eq!(outdated(plan("a/gone@holds-beside"), &suite), 1);
}

#[test]
fn an_entry_holds_on_its_last_day_and_no_longer() {
    let ended = held(&entry("a/x", "fail", "until = 2026-11-21"), &["a/x"]);
    assert_eq!(
        (ended.verdicts(), ended.summary.outdated),
        (vec![Verdict::Xfail], 0)
    );
    let ended = held(&entry("a/x", "fail", "until = 2026-11-20"), &["a/x"]);
    assert_eq!(
        (ended.verdicts(), ended.summary.outdated),
        (vec![Verdict::Fail], 1)
    );
    assert_eq!(
        ended.outdated(),
        ["b/iron.toml:1 a/x: was to hold until 2026-11-20"]
    );
}

#[test]
fn an_entry_about_other_versions_is_neither_used_nor_stale() {
    // The engine's version is `1`.
    let ended = held(&entry("a/x", "fail", "versions = \"<1.2\""), &["a/x"]);
    assert_eq!(
        (ended.verdicts(), ended.summary.outdated),
        (vec![Verdict::Xfail], 0)
    );
    let ended = held(&entry("a/x", "fail", "versions = \">=1.2\""), &["a/x"]);
    assert_eq!(
        (ended.verdicts(), ended.summary.outdated),
        (vec![Verdict::Fail], 0)
    );
}

#[test]
fn a_baseline_of_another_engine_is_not_used() {
    let plan = Plan {
        baselines: vec![Baseline {
            engine: "matiec".to_owned(),
            ..baseline(&entry("a/x", "fail", ""))
        }],
        ..Plan::default()
    };
    let ended = go(plan, &cases(&["a/x"]), &engine());
    assert_eq!(ended.verdicts(), [Verdict::Fail]);
    assert!(ended.header.baselines.is_empty());
}

#[test]
fn of_a_suite_that_could_not_be_read_nothing_is_called_stale() {
    let mut suite = cases(&["a/good"]);
    suite.errors = Suite::load(std::path::Path::new("no such folder anywhere")).errors;
    assert!(
        !suite.errors.is_empty(),
        "a folder that is not there is a mistake"
    );
    let plan = Plan {
        baselines: vec![baseline(&entry("b/*", "fail", ""))],
        ..Plan::default()
    };
    assert_eq!(go(plan, &suite, &engine()).summary.outdated, 0);
}

#[test]
fn a_case_that_no_baseline_knows_is_judged_as_ever() {
    let ended = held("", &["a/bad", "a/good"]);
    assert_eq!(ended.verdicts(), [Verdict::Crash, Verdict::Pass]);
    assert_eq!(ended.header.baselines.len(), 1, "it took part all the same");
}
