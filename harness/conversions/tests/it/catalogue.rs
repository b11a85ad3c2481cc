//! Tests the reference against exact arithmetic, function by function.

use crate::support::findings;
use std::collections::HashSet;
use stickler_conversions::overview::boundary_calls;
use stickler_conversions::sweep::{Sampling, Sweep, SweepMethod, agenda};
use stickler_exact::{Signature, functions, value};
use stickler_mdtest::check_examples;
use stickler_types::boundaries::BoundaryDetail;
use stickler_types::{ConversionChoices, Dialect, DialectName, join};

/// Sweeps every function of every dialect, each distinct rule once: every input of a source of at most 16 bits, and the
/// nearest neighbours of the boundaries with a sample of the others.
#[test]
fn the_reference_is_exact_wherever_a_moment_suffices() {
    let mut seen = HashSet::new();
    let mut wrong = Vec::new();
    for dialect in dialects() {
        for function in functions(dialect) {
            for sweep in coarse(&function, dialect, Some(1_000)) {
                if !seen.insert(rule(&sweep)) {
                    continue;
                }
                let operands = &sweep.signature.operands;
                let small = operands.iter().all(|ty| ty.bits() <= 16 && !ty.is_text());
                let sweeps = match small {
                    true => coarse(&function, dialect, None),
                    false => vec![sweep.clone()],
                };
                for sweep in sweeps.iter().filter(|all| all.signature == sweep.signature) {
                    let found = findings(sweep, &sweep.reference).first.into_iter();
                    wrong.extend(found.map(|difference| format!("{function} in {dialect}: {difference}")));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(seen.len() > 1_000, "only {} rules", seen.len());
}

/// Returns every dialect, and one for each option of its conversions that one of them has not.
fn dialects() -> Vec<DialectName> {
    let base = Dialect::of(DialectName::CODESYS);
    let others = ConversionChoices::keys().iter();
    let others = others.flat_map(|key| base.conversions.others(key));
    let define = |(number, conversions)| {
        let dialect = Dialect {
            conversions,
            rounds_up: true,
            ..Dialect::custom(&format!("other-{number}"), base.name, "here")
        };
        DialectName::define(dialect).expect("the name is free")
    };
    let others = (0..).zip(others).map(define);
    DialectName::ALL.into_iter().chain(others).collect()
}

/// Tells two sweeps apart: by their types, by the rule of the reference, or by what must come of the boundary values.
fn rule(sweep: &Sweep) -> String {
    let Signature {
        operands,
        result,
        operation,
        ..
    } = &sweep.signature;
    let calls = boundary_calls(&sweep.signature);
    let exact = calls
        .iter()
        .map(|call| value(&sweep.signature, call, &sweep.choices).to_string());
    let exact: Vec<String> = exact.collect();
    format!(
        "{operands:?} {result} {operation:?} {:?} {exact:?}",
        sweep.reference
    )
}

fn coarse(function: &str, dialect: DialectName, inputs: Option<u64>) -> Vec<Sweep> {
    let sampling = Sampling {
        inputs,
        detail: BoundaryDetail::Coarse,
        ..Sampling::default()
    };
    agenda(function, &[dialect], sampling, SweepMethod::Conversion).expect("the reference has every function")
}

/// Shows the sweeps of a function: their types, and the dialects that share each.
#[test]
fn golden_agendas() {
    check_examples("tests/examples/agendas.md", |example| {
        let dialects: Vec<DialectName> = match example.text("dialects") {
            "" => DialectName::ALL.to_vec(),
            names => names
                .split(' ')
                .map(|name| name.parse().expect("a dialect"))
                .collect(),
        };
        let method = match example.text("method") {
            "programs" => SweepMethod::Programs,
            _ => SweepMethod::Conversion,
        };
        let sweeps = match agenda(example.text("function"), &dialects, Sampling::default(), method) {
            Ok(sweeps) => sweeps,
            Err(error) => return error.to_string(),
        };
        if example.wanted() == "sweeps" {
            return sweeps.len().to_string();
        }
        let shown = |sweep: &Sweep| {
            let names: Vec<&str> = sweep.dialects.iter().map(|dialect| dialect.as_str()).collect();
            let types = (&sweep.signature.operands[0], &sweep.signature.result);
            format!("{} to {}: {}", types.0, types.1, names.join(" "))
        };
        join(sweeps.iter().map(shown), "\n")
    });
}
