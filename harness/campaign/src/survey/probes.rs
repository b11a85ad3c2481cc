//! The programs of a survey: random ones that together use all parts of the language, and a minimal one of each part, which is that
//! of `conformance-cases/features.toml` where the part is a feature.

use crate::differential::{EvaluatedProgram, JudgedProgram};
use crate::exclusions::Exclusions;
use crate::inputs::Inputs;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use stickler_exact::signatures;
use stickler_generate::features::features;
use stickler_generate::model::Program;
use stickler_generate::reader::read;
use stickler_suite::Features;
use stickler_types::{DialectName, ElementaryType, Value};

/// The seed of the random programs. It is the same for all campaigns, so that a survey depends on the engine alone.
const SEED: u64 = 0;

/// The number of random programs.
const SAMPLE_LEN: u64 = 1000;

/// A program with the parts of the language that it uses.
pub(super) struct ProbeProgram {
    dialect: DialectName,
    /// The source text.
    pub(super) text: String,
    /// The values that it must give; none where no document settles all of them.
    values: Vec<(String, Value)>,
    /// The words for the parts.
    pub(super) words: BTreeSet<String>,
}

impl ProbeProgram {
    /// Evaluates a random program; `None` where no document settles all of it.
    fn random(program: Program) -> Option<ProbeProgram> {
        let words = features(&program).into_keys().collect();
        let dialect = program.dialect;
        let EvaluatedProgram {
            text, values, opened, ..
        } = EvaluatedProgram::new(program).ok()?;
        opened.is_empty().then_some(ProbeProgram {
            dialect,
            text,
            values,
            words,
        })
    }

    /// Evaluates a minimal program, of which an engine need only accept what no document settles.
    fn minimal(text: String, word: &str, dialect: DialectName) -> ProbeProgram {
        let evaluated = read(&text, dialect).and_then(|program| EvaluatedProgram::new(program).ok());
        let settled = evaluated.filter(|evaluated| evaluated.opened.is_empty());
        let used = stickler_syntax::features::features(&text, dialect.rules());
        let words = used.into_iter().map(|key| key.into_owned());
        ProbeProgram {
            dialect,
            values: settled.map(|evaluated| evaluated.values).unwrap_or_default(),
            words: words.chain([word.to_owned()]).collect(),
            text,
        }
    }

    /// Returns the question that an engine is asked about the program.
    pub(super) fn question(&self) -> JudgedProgram<'_> {
        JudgedProgram {
            dialect: self.dialect,
            text: &self.text,
            values: &self.values,
            binds: true,
        }
    }
}

/// A program that uses a part of the language, and nothing else that can be left out.
pub(super) struct SurveyProbe {
    /// The word for the part.
    pub(super) word: String,
    pub(super) program: ProbeProgram,
}

/// The programs of a survey in one dialect.
pub(super) struct ProbeSource {
    pub(super) dialect: DialectName,
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
            .filter_map(ProbeProgram::random)
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

    /// Returns the minimal program for each of these words. Programs that use fewer parts come first, and of these the parts that more
    /// random programs use.
    pub(super) fn probes(&self, wanted: &BTreeSet<String>) -> Vec<SurveyProbe> {
        let frequency = |word: &str| Reverse(self.frequencies.get(word).copied());
        let probe = |word: &String| {
            Some(SurveyProbe {
                word: word.clone(),
                program: ProbeProgram::minimal(minimal(word, self.dialect)?, word, self.dialect),
            })
        };
        let mut probes: Vec<SurveyProbe> = wanted.iter().filter_map(probe).collect();
        probes.sort_by_key(|SurveyProbe { word, program }| {
            (program.words.len(), frequency(word), word.clone())
        });
        probes
    }
}

/// Returns the minimal program of a part of the language; `None` for a word that stands for nothing in the dialect.
fn minimal(word: &str, dialect: DialectName) -> Option<String> {
    if let Some(feature) = Features::built_in().get(&word.to_ascii_lowercase()) {
        return Some(feature.program.clone());
    }
    let of_types = |from: &str, to: &str, value: &str| {
        format!(
            "PROGRAM main\nVAR\n    x : {from};\n    y : {to};\nEND_VAR\n    y := {value};\nEND_PROGRAM\n"
        )
    };
    if let Some((from, to)) = word.split_once(" to ") {
        return Some(of_types(from, to, "x"));
    }
    if let Some(ty) = ElementaryType::from_name(word.trim_end_matches('#')) {
        let value = match ty.is_text() {
            true => Value::text(ty, vec![u16::from(b'a')]),
            false => Value::plain(ty, ty.wrap(1)),
        };
        let literal = value.to_string();
        let value = if word.ends_with('#') { &literal } else { "x" };
        return Some(of_types(ty.name(), ty.name(), value));
    }
    let signature = signatures(word, dialect).into_iter().next()?;
    let [from] = signature.operands[..] else {
        return None;
    };
    Some(of_types(
        from.name(),
        signature.result.name(),
        &format!("{word}(x)"),
    ))
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
