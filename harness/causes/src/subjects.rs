//! The features of the language that all cases of a claim use: a smaller program without one of them is none that the claim speaks of.

use std::collections::{BTreeSet, HashMap};
use stickler_suite::{Case, FeatureKey};
use stickler_syntax::features::features;
use stickler_types::Dialect;

/// The number of cases of a claim whose programs are looked at, from its first to its last.
const SAMPLE: usize = 64;

/// The number of cases below which what they have in common says nothing of the claim.
const FEW: usize = 4;

/// The features that all cases in a sample of those of a claim use, by the claim's basis.
pub(crate) struct Subjects<'s>(HashMap<&'s str, BTreeSet<FeatureKey>>);

impl<'s> Subjects<'s> {
    /// Looks up what some claims are about, in a sample of the cases that rest on each.
    pub(crate) fn of(bases: &BTreeSet<&str>, cases: &'s [Case]) -> Subjects<'s> {
        let mut resting: HashMap<&str, Vec<&Case>> = HashMap::new();
        for case in cases.iter().filter(|case| bases.contains(&*case.basis)) {
            resting.entry(&case.basis).or_default().push(case);
        }
        let known = resting.into_iter().filter(|(_, cases)| cases.len() >= FEW);
        let shared = known.map(|(basis, cases)| {
            let sample = cases.iter().step_by(cases.len().div_ceil(SAMPLE));
            let used = sample.map(|case| features(&case.source, Dialect::of(case.dialect)));
            (basis, used.reduce(|all, used| &all & &used).unwrap_or_default())
        });
        Subjects(shared.collect())
    }

    /// Returns whether a program that was made from the case of a claim uses all features that the claim is about.
    pub(crate) fn are_kept(&self, basis: &str, program: &str, dialect: &Dialect) -> bool {
        let shared = self.0.get(basis);
        shared.is_none_or(|shared| shared.is_subset(&features(program, dialect)))
    }
}
