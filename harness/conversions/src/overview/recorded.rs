//! The answers of recordings to the questions of a table of statements, compared with what the sources state.

use super::results::{ComparedResult, ExpectedResult};
use crate::implicit::MatrixAnswer;
use crate::recording::Recording;
use crate::session::{Refusal, RefusalKind};
use stickler_exact::Signature;
use stickler_types::{DialectName, MatrixWord, RecordingOrigin, TypePair, Value};

/// The number of a question to which documents and engines have answers: whether a pair of types converts implicitly, whether a
/// type has a part, or what one call of a function gives. Pairs come first, then parts, then calls.
pub type QuestionNumber = u32;

/// The answers of a recording in one dialect.
#[derive(Clone, PartialEq, Debug)]
pub struct RecordedAnswers {
    /// The name of the recording's file, by which runs name the engine.
    pub name: String,
    /// The origin of the recording.
    pub origin: RecordingOrigin,
    /// The dialect.
    pub dialect: DialectName,
    /// The answers, in the order of their questions.
    pub answers: Vec<(QuestionNumber, ComparedAnswer)>,
    /// Whether the [`extreme`](crate::recording::extreme) value of a type is less than that of another, for each pair that was asked, by
    /// the word of the answer.
    pub comparisons: Vec<(TypePair, &'static str)>,
}

/// An answer of an engine or of a recorded compiler, compared with what a source states. Of several answers to one question the greatest
/// counts, so that what deviates is seen.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum ComparedAnswer {
    /// The compiler answers as the source says.
    Met,
    /// No source in Stickler says what the answer must be; holds the answer.
    Open(String),
    /// The compiler answers something else, or has no answer; holds the answer.
    Other(String),
}

impl RecordedAnswers {
    /// Returns whether an engine with this name is the recorded compiler.
    pub fn is_of(&self, engine: &str) -> bool {
        self.origin.is_of(&self.name, engine)
    }
}

/// Gathers the answers of a recording in one dialect.
pub(super) struct RecordedColumn<'r> {
    recording: &'r Recording,
    /// The index of the dialect among those of the table.
    pub(super) dialect: usize,
    pub(super) answers: RecordedAnswers,
}

impl<'r> RecordedColumn<'r> {
    /// Returns an empty column for each recording and each of its dialects that the table has.
    pub(super) fn all(recordings: &'r [Recording], dialects: &[DialectName]) -> Vec<RecordedColumn<'r>> {
        let of_recording = |recording: &'r Recording| {
            let spoken = dialects.iter().enumerate();
            let spoken = spoken.filter(|(_, dialect)| recording.dialects.contains(dialect));
            let column = |(index, dialect): (usize, &DialectName)| RecordedColumn {
                recording,
                dialect: index,
                answers: RecordedAnswers {
                    name: recording.name.clone(),
                    origin: recording.origin.clone(),
                    dialect: *dialect,
                    answers: Vec::new(),
                    comparisons: recording.all_comparisons(*dialect),
                },
            };
            spoken.map(column).collect::<Vec<_>>()
        };
        recordings.iter().flat_map(of_recording).collect()
    }

    /// Adds the answer to a question about two words, of which the sources state `word`.
    pub(super) fn add(
        &mut self,
        question: QuestionNumber,
        word: Option<MatrixWord>,
        answer: impl FnOnce(&Recording, DialectName) -> Option<MatrixAnswer>,
    ) {
        let answer = answer(self.recording, self.answers.dialect);
        self.answers
            .answers
            .extend(answer.map(|answer| (question, accepted(answer, word))));
    }

    /// Adds the answers for the calls of a signature, of which the sources state `expected`; the first call is the question `first`.
    pub(super) fn add_calls(
        &mut self,
        first: QuestionNumber,
        signature: &Signature,
        calls: &[Vec<Value>],
        expected: &[ExpectedResult],
    ) {
        let results = self.recording.results(self.answers.dialect, signature, calls);
        let compared = results.into_iter().zip(expected).zip(first..);
        let answers = compared.filter_map(|((got, expected), question)| {
            let expected = expected.clone();
            let answer = called(ComparedResult { got, expected })?;
            Some((question, answer))
        });
        self.answers.answers.extend(answers);
    }
}

pub(crate) fn accepted(answer: MatrixAnswer, word: Option<MatrixWord>) -> ComparedAnswer {
    let said = match answer {
        MatrixAnswer::Accepts if word == Some(MatrixWord::Warn) => "no warning",
        MatrixAnswer::Accepts => "accepted",
        MatrixAnswer::Warns => "warned",
        MatrixAnswer::Rejects => "rejected",
        MatrixAnswer::Unsupported => "unsupported",
        MatrixAnswer::Fails => "crashed",
    };
    let says_no_warning = matches!(word, Some(MatrixWord::Yes | MatrixWord::Same));
    match (answer, word) {
        (MatrixAnswer::Unsupported | MatrixAnswer::Fails, _) => ComparedAnswer::Other(said.to_owned()),
        _ if answer.contradicts(word) => ComparedAnswer::Other(said.to_owned()),
        (_, None | Some(MatrixWord::Open)) => ComparedAnswer::Open(said.to_owned()),
        // It contradicts nothing, but is worth to be seen.
        (MatrixAnswer::Warns, _) if says_no_warning => ComparedAnswer::Open(said.to_owned()),
        _ => ComparedAnswer::Met,
    }
}

/// Returns the answer to a call; `None` where it was not recorded.
fn called(compared: ComparedResult) -> Option<ComparedAnswer> {
    let contradicts = compared.contradicts();
    let said = match &compared.got {
        Err(Refusal {
            kind: RefusalKind::NotAsked,
            ..
        }) => return None,
        Ok(value) => value.to_string(),
        Err(refusal) => refusal.kind.word().to_owned(),
    };
    Some(match compared.got {
        _ if contradicts => ComparedAnswer::Other(said),
        Ok(_) if compared.expected.basis.is_some() => ComparedAnswer::Met,
        _ => ComparedAnswer::Open(said),
    })
}
