//! Tests of whom the source of an expectation binds: a miss that binds fails, any other differs.

use crate::fixtures::{Puppet, executed, expecting, rejected, rejection, suite, timeless_run, values};
use std::path::Path;
use std::time::Duration;
use stickler_engines::{Engine, Outcome};
use stickler_run::{
    Answers, Baseline, Blessing, CaseEvent, CaseJudge, ChangeKind, EngineRun, Event, Fact, Grade, Plan,
    Rendering, Verdict, bless,
};
use stickler_suite::{Acceptance, Case, Expectation, ExpectedFault, ExpectedText, Sources, Suite};
use stickler_types::{DialectName, Fault};

const RULE: &str = "rule: not-stated";
const STANDARD: &str = "iec-61131-3: 6.3.4";
const IRONPLC: &str = "ironplc-bit-access: Syntax";
const RUSTY: &str = "rusty-datatypes: Date and Time";
const RECORDED: &str = "recording: ironplc";
const STRUCPP: &str = "strucpp-architecture: Type System";

/// Returns a suite of one case with this basis, and the sources of Stickler's own suite.
fn citing(basis: &str) -> Suite {
    let case = Case {
        basis: basis.into(),
        dialect: DialectName::IRONPLC_ED3,
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
    judged(plan, &citing(basis), engine).verdict
}

/// Returns the event of the only case of a suite.
fn judged(plan: &Plan, suite: &Suite, engine: &Puppet) -> CaseEvent {
    let (_, events) = timeless_run(plan, suite, &[engine], &[]);
    let cases = events.into_iter().filter_map(|event| match event {
        Event::Case(case) => Some(case),
        Event::Header(_) | Event::Cause(_) | Event::Footer(_) => None,
    });
    let mut cases: Vec<CaseEvent> = cases.collect();
    assert_eq!(cases.len(), 1);
    cases.remove(0)
}

/// Returns an engine of this name that answers every program by a message that it is not implemented.
fn unfinished(name: &str) -> Puppet {
    Puppet::new(name, |_| Outcome::NotImplemented {
        reason: "P9999: not yet".to_owned(),
    })
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
        ("strucpp", STRUCPP, Fail),
        ("ironplc", STRUCPP, Differs),
        ("rusty", RUSTY, Fail),
        ("strucpp", RUSTY, Differs),
        ("strucpp", STANDARD, Fail),
        ("strucpp", RULE, Differs),
        // A recording binds what was recorded, by the name of its file.
        ("ironplc", RECORDED, Fail),
        ("strucpp", RECORDED, Differs),
        // Its author lists the dialect.
        ("described", RECORDED, Fail),
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
            dialect: DialectName::IRONPLC_ED3,
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
fn places_and_further_mistakes_that_are_not_told_are_a_rule_whatever_the_source() {
    use Verdict::{Differs, Fail};
    let judged = |plan: &Plan, engine: &str, wanted: &[&'static str], reported: &[&'static str]| {
        let mut suite = citing(IRONPLC);
        suite.cases[0].expectation = rejection(wanted).into();
        let reported = reported.to_vec();
        let case = judged(plan, &suite, &Puppet::new(engine, move |_| rejected(&reported)));
        (case.verdict, case.basis)
    };
    let rule = || (Differs, "rule: every-mistake-is-told".to_owned());
    let failed = || (Fail, IRONPLC.to_owned());
    let plan = Plan::default();
    for (wanted, reported, came) in [
        (&["6 P4025"][..], &["- P4025"][..], rule()),
        (&["6 P4025"], &["- P4026"], failed()),
        (&["6 P4025"], &["- -"], failed()),
        (&["6 P4025"], &["7 P4025"], failed()),
        (&["6 P4025"], &["6 P4025", "- P4025"], failed()),
        (&["6 P4025"], &["- P4025", "- P4026"], failed()),
        (&["6 P4025"], &["- P4025", "7 P4025"], failed()),
        (&["6 P4025"], &[], failed()),
        (&["6 P4025", "7 P4026"], &["6 P4025", "- P4026"], rule()),
        (&["6 P4025", "7 P4026"], &["- P4026"], failed()),
        (&["6 P4025", "7 P4026"], &["6 P4025"], rule()),
        (&["6 P4025", "7 P4026"], &["6 P4025", "8 P4026"], failed()),
    ] {
        assert_eq!(
            judged(&plan, "ironplc", wanted, reported),
            came,
            "{wanted:?} {reported:?}"
        );
    }
    let strict = |grade, strict_rules| Plan {
        strict: Some(grade),
        strict_rules,
        ..Plan::default()
    };
    // Where lines are judged alone, no code is asked for.
    let by_line = strict(Grade::Line, false);
    for (wanted, reported, came) in [
        (&["6 P4025"][..], &["- P4026"][..], rule()),
        (&["6 P4025", "7 P4026"], &["6 -", "- -"], rule()),
        (&["6 P4025", "7 P4026"], &["7 -"], rule()),
        (&["6 P4025"], &["6 -", "- -"], failed()),
        (&["6 P4025"], &["7 -"], failed()),
    ] {
        assert_eq!(
            judged(&by_line, "ironplc", wanted, reported),
            came,
            "{wanted:?} {reported:?}"
        );
    }
    let bound = judged(&strict(Grade::Code, true), "ironplc", &["6 P4025"], &["- P4025"]);
    assert_eq!((bound.0, bound.1), (Fail, rule().1));
    assert_eq!(judged(&plan, "reference", &["6 P4025"], &["- P4025"]).0, Fail);
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
fn an_endless_loop_may_take_endless_time_where_no_binding_source_limits_its_steps() {
    let endless = |engine: &str| Puppet::new(engine, |_| Outcome::TimedOut { after_ms: 10 });
    let judged = |engine: &str, fault| {
        let mut suite = citing(RULE);
        let fault = ExpectedFault { fault, line: 1 };
        suite.cases[0].expectation = Expectation {
            fault: Some(fault),
            ..Expectation::default()
        }
        .into();
        judged(&Plan::default(), &suite, &endless(engine)).verdict
    };
    assert_eq!(judged("rusty", Fault::StepLimit), Verdict::Differs);
    assert_eq!(judged("reference", Fault::StepLimit), Verdict::Timeout);
    assert_eq!(judged("rusty", Fault::DivisionByZero), Verdict::Timeout);
}

#[test]
fn an_accepted_program_that_comes_to_nothing_is_a_crash_only_where_a_binding_source_has_it_accepted() {
    use Verdict::{Crash, Differs, Fail};
    let useless = |engine: &str| {
        Puppet::new(engine, |_| Outcome::Unusable {
            reason: "the C++ that it wrote cannot be built".to_owned(),
        })
    };
    let accepted = |accepted| Expectation {
        accepted,
        ..Expectation::default()
    };
    let judged = |engine: &str, basis: &str, expectation: Expectation| {
        let mut suite = citing(basis);
        suite.cases[0].expectation = expectation.into();
        let case = judged(&Plan::default(), &suite, &useless(engine));
        (case.verdict, Fact::text(&case.got))
    };
    let came = |verdict| {
        (
            verdict,
            "accepted, but the C++ that it wrote cannot be built".to_owned(),
        )
    };
    let value = || values(&["q = INT#1"]);
    assert_eq!(judged("strucpp", STRUCPP, value()), came(Crash));
    assert_eq!(judged("strucpp", STANDARD, value()), came(Crash));
    assert_eq!(judged("strucpp", RULE, value()), came(Differs));
    assert_eq!(judged("strucpp", RUSTY, value()), came(Differs));
    let open = || accepted(Acceptance::Observed);
    assert_eq!(judged("strucpp", STRUCPP, open()), came(Differs));
    // Accepting was the mistake.
    let wrong = || accepted(Acceptance::Rejected);
    assert_eq!(judged("strucpp", STRUCPP, wrong()), (Fail, "accepted".to_owned()));
    assert_eq!(judged("strucpp", RULE, wrong()).0, Differs);
}

#[test]
fn what_is_not_implemented_fails_where_a_document_of_the_compiler_promises_it() {
    use Verdict::{Fail, Unsupported};
    for (engine, basis, expected) in [
        ("ironplc", IRONPLC, Fail),
        ("ironplc", STANDARD, Unsupported),
        ("ironplc", RULE, Unsupported),
        ("matiec", "matiec: implicit conversion", Unsupported),
        ("strucpp", IRONPLC, Unsupported),
        // Its author lists the dialect.
        ("described", IRONPLC, Fail),
    ] {
        let strict = Plan {
            strict_rules: true,
            ..Plan::default()
        };
        for plan in [Plan::default(), strict] {
            let case = judged(&plan, &citing(basis), &unfinished(engine));
            assert_eq!(case.verdict, expected, "{engine}: {basis}");
            let words = match expected {
                Fail => format!("not implemented, though promised by {basis}: P9999: not yet"),
                _ => "not implemented: P9999: not yet".to_owned(),
            };
            assert_eq!(Fact::text(&case.got), words);
        }
    }
}

#[test]
fn nothing_is_promised_of_a_program_that_need_not_be_accepted_or_is_only_rendered() {
    let unfinished = unfinished("ironplc");
    let open = Expectation {
        accepted: Acceptance::Observed,
        clean_lines: vec![3],
        ..Expectation::default()
    };
    let rejected = Expectation {
        accepted: Acceptance::Rejected,
        ..Expectation::default()
    };
    let rendered = Expectation {
        rendered: Some(ExpectedText {
            lines: vec!["a := b;".into()],
            line: 1,
        }),
        ..Expectation::default()
    };
    for expectation in [open, rejected, rendered] {
        let mut suite = citing(IRONPLC);
        suite.cases[0].expectation = expectation.into();
        let verdict = judged(&Plan::default(), &suite, &unfinished).verdict;
        assert_eq!(verdict, Verdict::Unsupported);
    }
}

#[test]
fn a_difference_neither_fails_the_run_nor_counts_as_a_pass() {
    let engine = wrong("strucpp");
    let (summary, _) = timeless_run(&Plan::default(), &citing(RULE), &[&engine], &[]);
    assert_eq!((summary.totals.differs, summary.totals.pass), (1, 0));
    assert_eq!(summary.totals.unexpected(), 0);
}

/// Runs a case with this basis on an engine with an older baseline, which expects the verdict `word` of it. Returns the verdict
/// that comes, and what blessing changes.
fn blessed(word: &str, basis: &str, engine: &Puppet) -> (Verdict, Blessing) {
    let text = format!("[[expected]]\ncase = \"area/file\"\nverdict = \"{word}\"\nreason = \"why\"\n");
    let name = &engine.identity().name;
    let baseline = Baseline::read(&text, &format!("b/{name}.toml"), name).unwrap();
    let plan = Plan {
        baselines: vec![baseline.clone()],
        ..Plan::default()
    };
    let suite = citing(basis);
    let (_, events) = timeless_run(&plan, &suite, &[engine as &dyn Engine], &[]);
    let mut run = None;
    for event in &events {
        match event {
            Event::Header(header) => run = Some(EngineRun::new(header.engines[0].clone())),
            Event::Case(case) => run.as_mut().unwrap().take(case),
            Event::Cause(_) | Event::Footer(_) => {}
        }
    }
    let came = judged(&plan, &suite, engine).verdict;
    let blessing = bless(&text, &baseline, &run.unwrap(), &suite, plan.today);
    (came, blessing)
}

fn changes(blessing: &Blessing) -> Vec<(ChangeKind, &str)> {
    let changes = blessing.changes.iter();
    changes.map(|change| (change.kind, change.why.as_str())).collect()
}

#[test]
fn an_older_baseline_that_expects_a_failure_is_read_and_blessing_it_says_what_changed() {
    let (came, blessing) = blessed("fail", RULE, &wrong("strucpp"));
    assert_eq!(came, Verdict::Differs);
    assert_eq!(changes(&blessing), [(ChangeKind::Removed, "1 now differs")]);
    assert_eq!(blessing.entries, 0);
}

#[test]
fn an_older_baseline_that_expects_a_promised_construct_to_be_unsupported_is_blessed_as_a_failure() {
    let (came, blessing) = blessed("unsupported", IRONPLC, &unfinished("ironplc"));
    assert_eq!(came, Verdict::Fail);
    assert_eq!(
        changes(&blessing),
        [(ChangeKind::Removed, "1 now fail"), (ChangeKind::Added, "1 case")]
    );
    assert_eq!(blessing.entries, 1);
    let (came, blessing) = blessed("unsupported", STANDARD, &unfinished("ironplc"));
    assert_eq!(came, Verdict::Unsupported);
    assert_eq!(changes(&blessing), []);
}
