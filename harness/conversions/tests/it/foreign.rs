//! Tests sweeps through programs: of the reference, and of engines with a single planted error.

use crate::between::{Between, wrong};
use stickler_conversions::RefusalKind;
use stickler_conversions::sweep::foreign::{ForeignFindings, run};
use stickler_conversions::sweep::{Sampling, Sweep, SweepMethod, agenda};
use stickler_engines::{Engine, Outcome, Reference, RunRequest, Session};
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

/// Asserts that a sweep dealt with all inputs and found nothing wrong.
fn assert_clean(function: &str, found: &ForeignFindings) {
    let clean = ForeignFindings {
        inputs: found.inputs,
        done: found.inputs,
        left_out: found.left_out,
        programs: found.programs,
        ..ForeignFindings::default()
    };
    assert_eq!(*found, clean, "{function}");
}

#[test]
fn the_reference_is_exact_through_programs_that_count() {
    for dialect in [DialectName::IRONPLC_ED3, DialectName::MATIEC] {
        for function in [
            "SINT_TO_BYTE",
            "INT_TO_SINT",
            "UINT_TO_LINT",
            "INT_TO_ULINT",
            "INT_TO_LREAL",
            "UINT_TO_REAL",
            "WORD_TO_INT",
            "WORD_TO_LWORD",
            "BYTE_TO_BOOL",
            "BCD_TO_INT",
            "INT_TO_BCD",
            "TO_DINT",
        ] {
            for sweep in sweeps(function, dialect, None) {
                if sweep.signature.operands[0].bits() <= 16 {
                    assert_clean(function, &found_by(2, &sweep, &Reference::new()));
                }
            }
        }
    }
}

#[test]
fn the_reference_is_exact_through_programs_that_list() {
    exact_through_lists(DialectName::IRONPLC_ED3);
}

#[test]
fn the_reference_is_exact_through_programs_that_list_in_another_dialect() {
    exact_through_lists(DialectName::MATIEC);
}

fn exact_through_lists(dialect: DialectName) {
    for function in [
        "BOOL_TO_DINT",
        "DINT_TO_INT",
        "LINT_TO_REAL",
        "LWORD_TO_BYTE",
        "REAL_TO_INT",
        "LREAL_TO_REAL",
        "TRUNC",
        "ROUND",
        "TIME_TO_DINT",
        "INT_TO_TIME",
        "LTIME_TO_LINT",
        "DT_TO_TOD",
        "CONCAT_DATE_TOD",
        "STRING_TO_INT",
        "REAL_TO_STRING",
        "STRING_TO_WSTRING",
        "WCHAR_TO_CHAR",
    ] {
        for sweep in sweeps(function, dialect, Some(100)) {
            assert_clean(function, &found_by(2, &sweep, &Reference::new()));
        }
    }
}

#[test]
fn what_no_literal_says_is_counted_as_left_out() {
    let sweep = &sweeps("LREAL_TO_INT", DialectName::MATIEC, Some(0))[0];
    let found = found(sweep, &Reference::new());
    assert!((1..100).contains(&found.left_out), "{found:?}");
    assert_eq!(found.answered(), found.inputs - found.left_out);
}

#[test]
fn one_wrong_input_among_all_of_sixteen_bits_is_named() {
    for (function, from, to, body, named) in [
        (
            "INT_TO_DINT",
            "INT",
            "DINT",
            "IF x = 4711 THEN Wrong := DINT#4712; ELSE Wrong := RIGHT; END_IF;",
            "INT#4711 gives DINT#4712, not DINT#4711",
        ),
        (
            "INT_TO_LREAL",
            "INT",
            "LREAL",
            "IF x = INT#-32768 THEN Wrong := LREAL#-32768.00000000001; ELSE Wrong := RIGHT; END_IF;",
            "INT#-32768 gives LREAL#-32768.00000000001, not LREAL#-32768.0",
        ),
        (
            "INT_TO_LREAL",
            "INT",
            "LREAL",
            "IF x = 0 THEN Wrong := LREAL#-0.0; ELSE Wrong := RIGHT; END_IF;",
            "INT#0 gives LREAL#-0.0, not LREAL#0.0",
        ),
        (
            "WORD_TO_BOOL",
            "WORD",
            "BOOL",
            "Wrong := RIGHT AND x <> WORD#16#8000;",
            "WORD#16#8000 gives BOOL#FALSE, not BOOL#TRUE",
        ),
        (
            "UINT_TO_ULINT",
            "UINT",
            "ULINT",
            "Wrong := RIGHT; IF x = 65535 THEN Wrong := ULINT#18446744073709551615; END_IF;",
            "UINT#65535 gives ULINT#18446744073709551615, not ULINT#65535",
        ),
    ] {
        let found = found(
            &sweeps(function, DialectName::MATIEC, None)[0],
            &wrong(function, from, to, body),
        );
        assert_eq!(
            (found.mismatches, found.unexamined, found.unexplained),
            (1, 0, 0),
            "{found:?}"
        );
        assert_eq!(found.first[0].to_string(), named);
        assert!(found.first[0].basis.is_some() && found.has_failures());
    }
}

#[test]
fn one_wrong_input_among_a_list_is_named() {
    let engine = wrong(
        "LINT_TO_INT",
        "LINT",
        "INT",
        "Wrong := RIGHT; IF x = LINT#32768 THEN Wrong := INT#32767; END_IF;",
    );
    let found = found(&sweeps("LINT_TO_INT", DialectName::MATIEC, Some(100))[0], &engine);
    assert_eq!(found.mismatches, 1);
    assert_eq!(
        found.first[0].to_string(),
        "LINT#32768 gives INT#32767, not INT#-32768"
    );
}

#[test]
fn where_everything_is_wrong_the_first_are_named_and_the_rest_not_looked_into() {
    let engine = wrong("INT_TO_UINT", "INT", "UINT", "Wrong := RIGHT + UINT#1;");
    let found = found(&sweeps("INT_TO_UINT", DialectName::MATIEC, None)[0], &engine);
    assert_eq!(found.first.len(), 10);
    assert_eq!(found.first[0].to_string(), "INT#0 gives UINT#1, not UINT#0");
    assert_eq!(found.mismatches + found.unexamined, 65_536);
    assert!(found.programs < 100, "{found:?}");
}

#[test]
fn what_no_document_speaks_of_is_an_observation() {
    // The engine stays at the limit, which PLCnext's documents neither demand nor forbid.
    let limit = "IF x > 127 THEN Wrong := SINT#127; ELSIF x < -128 THEN Wrong := SINT#-128; ELSE Wrong := RIGHT; END_IF;";
    let engine = wrong("INT_TO_SINT", "INT", "SINT", limit);
    let found = found(&sweeps("INT_TO_SINT", DialectName::PLCNEXT, None)[0], &engine);
    assert_eq!((found.mismatches, found.unexamined), (0, 0));
    assert!(
        found.observed >= 10 && found.unexamined_observed > 0 && !found.has_failures(),
        "{found:?}"
    );
    assert_eq!(
        found.first_observed[0].to_string(),
        "INT#128 gives SINT#127, not SINT#-128"
    );
}

#[test]
fn an_input_that_is_not_answered_is_told_apart_with_its_reason() {
    let engine = wrong(
        "INT_TO_DINT",
        "INT",
        "DINT",
        "Wrong := RIGHT / (RIGHT - DINT#77); Wrong := RIGHT;",
    );
    let found = found(&sweeps("INT_TO_DINT", DialectName::MATIEC, None)[0], &engine);
    assert_eq!((found.mismatches, found.observed), (0, 0));
    let [unanswered] = &found.unanswered[..] else {
        panic!("{found:?}")
    };
    assert_eq!(
        (unanswered.inputs, unanswered.refusal.kind),
        (1, RefusalKind::Faulted)
    );
    assert_eq!(unanswered.example[0].to_string(), "INT#77");
    assert_eq!(unanswered.refusal.detail, "division-by-zero");
    assert_eq!(found.answered(), 65_535);
}

#[test]
fn an_engine_that_crashes_at_one_input_is_asked_on() {
    let engine = Between {
        reference: Reference::new(),
        answer: |session: &mut dyn Session, request: &RunRequest<'_>| {
            assert!(!request.source.contains(":= 'abc';"), "a bug of the engine");
            session.run(request)
        },
    };
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
    let engine = Between {
        reference: Reference::new(),
        answer: |session: &mut dyn Session, request: &RunRequest<'_>| {
            let long = ["DINT#16383 ", "DINT#16384 ", "DINT#8192 "];
            match long.iter().any(|count| request.source.contains(count)) {
                true => Outcome::TimedOut { after_ms: 1 },
                false => session.run(request),
            }
        },
    };
    let sweep = &sweeps("INT_TO_DINT", DialectName::MATIEC, None)[0];
    let found = found(sweep, &engine);
    assert_eq!(found.mismatches, 0, "{found:?}");
}

#[test]
fn a_sum_that_is_wrong_although_each_result_is_right_is_told_apart() {
    let engine = Between {
        reference: Reference::new(),
        answer: |session: &mut dyn Session, request: &RunRequest<'_>| {
            let source = request
                .source
                .replace("MOD LINT#1999999973", "MOD LINT#1999999993");
            session.run(&RunRequest {
                source: &source,
                ..*request
            })
        },
    };
    let found = found(&sweeps("SINT_TO_DINT", DialectName::MATIEC, None)[0], &engine);
    assert_eq!((found.mismatches, found.observed), (0, 0));
    assert!(found.unexplained > 0 && found.has_failures(), "{found:?}");
}

#[test]
fn an_engine_that_answers_nothing_is_an_error_with_its_words() {
    let engine = Between {
        reference: Reference::new(),
        answer: |session: &mut dyn Session, request: &RunRequest<'_>| {
            let source = request.source.replace("INT_TO_DINT(", "INT_TO_NOTHING(");
            session.run(&RunRequest {
                source: &source,
                ..*request
            })
        },
    };
    let sweep = &sweeps("INT_TO_DINT", DialectName::MATIEC, None)[0];
    let error = run(sweep, &engine, 1, &|_| {}, &Cancellation::new()).expect_err("it knows no such function");
    let error = error.to_string();
    assert!(
        error.starts_with("reference could not be asked INT_TO_DINT in matiec: it rejected"),
        "{error}"
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
