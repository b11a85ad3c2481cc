//! Tests of whom the source of an expectation binds: a miss that binds fails, any other differs.

use crate::fixtures::{Puppet, executed, expecting, suite, timeless_run, values};
use std::path::Path;
use std::time::Duration;
use stickler_engines::{Engine, Outcome};
use stickler_run::{Answers, Baseline, CaseJudge, EngineRun, Event, Plan, Rendering, Verdict, bless};
use stickler_suite::{Case, Expectation, ExpectedText, Sources, Suite};
use stickler_types::DialectName;

const RULE: &str = "rule: not-stated";
const STANDARD: &str = "iec-61131-3: 6.3.4";
const IRONPLC: &str = "ironplc-bit-access: Syntax";

/// Returns a suite of one case with this basis, and the sources of Stickler's own suite.
fn citing(basis: &str) -> Suite {
    let case = Case {
        basis: basis.into(),
        dialect: DialectName::IronplcEd3,
        ..expecting(values(&["q = INT#1"]))
    };
    let mut suite = suite(vec![case]);
    suite.sources = sources();
    suite
}

fn sources() -> Sources {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    Suite::load_files(&cases, &[], |_, _| false).sources
}

/// Returns an engine of this name that misses every expectation.
fn wrong(name: &str) -> Puppet {
    Puppet::new(name, |_| executed(&["q = INT#2"]))
}

fn verdict(plan: &Plan, basis: &str, engine: &Puppet) -> Verdict {
    let (_, events) = timeless_run(plan, &citing(basis), &[engine], &[]);
    let cases = events.into_iter().filter_map(|event| match event {
        Event::Case(case) => Some(case.verdict),
        Event::Header(_) | Event::Cause(_) | Event::Footer(_) => None,
    });
    let verdicts: Vec<Verdict> = cases.collect();
    assert_eq!(verdicts.len(), 1);
    verdicts[0]
}

#[test]
fn a_miss_fails_where_the_source_binds_and_differs_elsewhere() {
    use Verdict::{Differs, Fail};
    for (engine, basis, expected) in [
        ("reference", RULE, Fail),
        ("reference", IRONPLC, Fail),
        ("ironplc", IRONPLC, Fail),
        ("ironplc", STANDARD, Fail),
        ("ironplc", RULE, Differs),
        ("strucpp", IRONPLC, Differs),
        ("strucpp", STANDARD, Fail),
        ("strucpp", RULE, Differs),
        // Its author lists the dialect.
        ("described", IRONPLC, Fail),
        ("described", RULE, Differs),
        // The source speaks for another dialect than that of the case.
        (
            "described",
            "forgeiec-conversion-functions: BCD encoding",
            Differs,
        ),
    ] {
        let came = verdict(&Plan::default(), basis, &wrong(engine));
        assert_eq!(came, expected, "{engine}: {basis}");
    }
}

#[test]
fn rules_bind_where_the_plan_says_so() {
    let plan = Plan {
        strict_rules: true,
        ..Plan::default()
    };
    assert_eq!(verdict(&plan, RULE, &wrong("ironplc")), Verdict::Fail);
    assert_eq!(verdict(&plan, IRONPLC, &wrong("strucpp")), Verdict::Differs);
}

#[test]
fn blanks_of_a_rendered_line_are_a_rule_whatever_the_source() {
    use Verdict::{Differs, Fail, Pass};
    let verdict = |engine: &str, wanted: &str, rendered: &str| {
        let expectation = Expectation {
            rendered: Some(ExpectedText {
                lines: vec![wanted.into()],
                line: 8,
            }),
            ..Expectation::default()
        };
        let case = Case {
            basis: IRONPLC.into(),
            dialect: DialectName::IronplcEd3,
            ..expecting(expectation)
        };
        let text = Outcome::Rendered {
            text: format!("PROGRAM main\n{rendered}\nEND_PROGRAM\n"),
        };
        let answers = Answers {
            run: executed(&[]),
            rendering: Some(Rendering {
                first: text.clone(),
                again: Some(text),
                rerun: Some(executed(&[])),
            }),
        };
        let (plan, sources, puppet) = (Plan::default(), sources(), wrong(engine));
        let judge = CaseJudge {
            plan: &plan,
            sources: &sources,
            engine: puppet.identity(),
            baseline: None,
        };
        judge.event(&case, &answers, Duration::ZERO).verdict
    };
    for (wanted, rendered, came) in [
        ("r := a + f(1, 2);", "r := a + f(1, 2);", Pass),
        ("r := a + f(1, 2);", "r:=a+f( 1,2 ) ;", Differs),
        ("r := NOT  a;", "r := NOT a;", Differs),
        ("r := NOT a;", "r := NOTa;", Fail),
        ("s := 'a b';", "s := 'a  b';", Fail),
        ("s := ' a';", "s := 'a';", Fail),
    ] {
        assert_eq!(verdict("ironplc", wanted, rendered), came, "{rendered}");
    }
    assert_eq!(verdict("reference", "r := a + b;", "r := a+b;"), Fail);
}

#[test]
fn a_crash_is_a_crash_whatever_the_source_and_a_met_rule_is_a_pass() {
    let dead = Puppet::new("strucpp", |_| Outcome::Crashed {
        reason: "dead".to_owned(),
    });
    assert_eq!(verdict(&Plan::default(), RULE, &dead), Verdict::Crash);
    let right = Puppet::new("strucpp", |_| executed(&["q = INT#1"]));
    assert_eq!(verdict(&Plan::default(), RULE, &right), Verdict::Pass);
}

#[test]
fn a_difference_neither_fails_the_run_nor_counts_as_a_pass() {
    let engine = wrong("strucpp");
    let (summary, _) = timeless_run(&Plan::default(), &citing(RULE), &[&engine], &[]);
    assert_eq!((summary.totals.differs, summary.totals.pass), (1, 0));
    assert_eq!(summary.totals.unexpected(), 0);
}

#[test]
fn an_older_baseline_that_expects_a_failure_is_read_and_blessing_it_says_what_changed() {
    let text = "[[expected]]\ncase = \"area/file\"\nverdict = \"fail\"\nreason = \"why\"\n";
    let baseline = Baseline::read(text, "b/strucpp.toml", "strucpp").unwrap();
    let plan = Plan {
        baselines: vec![baseline.clone()],
        ..Plan::default()
    };
    let (suite, engine) = (citing(RULE), wrong("strucpp"));
    assert_eq!(verdict(&plan, RULE, &engine), Verdict::Differs);
    let (_, events) = timeless_run(&plan, &suite, &[&engine as &dyn Engine], &[]);
    let mut run = None;
    for event in &events {
        match event {
            Event::Header(header) => run = Some(EngineRun::new(header.engines[0].clone())),
            Event::Case(case) => run.as_mut().unwrap().take(case),
            Event::Cause(_) | Event::Footer(_) => {}
        }
    }
    let day = plan.today;
    let blessing = bless(text, &baseline, &run.unwrap(), &suite, day);
    let whys: Vec<&str> = blessing
        .changes
        .iter()
        .map(|change| change.why.as_str())
        .collect();
    assert_eq!(whys, ["1 now differs"]);
    assert_eq!(blessing.entries, 0);
}
