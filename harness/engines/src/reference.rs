//! The reference implementation as an engine.

use crate::{Ability, Engine, EngineError, Grade, Identity, Outcome, RunRequest, Session};
use stickler_reference as reference;
use stickler_types::{Code, DialectName};

/// The reference implementation: every dialect, every ability, in this process.
#[derive(Clone, Debug)]
pub struct Reference {
    identity: Identity,
    limits: reference::Limits,
}

impl Reference {
    /// The name of the reference, in this process and in a process of its own.
    pub const NAME: &str = "reference";

    /// Returns the reference under the name `reference`, with the version of this workspace. It speaks every dialect that
    /// exists at the time of the call, custom dialects included.
    pub fn new() -> Reference {
        let identity = Identity {
            name: Reference::NAME.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            dialects: DialectName::ALL
                .into_iter()
                .chain(DialectName::defined())
                .collect(),
            abilities: vec![Ability::Check, Ability::Execute, Ability::Render, Ability::Scans],
            grade: Grade::Code,
            lacks: Code::ALL
                .iter()
                .copied()
                .filter(|code| code.example_dialect().is_none())
                .collect(),
        };
        Reference {
            identity,
            limits: reference::Limits::default(),
        }
    }

    /// Returns the reference with a step limit of the caller's own; a run that needs more steps faults with `step-limit`.
    pub fn with_step_limit(steps: u64) -> Reference {
        Reference {
            limits: reference::Limits { steps },
            ..Reference::new()
        }
    }
}

impl Default for Reference {
    fn default() -> Reference {
        Reference::new()
    }
}

impl Engine for Reference {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        Ok(Box::new(ReferenceSession { limits: self.limits }))
    }
}

/// A session of the reference, which keeps nothing between requests.
#[derive(Default)]
pub(crate) struct ReferenceSession {
    limits: reference::Limits,
}

impl Session for ReferenceSession {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        reference::run(request, self.limits).unwrap_or_else(|error| Outcome::Error {
            message: error.to_string(),
        })
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        Outcome::of_check(reference::check(source, dialect))
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match reference::render(source, dialect) {
            Ok(text) => Outcome::Rendered { text },
            Err(diagnostics) => Outcome::Rejected { diagnostics },
        }
    }
}
