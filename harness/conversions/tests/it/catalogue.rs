//! Tests the reference against exact arithmetic, function by function.

use crate::support::findings;
use std::collections::HashSet;
use stickler_conversions::sweep::{Sampling, Sweep, SweepMethod, agenda};
use stickler_exact::{Signature, functions};
use stickler_mdtest::check_examples;
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
        sweeps.iter().map(shown).collect::<Vec<_>>().join("\n")
    });
}
