//! The suite as the judge of mutants reads it: every case in texts, and those first that are most unlike each other.
//!
//! Most mutants break much, so a judge that sees one case of each probe before it sees the second of any has found them out
//! after some hundred cases.

use std::collections::HashMap;
use stickler_mutants_judge::prepared::{PreparedCase, PreparedExpectation};
use stickler_suite::{Case, Expectation, ExpectedDiagnostic, ExpectedText, ExpectedValue};

/// Returns all cases but those with a code that the reference does not give, in the order in which they are judged.
pub fn prepare(cases: &[Case]) -> Vec<PreparedCase> {
    let ordered = order(cases).into_iter().map(|index| &cases[index]);
    ordered.filter(|case| is_judged(case)).map(prepared).collect()
}

/// Returns whether the reference gives all codes that a case asks for: without them its judgement says too little of a change.
fn is_judged(case: &Case) -> bool {
    let mut codes = case.expectation.diagnostics.iter().map(|expected| expected.code);
    codes.all(|code| code.example_dialect().is_some())
}

fn prepared(case: &Case) -> PreparedCase {
    PreparedCase {
        key: case.key(),
        dialect: case.dialect.as_str().to_owned(),
        source: case.source.to_string(),
        scans: case.scans,
        observe: case.observe.to_vec(),
        set: case.set.to_vec(),
        clock: case.clock.to_vec(),
        expectation: expectation(&case.expectation),
    }
}

fn expectation(expectation: &Expectation) -> PreparedExpectation {
    let lines = |text: &ExpectedText| {
        let lines = text.lines.iter().map(|line| line.trim());
        lines.filter(|line| !line.is_empty()).map(str::to_owned).collect()
    };
    let reported = |reported: &[ExpectedDiagnostic]| {
        let reported = reported
            .iter()
            .map(|one| (one.line, one.code.as_str().to_owned()));
        reported.collect()
    };
    let value = |expected: &ExpectedValue| (expected.key().to_string(), expected.value.to_string());
    PreparedExpectation {
        acceptance: expectation.accepted,
        diagnostics: reported(&expectation.diagnostics),
        warnings: reported(&expectation.warnings),
        clean_lines: expectation.clean_lines.clone(),
        values: expectation.values.iter().map(value).collect(),
        fault: expectation
            .fault
            .map(|expected| (expected.line, expected.fault.as_str().to_owned())),
        rendered: expectation.rendered.as_ref().map(lines),
    }
}

/// Returns the indices of the cases in waves: each wave has one case of every probe and dialect, as far from those before it in the
/// probe's table as can be.
fn order(cases: &[Case]) -> Vec<usize> {
    let mut probes: HashMap<(&str, &str), Vec<usize>> = HashMap::new();
    for (index, case) in cases.iter().enumerate() {
        let probe = case.id.split('(').next().unwrap_or_default();
        probes
            .entry((probe, case.dialect.as_str()))
            .or_default()
            .push(index);
    }
    let mut waves: Vec<(usize, usize)> = Vec::with_capacity(cases.len());
    for indices in probes.into_values() {
        let mut spread: Vec<(usize, usize)> = indices.into_iter().enumerate().collect();
        spread.sort_by_key(|(place, _)| place.reverse_bits());
        waves.extend((0..).zip(spread.into_iter().map(|(_, index)| index)));
    }
    waves.sort_unstable();
    waves.into_iter().map(|(_, index)| index).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::path::Path;
    use std::sync::LazyLock;
    use stickler_mutants_judge::judge::complaint;
    use stickler_suite::{Acceptance, Suite};

    static SUITE: LazyLock<Suite> = LazyLock::new(|| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
        let mut suite = Suite::load(&folder);
        suite
            .cases
            .retain(|case| case.dialect.definition().is_none() && is_judged(case));
        suite
    });

    static PREPARED: LazyLock<Vec<PreparedCase>> = LazyLock::new(|| prepare(&SUITE.cases));

    #[test]
    fn every_case_is_prepared_once_and_each_probe_comes_early() {
        let keys: BTreeSet<&str> = PREPARED.iter().map(|case| &*case.key).collect();
        assert_eq!(keys.len(), SUITE.cases.len());
        let probes = PREPARED
            .iter()
            .map(|case| case.key.split(['(', '@']).next().unwrap());
        let all: BTreeSet<&str> = probes.clone().collect();
        let early: BTreeSet<&str> = probes.take(5 * all.len()).collect();
        assert_eq!(early, all);
    }

    #[test]
    fn the_judge_finds_the_reference_right_and_a_case_with_another_expectation_wrong() {
        for case in PREPARED.iter().take(3000) {
            assert_eq!(complaint(case), None, "{}", case.key);
            let mut other = case.clone();
            let expectation = &mut other.expectation;
            match (expectation.acceptance, &mut expectation.fault) {
                (_, Some((line, _))) => *line += 1,
                (Acceptance::Required, None) => expectation.acceptance = Acceptance::Rejected,
                (Acceptance::Rejected, None) => expectation.diagnostics.push((1, "P0001".to_owned())),
                (Acceptance::Observed, None) => continue,
            }
            assert!(complaint(&other).is_some(), "{}", case.key);
        }
    }
}
