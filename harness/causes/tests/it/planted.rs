//! Asks more of the search for the three defects of one compiler: `defects/three.toml` has them and the cases that show them.

use crate::compiler::DefectiveCompiler;
use crate::defects::defects;
use crate::search::causes;
use std::collections::BTreeSet;
use std::time::Duration;
use stickler_causes::SearchLimits;
use stickler_run::{Cause, Reduced};
use stickler_suite::Suite;

fn three_defects() -> (Suite, DefectiveCompiler) {
    let first = defects(include_str!("defects/three.toml")).into_iter().next();
    let first = first.expect("a defect");
    (first.suite(), first.compiler())
}

#[test]
fn the_programs_of_three_defects_are_small_and_each_has_all_of_its_claims() {
    let (suite, compiler) = three_defects();
    let found = causes(&suite, &compiler, 2, SearchLimits::default());
    for cause in &found {
        assert_eq!((cause.reduction, &cause.flaky), (Reduced::Smallest, &None));
        assert_ne!(cause.shown.expected, cause.shown.got);
        let program = &cause.shown.program;
        assert!(!program.contains("other"), "{program}");
    }
    let with = |text: &str| {
        let cause = found.iter().find(|cause| cause.title.contains(text));
        cause.expect("a cause with this title")
    };
    let bases: BTreeSet<&str> = with("1.0E250")
        .cases
        .iter()
        .map(|some| some.basis.as_str())
        .collect();
    assert_eq!(bases.len(), 3, "one defect under three claims: {bases:?}");
}

#[test]
fn the_same_is_found_however_many_threads_there_are() {
    let (suite, compiler) = three_defects();
    let found = |jobs| causes(&suite, &compiler, jobs, SearchLimits::default());
    assert_eq!(found(1), found(4));
}

#[test]
fn without_questions_every_case_still_has_a_cause_with_the_program_of_a_case() {
    let (suite, compiler) = three_defects();
    let limits = SearchLimits {
        questions: 0,
        ..SearchLimits::default()
    };
    let found = causes(&suite, &compiler, 1, limits);
    assert_eq!(found.iter().map(Cause::number).sum::<u64>(), 18);
    assert_eq!(compiler.number_asked(""), 18, "the run alone asked");
    let mistaken = found.iter().find(|cause| cause.title.contains("is accepted"));
    let shown = &mistaken.expect("a cause").shown;
    assert!(shown.program.starts_with("PROGRAM main\n"), "{}", shown.program);
    let line = shown.expected[0].diagnostic().and_then(|reported| reported.line);
    assert_eq!(line, Some(8), "lines are those of the program that is shown");
    let late = SearchLimits {
        time: Duration::ZERO,
        ..SearchLimits::default()
    };
    let found = causes(&suite, &compiler, 1, late);
    assert!(found.iter().all(|cause| cause.reduction == Reduced::Partly));
}

#[test]
fn what_comes_by_chance_is_told_as_such() {
    let (suite, mut compiler) = three_defects();
    compiler.rejects_every = 19;
    let found = causes(&suite, &compiler, 1, SearchLimits::default());
    let chance = found.iter().find(|cause| cause.title.contains("the dice"));
    let repeats = chance.expect("a cause").flaky.as_ref();
    let repeats = repeats.expect("it does not come each time");
    assert!(repeats.seen < repeats.of, "{repeats:?}");
    let runs: u32 = repeats.outcomes.iter().map(|outcome| outcome.runs).sum();
    assert!(repeats.outcomes.len() > 1 && runs == repeats.of, "{repeats:?}");
}

#[test]
fn what_has_no_answer_in_time_comes_by_no_chance() {
    let (suite, mut compiler) = three_defects();
    // The run asks about so many cases.
    compiler.busy_after = 18;
    let found = causes(&suite, &compiler, 1, SearchLimits::default());
    let is_open = |cause: &Cause| cause.flaky.is_none() && cause.reduction != Reduced::Not;
    assert!(found.iter().all(is_open), "{found:?}");
}

/// A program of which one statement matters.
const OF_CHANCE: &str = r#"
[[defect]]
name   = "what comes by chance is made small"
cases  = [{ has = "a : INT; b : INT; c : INT;", does = "a := 1;\nb := 2;\nc := b;", must = "c = INT#2" }]
titles = []
"#;

#[test]
fn what_comes_by_chance_is_made_small_by_asking_again() {
    let planted = &defects(OF_CHANCE)[0];
    let mut compiler = planted.compiler();
    (compiler.rejects_every, compiler.rejects_where) = (3, "c := b");
    let found = causes(&planted.suite(), &compiler, 1, SearchLimits::default());
    let [cause] = &found[..] else {
        panic!("{found:?}");
    };
    let program = &cause.shown.program;
    assert!(
        cause.flaky.is_some() && cause.reduction == Reduced::Smallest,
        "{cause:?}"
    );
    assert!(
        program.contains("c := b") && !program.contains("a := 1"),
        "{program}"
    );
}
