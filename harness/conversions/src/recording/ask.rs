//! Asks an engine for the answers of a recording.

use super::questions::{self, is_true, pairs_compared, program_of, questions_of, signatures, word_key};
use super::{ComparisonAnswer, FunctionAnswers, RecordedSection, Recording, comparison_word};
use crate::implicit::{self, MatrixAnswer};
use crate::overview;
use crate::session::FunctionSession;
use crate::sweep::foreign::ForeignError;
use stickler_engines::Engine;
use stickler_exact::Signature;
use stickler_types::{DialectName, Question, RecordingOrigin, TypePair};
use stickler_workers::WorkerPool;

/// The number of pairs that one program compares, where an engine accepts them together.
const COMPARED_AT_ONCE: usize = 15;

impl Recording {
    /// Asks an engine, in each of the dialects, the questions of these sections: every pair of elementary types; the bits and parts of each
    /// type; comparisons of numbers and bit strings of different types; every conversion function of the dialect at the boundary
    /// values that `stickler conversions` shows. Calls `answered` after each pair, part, comparison and signature.
    ///
    /// # Errors
    /// An engine that cannot be started.
    pub fn ask(
        engine: &dyn Engine,
        origin: RecordingOrigin,
        dialects: &[DialectName],
        sections: &[RecordedSection],
        jobs: usize,
        answered: &(dyn Fn() + Sync),
    ) -> Result<Recording, ForeignError> {
        let mut recording = Recording::empty(&engine.identity().name, origin, dialects.to_vec());
        for dialect in dialects {
            for section in sections {
                recording.ask_section(engine, *dialect, *section, jobs, answered)?;
            }
        }
        Ok(recording)
    }

    fn ask_section(
        &mut self,
        engine: &dyn Engine,
        dialect: DialectName,
        section: RecordedSection,
        jobs: usize,
        answered: &(dyn Fn() + Sync),
    ) -> Result<(), ForeignError> {
        match section {
            RecordedSection::Implicit | RecordedSection::Bits => {
                let asked = questions_of(section);
                let sources: Vec<String> = asked
                    .iter()
                    .map(|question| program_of(question).source())
                    .collect();
                let answers = implicit::accepted(engine, dialect, &sources, jobs, answered)?;
                self.add_words(dialect, &asked, answers.into_iter().map(MatrixAnswer::as_str));
            }
            RecordedSection::Comparisons => {
                let answers = compared(engine, dialect, &pairs_compared(), jobs, answered)?;
                let words = answers.into_iter().map(comparison_word);
                self.add_words(dialect, &questions_of(section), words);
            }
            RecordedSection::Functions => {
                let signatures = signatures(dialect);
                let answers = WorkerPool::new(jobs).map(
                    signatures.iter(),
                    || Ok::<_, ForeignError>(FunctionSession::open(engine)?),
                    |session, signature| {
                        let answers = of_function(session, dialect, signature);
                        answered();
                        Ok(answers)
                    },
                )?;
                let keys = signatures.iter().map(|one| (dialect, one.to_string()));
                self.functions.extend(keys.zip(answers));
            }
        }
        Ok(())
    }

    /// Adds the words of the answers to questions.
    fn add_words(
        &mut self,
        dialect: DialectName,
        asked: &[Question],
        words: impl Iterator<Item = &'static str>,
    ) {
        let keys = asked.iter().filter_map(word_key);
        self.words.extend(keys.map(|key| (dialect, key)).zip(words));
    }

    /// Returns how often [`Recording::ask`] calls `answered`.
    pub fn questions(dialects: &[DialectName], sections: &[RecordedSection]) -> usize {
        let of = |dialect: DialectName, section: RecordedSection| match section {
            RecordedSection::Functions => signatures(dialect).len(),
            section => questions_of(section).len(),
        };
        let of_dialect = |dialect: &DialectName| {
            sections
                .iter()
                .map(|section| of(*dialect, *section))
                .sum::<usize>()
        };
        dialects.iter().map(of_dialect).sum()
    }
}

/// Returns whether the first of each pair is less than the second. Several pairs stand in one program, since compilers take their time;
/// where an engine refuses that, each stands in a program of its own.
fn compared(
    engine: &dyn Engine,
    dialect: DialectName,
    pairs: &[TypePair],
    jobs: usize,
    answered: &(dyn Fn() + Sync),
) -> Result<Vec<ComparisonAnswer>, ForeignError> {
    let answers = WorkerPool::new(jobs).map(
        pairs.chunks(COMPARED_AT_ONCE),
        || Ok::<_, ForeignError>(FunctionSession::open(engine)?),
        |session, chunk| {
            let together = session.run(dialect, &questions::comparisons(chunk));
            let answers: Vec<ComparisonAnswer> = match together {
                Ok(values) => values.iter().map(|value| Ok(is_true(value))).collect(),
                Err(_) => {
                    let alone = |pair: &TypePair| {
                        let values = session.run(dialect, &questions::comparisons(&[*pair]));
                        let value = values.map(|mut values| values.swap_remove(0));
                        value.map(|value| is_true(&value)).map_err(|refusal| refusal.kind)
                    };
                    chunk.iter().map(alone).collect()
                }
            };
            chunk.iter().for_each(|_| answered());
            Ok::<_, ForeignError>(answers)
        },
    )?;
    Ok(answers.into_iter().flatten().collect())
}

fn of_function(
    session: &mut FunctionSession<'_>,
    dialect: DialectName,
    signature: &Signature,
) -> FunctionAnswers {
    let calls = overview::boundary_calls(signature);
    let answers = session.results(dialect, signature, &calls);
    let answers = answers.into_iter().map(|got| got.map_err(|refusal| refusal.kind));
    FunctionAnswers::of(calls.into_iter().zip(answers).collect())
}
