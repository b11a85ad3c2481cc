//! What the adapters have in common: an engine of an adapter, and its sessions.

use super::fingerprint::Fingerprint;
use super::recipe::{Tools, Workplace};
use crate::engine::no_rendering;
use crate::{
    Ability, Diagnostic, Engine, EngineError, Identity, NoReproduction, Outcome, Packed, Reproduction,
    RunRequest, Session,
};
use stickler_types::DialectName;

/// How one compiler is asked about programs.
pub(super) trait Adapter: Send + Sync + Sized {
    /// The number of programs that [`Adapter::run_pack`] is best given at a time. Beyond it, the cost of starting the compilers for
    /// each pack is less than that of a failing program to its pack.
    const PACK_SIZE: usize = 1;

    /// Adds everything that decides the compiler's answers to a fingerprint.
    fn fingerprint(&self, fingerprint: Fingerprint) -> Fingerprint;

    /// Returns the reproduction of a request, as [`Engine::reproduce`] does.
    ///
    /// # Errors
    /// [`NoReproduction`], where the adapter would not run the program either.
    fn reproduce(request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction>;

    /// Executes a program, as [`Session::run`] does.
    ///
    /// # Errors
    /// The outcome of a program that is not executed to its end.
    fn run(&self, workplace: &Workplace<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome>;

    /// Executes several programs, as [`Session::run_pack`] does.
    fn run_pack(&self, _: &Workplace<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        vec![Packed::Alone; requests.len()]
    }

    /// Checks a program and returns the warnings of one that is accepted.
    ///
    /// # Errors
    /// The outcome of a program that is not accepted.
    fn check(
        &self,
        workplace: &Workplace<'_>,
        dialect: DialectName,
        source: &str,
    ) -> Result<Vec<Diagnostic>, Outcome>;

    /// Renders a program as normalised source.
    ///
    /// # Errors
    /// The outcome of a program that is not rendered.
    fn render(&self, _: &Workplace<'_>, _: DialectName, _: &str) -> Result<Outcome, Outcome> {
        Err(no_rendering())
    }
}

/// An engine of an adapter, whose compiler was found on this machine.
pub(super) struct AdapterEngine<A> {
    pub(super) identity: Identity,
    pub(super) tools: Tools,
    pub(super) adapter: A,
}

impl<A: Adapter> Engine for AdapterEngine<A> {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        Ok(Box::new(AdapterSession {
            adapter: &self.adapter,
            workplace: Workplace::new(&self.identity, &self.tools)?,
        }))
    }

    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        A::reproduce(request, ability)
    }

    fn tools(&self) -> Tools {
        self.tools.clone()
    }

    fn fingerprint(&self) -> Option<String> {
        let kind = std::any::type_name::<A>();
        self.adapter.fingerprint(Fingerprint::of(kind)).finish()
    }

    fn pack_size(&self) -> usize {
        A::PACK_SIZE
    }
}

/// A session: a folder in which programs are translated, built and run.
struct AdapterSession<'e, A> {
    adapter: &'e A,
    workplace: Workplace<'e>,
}

impl<A: Adapter> Session for AdapterSession<'_, A> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        let outcome = self.adapter.run(&self.workplace, request);
        outcome.unwrap_or_else(|outcome| outcome)
    }

    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        self.adapter.run_pack(&self.workplace, requests)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match self.adapter.check(&self.workplace, dialect, source) {
            Ok(warnings) => Outcome::Accepted { warnings },
            Err(outcome) => outcome,
        }
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        let outcome = self.adapter.render(&self.workplace, dialect, source);
        outcome.unwrap_or_else(|outcome| outcome)
    }
}
