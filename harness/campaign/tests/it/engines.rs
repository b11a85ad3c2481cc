//! Engines with known defects: the reference, which is given another program than it was asked about.

use std::sync::atomic::{AtomicU64, Ordering};
use stickler_engines::{Engine, EngineError, Identity, Outcome, Reference, RunRequest, Session};
use stickler_types::DialectName;

/// What is wrong with an engine.
#[derive(Clone, Copy, Debug)]
pub enum Defect {
    /// It takes one word of the program for another.
    Mistakes(&'static str, &'static str),
    /// It dies over programs with this word.
    DiesOver(&'static str),
    /// It dies over every so-manieth request, whatever it is.
    DiesEvery(u64),
    /// After so many requests it dies over everything.
    DiesAfter(u64),
}

/// An engine with a defect.
pub struct Defective {
    inner: Reference,
    identity: Identity,
    defect: Defect,
    requests: AtomicU64,
}

impl Defective {
    /// The reference with this defect, under the name `defective`.
    pub fn new(defect: Defect) -> Defective {
        let inner = Reference::default();
        let identity = Identity {
            name: "defective".to_owned(),
            ..inner.identity().clone()
        };
        Defective {
            inner,
            identity,
            defect,
            requests: AtomicU64::new(0),
        }
    }

    /// How often it was asked to run something.
    pub fn requests(&self) -> u64 {
        self.requests.load(Ordering::Relaxed)
    }
}

impl Engine for Defective {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        Ok(Box::new(DefectiveSession {
            engine: self,
            inner: self.inner.session()?,
        }))
    }
}

struct DefectiveSession<'e> {
    engine: &'e Defective,
    inner: Box<dyn Session + 'e>,
}

impl Session for DefectiveSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        let number = self.engine.requests.fetch_add(1, Ordering::Relaxed) + 1;
        let (source, dies) = match self.engine.defect {
            Defect::Mistakes(word, other) => (request.source.replace(word, other), false),
            Defect::DiesOver(word) => (request.source.to_owned(), request.source.contains(word)),
            Defect::DiesEvery(every) => (request.source.to_owned(), number.is_multiple_of(every)),
            Defect::DiesAfter(most) => (request.source.to_owned(), number > most),
        };
        if dies {
            return Outcome::Crashed {
                reason: "it was made to".to_owned(),
            };
        }
        self.inner.run(&RunRequest {
            source: &source,
            ..*request
        })
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.inner.check(dialect, source)
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.inner.render(dialect, source)
    }
}
