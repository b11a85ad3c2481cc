//! Asks an engine for the answers of a recording.

use super::{FunctionAnswers, Recording, RecordingOrigin, key};
use crate::implicit::{self, TypePair};
use crate::overview;
use crate::session::FunctionSession;
use crate::sweep::foreign::ForeignError;
use std::collections::HashMap;
use stickler_engines::Engine;
use stickler_exact::Signature;
use stickler_types::{DialectName, ElementaryType};
use stickler_workers::WorkerPool;

impl Recording {
    /// Asks an engine, in each of the dialects, for every pair of elementary types, and for every conversion function of the
    /// dialect at the boundary values that `stickler conversions` shows. Calls `answered` after each pair and each signature.
    ///
    /// # Errors
    /// An engine that cannot be started.
    pub fn ask(
        engine: &dyn Engine,
        origin: RecordingOrigin,
        dialects: &[DialectName],
        jobs: usize,
        answered: &(dyn Fn() + Sync),
    ) -> Result<Recording, ForeignError> {
        let mut recording = Recording {
            origin,
            dialects: dialects.to_vec(),
            implicit: HashMap::new(),
            functions: HashMap::new(),
        };
        for dialect in dialects {
            let pairs = pairs();
            let answers = implicit::answers(engine, *dialect, &pairs, jobs, answered)?;
            let keys = pairs.into_iter().map(|pair| (*dialect, pair));
            recording.implicit.extend(keys.zip(answers));
            let signatures = signatures(*dialect);
            let answers = WorkerPool::new(jobs).map(
                signatures.iter(),
                || Ok::<_, ForeignError>(FunctionSession::open(engine)?),
                |session, signature| {
                    let answers = of_function(session, *dialect, signature);
                    answered();
                    Ok(answers)
                },
            )?;
            let keys = signatures.iter().map(|signature| (*dialect, key(signature)));
            recording.functions.extend(keys.zip(answers));
        }
        Ok(recording)
    }

    /// Returns how often [`Recording::ask`] calls `answered`.
    #[must_use]
    pub fn questions(dialects: &[DialectName]) -> usize {
        let of_dialect = |dialect: &DialectName| pairs().len() + signatures(*dialect).len();
        dialects.iter().map(of_dialect).sum()
    }
}

fn pairs() -> Vec<TypePair> {
    let of_row = |row| ElementaryType::ALL.into_iter().map(move |column| (row, column));
    ElementaryType::ALL.into_iter().flat_map(of_row).collect()
}

fn signatures(dialect: DialectName) -> Vec<Signature> {
    let functions = stickler_exact::functions(dialect);
    functions
        .iter()
        .flat_map(|function| stickler_exact::signatures(function, dialect))
        .collect()
}

fn of_function(
    session: &mut FunctionSession<'_>,
    dialect: DialectName,
    signature: &Signature,
) -> FunctionAnswers {
    let calls = overview::boundary_calls(signature);
    let answers = session.results(dialect, signature, &calls);
    let answers: Vec<_> = answers
        .into_iter()
        .map(|got| got.map_err(|refusal| refusal.kind))
        .collect();
    match &answers[..] {
        [Err(kind), rest @ ..] if rest.iter().all(|answer| *answer == Err(*kind)) => {
            FunctionAnswers::Refused(*kind)
        }
        _ => FunctionAnswers::Calls(calls.into_iter().zip(answers).collect()),
    }
}
