//! Asks an engine for the answers of a recording.

use super::questions::{self, is_true, pairs, pairs_compared, parts, signatures};
use super::{ComparisonAnswer, FunctionAnswers, RecordedSection, Recording, key};
use crate::implicit::{self, TypePair};
use crate::overview;
use crate::session::FunctionSession;
use crate::sweep::foreign::ForeignError;
use stickler_engines::Engine;
use stickler_exact::Signature;
use stickler_types::{DialectName, ElementaryType, RecordingOrigin};
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
            RecordedSection::Implicit => {
                let asked = pairs(&ElementaryType::ALL);
                let answers = implicit::answers(engine, dialect, &asked, jobs, answered)?;
                let keys = asked.into_iter().map(|pair| (dialect, pair));
                self.implicit.extend(keys.zip(answers));
            }
            RecordedSection::Bits => {
                let asked = parts();
                let sources = asked.iter().map(|(ty, part)| questions::part_source(*ty, part));
                let sources: Vec<String> = sources.collect();
                let answers = implicit::accepted(engine, dialect, &sources, jobs, answered)?;
                let keys = asked.into_iter().map(|(ty, part)| (dialect, ty, part));
                self.parts.extend(keys.zip(answers));
            }
            RecordedSection::Comparisons => {
                let asked = pairs_compared();
                let answers = compared(engine, dialect, &asked, jobs, answered)?;
                let keys = asked.into_iter().map(|pair| (dialect, pair));
                self.comparisons.extend(keys.zip(answers));
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
                let keys = signatures.iter().map(|signature| (dialect, key(signature)));
                self.functions.extend(keys.zip(answers));
            }
        }
        Ok(())
    }

    /// Returns how often [`Recording::ask`] calls `answered`.
    #[must_use]
    pub fn questions(dialects: &[DialectName], sections: &[RecordedSection]) -> usize {
        let of = |dialect: DialectName, section: RecordedSection| match section {
            RecordedSection::Implicit => pairs(&ElementaryType::ALL).len(),
            RecordedSection::Bits => parts().len(),
            RecordedSection::Comparisons => pairs_compared().len(),
            RecordedSection::Functions => signatures(dialect).len(),
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
