//! Tests sweeps through programs: of the reference, and of engines with a single planted error.

use crate::support::{reading, wrong};
use stickler_conversions::RefusalKind;
use stickler_conversions::sweep::foreign::{ForeignFindings, run};
use stickler_conversions::sweep::{Sampling, Sweep, SweepMethod, agenda};
use stickler_engines::{ClosureEngine, Engine, Outcome, Reference};
use stickler_mdtest::{assert_fits, check_examples};
use stickler_types::DialectName;
use stickler_types::boundaries::BoundaryDetail;
use stickler_workers::Cancellation;

fn sweeps(function: &str, dialect: DialectName, inputs: Option<u64>) -> Vec<Sweep> {
    let sampling = Sampling {
        inputs,
        seed: 1,
        detail: BoundaryDetail::Coarse,
    };
    agenda(function, &[dialect], sampling, SweepMethod::Programs).unwrap_or_default()
}

/// Returns the findings of a sweep by one worker, so that the programs are always the same.
fn found(sweep: &Sweep, engine: &dyn Engine) -> ForeignFindings {
    found_by(1, sweep, engine)
}

fn found_by(workers: usize, sweep: &Sweep, engine: &dyn Engine) -> ForeignFindings {
    let found = run(sweep, engine, workers, &|_| {}, &Cancellation::new()).expect("it can be asked");
    assert!(found.is_complete(), "{found:?}");
    found
}

/// Tells what a sweep found.
fn described(found: &ForeignFindings) -> String {
    let mut text = String::new();
    let mut line = |name: &str, number: u64| {
        if number > 0 {
            text += &format!("{number} {name}\n");
        }
    };
    line("mismatches", found.mismatches);
    line("observed", found.observed);
    line("unexamined", found.unexamined);
    line("unexamined where no document speaks", found.unexamined_observed);
    line("unexplained", found.unexplained);
    line("left out", found.left_out);
    for unanswered in &found.unanswered {
        line(
            &format!(
                "unanswered: {:?}, {}",
                unanswered.refusal.kind, unanswered.refusal.detail
            ),
            unanswered.inputs,
        );
    }
    let first = found
        .first
        .iter()
        .map(|difference| format!("{difference} by {}\n", difference.basis.unwrap_or("nobody")));
    let observed = found
        .first_observed
        .iter()
        .map(|difference| format!("{difference}\n"));
    text.extend(first.chain(observed));
    assert!(found.unexamined == 0 || found.programs < 100, "{found:?}");
    assert_eq!(
        found.answered(),
        found.inputs - found.left_out - found.unanswered.iter().map(|it| it.inputs).sum::<u64>()
    );
    match found.has_failures() {
        true => text + "fails",
        false => text + "no failure",
    }
}

/// Sweeps a function on the reference by two workers, or by one worker with the function `body` in its place.
#[test]
fn golden_sweeps() {
    check_examples("tests/examples/sweeps.md", |example| {
        let dialects = example.text("dialects").split_whitespace();
        let inputs = example.get("inputs").filter(|inputs| !inputs.is_empty());
        let inputs = inputs.map(|inputs| inputs.parse().expect("a number"));
        let of_dialect = |dialect: &str| {
            sweeps(
                example.text("function"),
                dialect.parse().expect("a dialect"),
                inputs,
            )
        };
        let mut all: Vec<Sweep> = dialects.flat_map(of_dialect).collect();
        // Programs count through these; of others there are too many values.
        all.retain(|sweep| inputs.is_some() || sweep.signature.operands[0].bits() <= 16);
        let engine: Box<dyn Engine> = match example.get("body") {
            None => Box::new(Reference::new()),
            Some(body) => {
                let signature = &all[0].signature;
                Box::new(wrong(
                    &signature.function,
                    signature.operands[0].name(),
                    signature.result.name(),
                    body,
                ))
            }
        };
        let workers = if example.get("body").is_some() { 1 } else { 2 };
        let mut told: Vec<String> = all
            .iter()
            .map(|sweep| described(&found_by(workers, sweep, &*engine)))
            .collect();
        told.dedup();
        told.join("\n")
    });
}

#[test]
fn an_engine_that_crashes_at_one_input_is_asked_on() {
    let engine = ClosureEngine::new("reference", |reference, request| {
        assert!(!request.source.contains(":= 'abc';"), "a bug of the engine");
        reference.run(request)
    });
    let found = found(
        &sweeps("STRING_TO_INT", DialectName::MATIEC, Some(10))[0],
        &engine,
    );
    assert_eq!(found.unanswered.len(), 1, "{found:?}");
    assert_eq!(found.unanswered[0].refusal.kind, RefusalKind::Crashed);
    assert_eq!(found.answered(), found.inputs - 1);
}

#[test]
fn an_engine_that_allows_few_steps_gets_shorter_programs() {
    let engine = ClosureEngine::new("reference", |reference, request| {
        let long = ["DINT#16383 ", "DINT#16384 ", "DINT#8192 "];
        match long.iter().any(|count| request.source.contains(count)) {
            true => Outcome::TimedOut { after_ms: 1 },
            false => reference.run(request),
        }
    });
    let sweep = &sweeps("INT_TO_DINT", DialectName::MATIEC, None)[0];
    let found = found(sweep, &engine);
    assert_eq!(found.mismatches, 0, "{found:?}");
}

#[test]
fn a_sum_that_is_wrong_although_each_result_is_right_is_told_apart() {
    let engine = reading(|source| source.replace("MOD LINT#1999999973", "MOD LINT#1999999993"));
    let found = found(&sweeps("SINT_TO_DINT", DialectName::MATIEC, None)[0], &engine);
    assert_eq!((found.mismatches, found.observed), (0, 0));
    assert!(found.unexplained > 0 && found.has_failures(), "{found:?}");
}

#[test]
fn an_engine_that_answers_nothing_is_an_error_with_its_words() {
    let engine = reading(|source| source.replace("INT_TO_DINT(", "INT_TO_NOTHING("));
    let sweep = &sweeps("INT_TO_DINT", DialectName::MATIEC, None)[0];
    let error = run(sweep, &engine, 1, &|_| {}, &Cancellation::new()).expect_err("it knows no such function");
    let error = error.to_string();
    assert_fits(
        &error,
        "reference could not be asked INT_TO_DINT in matiec: it rejected…",
    );
    assert!(error.contains("at `given := INT_TO_DINT(operand);`"), "{error}");
}

#[test]
fn a_sweep_of_an_engine_can_be_cancelled() {
    let sweep = &sweeps("DINT_TO_INT", DialectName::MATIEC, None)[0];
    let cancel = Cancellation::new();
    let progress = |reached: stickler_conversions::sweep::SweepProgress| {
        if reached.done > 10_000 {
            cancel.request();
        }
    };
    let found = run(sweep, &Reference::new(), 2, &progress, &cancel).expect("it can be asked");
    assert!(!found.is_complete() && found.done > 10_000, "{found:?}");
}
