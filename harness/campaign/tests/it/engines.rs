//! Engines with known defects: the reference, which is given another program than it was asked about.

use std::collections::HashSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use stickler_engines::{Engine, EngineError, Identity, Outcome, Reference, RunRequest, Session};
use stickler_types::DialectName;

/// A planted defect of an engine.
#[derive(Clone, Copy, Debug)]
pub enum Defect {
    /// Takes one word of the program for another.
    Mistakes(&'static str, &'static str),
    /// Dies over programs with this word.
    DiesOver(&'static str),
    /// Dies over each request whose number is a multiple of this one, and over no program twice.
    DiesEvery(u64),
    /// Dies over every request from the first program with this word on.
    DiesForEverOver(&'static str),
    /// Rejects programs with one of these texts.
    Rejects(&'static [&'static str]),
    /// No defect.
    None,
}

/// An engine with a defect.
pub struct Defective {
    inner: Reference,
    identity: Identity,
    defect: Defect,
    requests: AtomicU64,
    /// The number of requests that the engine answers before it dies over all others.
    life: AtomicU64,
    /// The programs over which it has died.
    fatal: Mutex<HashSet<String>>,
}

impl Defective {
    /// The reference with this defect, under the name `defective`.
    pub fn new(defect: Defect) -> Defective {
        Defective::dying(defect, u64::MAX)
    }

    /// Returns an engine with a defect that dies over every request after the first `life`.
    pub fn dying(defect: Defect, life: u64) -> Defective {
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
            life: AtomicU64::new(life),
            fatal: Mutex::default(),
        }
    }

    fn is_first_death(&self, source: &str) -> bool {
        let mut fatal = self.fatal.lock().unwrap_or_else(PoisonError::into_inner);
        fatal.insert(source.to_owned())
    }

    /// Returns the number of requests to run a program.
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
        let source = match self.engine.defect {
            Defect::Mistakes(word, other) => request.source.replace(word, other),
            _ => request.source.to_owned(),
        };
        let dies = match self.engine.defect {
            Defect::DiesOver(word) => source.contains(word),
            Defect::DiesEvery(every) => number.is_multiple_of(every) && self.engine.is_first_death(&source),
            Defect::DiesForEverOver(word) if source.contains(word) => {
                self.engine.life.store(0, Ordering::Relaxed);
                true
            }
            Defect::Rejects(texts) if texts.iter().any(|text| source.contains(text)) => {
                return Outcome::Rejected {
                    diagnostics: Vec::new(),
                };
            }
            Defect::DiesForEverOver(_) | Defect::Mistakes(..) | Defect::Rejects(_) | Defect::None => false,
        };
        let dies = dies || number > self.engine.life.load(Ordering::Relaxed);
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
