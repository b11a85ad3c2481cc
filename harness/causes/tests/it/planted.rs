//! Finds three defects of one compiler, each of which many cases of several tables and dialects show: it cannot read an exponent
//! of three digits, it assigns a value of every type to every other, and it does not convert integers to REAL.

use crate::compiler::{DefectiveCompiler, Defects, RejectedLine, WrongValue};
use crate::suites::{self, causes, suite_with_sources, titles};
use std::time::Duration;
use stickler_causes::SearchLimits;
use stickler_run::{Cause, Reduced};
use stickler_suite::{Case, Suite};
use stickler_types::DialectName;

fn compiler() -> DefectiveCompiler {
    let texts = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect();
    DefectiveCompiler::new(&Defects {
        rejects: vec![RejectedLine {
            with: texts(&["E300", "E250"]),
            message: "exponent of three digits".to_owned(),
            column: Some(1),
            ..RejectedLine::default()
        }],
        accepts: texts(&["P4035"]),
        computes: vec![WrongValue {
            of: "REAL".to_owned(),
            with: texts(&["SINT", " INT", "DINT"]),
            is: "REAL#0.5".to_owned(),
        }],
        ..Defects::default()
    })
}

/// Returns a case in both dialects.
fn case(id: &str, program: &str, must: &str) -> [Case; 2] {
    [DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3].map(|dialect| Case {
        dialect,
        ..suites::case(id, program, must)
    })
}

/// Returns a program that assigns a variable of one type to one of another, and more that does not matter.
fn assigning(from: &str, value: &str, into: &str) -> String {
    format!(
        "(*!\ntitle = \"t\"\n*)\nPROGRAM main\nVAR\n    other : INT := 7;\n    data : {from} := {value};\n    into : {into};\nEND_VAR\n    \
         other := other + 1;\n    into := data;   (*! here *)\nEND_PROGRAM\n"
    )
}

fn suite() -> Suite {
    let mut cases = Vec::new();
    for (from, value, into, is) in [
        ("INT", "5", "REAL", "REAL#5.0"),
        ("SINT", "-7", "REAL", "REAL#-7.0"),
        ("INT", "-300", "REAL", "REAL#-300.0"),
    ] {
        let id = format!("real/from-integer::assignment({from},{value})");
        cases.extend(case(&id, &assigning(from, value, into), &format!("into = {is}")));
    }
    for (from, into) in [("DINT", "INT"), ("LREAL", "REAL"), ("REAL", "INT")] {
        let value = if from == "DINT" { "5" } else { "5.0" };
        let id = format!("integer/narrower::assignment({from},{into})");
        cases.extend(case(&id, &assigning(from, value, into), "11 P4035"));
    }
    let field = "TYPE R : STRUCT f : LREAL; END_STRUCT; END_TYPE\nPROGRAM main\nVAR\n    r : R;\n    into : BOOL;\nEND_VAR\n    \
                 r.f := 1.0E300;\n    into := r.f > 2.0;\nEND_PROGRAM\n";
    cases.extend(case("real/fields::write", field, "into = BOOL#TRUE"));
    for (id, value) in [
        ("real/large::initial(1)", "1.0E300"),
        ("widening/large::initial(2)", "-2.5E250"),
    ] {
        let must = format!("into = LREAL#{value}");
        cases.extend(case(id, &assigning("LREAL", value, "LREAL"), &must));
    }
    suites::suite(cases)
}

#[test]
fn three_defects_are_three_causes_whatever_tables_and_dialects_show_them() {
    let found = causes(&suite(), &compiler(), 2, SearchLimits::default());
    assert_eq!(
        titles(&found),
        [
            "6 `data : LREAL := 1.0E300` is rejected: exponent of three digits",
            "6 `into := data` (into : INT, data : DINT) is accepted, though the value's type does not fit the target (P4035)",
            "6 `into := data` (into : REAL, data : INT := 5) gives REAL#0.5, not REAL#5.0",
        ]
    );
    for cause in &found {
        assert_eq!(cause.reduction, Reduced::Smallest);
        assert_ne!(cause.shown.expected, cause.shown.got);
        assert!(!cause.shown.program.contains("(*!"), "{}", cause.shown.program);
        assert!(!cause.shown.program.contains("other"), "{}", cause.shown.program);
        assert_eq!(cause.flaky, None);
    }
    let bases = found[0].cases.iter().map(|some| some.basis.as_str());
    let bases: std::collections::BTreeSet<&str> = bases.collect();
    assert_eq!(bases.len(), 3, "one defect under three claims: {bases:?}");
    let second = found[2].second.as_ref().expect("a second witness");
    assert!(second.program.contains("SINT"), "{}", second.program);
}

#[test]
fn the_same_is_found_however_many_threads_there_are() {
    let found = |jobs| causes(&suite(), &compiler(), jobs, SearchLimits::default());
    assert_eq!(found(1), found(4));
}

#[test]
fn without_questions_every_case_still_has_a_cause_with_the_program_of_a_case() {
    let engine = compiler();
    let limits = SearchLimits {
        questions: 0,
        ..SearchLimits::default()
    };
    let found = causes(&suite(), &engine, 1, limits);
    assert_eq!(found.iter().map(Cause::number).sum::<u64>(), 18);
    assert_eq!(engine.number_asked(""), 18, "the run alone asked");
    let mistaken = found.iter().find(|cause| cause.symptom.contains("P4035"));
    let shown = &mistaken.expect("a cause").shown;
    assert!(shown.program.starts_with("PROGRAM main\n"), "{}", shown.program);
    let line = shown.expected[0].diagnostic().and_then(|reported| reported.line);
    assert_eq!(line, Some(8), "lines are those of the program that is shown");
    let late = SearchLimits {
        time: Duration::ZERO,
        ..SearchLimits::default()
    };
    let found = causes(&suite(), &engine, 1, late);
    assert!(found.iter().all(|cause| cause.reduction == Reduced::Partly));
}

#[test]
fn what_comes_by_chance_is_told_as_such() {
    let mut engine = compiler();
    engine.rejects_every = 19;
    let found = causes(&suite(), &engine, 1, SearchLimits::default());
    let chance = found.iter().find(|cause| cause.title.contains("the dice"));
    let repeats = chance.expect("a cause").flaky.as_ref();
    let repeats = repeats.expect("it does not come each time");
    assert!(repeats.seen < repeats.of, "{repeats:?}");
    let runs: u32 = repeats.outcomes.iter().map(|outcome| outcome.runs).sum();
    assert!(repeats.outcomes.len() > 1 && runs == repeats.of, "{repeats:?}");
}

#[test]
fn a_construct_that_a_document_promises_and_that_is_not_implemented_is_a_cause_with_the_smallest_program() {
    let mut engine = compiler();
    engine.defects.lacks = Some((" MOD ".to_owned(), "no such operator yet".to_owned()));
    // Of a compiler with an adapter, Stickler's own sources say which of them speak for it.
    engine.identity.name = "ironplc".to_owned();
    let mut cases = Vec::new();
    for (id, basis) in [
        ("language/mod::promised", "ironplc-standard-functions: mod"),
        ("language/mod::not-promised", "iec-61131-3: Table 29"),
    ] {
        let program = assigning("INT", "7", "INT").replace("data;", "data MOD 4;");
        let both = case(id, &program, "into = INT#3").into_iter();
        cases.extend(both.map(|case| Case {
            basis: basis.into(),
            ..case
        }));
    }
    let found = causes(&suite_with_sources(cases), &engine, 1, SearchLimits::default());
    assert_eq!(found.len(), 1, "{found:?}");
    let cause = &found[0];
    assert_eq!(cause.number(), 2);
    let mut cases = cause.cases.iter();
    assert!(cases.all(|some| some.probe == "language/mod::promised"));
    let promised = "(into : INT) is not implemented, though promised by ironplc-standard-functions: mod: no such operator yet";
    assert!(cause.title.ends_with(promised), "{}", cause.title);
    assert_eq!(cause.reduction, Reduced::Smallest);
    assert!(!cause.shown.program.contains("other"), "{}", cause.shown.program);
}
