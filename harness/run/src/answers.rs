//! Asking an engine all that a case needs.

use stickler_engines::{
    ClockStep, Engine, EngineError, Observation, Outcome, Packed, RunRequest, Session, Setting, guard,
    guarded,
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
        let answers = ask_session(self.session()?, &Question::of(case));
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
        let questions: Vec<Question<'_>> = cases.iter().map(|case| Question::of(case)).collect();
        let requests: Vec<RunRequest<'_>> = questions.iter().map(Question::request).collect();
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

/// What an engine is asked about a case, in its own words.
struct Question<'c> {
    case: &'c Case,
    observe: Vec<Observation<'c>>,
    clock: Vec<ClockStep>,
    set: Vec<Setting<'c>>,
}

impl<'c> Question<'c> {
    fn of(case: &'c Case) -> Question<'c> {
        let observe = case.observe.iter().map(|asked| Observation {
            name: &asked.name,
            type_name: &asked.ty,
            after: asked.after,
        });
        let set = case.set.iter().map(|setting| Setting {
            before: setting.before,
            name: &setting.name,
            value: &setting.value,
        });
        Question {
            case,
            observe: observe.collect(),
            clock: case.clock.iter().map(clock_step).collect(),
            set: set.collect(),
        }
    }

    fn request(&self) -> RunRequest<'_> {
        RunRequest {
            dialect: self.case.dialect,
            source: &self.case.source,
            scans: self.case.scans,
            observe: &self.observe,
            clock: &self.clock,
            set: &self.set,
        }
    }
}

fn ask_session(session: &mut dyn Session, question: &Question<'_>) -> Answers {
    let request = question.request();
    let run = guard(|| session.run(&request));
    let wants_rendering =
        question.case.expectation.rendered.is_some() && !matches!(run, Outcome::Crashed { .. });
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
