//! Tests of baselines that name dialects of `stickler.toml`, and of suites that cannot be read.

use crate::fixtures::{case, engine_header, event, puppet, suite, timeless_run};
use crate::words::outcome;
use jiff::civil::date;
use stickler_run::{Baseline, BaselineNote, CaseEvent, EngineRun, Plan, Verdict, bless};
use stickler_suite::{Case, Suite};
use stickler_types::{Dialect, DialectName};

/// Returns a dialect of `stickler.toml` that overrides nothing.
pub(crate) fn extending(name: &str, base: DialectName) -> DialectName {
    DialectName::define(Dialect::custom(name, base, "here")).unwrap()
}

fn entry(case: &str, verdict: &str) -> String {
    format!("[[expected]]\ncase = \"{case}\"\nverdict = \"{verdict}\"\nreason = \"why\"\n")
}

/// Returns how many entries of a baseline with this case are out of date in a run of the suite.
fn outdated(case: &str, suite: &Suite) -> u64 {
    let plan = Plan {
        baselines: vec![Baseline::read(&entry(case, "fail"), "b/iron.toml", "iron").unwrap()],
        ..Plan::default()
    };
    let engine = puppet("iron", |_| outcome("executed"));
    timeless_run(&plan, suite, &[&engine], &[]).0.outdated
}

#[test]
fn of_a_dialect_that_was_defined_and_takes_no_part_nothing_is_called_stale() {
    let dialect = extending("holds-beside", DialectName::MATIEC);
    let mut cases = vec![case("a/good")];
    assert_eq!(outdated("a/gone@holds-beside", &suite(cases.clone())), 0);
    cases.push(Case {
        dialect,
        ..case("a/good")
    });
    assert_eq!(outdated("a/gone@holds-beside", &suite(cases)), 1);
}

#[test]
fn of_a_suite_that_could_not_be_read_nothing_is_called_stale() {
    let mut suite = suite(vec![case("a/good")]);
    suite.errors = Suite::load(std::path::Path::new("no such folder anywhere")).errors;
    assert!(
        !suite.errors.is_empty(),
        "a folder that is not there is a mistake"
    );
    assert_eq!(outdated("b/*", &suite), 0);
}

/// Returns a run of `iron` with these verdicts.
fn ran(verdicts: &[(&str, &str, Verdict)]) -> EngineRun {
    let mut run = EngineRun::new(engine_header("iron"));
    for (id, dialect, verdict) in verdicts {
        let note = BaselineNote {
            verdict: Verdict::Crash,
            ..BaselineNote::default()
        };
        run.take(&CaseEvent {
            baseline: (*verdict == Verdict::Xfail).then_some(note),
            ..event(id, dialect.parse().unwrap(), *verdict)
        });
    }
    run
}

/// Returns the entries of a baseline that is blessed by a run, and the number of cases of the run that the suite does not have.
fn blessed(text: &str, run: &EngineRun, cases: &[(&str, DialectName)]) -> (Vec<String>, usize) {
    let cases = cases.iter().map(|&(id, dialect)| Case { dialect, ..case(id) });
    let read = |text: &str| Baseline::read(text, "b/iron.toml", "iron").unwrap();
    let blessing = bless(
        text,
        &read(text),
        run,
        &suite(cases.collect()),
        date(2026, 11, 21),
    );
    let entries = read(&blessing.text).entries.into_iter();
    let entries =
        entries.map(|entry| format!("{} {}", Verdict::any_of(&entry.verdicts), entry.cases[0].as_str()));
    (entries.collect(), blessing.strangers)
}

#[test]
fn what_a_baseline_turned_is_turned_back_before_it_is_blessed() {
    let base = DialectName::IRONPLC_ED3;
    let run = ran(&[
        ("a/one", "ironplc-ed3", Verdict::Xfail),
        ("a/two", "ironplc-ed3", Verdict::Xpass),
    ]);
    let old = entry("a/one", "crash") + &entry("a/two", "fail");
    let (entries, _) = blessed(&old, &run, &[("a/one", base), ("a/two", base)]);
    assert_eq!(entries, ["crash a/one"]);
}

#[test]
fn a_dialect_that_was_defined_has_entries_where_it_takes_part_and_keeps_them_elsewhere() {
    let base = DialectName::IRONPLC_ED3;
    let defined = extending("blessed", base);
    // Of what it states itself, only it has the case.
    let with = [("a/one", base), ("a/one", defined), ("a/own(1)", defined)];
    let run = ran(&[
        ("a/one", "ironplc-ed3", Verdict::Pass),
        ("a/one", "blessed", Verdict::Fail),
        ("a/own(1)", "blessed", Verdict::Fail),
    ]);
    let entries = ["fail a/one@blessed", "fail a/own(1)@blessed"];
    assert_eq!(blessed("", &run, &with), (entries.map(str::to_owned).to_vec(), 0));
    let text = entry("a/one@blessed", "fail") + &entry("a/own(1)@blessed", "fail");
    let run = ran(&[("a/one", "ironplc-ed3", Verdict::Pass)]);
    let (kept, _) = blessed(&text, &run, &[("a/one", base)]);
    assert_eq!(kept, entries);
}
