//! The reference with closures in place of some of its answers: engines with planted defects, and engines whose answers a test states.

use crate::reference::ReferenceSession;
use crate::{Engine, EngineError, Identity, Outcome, Reference, RunRequest, Session};
use stickler_types::DialectName;

type Open<'f> = dyn Fn() -> Result<(), EngineError> + Send + Sync + 'f;
type Run<'f> = dyn Fn(&mut dyn Session, &RunRequest<'_>) -> Outcome + Send + Sync + 'f;
type Render<'f> = dyn Fn(DialectName, &str) -> Outcome + Send + Sync + 'f;

/// An engine that does what the reference does, but for what its closures do.
pub struct ClosureEngine<'f> {
    /// The name, version, dialects and abilities of the engine: those of the reference where nothing else is said.
    pub identity: Identity,
    /// Called whenever a session is opened.
    pub open: Box<Open<'f>>,
    /// Executes a program, as [`Session::run`] does; may ask the session of the reference.
    pub run: Box<Run<'f>>,
    /// Renders a program, as [`Session::render`] does; `None` where the reference does.
    pub render: Option<Box<Render<'f>>>,
}

impl<'f> ClosureEngine<'f> {
    /// Returns an engine that executes programs by `run`.
    pub fn new(
        name: &str,
        run: impl Fn(&mut dyn Session, &RunRequest<'_>) -> Outcome + Send + Sync + 'f,
    ) -> ClosureEngine<'f> {
        ClosureEngine {
            identity: Identity {
                name: name.to_owned(),
                ..Reference::new().identity().clone()
            },
            open: Box::new(|| Ok(())),
            run: Box::new(run),
            render: None,
        }
    }
}

impl Engine for ClosureEngine<'_> {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        (self.open)()?;
        Ok(Box::new(ClosureSession(self, ReferenceSession::default())))
    }
}

struct ClosureSession<'e>(&'e ClosureEngine<'e>, ReferenceSession);

impl Session for ClosureSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        (self.0.run)(&mut self.1, request)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match self.run(&RunRequest::once(dialect, source, &[])) {
            Outcome::Executed { warnings, .. } => Outcome::Accepted { warnings },
            outcome => outcome,
        }
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match &self.0.render {
            Some(render) => render(dialect, source),
            None => self.1.render(dialect, source),
        }
    }
}
