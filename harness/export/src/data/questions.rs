//! The answers of systems to questions, each with its kind and source; systems with one answer stand together.

use serde::Serialize;
use std::collections::BTreeMap;
use stickler_conversions::implicit::MatrixAnswer;
use stickler_conversions::overview::{ExpectedResult, StatementsBuilder};
use stickler_conversions::recording::Recording;
use stickler_conversions::{Refusal, RefusalKind};
use stickler_exact::Signature;
use stickler_suite::{SourceKind, Sources};
use stickler_types::{ConversionCall, DialectName, MatrixWord, Question, Value};

/// The kind of source that gives an answer to a question.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A document of the system states it.
    Documented,
    /// The standard states it.
    Standard,
    /// A product of a named version was recorded to give it.
    Recorded,
    /// An open compiler of a named version gives it.
    Measured,
    /// No source in Stickler states it: it is what Stickler's model of the system gives, by the choices of its file or a rule of Stickler's own.
    Chosen,
    /// No source in Stickler states it, and Stickler has no answer either.
    Open,
}

impl Kind {
    /// Returns the kind of what a basis states; that of no basis is [`Kind::Chosen`].
    pub(super) fn of(basis: Option<&str>, sources: &Sources) -> Kind {
        let source = basis.and_then(|basis| sources.of(basis));
        match source.map(|(source, _)| source.kind) {
            Some(SourceKind::Standard) => Kind::Standard,
            Some(SourceKind::Recording) => Kind::Recorded,
            Some(SourceKind::Measurement) => Kind::Measured,
            Some(SourceKind::Rule) => Kind::Chosen,
            None if basis.is_none() => Kind::Chosen,
            Some(SourceKind::Document) | None => Kind::Documented,
        }
    }
}

/// An answer, and the systems that give it.
#[derive(Serialize)]
struct Answer {
    /// A typed literal, or a word: `yes`, `no`, `warn`, `open` or `rejected`.
    answer: String,
    /// The kind of source that gives the answer.
    kind: Kind,
    /// The source that states it, a key of `sources`; null where no source does.
    source: Option<String>,
    /// The systems. A variant is named only where its system has another answer.
    systems: Vec<&'static str>,
}

/// The answers to one question.
#[derive(Default, Serialize)]
#[serde(transparent)]
pub(super) struct Answers(Vec<Answer>);

/// Questions by their texts, each with its answers.
#[derive(Default, Serialize)]
#[serde(transparent)]
pub struct Questions(pub(super) BTreeMap<String, Answers>);

impl Answers {
    /// Adds the answer of a system. A variant, which is added behind its system, is left out where it has the same answer.
    pub(super) fn add(&mut self, system: DialectName, answer: &str, (kind, source): (Kind, Option<&str>)) {
        let is_same =
            |one: &&mut Answer| one.answer == answer && one.kind == kind && one.source.as_deref() == source;
        match self.0.iter_mut().find(is_same) {
            Some(one) if one.systems.contains(&system.base().as_str()) => {}
            Some(one) => one.systems.push(system.as_str()),
            None => self.0.push(Answer {
                answer: answer.to_owned(),
                kind,
                source: source.map(str::to_owned),
                systems: vec![system.as_str()],
            }),
        }
    }

    /// Returns the sources of the answers.
    pub(super) fn sources(&self) -> impl Iterator<Item = &str> {
        self.0.iter().filter_map(|answer| answer.source.as_deref())
    }
}

impl Questions {
    /// Collects what cases and documents state, and what recordings answer.
    pub fn gather(sources: &Sources, statements: &StatementsBuilder, recordings: &[Recording]) -> Questions {
        let mut questions = Questions::default();
        questions.add_accepted(sources, statements, recordings);
        questions.add_calls(sources, statements, recordings);
        questions
    }

    /// Adds the answer of a system.
    pub fn add(&mut self, question: String, system: DialectName, answer: &str, known: (Kind, Option<&str>)) {
        self.0.entry(question).or_default().add(system, answer, known);
    }

    /// Returns the sources of the answers.
    pub(super) fn sources(&self) -> impl Iterator<Item = &str> {
        self.0.values().flat_map(Answers::sources)
    }

    /// Adds the result that is expected of a call, and what a vendor's page says otherwise.
    pub fn add_expected(
        &mut self,
        question: &str,
        system: DialectName,
        expected: &ExpectedResult,
        sources: &Sources,
    ) {
        let other = expected.otherwise.as_ref();
        let other = other.map(|other| (&other.value, Some(&*other.basis)));
        for (value, basis) in [(&expected.value, expected.basis.as_deref())]
            .into_iter()
            .chain(other)
        {
            let known = (Kind::of(basis, sources), basis);
            self.add(question.to_owned(), system, &value.to_string(), known);
        }
    }

    /// Adds the result that an engine gives for a call, unless it was not asked.
    pub fn add_result(
        &mut self,
        question: &str,
        system: DialectName,
        result: &Result<Value, Refusal>,
        known: (Kind, Option<&str>),
    ) {
        let answer = match result {
            Ok(value) => value.to_string(),
            Err(refusal) if refusal.kind == RefusalKind::NotAsked => return,
            Err(refusal) => refusal.kind.word().to_owned(),
        };
        self.add(question.to_owned(), system, &answer, known);
    }

    /// Adds which types convert implicitly, and which bits and parts a type has.
    fn add_accepted(&mut self, sources: &Sources, statements: &StatementsBuilder, recordings: &[Recording]) {
        for (question, system, word, basis) in statements.accepted() {
            let known = match word {
                MatrixWord::Open => (Kind::Open, None),
                _ => (Kind::of(Some(basis), sources), Some(basis)),
            };
            let word = if word == MatrixWord::Same {
                MatrixWord::Yes
            } else {
                word
            };
            self.add(question.to_string(), system, word.as_str(), known);
            for recording in of_dialect(recordings, system) {
                let answer = match &question {
                    Question::Implicit(pair) => recording.implicit(system, *pair),
                    Question::Part(ty, part) => recording.part(system, *ty, part),
                    _ => None,
                };
                if let Some(answer) = answer {
                    let source = format!("recording: {}", recording.name);
                    let known = (Kind::Recorded, Some(&*source));
                    self.add(question.to_string(), system, answer_word(answer), known);
                }
            }
        }
    }

    /// Adds what functions give for boundary values and the operands of cases.
    fn add_calls(&mut self, sources: &Sources, statements: &StatementsBuilder, recordings: &[Recording]) {
        for function in statements.functions() {
            let (signature, calls) = (&function.signature, &function.calls);
            let texts: Vec<String> = calls.iter().map(|call| call_question(signature, call)).collect();
            for &index in &function.dialects {
                let system = statements.dialects()[index];
                for (text, expected) in texts.iter().zip(function.expected(index, system)) {
                    self.add_expected(text, system, &expected, sources);
                }
                for recording in of_dialect(recordings, system) {
                    let source = format!("recording: {}", recording.name);
                    let results = recording.results(system, signature, calls);
                    for (text, result) in texts.iter().zip(&results) {
                        self.add_result(text, system, result, (Kind::Recorded, Some(&source)));
                    }
                }
            }
        }
    }
}

/// Returns the text of the question what a function gives for operands.
pub fn call_question(signature: &Signature, operands: &[Value]) -> String {
    let call = ConversionCall {
        function: signature.function.clone(),
        operands: operands.to_vec(),
        result: signature.result,
    };
    Question::Call(call).to_string()
}

/// Returns the recordings of products that were asked in a dialect.
fn of_dialect(recordings: &[Recording], dialect: DialectName) -> impl Iterator<Item = &Recording> {
    recordings
        .iter()
        .filter(move |recording| recording.dialects.contains(&dialect))
}

/// Returns the word for what a compiler does with a conversion or a part of a type, as documents have it.
pub fn answer_word(answer: MatrixAnswer) -> &'static str {
    match answer {
        MatrixAnswer::Accepts => MatrixWord::Yes.as_str(),
        MatrixAnswer::Warns => MatrixWord::Warn.as_str(),
        MatrixAnswer::Rejects => MatrixWord::No.as_str(),
        MatrixAnswer::Unsupported | MatrixAnswer::Fails => answer.as_str(),
    }
}
