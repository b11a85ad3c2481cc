//! An engine is given a program, and answers with values or with a reason why there are none.

use crate::sweep::foreign::Program;
use std::fmt;
use stickler_engines::{Diagnostic, Engine, EngineError, Observation, Outcome, RunRequest, Session, guard};
use stickler_types::{DialectName, Fault, Value};

/// Why an engine gave no values.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal {
    /// What it did.
    pub kind: RefusalKind,
    /// What is known about it, as a fragment: its first diagnostic, its last words.
    pub detail: String,
}

/// What an engine did instead of giving values.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum RefusalKind {
    /// It says that it cannot do this, or that it only checks.
    Unsupported,
    /// It rejects the program.
    Rejected,
    /// The program stopped at a run-time fault.
    Faulted,
    /// The program took more steps than the engine allows.
    TooManySteps,
    /// It did not answer in time.
    TimedOut,
    /// It died.
    Crashed,
    /// It answered nonsense, or left values out.
    Nonsense,
}

impl fmt::Display for Refusal {
    /// `rejected the program (P4017: …)`, for the end of a sentence that names the engine.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Refusal { kind, detail } = self;
        write!(f, "{} ({detail})", kind.as_str())
    }
}

impl RefusalKind {
    /// What it did, behind the engine's name: `rejected the program`, `crashed` …
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            RefusalKind::Unsupported => "does not support this",
            RefusalKind::Rejected => "rejected the program",
            RefusalKind::Faulted => "stopped at a fault",
            RefusalKind::TooManySteps => "took too many steps",
            RefusalKind::TimedOut => "took too long",
            RefusalKind::Crashed => "crashed",
            RefusalKind::Nonsense => "answered nonsense",
        }
    }

    /// Whether an engine that accepts a program must not do this, whatever the program asks.
    #[must_use]
    pub const fn is_failure(self) -> bool {
        !matches!(self, RefusalKind::Unsupported | RefusalKind::Rejected)
    }
}

impl Refusal {
    fn new(kind: RefusalKind, detail: impl Into<String>) -> Refusal {
        Refusal {
            kind,
            detail: detail.into(),
        }
    }
}

/// An engine and the session kept to it.
pub struct Asker<'e> {
    engine: &'e dyn Engine,
    session: Box<dyn Session + 'e>,
    dialect: DialectName,
}

impl<'e> Asker<'e> {
    /// # Errors
    /// Where no session can be opened.
    pub fn new(engine: &'e dyn Engine, dialect: DialectName) -> Result<Asker<'e>, EngineError> {
        let session = engine.session()?;
        Ok(Asker {
            engine,
            session,
            dialect,
        })
    }

    /// The values of the variables to observe, in their order.
    ///
    /// # Errors
    /// What the engine did instead.
    pub fn ask(&mut self, program: &Program) -> Result<Vec<Value>, Refusal> {
        let observe: Vec<Observation<'_>> = program
            .observed
            .iter()
            .map(|name| Observation::last(name, program.ty.name()))
            .collect();
        let request = RunRequest::once(self.dialect, &program.source, &observe);
        let outcome = guard(|| self.session.run(&request));
        if let Outcome::Crashed { .. } = outcome {
            // Where there is no new session the old one goes on refusing.
            if let Ok(session) = self.engine.session() {
                self.session = session;
            }
        }
        values(outcome, program)
    }
}

/// The values that an outcome has for a program.
fn values(outcome: Outcome, program: &Program) -> Result<Vec<Value>, Refusal> {
    use RefusalKind::{Crashed, Faulted, Nonsense, Rejected, TimedOut, TooManySteps, Unsupported};
    let (kind, detail) = match outcome {
        Outcome::Executed { values } => return in_order(values, program),
        Outcome::Accepted => (Unsupported, "it accepts programs and executes none".to_owned()),
        Outcome::Unsupported { reason } => (Unsupported, reason),
        Outcome::Rejected { diagnostics } => (Rejected, told(&diagnostics, &program.source)),
        Outcome::Faulted { fault, .. } if fault == Fault::StepLimit => {
            (TooManySteps, fault.as_str().to_owned())
        }
        Outcome::Faulted { fault, .. } => (Faulted, fault.as_str().to_owned()),
        Outcome::Crashed { reason } => (Crashed, reason),
        Outcome::TimedOut { after_ms } => {
            (TimedOut, format!("no answer within {}", Outcome::limit(after_ms)))
        }
        Outcome::Error { message } => (Nonsense, message),
        Outcome::Rendered { .. } => (Nonsense, "it rendered what it was to run".to_owned()),
    };
    Err(Refusal::new(kind, detail))
}

/// Engines should answer in the order of the question, but need not.
fn in_order(mut values: Vec<(String, Value)>, program: &Program) -> Result<Vec<Value>, Refusal> {
    let asked = &program.observed;
    if values.len() != asked.len() || values.iter().zip(asked).any(|((key, _), name)| key != name) {
        let place = |key: &str| asked.iter().position(|name| name == key);
        values.retain(|(key, _)| place(key).is_some());
        values.sort_by_key(|(key, _)| place(key));
        values.dedup_by(|(one, _), (other, _)| one == other);
    }
    if values.len() != asked.len() {
        let detail = format!("values of {} of {} variables", values.len(), asked.len());
        return Err(Refusal::new(RefusalKind::Nonsense, detail));
    }
    Ok(values.into_iter().map(|(_, value)| value).collect())
}

/// The first diagnostic, with the line of the program that it is about.
fn told(diagnostics: &[Diagnostic], source: &str) -> String {
    let Some(first) = diagnostics.first() else {
        return "without a diagnostic".to_owned();
    };
    let code = first
        .code
        .as_ref()
        .map_or(String::new(), |code| format!("{code}: "));
    let line = first
        .line
        .and_then(|line| source.lines().nth(line.saturating_sub(1) as usize));
    let place = line.map_or(String::new(), |line| format!(", at `{}`", line.trim()));
    format!("{code}{}{place}", first.message)
}
