//! Asking an engine all that a case needs.

use stickler_engines::{
    ClockStep, Engine, EngineError, Observation, Outcome, RunRequest, Session, Setting, guard,
};
use stickler_suite::{Case, ClockSetting};
use stickler_types::Value;

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
        let session = match &mut self.session {
            Some(session) => session,
            closed => closed.insert(self.engine.session()?),
        };
        let answers = ask_session(session.as_mut(), case);
        if answers.crashed() {
            self.session = None;
        }
        Ok(answers)
    }
}

fn ask_session(session: &mut dyn Session, case: &Case) -> Answers {
    let observe: Vec<Observation<'_>> = case
        .observe
        .iter()
        .map(|asked| Observation {
            name: &asked.name,
            type_name: &asked.ty,
            after: asked.after,
        })
        .collect();
    let clock: Vec<ClockStep> = case.clock.iter().map(clock_step).collect();
    let set: Vec<Setting<'_>> = case
        .set
        .iter()
        .map(|setting| Setting {
            before: setting.before,
            name: &setting.name,
            value: &setting.value,
        })
        .collect();
    let request = RunRequest {
        dialect: case.dialect,
        source: &case.source,
        scans: case.scans,
        observe: &observe,
        clock: &clock,
        set: &set,
    };
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

fn clock_step(setting: &ClockSetting) -> ClockStep {
    let nanoseconds = match setting.value {
        Value::Plain { raw, .. } => raw.cast_signed(),
        Value::Text { .. } | Value::Enumerated { .. } => 0,
    };
    ClockStep {
        before: setting.before,
        nanoseconds,
    }
}
