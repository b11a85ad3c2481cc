//! Tests what an engine lacks: features, and programs without a mistake beside those that it must reject.

use crate::fixtures::{go, puppet, suite, timeless_run, with_jobs};
use crate::words::expecting;
use stickler_engines::{ClosureEngine, Engine, Outcome, Reference, RunRequest};
use stickler_mdtest::{Example, check_examples};
use stickler_run::{Cause, Event, Grade, Plan, RunError};
use stickler_suite::{Case, Features, Suite};
use stickler_types::{Diagnostic, DialectName, join};

/// Returns the case of a line: an id, what it expects, the type of a variable, and a statement.
fn case(line: &str) -> Case {
    let [id, expected, ty, statement] = line.split('|').map(str::trim).collect::<Vec<_>>()[..] else {
        panic!("`{line}` has no four parts")
    };
    let source = format!("PROGRAM main\nVAR\n    x : {ty};\nEND_VAR\n    {statement}\nEND_PROGRAM\n");
    Case {
        id: format!("area/file::{id}").into(),
        file: "conformance-cases/area/file.toml".into(),
        source: source.into(),
        ..expecting(expected)
    }
}

/// Returns a suite of such cases, with the features of Stickler's own.
fn with_features(lines: &str) -> Suite {
    let mut suite = suite(lines.lines().map(case).collect());
    suite.features = Features::built_in().clone();
    suite
}

/// Returns an engine that rejects the programs that have the text of a line, with the message behind it.
fn without(lines: &str) -> ClosureEngine<'static> {
    let line = |line: &str| {
        let (text, message) = line.split_once(" → ").unwrap_or((line, "what is that?"));
        (text.replace('⏎', "\n"), message.to_owned())
    };
    let refused: Vec<(String, String)> = lines.lines().map(line).collect();
    let mut engine = puppet("little", move |request: &RunRequest<'_>| {
        let found = refused
            .iter()
            .find_map(|(text, message)| Some((request.source.find(text)?, message)));
        let diagnostic = |(at, message): (usize, &String)| Diagnostic {
            line: Some(1 + request.source[..at].matches('\n').count() as u32),
            message: message.clone(),
            ..Diagnostic::default()
        };
        found.map_or(Outcome::ACCEPTED, |found| {
            Outcome::rejected(vec![diagnostic(found)])
        })
    });
    engine.identity.grade = Grade::Rejected;
    engine
}

/// Shows what an engine lacks, in how many cases, and what becomes of them.
fn lack(cause: &Cause) -> String {
    let (key, title, number) = (&cause.construct, &cause.title, cause.number());
    let verdicts = join(cause.lacked_in.values(), " ");
    format!("lacks {key}, {title}: {number} {verdicts}")
}

/// Shows the verdict of each case and what the engine lacks, or the program that shows it.
#[test]
fn golden_lacks() {
    check_examples("tests/examples/lacks.md", |example: &Example| {
        let declared = example.text("declared").split_whitespace().map(str::to_owned);
        let plan = Plan {
            lacks: [("little".to_owned(), declared.collect())].into(),
            ..with_jobs(1)
        };
        let suite = with_features(example.text("cases"));
        let (_, events) = timeless_run(&plan, &suite, &[&without(example.text("refuses"))], &[]);
        let shown = |event: Event| match event {
            Event::Case(case) => {
                let id = case.id.replace("area/file::", "");
                Some(format!("{id}: {}", case.verdict))
            }
            Event::Cause(cause) if example.wanted() == "program" => Some(cause.shown.program),
            Event::Cause(cause) => Some(lack(&cause)),
            Event::Header(_) | Event::Footer(_) => None,
        };
        join(events.into_iter().filter_map(shown), "\n")
    });
}

#[test]
fn an_engine_that_rejects_the_plainest_program_ends_the_run() {
    let suite = with_features("plain | | INT | x := x;");
    let engine = without("PROGRAM");
    let (result, _) = go(&with_jobs(1), &suite, &[&engine]);
    assert!(matches!(result, Err(RunError::RejectsAll { .. })), "{result:?}");
}

#[test]
fn the_third_edition_takes_the_minimal_programs_of_its_features() {
    for feature in Features::built_in()
        .iter()
        .filter(|feature| feature.tables.contains_key(&3))
    {
        let checked = Reference::new()
            .session()
            .map(|mut session| session.check(DialectName::IEC_ED3, &feature.program));
        assert_eq!(checked.expect("a session"), Outcome::ACCEPTED, "{}", feature.key);
    }
}
