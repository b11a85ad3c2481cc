//! What the adapters have in common: finding a compiler, an engine of an adapter, and its sessions.

use super::Compiler;
use super::compilers::last_word;
use super::dependencies::DependencySearch;
use super::fingerprint::Fingerprint;
use super::locate::speaks_not;
use super::recipe::{Recipe, Tools, Workplace};
use super::settings::{run_written, with_settings, written};
use super::source::{MainProgram, main_program};
use crate::engine::no_rendering;
use crate::{
    Ability, Diagnostic, Engine, EngineError, Identity, NoReproduction, Outcome, Packed, Reproduction,
    RunRequest, Session,
};
use stickler_types::DialectName;

/// An adapter: the way in which one compiler is asked about programs.
pub(super) trait Adapter: Send + Sync + Sized {
    /// The compiler.
    const COMPILER: Compiler;

    /// The number of programs that [`Adapter::run_pack`] is best given at a time. Beyond it, the cost of starting the compilers for
    /// each pack is less than that of a failing program to its pack.
    const PACK_SIZE: usize = 1;

    /// Returns the adapter of a compiler whose tools were found; those that belong to others are added.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    fn new(tools: &mut Tools) -> Result<Self, String>;

    /// Returns what tells versions apart of what the compiler says of its version.
    fn version(said: &str) -> String {
        last_word(said)
    }

    /// Adds to the identity of the engine what only this compiler on this machine tells.
    fn identify(&self, _: &mut Identity) {}

    /// Adds everything that decides the compiler's answers to a fingerprint.
    fn fingerprint(&self, fingerprint: Fingerprint) -> Fingerprint;

    /// Returns the recipe by which a person sees whether a program is accepted.
    ///
    /// # Errors
    /// The outcome of a program that the adapter would not check either.
    fn translation(dialect: DialectName, source: &str) -> Result<Recipe, Outcome>;

    /// Returns the recipe by which a person executes the main program of a request.
    ///
    /// # Errors
    /// [`NoReproduction`], where the adapter would not run the program either.
    fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Recipe, NoReproduction>;

    /// Returns the recipe that renders a program.
    ///
    /// # Errors
    /// The outcome of a program that is not rendered.
    fn rendering(_: DialectName, _: &str) -> Result<Recipe, Outcome> {
        Err(no_rendering())
    }

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

/// Checks that a compiler speaks a dialect, or the one that it extends.
///
/// # Errors
/// [`Outcome::Unsupported`] where it does not.
fn speaks<A: Adapter>(dialect: DialectName) -> Result<(), Outcome> {
    let mut spoken = A::COMPILER.data().dialects.keys();
    match spoken.any(|spoken| spoken.0.base() == dialect.base()) {
        true => Ok(()),
        false => Err(speaks_not(dialect)),
    }
}

/// Returns the reproduction of a request, as [`Engine::reproduce`] does.
///
/// # Errors
/// [`NoReproduction`], where the adapter would not run the program either.
pub(super) fn reproduce<A: Adapter>(
    request: &RunRequest<'_>,
    ability: Ability,
) -> Result<Reproduction, NoReproduction> {
    let RunRequest { dialect, source, .. } = *request;
    speaks::<A>(dialect)?;
    let text = with_settings(request);
    let request = &written(request, text.as_ref());
    let recipe = match (ability, main_program(request)) {
        (Ability::Render, _) => A::rendering(dialect, source)?,
        (Ability::Execute | Ability::Scans, Some(main)) => A::execution(request, &main)?,
        (Ability::Check, _) | (_, None) => A::translation(dialect, source)?.accepted(),
    };
    Ok(recipe.on(A::COMPILER))
}

/// An engine of an adapter, whose compiler was found on this machine.
pub(super) struct AdapterEngine<A> {
    identity: Identity,
    tools: Tools,
    adapter: A,
}

impl<A: Adapter + 'static> AdapterEngine<A> {
    /// Finds a compiler, which is `called` so in reports.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(called: &str, search: &mut DependencySearch<'_>) -> Result<Box<dyn Engine>, String> {
        let (mut identity, mut tools) = A::COMPILER.data().find(called, search, A::version)?;
        let adapter = A::new(&mut tools)?;
        adapter.identify(&mut identity);
        Ok(Box::new(AdapterEngine {
            identity,
            tools,
            adapter,
        }))
    }
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
        reproduce::<A>(request, ability)
    }

    fn tools(&self) -> Tools {
        self.tools.clone()
    }

    fn fingerprint(&self) -> Option<String> {
        let fingerprint = Fingerprint::of(A::COMPILER.as_str());
        self.adapter.fingerprint(fingerprint).finish()
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
        let spoken = speaks::<A>(request.dialect);
        let outcome = spoken.and_then(|()| {
            let (adapter, workplace) = (self.adapter, &self.workplace);
            let check = |request: &RunRequest<'_>| adapter.check(workplace, request.dialect, request.source);
            run_written(request, |request| adapter.run(workplace, request), check)
        });
        outcome.unwrap_or_else(|outcome| outcome)
    }

    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        let texts: Vec<Option<String>> = requests.iter().map(with_settings).collect();
        let with_texts = requests.iter().zip(&texts);
        let written: Vec<RunRequest<'_>> = with_texts
            .map(|(request, text)| written(request, text.as_ref()))
            .collect();
        let mut answers = self.adapter.run_pack(&self.workplace, &written);
        for (answer, _) in answers.iter_mut().zip(&texts).filter(|(_, text)| text.is_some()) {
            // Whether the program itself is accepted is asked alone.
            if !matches!(answer, Packed::Answered(Outcome::Executed { .. })) {
                *answer = Packed::Alone;
            }
        }
        answers
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        let spoken = speaks::<A>(dialect);
        match spoken.and_then(|()| self.adapter.check(&self.workplace, dialect, source)) {
            Ok(warnings) => Outcome::Accepted { warnings },
            Err(outcome) => outcome,
        }
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        let spoken = speaks::<A>(dialect);
        let outcome = spoken.and_then(|()| self.adapter.render(&self.workplace, dialect, source));
        outcome.unwrap_or_else(|outcome| outcome)
    }
}
