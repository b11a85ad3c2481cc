//! Asks an engine which types it converts implicitly.

use crate::recording::program_of;
use crate::sweep::foreign::ForeignError;
use stickler_engines::{Engine, EngineSession, Outcome};
use stickler_types::{DialectName, MatrixWord, Question, TypePair, words};
use stickler_workers::WorkerPool;

words! {
    /// The reaction of an engine to a value of one type in a variable of another, with its word in a recording. A crash is no
    /// rejection.
    MatrixAnswer {
        /// The engine accepts the program.
        Accepts = "accepts",
        /// The engine accepts the program with a warning.
        Warns = "warns",
        /// The engine rejects the program.
        Rejects = "rejects",
        /// The engine does not support the request, which contradicts no document.
        Unsupported = "unsupported",
        /// The engine crashed, took too long or gave a malformed answer.
        Fails = "fails",
    }
}

impl MatrixAnswer {
    /// Returns whether the answer contradicts the word of the documents. An engine that does not support the request contradicts nothing,
    /// and nothing contradicts a word that leaves the conversion open.
    pub fn contradicts(self, word: Option<MatrixWord>) -> bool {
        match (word, self) {
            (_, MatrixAnswer::Unsupported) | (Some(MatrixWord::Open) | None, _) => false,
            // Nobody promises that there is no warning.
            (Some(MatrixWord::Yes | MatrixWord::Same), answer) => {
                !matches!(answer, MatrixAnswer::Accepts | MatrixAnswer::Warns)
            }
            (Some(MatrixWord::Warn), answer) => answer != MatrixAnswer::Warns,
            (Some(MatrixWord::No), answer) => answer != MatrixAnswer::Rejects,
        }
    }
}

/// Returns the answer for each pair, in their order. Asks in several sessions at once, since compilers take their time to start,
/// as many as `jobs` says (0: one a processor); calls `answered` after each answer.
///
/// # Errors
/// An engine that cannot be started.
pub fn answers(
    engine: &dyn Engine,
    dialect: DialectName,
    pairs: &[TypePair],
    jobs: usize,
    answered: &(dyn Fn() + Sync),
) -> Result<Vec<MatrixAnswer>, ForeignError> {
    let source = |pair: &TypePair| program_of(&Question::Implicit(*pair)).source();
    let sources: Vec<String> = pairs.iter().map(source).collect();
    accepted(engine, dialect, &sources, jobs, answered)
}

/// Returns the reaction of an engine to each program, as [`answers`] does for pairs.
///
/// # Errors
/// An engine that cannot be started.
pub(crate) fn accepted(
    engine: &dyn Engine,
    dialect: DialectName,
    sources: &[String],
    jobs: usize,
    answered: &(dyn Fn() + Sync),
) -> Result<Vec<MatrixAnswer>, ForeignError> {
    WorkerPool::new(jobs).map(
        sources.iter(),
        || Ok::<_, ForeignError>(EngineSession::open(engine)?),
        |session, source| {
            let outcome = session.check(dialect, source)?;
            answered();
            Ok(answer(&outcome))
        },
    )
}

/// Returns the reaction that an outcome of checking a program shows.
pub(crate) fn answer(outcome: &Outcome) -> MatrixAnswer {
    match outcome {
        Outcome::Accepted { warnings } if warnings.is_empty() => MatrixAnswer::Accepts,
        Outcome::Accepted { .. } => MatrixAnswer::Warns,
        Outcome::Rejected { .. } => MatrixAnswer::Rejects,
        Outcome::Unsupported { .. } | Outcome::NotImplemented { .. } => MatrixAnswer::Unsupported,
        Outcome::Executed { .. } | Outcome::Faulted { .. } | Outcome::Rendered { .. } => MatrixAnswer::Fails,
        Outcome::Crashed { .. }
        | Outcome::Unusable { .. }
        | Outcome::TimedOut { .. }
        | Outcome::Error { .. } => MatrixAnswer::Fails,
    }
}

#[cfg(test)]
mod tests {
    use super::{MatrixAnswer, answers};
    use std::sync::atomic::{AtomicUsize, Ordering};
    use stickler_engines::Reference;
    use stickler_types::{DialectName, ElementaryType};

    #[test]
    fn each_pair_gets_its_own_answer_however_many_are_asked_at_once() {
        let pairs: Vec<_> = ElementaryType::ALL
            .into_iter()
            .map(|ty| (ElementaryType::Sint, ty))
            .collect();
        let answered = AtomicUsize::new(0);
        let count = || {
            answered.fetch_add(1, Ordering::Relaxed);
        };
        let found = answers(&Reference::default(), DialectName::MATIEC, &pairs, 0, &count).unwrap();
        // In matiec each type converts to itself only.
        for (pair, answer) in pairs.iter().zip(&found) {
            let expected = match pair.0 == pair.1 {
                true => MatrixAnswer::Accepts,
                false => MatrixAnswer::Rejects,
            };
            assert_eq!(*answer, expected, "{pair:?}");
        }
        assert_eq!(answered.load(Ordering::Relaxed), pairs.len());
    }
}
