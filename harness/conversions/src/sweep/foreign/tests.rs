//! Tests that counting and checksum are the same in Rust and in ST, which the reference executes.

use super::counter;
use super::plan::SweepPlan;
use crate::session::FunctionSession;
use crate::sweep::agenda::{SweepMethod, agenda};
use crate::sweep::domain::Sampling;
use std::collections::HashSet;
use std::ops::Range;
use stickler_engines::Reference;
use stickler_exact::{functions, signatures};
use stickler_types::boundaries::BoundaryDetail;
use stickler_types::{DialectName, Value};

/// The first and the last inputs of a stretch.
fn ends(stretch: &Range<u64>) -> [Range<u64>; 2] {
    let some = 20.min(stretch.end - stretch.start);
    [
        stretch.start..stretch.start + some,
        stretch.end - some..stretch.end,
    ]
}

/// Compares the two sums for a function of each pair of types that can be counted, in the first dialect that has each rule, at both
/// ends of its stretches: of all where they are few, of some where a REAL has hundreds.
#[test]
fn the_sum_in_st_is_the_sum_in_rust() {
    let mut programs = 0;
    let mut seen = HashSet::new();
    for dialect in DialectName::ALL {
        let reference = Reference::new();
        let mut session = FunctionSession::open(&reference).expect("a session");
        let all = functions(dialect);
        for function in all.iter().filter(|function| !function.starts_with("TO_")) {
            if !signatures(function, dialect)
                .iter()
                .any(|signature| signature.operands[0].bits() <= 32)
            {
                continue;
            }
            let sampling = Sampling {
                detail: BoundaryDetail::Coarse,
                ..Sampling::default()
            };
            for sweep in agenda(function, &[dialect], sampling, SweepMethod::Programs).expect("a function") {
                let rule = format!("{:?} {:?} {:?}", sweep.signature, sweep.choices, sweep.reference);
                if !seen.insert(rule) {
                    continue;
                }
                let plan = SweepPlan::of(&sweep);
                let Some(counting) = &plan.counting else { continue };
                let few = if plan.stretches.len() > 10 { 37 } else { 1 };
                for places in plan.stretches.iter().step_by(few).flat_map(ends) {
                    let summed = session.run(dialect, &counter::summed(&sweep.signature, counting, &places));
                    let exact = super::worker::total(&sweep, counting, places.clone());
                    assert_eq!(summed, Ok(vec![exact]), "{function} {places:?}");
                    let unrolled =
                        session.run(dialect, &counter::unrolled(&sweep.signature, counting, &places));
                    let exact: Vec<Value> = places
                        .map(|place| {
                            stickler_exact::value(
                                &sweep.signature,
                                &sweep.domain.operands(place),
                                &sweep.choices,
                            )
                        })
                        .collect();
                    assert_eq!(unrolled, Ok(exact), "{function}");
                    programs += 2;
                }
            }
        }
    }
    assert!(programs > 5_000, "{programs}");
}

/// Runs programs whose results are wrong in one bit or by one, for each kind of result: their sum must differ.
#[test]
fn a_wrong_bit_changes_the_sum_in_st_too() {
    let dialect = DialectName::IRONPLC_ED3;
    let reference = Reference::new();
    let mut session = FunctionSession::open(&reference).expect("a session");
    for (function, wrong) in [
        ("INT_TO_DINT", "INT_TO_DINT(operand) + DINT#1"),
        ("INT_TO_LINT", "INT_TO_LINT(operand) + LINT#4294967296"),
        (
            "UINT_TO_ULINT",
            "UINT_TO_ULINT(operand) + ULINT#9223372036854775808",
        ),
        (
            "INT_TO_LWORD",
            "INT_TO_LWORD(operand) XOR LWORD#16#8000_0000_0000_0000",
        ),
        ("INT_TO_BOOL", "NOT INT_TO_BOOL(operand)"),
        ("INT_TO_REAL", "INT_TO_REAL(operand) * REAL#1.0000001"),
        ("INT_TO_LREAL", "INT_TO_LREAL(operand) * LREAL#1.0000000000000002"),
        ("INT_TO_LREAL", "-INT_TO_LREAL(operand)"),
        ("INT_TO_LREAL", "INT_TO_LREAL(operand) / LREAL#0.0"),
        ("INT_TO_LREAL", "INT_TO_LREAL(operand) / LREAL#0.0 * LREAL#0.0"),
        ("INT_TO_LREAL", "INT_TO_LREAL(operand) * LREAL#1.0E-300"),
    ] {
        let sweep =
            agenda(function, &[dialect], Sampling::default(), SweepMethod::Programs).expect("a function");
        let plan = SweepPlan::of(&sweep[0]);
        let counting = plan.counting.expect("it can be counted");
        let places = 1..9;
        let mut program = counter::summed(&sweep[0].signature, &counting, &places);
        let call = format!("{function}(operand)");
        assert!(program.statements.contains(&call));
        program.statements = program.statements.replace(&call, wrong);
        let exact = super::worker::total(&sweep[0], &counting, places);
        let Ok(summed) = session.run(dialect, &program) else {
            panic!("{function}: {}", program.source())
        };
        assert_ne!(summed, [exact], "{wrong}");
    }
}

/// Checks that the basis changes at most once within a stretch: a sweep looks at the ends only.
#[test]
fn what_a_document_speaks_of_does_not_change_back_and_forth() {
    for dialect in DialectName::ALL {
        for function in [
            "INT_TO_SINT",
            "WORD_TO_INT",
            "REAL_TO_INT",
            "REAL_TO_USINT",
            "REAL_TO_LINT",
            "REAL_TO_BOOL",
            "TRUNC",
        ] {
            for signature in signatures(function, dialect) {
                let Some(counter) = super::counter::Counter::new(signature.operands[0]) else {
                    continue;
                };
                let spoken = |place: u64| {
                    let ty = signature.operands[0];
                    let operand = Value::plain(ty, ty.wrap(place.into()));
                    stickler_exact::expected(&signature, &[operand], dialect)
                        .basis
                        .is_some()
                };
                for stretch in counter.stretches() {
                    let some = ((stretch.end - stretch.start) / 200).max(1) as usize;
                    let changes = stretch
                        .clone()
                        .step_by(some)
                        .chain([stretch.end - 1])
                        .map(spoken)
                        .collect::<Vec<_>>();
                    let changes = changes.windows(2).filter(|pair| pair[0] != pair[1]).count();
                    assert!(changes <= 1, "{function} in {dialect}: {stretch:?}");
                }
            }
        }
    }
}
