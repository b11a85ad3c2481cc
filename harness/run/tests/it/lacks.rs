//! Tests what an engine lacks: features, and programs without a mistake beside those that it must reject.

use crate::fixtures::{puppet, suite, timeless_run, with_jobs};
use crate::words::expecting;
use std::collections::BTreeMap;
use stickler_engines::{ClosureEngine, Outcome, RunRequest};
use stickler_run::{Cause, Event, Grade, Plan, RunError, Verdict, run};
use stickler_suite::{Case, Features, Suite};
use stickler_types::Diagnostic;
use stickler_workers::Cancellation;

/// Returns a case about a program that declares a variable of a type and has a statement.
fn case(id: &str, lines: &str, (ty, statement): (&str, &str)) -> Case {
    let source = format!("PROGRAM main\nVAR\n    x : {ty};\nEND_VAR\n    {statement}\nEND_PROGRAM\n");
    Case {
        id: format!("area/file::{id}").into(),
        file: "conformance-cases/area/file.toml".into(),
        source: source.into(),
        ..expecting(lines)
    }
}

/// Returns a suite of such cases, with the features of Stickler's own.
fn with_features(cases: Vec<Case>) -> Suite {
    let mut suite = suite(cases);
    suite.features = Features::built_in().clone();
    suite
}

/// Returns an engine that rejects what holds any of these words, on the line where the first one is.
fn without(words: &'static [&'static str]) -> ClosureEngine<'static> {
    let answer = move |request: &RunRequest<'_>| {
        let mut lines = request.source.lines().zip(1..);
        let refused = lines.find(|(line, _)| words.iter().any(|word| line.contains(word)));
        match refused {
            Some((_, line)) => Outcome::rejected(vec![Diagnostic {
                line: Some(line),
                message: "what is that?".to_owned(),
                ..Diagnostic::default()
            }]),
            None => Outcome::ACCEPTED,
        }
    };
    let mut engine = puppet("little", answer);
    engine.identity.grade = Grade::Rejected;
    engine
}

/// Returns the verdict of each case by its id, and the features that the engine lacks.
fn verdicts(plan: &Plan, suite: &Suite, engine: &ClosureEngine<'_>) -> (Vec<(String, Verdict)>, Vec<Cause>) {
    let (_, events) = timeless_run(plan, suite, &[engine], &[]);
    let mut found = (Vec::new(), Vec::new());
    for event in events {
        match event {
            Event::Case(case) => found.0.push((case.id.replace("area/file::", ""), case.verdict)),
            Event::Cause(cause) => found.1.push(cause),
            Event::Header(_) | Event::Footer(_) => {}
        }
    }
    found
}

#[test]
fn what_uses_a_feature_that_is_not_there_waits_unless_the_engine_takes_it() {
    let suite = with_features(vec![
        case("plain", "", ("INT", "x := x;")),
        case("lreal", "", ("LREAL", "x := x;")),
        case("open", "open", ("LREAL", "x := x;")),
        case("taken", "rejected", ("LReal", "x := 1;")),
        case("both", "", ("ARRAY[0..1] OF LREAL", ";")),
        case("other", "", ("INT", "x := ?;")),
    ]);
    let (verdicts, lacks) = verdicts(&with_jobs(1), &suite, &without(&["LREAL", "?"]));
    let verdicts: Vec<(&str, Verdict)> = verdicts.iter().map(|(id, verdict)| (&**id, *verdict)).collect();
    assert_eq!(
        verdicts,
        [
            ("plain", Verdict::Pass),
            ("lreal", Verdict::Waiting),
            ("open", Verdict::Waiting),
            ("taken", Verdict::Fail),
            ("both", Verdict::Waiting),
            ("other", Verdict::Fail),
        ]
    );
    let [lreal] = &lacks[..] else { panic!("{lacks:#?}") };
    assert_eq!((lreal.construct.as_str(), lreal.number()), ("lreal", 3));
    // The statement of the minimal program does nothing, and goes where the engine refuses the rest in the same words.
    let minimal = &Features::built_in().get("lreal").unwrap().program;
    assert_eq!(lreal.shown.program, minimal.replace("    x := x;\n", ""));
}

#[test]
fn a_body_keeps_a_statement_where_one_without_is_refused_for_that() {
    let suite = with_features(vec![case("lreal", "", ("LREAL", "x := x;"))]);
    let answer = |request: &RunRequest<'_>| {
        let refused = [
            ("END_VAR\nEND_PROGRAM", "no statement"),
            ("LREAL", "what is that?"),
        ];
        let said = refused.iter().find(|(words, _)| request.source.contains(words));
        said.map_or(Outcome::ACCEPTED, |(_, message)| {
            let message = (*message).to_owned();
            Outcome::rejected(vec![Diagnostic {
                message,
                ..Diagnostic::default()
            }])
        })
    };
    let (_, lacks) = verdicts(&with_jobs(1), &suite, &puppet("little", answer));
    let [lreal] = &lacks[..] else { panic!("{lacks:#?}") };
    assert!(
        lreal.shown.program.contains("    ;\nEND_PROGRAM"),
        "{}",
        lreal.shown.program
    );
}

#[test]
fn data_types_that_are_refused_in_the_same_words_are_one_cause() {
    let types = ["LREAL", "DINT", "WORD"];
    let suite = with_features(types.map(|ty| case(ty, "", (ty, "x := x;"))).to_vec());
    let said = |ty: &str| match ty {
        "WORD" => "a WORD is not supported".to_owned(),
        _ => format!("no type {ty}"),
    };
    let answer = move |request: &RunRequest<'_>| {
        let refused = types
            .into_iter()
            .find(|ty| request.source.contains(&format!(": {ty};")));
        refused.map_or(Outcome::ACCEPTED, |ty| {
            Outcome::rejected(vec![Diagnostic {
                message: said(ty),
                ..Diagnostic::default()
            }])
        })
    };
    let (_, lacks) = verdicts(&with_jobs(1), &suite, &puppet("little", answer));
    let found: Vec<(&str, &str, u64)> = lacks
        .iter()
        .map(|lack| (&*lack.construct, &*lack.title, lack.number()))
        .collect();
    assert_eq!(
        found,
        [
            ("dint, lreal", "the data types DINT, LREAL", 2),
            ("word", "the data type WORD", 1),
        ]
    );
}

#[test]
fn a_feature_that_needs_another_is_explained_by_that() {
    let arrays = ("ARRAY[0..1] OF INT", "x[0] := x[1];");
    let suite = with_features(vec![case("element", "", arrays)]);
    let (_, lacks) = verdicts(&with_jobs(1), &suite, &without(&["ARRAY"]));
    let keys: Vec<&str> = lacks.iter().map(|lack| &*lack.construct).collect();
    assert_eq!(keys, ["array"]);
    // It has arrays, but no elements of them.
    let (_, lacks) = verdicts(&with_jobs(1), &suite, &without(&["x[0]"]));
    assert_eq!(lacks[0].construct, "array-element");
}

#[test]
fn what_is_declared_as_lacking_is_not_asked_for_and_fails_nothing() {
    let suite = with_features(vec![case("lreal", "", ("LREAL", "x := x;"))]);
    let plan = Plan {
        lacks: BTreeMap::from([("little".to_owned(), vec!["lreal".to_owned()])]),
        ..with_jobs(1)
    };
    let (_, lacks) = verdicts(&plan, &suite, &without(&["LREAL"]));
    assert_eq!(
        lacks[0].lacked_in.values().collect::<Vec<_>>(),
        [&Verdict::Unsupported]
    );
    // A declaration that is wrong hides nothing.
    let (found, _) = verdicts(&plan, &suite, &without(&[]));
    assert_eq!(found[0].1, Verdict::Pass);
}

#[test]
fn a_rejection_tells_nothing_where_the_same_without_a_mistake_is_rejected_too() {
    let suite = with_features(vec![
        case("right(1)", "", ("SINT", "x := x + 1;")),
        case("wrong(1)", "rejected", ("SINT", "x := x + 1000;")),
    ]);
    let of = |words| verdicts(&with_jobs(1), &suite, &without(words)).0[1].1;
    assert_eq!(of(&["1000"]), Verdict::Pass);
    assert_eq!(of(&["x + 1"]), Verdict::Waiting);
    assert_eq!(of(&[]), Verdict::Fail);
}

#[test]
fn an_engine_that_rejects_the_plainest_program_ends_the_run() {
    let suite = with_features(vec![case("plain", "", ("INT", "x := x;"))]);
    let result = run(
        &with_jobs(1),
        &suite,
        &[&without(&["PROGRAM"])],
        &mut |_| {},
        &Cancellation::new(),
    );
    assert!(matches!(result, Err(RunError::RejectsAll { .. })), "{result:?}");
}
