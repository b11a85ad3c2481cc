//! Asking an engine all that a case needs.

use stickler_engines::{EngineError, EngineSession, Outcome, Packed, RunRequest};
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
}

/// Asks an engine all that a case needs. The engine sees the program and what to observe, never the expectation.
///
/// # Errors
/// [`EngineError`] where no session can be opened.
pub fn ask(session: &mut EngineSession<'_>, case: &Case) -> Result<Answers, EngineError> {
    let request = case.request();
    let run = session.run(&request)?;
    let wants_rendering = case.expectation.rendered.is_some() && !is_crash(&run);
    let rendering = match wants_rendering {
        true => Some(ask_rendering(session, &request)?),
        false => None,
    };
    Ok(Answers { run, rendering })
}

/// Asks an engine to run several programs at a time. Of the cases, none may need more than a run.
///
/// # Errors
/// [`EngineError`] where no session can be opened.
pub(crate) fn ask_pack(session: &mut EngineSession<'_>, cases: &[&Case]) -> Result<Vec<Packed>, EngineError> {
    let requests: Vec<RunRequest<'_>> = cases.iter().map(|case| case.request()).collect();
    session.run_pack(&requests)
}

fn ask_rendering(
    session: &mut EngineSession<'_>,
    request: &RunRequest<'_>,
) -> Result<Rendering, EngineError> {
    let first = session.render(request.dialect, request.source)?;
    let (mut again, mut rerun) = (None, None);
    if let Outcome::Rendered { text } = &first {
        let rendered_again = session.render(request.dialect, text)?;
        if !is_crash(&rendered_again) {
            let request = RunRequest {
                source: text,
                ..*request
            };
            rerun = Some(session.run(&request)?);
        }
        again = Some(rendered_again);
    }
    Ok(Rendering { first, again, rerun })
}

const fn is_crash(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Crashed { .. })
}
