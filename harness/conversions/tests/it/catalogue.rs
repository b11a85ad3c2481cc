//! Tests the reference against exact arithmetic, function by function.

use crate::support::{findings, sampled};
use std::collections::HashSet;
use stickler_conversions::NoSuchFunction;
use stickler_conversions::sweep::{AgendaError, Sampling, Sweep, SweepMethod, agenda};
use stickler_exact::{Signature, functions};
use stickler_types::DialectName;
use stickler_types::boundaries::BoundaryDetail;

/// Sweeps every function of every dialect, each distinct rule once: every input of a source of at most 16 bits, and the
/// nearest neighbours of the boundaries with a small sample of the others.
#[test]
fn the_reference_is_exact_wherever_a_moment_suffices() {
    let mut seen = HashSet::new();
    let mut wrong = Vec::new();
    for dialect in DialectName::ALL {
        for function in functions(dialect) {
            for sweep in coarse(&function, dialect, Some(200)) {
                let Signature {
                    operands,
                    result,
                    operation,
                    ..
                } = &sweep.signature;
                let rule = (
                    operands.clone(),
                    *result,
                    *operation,
                    format!("{:?}", sweep.reference),
                );
                if !seen.insert(rule) {
                    continue;
                }
                let small = operands.iter().all(|ty| ty.bits() <= 16 && !ty.is_text());
                let sweeps = match small {
                    true => coarse(&function, dialect, None),
                    false => vec![sweep.clone()],
                };
                for sweep in sweeps.iter().filter(|all| all.signature == sweep.signature) {
                    let found = findings(sweep, &sweep.reference);
                    wrong.extend(
                        found
                            .first
                            .into_iter()
                            .map(|difference| (function.clone(), difference)),
                    );
                }
            }
        }
    }
    let shown: Vec<String> = wrong
        .iter()
        .map(|(function, difference)| format!("{function}: {difference}"))
        .collect();
    assert!(shown.is_empty(), "{}", shown.join("\n"));
    assert!(seen.len() > 600, "only {} rules", seen.len());
}

fn coarse(function: &str, dialect: DialectName, inputs: Option<u64>) -> Vec<Sweep> {
    let sampling = Sampling {
        inputs,
        detail: BoundaryDetail::Coarse,
        ..Sampling::default()
    };
    agenda(function, &[dialect], sampling, SweepMethod::Conversion).expect("the reference has every function")
}

#[test]
fn dialects_with_the_same_rule_share_a_sweep() {
    let shared = sampled("DINT_TO_INT", &DialectName::ALL, None);
    assert_eq!(shared.len(), 1);
    assert_eq!(shared[0].dialects, DialectName::ALL);
    let rounding = sampled("REAL_TO_INT", &DialectName::ALL, None);
    assert_eq!(rounding.len(), 4);
    assert_eq!(
        rounding[1].dialects,
        [
            DialectName::PLCNEXT,
            DialectName::LOGIX,
            DialectName::CONTROL_EXPERT,
            DialectName::OMRON,
            DialectName::IEC_ED3
        ]
    );
    assert_eq!(rounding[2].dialects, [DialectName::STRUCPP, DialectName::RUSTY]);
    assert_eq!(rounding[3].dialects, [DialectName::CODESYS, DialectName::TWINCAT]);
    let separate = agenda(
        "DINT_TO_INT",
        &DialectName::ALL,
        Sampling::default(),
        SweepMethod::Programs,
    );
    assert_eq!(separate.map(|sweeps| sweeps.len()), Ok(DialectName::ALL.len()));
}

#[test]
fn an_overloaded_name_is_swept_for_each_of_its_types() {
    let types: Vec<String> = sampled("TRUNC", &[DialectName::MATIEC], None)
        .iter()
        .map(|sweep| format!("{} {}", sweep.signature.operands[0], sweep.signature.result))
        .collect();
    assert_eq!(types, ["REAL DINT", "LREAL DINT"]);
}

#[test]
fn a_function_that_a_dialect_lacks_is_named_with_those_that_have_it() {
    let error = agenda(
        "ROUND",
        &[DialectName::MATIEC],
        Sampling::default(),
        SweepMethod::Conversion,
    );
    let Err(AgendaError::NoSuchFunction(NoSuchFunction::InDialects { elsewhere, .. })) = &error else {
        panic!("{error:?}")
    };
    assert_eq!(elsewhere.len(), DialectName::ALL.len() - 1);
    let unknown = agenda(
        "FOO",
        &DialectName::ALL,
        Sampling::default(),
        SweepMethod::Conversion,
    );
    assert_eq!(
        unknown.map_err(|error| error.to_string()),
        Err("there is no conversion function `FOO`; `stickler conversions` lists all".to_owned())
    );
}

/// Checks that a dialect's rounding separates sweeps only where a real becomes an integer.
#[test]
fn dialects_share_a_sweep_unless_their_rules_for_it_differ() {
    for (function, distinct) in [
        ("REAL_TO_LREAL", 1),
        ("REAL_TO_BOOL", 1),
        ("REAL_TO_TIME", 2),
        ("DINT_TO_INT", 1),
        ("TRUNC_INT", 4),
        ("REAL_TO_INT", 4),
        ("REAL_TO_WORD", 4),
        ("REAL_TO_STRING", 3),
        ("WORD_TO_STRING", 3),
    ] {
        let sweeps = sampled(function, &DialectName::ALL, None);
        assert_eq!(sweeps.len(), distinct, "{function}");
    }
}
