//! Finds the defects that are planted in an engine, each of which many cases of several tables and dialects show.

use crate::fixtures::{self, causes, identity, titles};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;
use stickler_causes::SearchLimits;
use stickler_engines::{Engine, EngineError, Identity, Outcome, RunRequest, Session};
use stickler_run::{Cause, Reduced};
use stickler_suite::{Case, Suite};
use stickler_types::{Diagnostic, DialectName, Value};

/// A compiler that does what the reference does, but for three defects: it cannot read an exponent of three digits, it
/// assigns a value of every type to every other, and it does not convert integers to REAL.
#[derive(Default)]
struct ThreeDefects {
    identity: Option<Identity>,
    /// The number of programs that were run.
    asked: AtomicU64,
    /// The interval at which programs are rejected, whatever they are; 0 stands for none.
    rejects_every: u64,
    /// The operator that it does not implement.
    lacks: Option<&'static str>,
}

impl ThreeDefects {
    fn new(rejects_every: u64) -> ThreeDefects {
        ThreeDefects {
            identity: Some(identity()),
            rejects_every,
            ..ThreeDefects::default()
        }
    }
}

impl Engine for ThreeDefects {
    fn identity(&self) -> &Identity {
        self.identity.as_ref().expect("made by new")
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        Ok(Box::new(Compiling(self)))
    }
}

struct Compiling<'e>(&'e ThreeDefects);

impl Session for Compiling<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        let number = self.0.asked.fetch_add(1, Ordering::Relaxed);
        let rejected = |line: usize, message: &str| Outcome::Rejected {
            diagnostics: vec![Diagnostic {
                line: u32::try_from(line).ok(),
                column: Some(1),
                message: message.to_owned(),
                ..Diagnostic::default()
            }],
        };
        if self.0.rejects_every > 0 && number.is_multiple_of(self.0.rejects_every) {
            return rejected(1, "the dice said no");
        }
        if self
            .0
            .lacks
            .is_some_and(|operator| request.source.contains(operator))
        {
            let reason = "no such operator yet".to_owned();
            return Outcome::NotImplemented { reason };
        }
        let lines = || request.source.lines().zip(1..);
        if let Some((_, line)) = lines().find(|(line, _)| line.contains("E300") || line.contains("E250")) {
            return rejected(line, "exponent of three digits");
        }
        let outcome = stickler_reference::run(request, stickler_reference::Limits::default());
        let integers = ["SINT", " INT", "DINT"]
            .iter()
            .any(|ty| request.source.contains(ty));
        match outcome.expect("observed variables are there") {
            Outcome::Rejected { mut diagnostics } => {
                diagnostics.retain(|reported| reported.code.as_deref() != Some("P4035"));
                match diagnostics.is_empty() {
                    true => Outcome::ACCEPTED,
                    false => Outcome::Rejected { diagnostics },
                }
            }
            Outcome::Executed { mut values, .. } => {
                let reals = values.iter_mut().filter(|(_, value)| value.type_name() == "REAL");
                let wrong = || Value::parse("REAL#0.5").expect("a literal");
                reals.filter(|_| integers).for_each(|(_, value)| *value = wrong());
                Outcome::executed(values)
            }
            other => other,
        }
    }

    fn check(&mut self, _: DialectName, _: &str) -> Outcome {
        Outcome::ACCEPTED
    }

    fn render(&mut self, _: DialectName, source: &str) -> Outcome {
        Outcome::Rendered {
            text: source.to_owned(),
        }
    }
}

/// Returns a case in both dialects.
fn case(id: &str, program: &str, must: &str) -> [Case; 2] {
    [DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3].map(|dialect| Case {
        dialect,
        ..fixtures::case(id, program, must)
    })
}

/// Returns a program that assigns a variable of one type to one of another in a function, and more that does not matter.
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
    fixtures::suite(cases)
}

#[test]
fn three_defects_are_three_causes_whatever_tables_and_dialects_show_them() {
    let found = causes(&suite(), &ThreeDefects::new(0), 2, SearchLimits::default());
    assert_eq!(
        titles(&found),
        [
            (
                6,
                "`data : LREAL := 1.0E300` is rejected: exponent of three digits"
            ),
            (
                6,
                "`into := data` (into : INT, data : DINT) is accepted, though the value's type does not fit the target (P4035)"
            ),
            (
                6,
                "`into := data` (into : REAL, data : INT := 5) gives REAL#0.5, not REAL#5.0"
            ),
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
    let found = |jobs| causes(&suite(), &ThreeDefects::new(0), jobs, SearchLimits::default());
    assert_eq!(found(1), found(4));
}

#[test]
fn without_questions_every_case_still_has_a_cause_with_the_program_of_a_case() {
    let engine = ThreeDefects::new(0);
    let limits = SearchLimits {
        questions: 0,
        ..SearchLimits::default()
    };
    let found = causes(&suite(), &engine, 1, limits);
    assert_eq!(found.iter().map(Cause::number).sum::<u64>(), 18);
    assert_eq!(engine.asked.load(Ordering::Relaxed), 18, "the run alone asked");
    let program = &found
        .iter()
        .find(|cause| cause.symptom.contains("P4035"))
        .expect("a cause")
        .shown;
    assert!(
        program.program.starts_with("PROGRAM main\n"),
        "{}",
        program.program
    );
    let line = program.expected[0]
        .diagnostic()
        .and_then(|reported| reported.line);
    assert_eq!(line, Some(8), "lines are those of the program that is shown");
    let late = SearchLimits {
        time: Duration::ZERO,
        ..SearchLimits::default()
    };
    assert!(
        causes(&suite(), &engine, 1, late)
            .iter()
            .all(|cause| cause.reduction == Reduced::Partly)
    );
}

#[test]
fn what_comes_by_chance_is_told_as_such() {
    let found = causes(&suite(), &ThreeDefects::new(19), 1, SearchLimits::default());
    let chance = found
        .iter()
        .find(|cause| cause.title.contains("the dice"))
        .expect("a cause");
    let repeats = chance.flaky.as_ref().expect("it does not come each time");
    assert!(repeats.seen < repeats.of, "{repeats:?}");
    let runs: u32 = repeats.outcomes.iter().map(|outcome| outcome.runs).sum();
    assert!(repeats.outcomes.len() > 1 && runs == repeats.of, "{repeats:?}");
}

#[test]
fn a_construct_that_a_document_promises_and_that_is_not_implemented_is_a_cause_with_the_smallest_program() {
    let mut engine = ThreeDefects {
        lacks: Some(" MOD "),
        ..ThreeDefects::new(0)
    };
    // Of a compiler with an adapter, Stickler's own sources say which of them speak for it.
    engine.identity.as_mut().expect("made by new").name = "ironplc".to_owned();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let mut suite = Suite::load_files(&folder, &[], |_, _| false);
    for (id, basis) in [
        ("language/mod::promised", "ironplc-standard-functions: mod"),
        ("language/mod::not-promised", "iec-61131-3: Table 29"),
    ] {
        let program = assigning("INT", "7", "INT").replace("data;", "data MOD 4;");
        let cases = case(id, &program, "into = INT#3").into_iter();
        suite.cases.extend(cases.map(|case| Case {
            basis: basis.into(),
            ..case
        }));
    }
    let found = causes(&suite, &engine, 1, SearchLimits::default());
    assert_eq!(found.len(), 1, "{found:?}");
    let cause = &found[0];
    assert_eq!(cause.number(), 2);
    assert!(
        cause
            .cases
            .iter()
            .all(|some| some.probe == "language/mod::promised")
    );
    let promised = "(into : INT) is not implemented, though promised by ironplc-standard-functions: mod: no such operator yet";
    assert!(cause.title.ends_with(promised), "{}", cause.title);
    assert_eq!(cause.reduction, Reduced::Smallest);
    assert!(!cause.shown.program.contains("other"), "{}", cause.shown.program);
}
