//! Asking an engine all that a case needs.

use stickler_engines::{Engine, EngineError, Outcome, Packed, RunRequest, Session, guard, guarded};
use stickler_suite::Case;

/// All that an engine answered about one case.
#[derive(Clone, PartialEq, Debug)]
pub struct Answers {
    /// To `run`.
    pub run: Outcome,
    /// To `render` and what follows from it; `None` where the case expects no rendered text.
    pub rendering: Option<Rendering>,
}

/// What came of rendering a program, and of the rendered program. Basis: design, sections 3.1 and 4
/// (rendering again changes nothing, and the rendered program means the same).
#[derive(Clone, PartialEq, Debug)]
pub struct Rendering {
    /// The program, rendered.
    pub first: Outcome,
    /// The rendered program, rendered; `None` where there was no rendered program.
    pub again: Option<Outcome>,
    /// The rendered program, run.
    pub rerun: Option<Outcome>,
}

impl Answers {
    /// The answers where `run` was all that was asked.
    #[must_use]
    pub fn of_run(run: Outcome) -> Answers {
        Answers { run, rendering: None }
    }

    /// All outcomes, in the order in which they were asked for.
    pub fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        let rendering = self.rendering.iter();
        let later = rendering
            .flat_map(|r| [Some(&r.first), r.again.as_ref(), r.rerun.as_ref()])
            .flatten();
        std::iter::once(&self.run).chain(later)
    }

    /// Whether the engine panicked over any of it, so that its session is not to be trusted any more.
    #[must_use]
    pub fn crashed(&self) -> bool {
        self.outcomes()
            .any(|outcome| matches!(outcome, Outcome::Crashed { .. }))
    }
}

/// An engine with the session that a worker keeps to it. A session that crashed is thrown away; the next case
/// opens a new one.
pub struct Desk<'e> {
    engine: &'e dyn Engine,
    session: Option<Box<dyn Session + 'e>>,
}

impl<'e> Desk<'e> {
    /// A desk at which nothing was asked yet.
    #[must_use]
    pub fn new(engine: &'e dyn Engine) -> Desk<'e> {
        Desk {
            engine,
            session: None,
        }
    }

    /// Asks the engine all that the case needs. The engine sees the program and what to observe, never the
    /// expectation.
    ///
    /// # Errors
    /// Where no session can be opened. A panic of the engine is no error but [`Outcome::Crashed`].
    pub fn ask(&mut self, case: &Case) -> Result<Answers, EngineError> {
        let answers = ask_session(self.session()?, case);
        if answers.crashed() {
            self.session = None;
        }
        Ok(answers)
    }

    /// Asks the engine to run several programs at a time. Of the cases, none may need more than a run.
    ///
    /// # Errors
    /// As [`Desk::ask`]. An engine that panics has told nothing about any of them.
    pub(crate) fn ask_pack(&mut self, cases: &[&Case]) -> Result<Vec<Packed>, EngineError> {
        let requests: Vec<RunRequest<'_>> = cases.iter().map(|case| case.request()).collect();
        let session = self.session()?;
        let mut packed = match guarded(|| session.run_pack(&requests)) {
            Ok(packed) => packed,
            Err(_) => {
                self.session = None;
                Vec::new()
            }
        };
        // Whatever an engine gives, it is one answer a case.
        packed.resize(cases.len(), Packed::Unknown);
        Ok(packed)
    }

    fn session(&mut self) -> Result<&mut (dyn Session + 'e), EngineError> {
        let session = match &mut self.session {
            Some(session) => session,
            closed => closed.insert(self.engine.session()?),
        };
        Ok(session.as_mut())
    }
}

fn ask_session(session: &mut dyn Session, case: &Case) -> Answers {
    let request = case.request();
    let run = guard(|| session.run(&request));
    let wants_rendering = case.expectation.rendered.is_some() && !matches!(run, Outcome::Crashed { .. });
    let rendering = wants_rendering.then(|| ask_rendering(session, &request));
    Answers { run, rendering }
}

fn ask_rendering(session: &mut dyn Session, request: &RunRequest<'_>) -> Rendering {
    let first = guard(|| session.render(request.dialect, request.source));
    let Outcome::Rendered { text } = &first else {
        return Rendering {
            first,
            again: None,
            rerun: None,
        };
    };
    let again = guard(|| session.render(request.dialect, text));
    if let Outcome::Crashed { .. } = again {
        return Rendering {
            again: Some(again),
            rerun: None,
            first,
        };
    }
    let rerun = guard(|| {
        session.run(&RunRequest {
            source: text,
            ..*request
        })
    });
    Rendering {
        again: Some(again),
        rerun: Some(rerun),
        first,
    }
}
