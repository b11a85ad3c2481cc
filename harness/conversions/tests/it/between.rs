//! Engines that are the reference with a planted error.

use stickler_engines::{Engine, EngineError, Identity, Outcome, Reference, RunRequest, Session};
use stickler_types::DialectName;

/// An engine that passes requests to the reference through a function, which may change request and answer.
pub struct Between<F> {
    /// The reference that answers requests.
    pub reference: Reference,
    /// The function that answers a request, by the session of the reference.
    pub answer: F,
}

impl<F: Fn(&mut dyn Session, &RunRequest<'_>) -> Outcome + Send + Sync> Engine for Between<F> {
    fn identity(&self) -> &Identity {
        self.reference.identity()
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let session = self.reference.session()?;
        Ok(Box::new(BetweenSession {
            session,
            answer: &self.answer,
        }))
    }
}

struct BetweenSession<'e, F> {
    session: Box<dyn Session + 'e>,
    answer: &'e F,
}

impl<F: Fn(&mut dyn Session, &RunRequest<'_>) -> Outcome> Session for BetweenSession<'_, F> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        (self.answer)(self.session.as_mut(), request)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.session.check(dialect, source)
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.session.render(dialect, source)
    }
}

/// Returns the reference, whose requests pass through a function.
pub fn between<F>(answer: F) -> Between<F>
where
    F: Fn(&mut dyn Session, &RunRequest<'_>) -> Outcome + Send + Sync,
{
    Between {
        reference: Reference::new(),
        answer,
    }
}

/// Returns the reference, whose programs a function changes.
pub fn rewritten(change: impl Fn(&str) -> String + Send + Sync) -> impl Engine {
    between(move |session: &mut dyn Session, request: &RunRequest<'_>| {
        let source = &change(request.source);
        session.run(&RunRequest { source, ..*request })
    })
}

/// Returns the reference with a function replaced: `body` assigns `Wrong` from `x`, and may say `RIGHT` for the right result.
pub fn wrong(function: &str, from: &str, to: &str, body: &str) -> impl Engine + use<> {
    let body = body.replace("RIGHT", &format!("{function}(x)"));
    let call = format!(":= {function}(");
    let declared = format!("FUNCTION Wrong : {to}\nVAR_INPUT x : {from}; END_VAR\n{body}\nEND_FUNCTION\n");
    rewritten(move |source| declared.clone() + &source.replace(&call, ":= Wrong("))
}
