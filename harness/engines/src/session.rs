//! One worker's session of an engine, which outlives the engine's panics and crashes.

use crate::{Engine, EngineError, Outcome, Packed, RunRequest, Session};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use stickler_types::DialectName;

/// A session of an engine that is opened when it is needed, and anew after each crash.
///
/// A panic of an engine that lives in this process becomes [`Outcome::Crashed`]: it is a crash of that engine, not of
/// Stickler. What a panic or a crash has left behind is not used again; the next request opens a new session.
pub struct EngineSession<'e> {
    engine: &'e dyn Engine,
    session: Option<Box<dyn Session + 'e>>,
}

impl<'e> EngineSession<'e> {
    /// Returns an engine session that is opened at the first request.
    pub fn new(engine: &'e dyn Engine) -> EngineSession<'e> {
        EngineSession {
            engine,
            session: None,
        }
    }

    /// Opens a session.
    ///
    /// # Errors
    /// [`EngineError`] where the engine cannot be started.
    pub fn open(engine: &'e dyn Engine) -> Result<EngineSession<'e>, EngineError> {
        let session = Some(engine.session()?);
        Ok(EngineSession { engine, session })
    }

    /// Returns the engine that is asked.
    pub const fn engine(&self) -> &'e dyn Engine {
        self.engine
    }

    /// Executes a program, as [`Session::run`] does.
    ///
    /// # Errors
    /// [`EngineError`] where there is no session and none can be opened.
    pub fn run(&mut self, request: &RunRequest<'_>) -> Result<Outcome, EngineError> {
        self.ask(|session| session.run(request))
    }

    /// Checks a program, as [`Session::check`] does.
    ///
    /// # Errors
    /// [`EngineError`] where there is no session and none can be opened.
    pub fn check(&mut self, dialect: DialectName, source: &str) -> Result<Outcome, EngineError> {
        self.ask(|session| session.check(dialect, source))
    }

    /// Renders a program as normalised source, as [`Session::render`] does.
    ///
    /// # Errors
    /// [`EngineError`] where there is no session and none can be opened.
    pub fn render(&mut self, dialect: DialectName, source: &str) -> Result<Outcome, EngineError> {
        self.ask(|session| session.render(dialect, source))
    }

    /// Executes several programs, as [`Session::run_pack`] does. Returns one answer for each request whatever the engine gives;
    /// where the engine panics, every answer is [`Packed::Unknown`].
    ///
    /// # Errors
    /// [`EngineError`] where there is no session and none can be opened.
    pub fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Result<Vec<Packed>, EngineError> {
        let session = self.session()?;
        let mut packed = guarded(|| session.run_pack(requests)).unwrap_or_else(|_| {
            self.session = None;
            Vec::new()
        });
        packed.resize(requests.len(), Packed::Unknown);
        Ok(packed)
    }

    fn ask(&mut self, ask: impl FnOnce(&mut dyn Session) -> Outcome) -> Result<Outcome, EngineError> {
        let session = self.session()?;
        let outcome = guarded(|| ask(session)).unwrap_or_else(|reason| Outcome::Crashed { reason });
        if let Outcome::Crashed { .. } = outcome {
            self.session = None;
        }
        Ok(outcome)
    }

    fn session(&mut self) -> Result<&mut (dyn Session + 'e), EngineError> {
        let session = match &mut self.session {
            Some(session) => session,
            closed => closed.insert(self.engine.session()?),
        };
        Ok(session.as_mut())
    }
}

/// Runs `ask` and catches a panic. Returns the panic's text, as a fragment, where there is one.
///
/// The caller must drop what was unwound: that makes it safe to go on.
fn guarded<T>(ask: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(ask)).map_err(|payload| panic_text(payload.as_ref()))
}

fn panic_text(payload: &(dyn Any + Send)) -> String {
    let text = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("with no message");
    format!("panicked: {text}")
}
