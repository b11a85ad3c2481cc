//! Recordings: what a compiler answered to implicit conversions, bit access, comparisons and conversion functions, with its product,
//! version and date, to be shown where the compiler itself is not at hand.
//!
//! [`Recording::ask`] asks an engine, and a [`RecordingBuilder`] takes what a person copied out of an editor; [`Recording::write`]
//! writes the file, and [`Recording::parse`] reads it. [`all_questions`] are what is asked, in the programs of [`program_of`].

mod ask;
mod imported;
mod parse;
mod questions;
mod tables;
mod write;

use crate::contradictions::{AnswerOrigin, ContradictionsBuilder};
use crate::implicit::MatrixAnswer;
use crate::session::{Refusal, RefusalKind};
use std::collections::HashMap;
use std::sync::Arc;
use stickler_engines::{Ability, Grade, Identity};
use stickler_exact::Signature;
use stickler_types::{
    ConversionCall, DialectName, ElementaryType, Question, RecordingOrigin, TypePair, Value, words,
};

pub use imported::RecordingBuilder;
pub use parse::RecordingError;
pub use questions::{all_questions, extreme, pairs, program_of};
pub use tables::{RecordedTable, RecordedTables};

/// The answers of one version of a compiler.
#[derive(Clone, PartialEq, Debug)]
pub struct Recording {
    /// The name of its file without the ending, by which runs name the engine.
    pub name: String,
    /// The origin of the answers.
    pub origin: RecordingOrigin,
    /// The dialects in which the compiler was asked.
    pub dialects: Vec<DialectName>,
    /// The words of answers, by dialect.
    words: HashMap<(DialectName, WordKey), &'static str>,
    functions: HashMap<(DialectName, String), FunctionAnswers>,
}

/// The place of a word in a recording: its section, its row, and in that another type or a part.
type WordKey = (RecordedSection, ElementaryType, String);

/// Whether the [`extreme`] value of one type is less than that of another, or why there is no answer.
pub type ComparisonAnswer = Result<bool, RefusalKind>;

/// Calls by their operands, each with its result or the reason why there is none.
type AnsweredCalls = Vec<(Vec<Value>, Result<Value, RefusalKind>)>;

/// The answers to the calls of one signature.
#[derive(Clone, PartialEq, Debug)]
enum FunctionAnswers {
    /// Every call was refused in the same way.
    Refused(RefusalKind),
    /// The answer to each call.
    Calls(AnsweredCalls),
}

words! {
    /// A section of the answers of a recording, with its name in a file; in the order in which a file has them.
    RecordedSection {
        /// The pairs of types that convert implicitly.
        Implicit = "implicit",
        /// The bits and parts of a type that can be read.
        Bits = "bits",
        /// The results of comparisons of different types.
        Comparisons = "comparisons",
        /// The results of conversion functions.
        Functions = "functions",
    }
}

impl FunctionAnswers {
    /// Returns the answers to calls, as one word where all were refused in the same way.
    fn of(calls: AnsweredCalls) -> FunctionAnswers {
        match &calls[..] {
            [(_, Err(kind)), rest @ ..] if rest.iter().all(|(_, answer)| *answer == Err(*kind)) => {
                FunctionAnswers::Refused(*kind)
            }
            _ => FunctionAnswers::Calls(calls),
        }
    }

    /// Returns the answers call by call; the key says the dialect and the signature.
    fn of_calls(self, (dialect, row): &(DialectName, String)) -> AnsweredCalls {
        match self {
            FunctionAnswers::Calls(calls) => calls,
            FunctionAnswers::Refused(kind) => {
                let signatures = questions::signatures(*dialect).into_iter();
                signatures
                    .filter(|signature| signature.to_string() == *row)
                    .flat_map(|signature| crate::overview::boundary_calls(&signature))
                    .map(|call| (call, Err(kind)))
                    .collect()
            }
        }
    }
}

impl Recording {
    /// Returns a recording without answers.
    fn empty(name: &str, origin: RecordingOrigin, dialects: Vec<DialectName>) -> Recording {
        Recording {
            name: name.to_owned(),
            origin,
            dialects,
            words: HashMap::new(),
            functions: HashMap::new(),
        }
    }

    /// Adds the answers of an older recording of the same compiler where this one has none.
    pub fn complete_from(&mut self, older: Recording) {
        for dialect in older.dialects {
            if !self.dialects.contains(&dialect) {
                self.dialects.push(dialect);
            }
        }
        for (key, word) in older.words {
            self.words.entry(key).or_insert(word);
        }
        for (key, answers) in older.functions {
            match (self.functions.get_mut(&key), answers) {
                (None, answers) => {
                    self.functions.insert(key, answers);
                }
                (Some(FunctionAnswers::Calls(known)), answers) => {
                    let calls = answers.of_calls(&key);
                    let is_new = |call: &(Vec<Value>, _)| known.iter().all(|(known, _)| *known != call.0);
                    let new: Vec<_> = calls.into_iter().filter(is_new).collect();
                    known.extend(new);
                }
                // The new answers are to every call.
                (Some(FunctionAnswers::Refused(_)), _) => {}
            }
        }
    }

    /// Returns the identity under which the answers are shown beside those of engines.
    pub fn identity(&self) -> Identity {
        let origin = &self.origin;
        Identity {
            name: format!("{} {}", origin.product, origin.version),
            version: format!("(recorded {})", origin.date),
            dialects: self.dialects.clone(),
            abilities: vec![Ability::Check, Ability::Execute],
            grade: Grade::Rejected,
            lacks: Vec::new(),
        }
    }

    /// Returns the recorded reaction to a value of one type in a variable of another; `None` where it was not asked.
    pub fn implicit(&self, dialect: DialectName, pair: TypePair) -> Option<MatrixAnswer> {
        let key = (RecordedSection::Implicit, pair.0, pair.1.name().to_owned());
        self.word(dialect, key).and_then(MatrixAnswer::from_word)
    }

    /// Returns the recorded reaction to a program that reads a bit or a part of a variable, such as `7` or `%B1`; `None` where it was not
    /// asked.
    pub fn part(&self, dialect: DialectName, ty: ElementaryType, part: &str) -> Option<MatrixAnswer> {
        let word = self.word(dialect, (RecordedSection::Bits, ty, part.to_owned()));
        word.and_then(MatrixAnswer::from_word)
    }

    /// Returns whether the [`extreme`] value of the first type is less than that of the second; `None` where it was not asked.
    pub fn comparison(&self, dialect: DialectName, pair: TypePair) -> Option<ComparisonAnswer> {
        let key = (RecordedSection::Comparisons, pair.0, pair.1.name().to_owned());
        match self.word(dialect, key)? {
            "true" => Some(Ok(true)),
            "false" => Some(Ok(false)),
            word => RefusalKind::stored(word).map(Err),
        }
    }

    /// Returns each pair of types of which a comparison was asked, in order, with the word of the answer: `true`, `false`, `rejected` …
    pub fn all_comparisons(&self, dialect: DialectName) -> Vec<(TypePair, &'static str)> {
        let pairs = questions::pairs_compared().into_iter();
        let answered = pairs.filter_map(|pair| {
            let key = (RecordedSection::Comparisons, pair.0, pair.1.name().to_owned());
            Some((pair, self.word(dialect, key)?))
        });
        answered.collect()
    }

    fn word(&self, dialect: DialectName, key: WordKey) -> Option<&'static str> {
        self.words.get(&(dialect, key)).copied()
    }

    /// Returns the recorded result of each call of a function. A call that was not recorded is a refusal of the kind
    /// [`RefusalKind::NotAsked`].
    pub fn results(
        &self,
        dialect: DialectName,
        signature: &Signature,
        calls: &[Vec<Value>],
    ) -> Vec<Result<Value, Refusal>> {
        let answers = self.functions.get(&(dialect, signature.to_string()));
        let answer = |call: &Vec<Value>| match answers {
            Some(FunctionAnswers::Refused(kind)) => Err(*kind),
            Some(FunctionAnswers::Calls(known)) => known
                .iter()
                .find(|(operands, _)| operands == call)
                .map_or(Err(RefusalKind::NotAsked), |(_, answer)| answer.clone()),
            None => Err(RefusalKind::NotAsked),
        };
        let refusal = |kind| Refusal {
            kind,
            detail: format!("recorded {}", self.origin.date),
            line: None,
        };
        calls.iter().map(|call| answer(call).map_err(refusal)).collect()
    }
}

/// Returns the word for the answer to a comparison.
fn comparison_word(answer: ComparisonAnswer) -> &'static str {
    match answer {
        Ok(true) => "true",
        Ok(false) => "false",
        Err(kind) => kind.word(),
    }
}

impl Recording {
    /// Adds what the compiler answered with a value, with acceptance or with a rejection; no call that it refused, which may be for its name.
    /// `address` is that of the file.
    pub fn add_answers(&self, builder: &mut ContradictionsBuilder, address: &str) {
        let RecordingOrigin {
            product,
            version,
            date,
            ..
        } = &self.origin;
        let origin = |dialect| {
            Arc::new(AnswerOrigin {
                system: product.clone(),
                kind: "recording".to_owned(),
                source: format!("recording: {}", self.name),
                read: format!("{version}, {date}"),
                address: address.to_owned(),
                dialect: Some(dialect),
            })
        };
        for ((dialect, (section, ty, other)), word) in &self.words {
            let answer = match *word {
                "accepts" | "warns" => "accepted",
                "rejects" | "rejected" => "rejected",
                "true" => "BOOL#TRUE",
                "false" => "BOOL#FALSE",
                _ => continue,
            };
            let question = match (section, ElementaryType::from_name(other)) {
                (RecordedSection::Bits, _) => Question::Part(*ty, other.clone()),
                (RecordedSection::Implicit, Some(into)) => Question::Implicit((*ty, into)),
                (RecordedSection::Comparisons, Some(right)) => Question::Comparison((*ty, right)),
                _ => continue,
            };
            builder.add_question(&question, None, (&origin(*dialect), answer.to_owned()));
        }
        for ((dialect, row), answers) in &self.functions {
            let FunctionAnswers::Calls(calls) = answers else {
                continue;
            };
            let function = row.split('(').next().unwrap_or_default();
            for (operands, value) in calls {
                let Ok(value) = value else { continue };
                if let Some(result) = ElementaryType::from_name(value.type_name()) {
                    let (function, operands) = (function.to_owned(), operands.clone());
                    let call = Question::Call(ConversionCall {
                        function,
                        operands,
                        result,
                    });
                    builder.add_question(&call, None, (&origin(*dialect), value.to_string()));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{RecordedSection, Recording, RecordingOrigin};
    use stickler_engines::Reference;
    use stickler_types::DialectName;

    const ORIGIN: &str =
        "[recording]\nproduct = \"p\"\nversion = \"1\"\nplatform = \"l\"\ndate = \"2026-11-24\"\n";

    #[test]
    fn what_was_written_is_read_again() {
        let origin = Recording::parse("reference.toml", ORIGIN).unwrap().origin;
        let with_commit = RecordingOrigin {
            commit: Some("a\"b".to_owned()),
            ..origin
        };
        let dialects = [DialectName::MATIEC, DialectName::IRONPLC_ED2];
        let reference = Reference::default();
        let sections = &RecordedSection::ALL;
        let recording = Recording::ask(&reference, with_commit, &dialects, sections, 0, &|| {}).unwrap();
        let mut text = Vec::new();
        recording.write(&mut text).unwrap();
        let mut read = Recording::parse("reference.toml", std::str::from_utf8(&text).unwrap()).unwrap();
        read.dialects
            .sort_by_key(|dialect| *dialect != DialectName::MATIEC);
        assert_eq!(read, recording);
    }
}
