//! The tests that are tables and files in `tests/examples`.

use crate::defined;
use crate::fixtures::{Book, answering, engine_header, event, puppet, sources, suite};
use crate::words::{expecting, outcome, shown};
use std::time::Duration;
use stickler_engines::{Engine, EngineSession, Identity, Outcome};
use stickler_mdtest::{Example, check_examples};
use stickler_run::{
    Answers, Baseline, CaseEvent, CaseJudge, Cause, EngineRun, Event, ExplainedCases, Fact, Filter, Grade,
    Judgement, Plan, Rendering, Symptom, Verdict, ask_stored, bless, judge, question, rendered_bodies, run,
    select,
};
use stickler_suite::{Case, FileKind};
use stickler_types::{Code, DialectName, join};
use stickler_workers::{Cancellation, Shard};

/// Returns the grade of the column `strict`; the code where there is none.
fn strict(example: &Example) -> Grade {
    Grade::from_word(example.text("strict")).unwrap_or_default()
}

/// Returns a rendered program: one with this body, if the text is no whole program and no other outcome.
fn rendered(text: &str) -> Outcome {
    let mut words = "accepted,rejected,unsupported,crashed,timed out,error".split(',');
    if words.any(|word| text.starts_with(word)) {
        return outcome(text);
    }
    let text = match text.starts_with("PROGRAM") {
        true => text.to_owned(),
        false => format!("PROGRAM main\n    VAR\n        r : BOOL;\n    END_VAR\n    {text}\nEND_PROGRAM\n"),
    };
    Outcome::Rendered { text }
}

/// Returns the answers of the columns `does`, `rendered`, `again` and `rerun`.
fn answers(example: &Example) -> Answers {
    let run = outcome(example.get("does").unwrap_or("executed"));
    let rendering = example.get("rendered").map(|first| {
        let has_text = matches!(rendered(first), Outcome::Rendered { .. });
        let rerun = || example.get("rerun").map_or_else(|| run.clone(), outcome);
        Rendering {
            first: rendered(first),
            again: has_text.then(|| rendered(example.get("again").unwrap_or(first))),
            rerun: has_text.then(rerun),
        }
    });
    Answers { run, rendering }
}

fn judged(example: &Example) -> Judgement {
    judge(
        &expecting(example.text("expects")),
        &answers(example),
        strict(example),
    )
}

#[test]
fn golden_judgements() {
    check_examples("tests/examples/judging.md", |example| match example.wanted() {
        "is open" => expecting(example.text("expects")).is_open().to_string(),
        "bodies" => rendered_bodies(example.text("rendered")).join("\n"),
        "expected" => Fact::text(&judged(example).expected),
        _ => shown(&judged(example)),
    });
}

#[test]
fn golden_symptoms() {
    check_examples("tests/examples/symptoms.md", |example| {
        let mut judgement = judged(example);
        if let Some(got) = example.get("got") {
            judgement.got = serde_json::from_str(got).unwrap();
        }
        let facts = (&judgement.expected[..], &judgement.got[..]);
        let symptom = Symptom::of_facts(judgement.verdict, facts, strict(example));
        match example.wanted() {
            "sentence" => symptom.to_string(),
            _ => symptom.word(),
        }
    });
}

#[test]
fn golden_facts() {
    check_examples("tests/examples/facts.md", |example| {
        let json = example.text("json");
        let fact: Fact = match serde_json::from_str(json) {
            Ok(fact) => fact,
            Err(error) => return error.to_string(),
        };
        let value: serde_json::Value = serde_json::from_str(json).unwrap();
        assert_eq!(serde_json::to_value(&fact).unwrap(), value, "{json}");
        fact.to_string()
    });
}

#[test]
fn golden_filters() {
    check_examples("tests/examples/filters.md", |example| {
        let filter = Filter::new(example.text("filter"));
        let key = example.text("case");
        let (id, dialect) = key.split_once('@').unwrap_or((key, ""));
        let holds = match example.wanted() {
            "fits" => filter.fits(id, dialect),
            "names" => filter.names(id, dialect),
            "may fit table" => filter.may_fit_file(id, FileKind::Table),
            "may fit program" => filter.may_fit_file(id, FileKind::Program),
            _ => return join(filter.dialect(), ""),
        };
        if holds { "yes" } else { "no" }.to_owned()
    });
}

#[test]
fn golden_stored_answers() {
    check_examples("tests/examples/stored.md", |example| {
        let case = expecting(example.get("rendered").map_or("", |_| "rendered x"));
        let told = answers(example);
        let engine = answering("puppet", told.clone());
        let mut session = EngineSession::new(&engine);
        let mut book = Book::default();
        if let Some(stored) = example.get("stored") {
            book.before.insert(question(&case), stored.to_owned());
            let engine = puppet("other", |_| outcome("crashed: asked"));
            let known = ask_stored(&mut EngineSession::new(&engine), &case, Some(&book)).unwrap();
            return if known == told { "known" } else { "asked again" }.to_owned();
        }
        assert_eq!(ask_stored(&mut session, &case, Some(&book)).unwrap(), told);
        let book = book.turned();
        let Some(stored) = book.before.values().next() else {
            return "not kept".to_owned();
        };
        assert!(!stored.contains('\n'), "{stored}");
        // What was kept is read as it was, without the engine.
        let silent = puppet("silent", |_| panic!("asked again"));
        let known = ask_stored(&mut EngineSession::new(&silent), &case, Some(&book)).unwrap();
        assert_eq!(known, told);
        stored.clone()
    });
}

/// The cases among which the examples of selecting select, each in two dialects.
const SELECTABLE: [&str; 5] = ["a/b", "a/b2", "a/b::p(INT,-1)", "a/b::p(INT,-10)", "c/it's"];

#[test]
fn golden_selections() {
    check_examples("tests/examples/selecting.md", |example| {
        let dialects = [DialectName::MATIEC, DialectName::PLCNEXT];
        let keys = SELECTABLE
            .iter()
            .flat_map(|id| dialects.map(|dialect| format!("{id}@{dialect}")));
        let cases: Vec<Case> = keys.map(|key| case_of(&key)).collect();
        let words = |name: &str| example.text(name).split_whitespace().collect::<Vec<_>>();
        let asked_for = example
            .get("asked for")
            .map(|asked_for| (example.text("engine").to_owned(), asked_for.to_owned()));
        let plan = Plan {
            filters: words("filters").into_iter().map(Filter::new).collect(),
            dialects: words("dialects")
                .iter()
                .map(|name| name.parse().unwrap())
                .collect(),
            shard: example
                .get("shard")
                .map(|index| Shard::new(index.parse().unwrap(), 3).unwrap()),
            rerun_prefix: "stickler run".to_owned(),
            asked_for: asked_for.into_iter().collect(),
            ..Plan::default()
        };
        let keys: Vec<String> = select(&plan, &cases).into_iter().map(Case::key).collect();
        match example.wanted() {
            "again" => {
                let case = select(&plan, &cases)[0];
                // The command selects the case alone.
                let again = Plan {
                    filters: vec![Filter::new(&*case.id)],
                    dialects: vec![case.dialect],
                    ..Plan::default()
                };
                assert_eq!(select(&again, &cases), [case]);
                plan.rerun(case, example.text("engine"))
            }
            _ => keys.join(" "),
        }
    });
}

/// Returns the baseline of an example, of the engine `iron` unless the column `engine` names another.
fn baseline(example: &Example, engine: &str) -> Result<Baseline, String> {
    let path = format!("b/{engine}.toml");
    Baseline::read(example.text("baseline"), &path, engine).map_err(|error| error.to_string())
}

#[test]
fn golden_bindings() {
    let [sources, versioned] = ["../../conformance-cases", "tests/versions"].map(sources);
    check_examples("tests/examples/binding.md", |example| {
        let name = example.text("engine");
        let plan = Plan {
            strict: example.get("strict").map(|_| strict(example)),
            strict_rules: example.text("rules") == "bind",
            baselines: example
                .get("baseline")
                .map(|_| baseline(example, name).unwrap())
                .into_iter()
                .collect(),
            ..Plan::default()
        };
        let codes: Vec<Code> = example
            .text("lacks")
            .split_whitespace()
            .map(|code| code.parse().unwrap())
            .collect();
        let puppet = answering(name, answers(example));
        let engine = Identity {
            lacks: codes,
            version: example.get("version").unwrap_or("1").to_owned(),
            ..puppet.identity().clone()
        };
        let case = Case {
            basis: example.text("basis").into(),
            dialect: match example.get("dialect") {
                Some("mine") => defined::extending("of-described", DialectName::IRONPLC_ED3),
                named => named.unwrap_or("ironplc-ed3").parse().unwrap(),
            },
            ..expecting(example.get("expects").unwrap_or("q = INT#1"))
        };
        let mut suite = suite(vec![case.clone()]);
        suite.sources = match example.get("version") {
            Some(_) => versioned.clone(),
            None => sources.clone(),
        };
        let matched = plan.matched_baseline(&suite, &engine);
        let judge = CaseJudge {
            plan: &plan,
            suite: &suite,
            engine: &engine,
            lacks: None,
            baseline: matched.as_ref(),
        };
        let event = judge.event(&case, &answers(example), Duration::ZERO);
        let verdict = event.verdict;
        match example.wanted() {
            "verdict" => verdict.to_string(),
            "verdict and basis" => format!("{verdict} by {}", event.basis),
            "verdict and facts" => format!("{verdict}: {}", Fact::text(&event.got)),
            _ => {
                let mut run = EngineRun::new(engine_header(name));
                run.take(&event);
                let baseline = &plan.baselines[0];
                let blessing = bless(example.text("baseline"), baseline, &run, &suite, plan.today);
                let changes = blessing
                    .changes
                    .iter()
                    .map(|change| format!("\n{:?} {}", change.kind, change.why));
                format!("{verdict}{}", changes.collect::<String>())
            }
        }
    });
}

/// Returns the case of a line `id` or `id@dialect`; its program is its id.
fn case_of(line: &str) -> Case {
    let (id, dialect) = line.split_once('@').unwrap_or((line, "matiec"));
    Case {
        id: id.into(),
        source: id.into(),
        dialect: dialect.parse().unwrap(),
        ..expecting("q = INT#1")
    }
}

/// Runs the cases of an example on an engine that passes those whose ids end in `good`, crashes over those in `bad`, does not support those
/// in `odd`, and fails the rest. Shows the verdict and the entry of each case, the entries that are out of date, and how many cases are not
/// as expected.
fn run_with_baseline(example: &Example) -> String {
    let mut engine = puppet("iron", |request| {
        outcome(match request.source {
            good if good.ends_with("good") => "executed\nq = INT#1",
            bad if bad.ends_with("bad") => "crashed: dead",
            odd if odd.ends_with("odd") => "unsupported: cannot",
            _ => "executed\nq = INT#2",
        })
    });
    engine.identity.version = example.get("version").unwrap_or("1").to_owned();
    let plan = Plan {
        baselines: vec![match baseline(example, example.get("engine").unwrap_or("iron")) {
            Ok(baseline) => baseline,
            Err(mistake) => return mistake,
        }],
        filters: example.get("filter").map(Filter::new).into_iter().collect(),
        today: jiff::civil::date(2026, 11, 21),
        ..Plan::default()
    };
    let suite = suite(example.text("cases").lines().map(case_of).collect());
    let mut text = String::new();
    let mut sink = |event: Event| match event {
        Event::Case(case) => text += &noted(&case),
        Event::Header(header) => {
            // A baseline takes part where it is about the engine, whether or not it has entries.
            let about = plan.baselines[0].engine == "iron";
            let baselines = header.baselines.len();
            assert_eq!(baselines, usize::from(about), "{}", example.heading());
            for entry in header.baselines.iter().flat_map(|held| &held.outdated) {
                text += &format!("outdated: {} {}: {}\n", entry.at, entry.case, entry.why);
            }
        }
        Event::Cause(_) | Event::Footer(_) => {}
    };
    let summary = run(&plan, &suite, &[&engine], &mut sink, &Cancellation::new()).unwrap();
    format!("{text}{} unexpected", summary.totals.unexpected())
}

/// Shows the verdict of a case, and the note of its baseline.
fn noted(case: &CaseEvent) -> String {
    let mut text = format!("{}@{}: {}", case.id, case.dialect, case.verdict);
    if case.verdict != case.actual_verdict() {
        text += &format!(", was {}", case.actual_verdict());
    }
    if let Some(note) = &case.baseline {
        let link = join(note.link.iter().map(|link| format!(", {link}")), "");
        let verdicts = Verdict::any_of(&note.verdicts());
        text += &format!(" ({}: {verdicts}, {}{link})", note.at, note.reason);
    }
    text + "\n"
}

#[test]
fn golden_baselines() {
    check_examples("tests/examples/baselines.md", run_with_baseline);
}

/// The cases that an example of blessing knows, each in two dialects that the engine speaks and in one that it does not.
const IDS: [&str; 6] = [
    "a/one",
    "a/t::p(INT,1)",
    "a/t::p(INT,2)",
    "a/t::p(SINT,1)",
    "a/t::q(INT,1)",
    "a/t::q(INT,2)",
];

/// Blesses the baseline of an example by a run in which every case passes but those whose keys begin as a line of `run` says, `a/t::p( fail`;
/// with `only`, no other case is run. A line of `causes` is a probe and the title of the cause of its failing cases. Shows the changes and the new text.
fn blessed(example: &Example) -> String {
    let dialects = [
        DialectName::IRONPLC_ED2,
        DialectName::IRONPLC_ED3,
        DialectName::MATIEC,
    ];
    let keys = IDS
        .iter()
        .flat_map(|id| dialects.map(|dialect| format!("{id}@{dialect}")));
    let suite = suite(keys.map(|key| case_of(&key)).collect());
    let lines = example.text("run").lines().chain(example.text("only").lines());
    let lines: Vec<(&str, Verdict)> = lines
        .map(|line| line.rsplit_once(' ').unwrap())
        .map(|(start, verdict)| (start, Verdict::from_word(verdict).unwrap()))
        .collect();
    let mut run = EngineRun::new(engine_header("iron"));
    for case in suite
        .cases
        .iter()
        .filter(|case| case.dialect != DialectName::MATIEC)
    {
        let found = lines.iter().find(|(start, _)| case.key().starts_with(start));
        let passed = example.get("only").is_none().then_some(Verdict::Pass);
        if let Some(verdict) = found.map(|found| found.1).or(passed) {
            run.take(&event(&case.id, case.dialect, verdict));
        }
    }
    for (id, verdict) in lines.iter().filter(|(start, _)| start.starts_with("a/old")) {
        run.take(&event(id, DialectName::IRONPLC_ED2, *verdict));
    }
    for line in example.text("causes").lines() {
        let (probe, title) = line.split_once(": ").unwrap();
        run.take_cause(cause(probe, title, &dialects));
    }
    let file = example.get("file").unwrap_or("b/iron.toml");
    let text = join(example.get("baseline").map(|text| format!("{text}\n")), "");
    let day = jiff::civil::date(2026, 11, 21);
    let read = |text: &str| Baseline::read(text, file, "iron").unwrap();
    let blessing = bless(&text, &read(&text), &run, &suite, day);
    let again = read(&blessing.text);
    assert_eq!(again.entries.len(), blessing.entries, "{}", blessing.text);
    // The blessed baseline expects the actual verdicts, so blessing again changes nothing.
    let twice = bless(&blessing.text, &again, &run, &suite, day);
    assert_eq!(
        (twice.text.as_str(), twice.changes.len()),
        (blessing.text.as_str(), 0)
    );
    let changes = blessing.changes.iter().map(|change| {
        let verdicts = Verdict::any_of(&change.verdicts);
        format!("{:?} {verdicts} {}: {}\n", change.kind, change.case, change.why)
    });
    let changes: String = changes.collect();
    let strangers = match blessing.strangers {
        0 => String::new(),
        number => format!("{number} cases of the run are not in the suite\n"),
    };
    let text = match example.wanted() {
        "changes" => "",
        _ if blessing.text == text => "unchanged",
        _ => &blessing.text,
    };
    format!("{changes}{strangers}{text}")
}

fn cause(probe: &str, title: &str, dialects: &[DialectName]) -> Cause {
    let explained = |dialect: &DialectName| ExplainedCases {
        probe: probe.to_owned(),
        dialect: dialect.to_string(),
        verdict: Verdict::Fail,
        cases: 1,
        ..ExplainedCases::default()
    };
    Cause {
        engine: "iron".to_owned(),
        title: title.to_owned(),
        cases: dialects.iter().map(explained).collect(),
        ..Cause::default()
    }
}

#[test]
fn golden_blessings() {
    check_examples("tests/examples/blessing.md", blessed);
}
