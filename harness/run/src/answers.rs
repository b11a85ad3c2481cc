//! Asks an engine for everything that a case needs, and holds its answers.

use serde::{Deserialize, Serialize};
use stickler_engines::{Ability, EngineError, EngineSession, Outcome, Packed, RunRequest};
use stickler_suite::{Acceptance, Case};

/// Everything that an engine answered about one case.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Answers {
    /// The outcome of `run`.
    pub run: Outcome,
    /// The outcomes of `render` and of the requests that follow it; `None` where the case expects no rendered text.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rendering: Option<Rendering>,
}

/// The outcomes of rendering a program, and of rendering and running the rendered program. Basis: harness/engines/README.md
/// (rendering again changes nothing, and the rendered program means the same).
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rendering {
    /// The outcome of rendering the program.
    pub first: Outcome,
    /// The outcome of rendering the rendered program; `None` where rendering gave no text.
    pub again: Option<Outcome>,
    /// The outcome of running the rendered program; `None` where rendering gave no text, or rendering it again crashed the
    /// engine.
    pub rerun: Option<Outcome>,
}

impl Answers {
    /// Returns the answers about a case for which the engine was only asked to run the program.
    pub fn of_run(run: Outcome) -> Answers {
        Answers { run, rendering: None }
    }

    /// Returns all outcomes, in the order of the requests.
    pub fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        let rendering = self.rendering.iter();
        let later = rendering
            .flat_map(|r| [Some(&r.first), r.again.as_ref(), r.rerun.as_ref()])
            .flatten();
        std::iter::once(&self.run).chain(later)
    }
}

/// Asks an engine for everything that a case needs. The engine sees the program and what to observe, never the expectation.
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

/// Returns the ability of an engine that shows whether it meets a case, for a reproduction without Stickler: a rejection shows
/// in a check, a rendered text in rendering, and all else only when the program is executed.
pub fn shown_by(case: &Case) -> Ability {
    let expectation = &*case.expectation;
    if expectation.rendered.is_some() {
        return Ability::Render;
    }
    let executed = expectation.fault.is_some() || !case.observe.is_empty();
    match expectation.accepted {
        Acceptance::Required if executed => Ability::Execute,
        Acceptance::Required | Acceptance::Rejected | Acceptance::Observed => Ability::Check,
    }
}

/// Asks an engine to run several programs in one request. None of the cases may need more than a run.
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
