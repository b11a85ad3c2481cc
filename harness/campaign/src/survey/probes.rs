//! The smallest programs that use one part of the language each.

use crate::differential::EvaluatedProgram;
use crate::exclusions::Exclusions;
use crate::inputs::Inputs;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use stickler_generate::features::features;
use stickler_generate::model::Program;
use stickler_generate::reduce;
use stickler_reduce::{Interestingness, ReductionBudget};
use stickler_types::DialectName;

/// The seed of the random programs. It is the same for all campaigns, so that a survey depends on the engine alone.
const SEED: u64 = 0;

/// The number of random programs.
const SAMPLE_LEN: u64 = 1000;

/// The number of smaller programs that are tried for one part; each takes some microseconds.
const MAX_TRIES: u64 = 400;

/// A program with the parts of the language that it uses.
pub(super) struct ProbeProgram {
    pub(super) subject: EvaluatedProgram,
    /// The words for the parts.
    pub(super) words: BTreeSet<String>,
}

impl ProbeProgram {
    /// Evaluates a program; `None` where no document settles all of it.
    fn new(program: Program) -> Option<ProbeProgram> {
        let words = features(&program).into_keys().collect();
        let subject = EvaluatedProgram::new(program).ok()?;
        subject
            .opened
            .is_empty()
            .then_some(ProbeProgram { subject, words })
    }
}

/// A program that uses a part of the language, and little else.
pub(super) struct SurveyProbe {
    /// The word for the part.
    pub(super) word: String,
    pub(super) program: ProbeProgram,
}

/// Random programs of a dialect, from which the smallest ones are made.
pub(super) struct ProbeSource {
    dialect: DialectName,
    /// The programs, those with few parts first.
    sample: Vec<ProbeProgram>,
    /// The number of programs that use a part, by its word.
    frequencies: BTreeMap<String, u64>,
}

impl ProbeSource {
    /// Makes random programs of a dialect that have nothing of the exclusions.
    pub(super) fn new(dialect: DialectName, without: &Exclusions) -> ProbeSource {
        let inputs = Inputs::new(SEED);
        let programs = (0..SAMPLE_LEN).map(|place| inputs.program(place, &[dialect], false));
        let mut sample: Vec<ProbeProgram> = programs
            .filter(|program| without.admits(program))
            .filter_map(ProbeProgram::new)
            .collect();
        sample.sort_by_key(|program| program.words.len());
        let mut frequencies: BTreeMap<String, u64> = BTreeMap::new();
        for word in sample.iter().flat_map(|program| &program.words) {
            *frequencies.entry(word.clone()).or_default() += 1;
        }
        ProbeSource {
            dialect,
            sample,
            frequencies,
        }
    }

    /// Returns the dialect.
    pub(super) fn dialect(&self) -> DialectName {
        self.dialect
    }

    /// Returns the words for all parts that the programs use.
    pub(super) fn words(&self) -> BTreeSet<String> {
        self.frequencies.keys().cloned().collect()
    }

    /// Returns the programs to ask about all parts.
    pub(super) fn covering(&self) -> Covering<'_> {
        Covering {
            left: self.sample.iter().collect(),
        }
    }

    /// Returns the smallest program for each of these words that has none of `blamed`, where there is one. Programs that use
    /// fewer parts come first, and of these the parts that more programs use.
    pub(super) fn probes(
        &self,
        wanted: &BTreeSet<String>,
        blamed: &BTreeSet<String>,
        going: &dyn Fn() -> bool,
    ) -> Vec<SurveyProbe> {
        let frequency = |word: &str| Reverse(self.frequencies.get(word).copied());
        let mut wanted: Vec<&String> = wanted.iter().collect();
        wanted.sort_by_key(|word| frequency(word));
        let wanted = wanted.into_iter().take_while(|_| going());
        let mut probes: Vec<SurveyProbe> = wanted.filter_map(|word| self.probe(word, blamed)).collect();
        probes.sort_by_key(|SurveyProbe { word, program }| {
            (program.words.len(), frequency(word), word.clone())
        });
        probes
    }

    fn probe(&self, word: &str, blamed: &BTreeSet<String>) -> Option<SurveyProbe> {
        let suits =
            |program: &ProbeProgram| program.words.contains(word) && program.words.is_disjoint(blamed);
        let start = self.sample.iter().find(|program| suits(program))?;
        let interesting = |candidate: &Program| {
            if candidate.main.variables.is_empty() || candidate.main.body.is_empty() {
                return Interestingness::Invalid;
            }
            let program = ProbeProgram::new(candidate.clone());
            Interestingness::from(program.is_some_and(|program| suits(&program)))
        };
        let budget = ReductionBudget {
            tries: MAX_TRIES,
            ..ReductionBudget::default()
        };
        let reduced = reduce::program(&start.subject.program, interesting, &budget);
        Some(SurveyProbe {
            word: word.to_owned(),
            program: ProbeProgram::new(reduced.value)?,
        })
    }
}

/// Random programs that were not asked about yet.
pub(super) struct Covering<'s> {
    left: Vec<&'s ProbeProgram>,
}

impl<'s> Covering<'s> {
    /// Takes programs that together use all of these parts that any program uses, those with few parts first.
    pub(super) fn next(&mut self, wanted: &BTreeSet<String>) -> Vec<&'s ProbeProgram> {
        let mut wanted = wanted.clone();
        let mut taken = Vec::new();
        self.left.retain(|program| {
            let before = wanted.len();
            wanted.retain(|word| !program.words.contains(word));
            let is_taken = wanted.len() < before;
            if is_taken {
                taken.push(*program);
            }
            !is_taken
        });
        taken
    }
}
