//! A session of an engine that executes programs, and gives values or the reason why there are none.

use crate::literals::{literal, untyped_literal};
use crate::program::{self, ConversionProgram};
use std::fmt;
use stickler_engines::{Diagnostic, Engine, EngineError, EngineSession, Outcome, RunRequest};
use stickler_exact::Signature;
use stickler_types::{DialectName, Fault, Value, words};

/// The reason for which an engine gave no values.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal {
    /// The kind of the refusal.
    pub kind: RefusalKind,
    /// The details as a fragment: the first diagnostic of a rejection, or the last output of a crashed engine.
    pub detail: String,
    /// The line of the program to which the first diagnostic points.
    pub line: Option<String>,
}

words! {
    /// The kind of a [`Refusal`]: the act of an engine that gives no values, as the end of a sentence that names the engine.
    RefusalKind {
        /// The engine does not support the request, or only checks programs.
        Unsupported = "does not support this",
        /// The engine rejects the program.
        Rejected = "rejected the program",
        /// The program stopped at a run-time fault.
        Faulted = "stopped at a fault",
        /// The program took more steps than the engine allows.
        TooManySteps = "took too many steps",
        /// The engine did not answer in time.
        TimedOut = "took too long",
        /// The engine crashed.
        Crashed = "crashed",
        /// The engine's answer was malformed, or lacked values.
        Nonsense = "answered nonsense",
        /// The call does not stand in the recording that was asked.
        NotAsked = "was not asked",
    }
}

impl fmt::Display for Refusal {
    /// Writes the refusal as the end of a sentence that names the engine: `rejected the program (P4017: …)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Refusal { kind, detail, line } = self;
        write!(f, "{kind} ({detail}")?;
        if let Some(line) = line {
            write!(f, ", at `{line}`")?;
        }
        f.write_str(")")
    }
}

impl RefusalKind {
    /// The kinds that a recording holds, one for each [`RefusalKind::word`].
    pub const STORED: [RefusalKind; 6] = [
        RefusalKind::Unsupported,
        RefusalKind::Rejected,
        RefusalKind::Faulted,
        RefusalKind::TimedOut,
        RefusalKind::Crashed,
        RefusalKind::Nonsense,
    ];

    /// Returns the refusal's kind in a word that fits the cell of a table: `rejected`, `crashed` …
    pub const fn word(self) -> &'static str {
        match self {
            RefusalKind::Unsupported => "unsupported",
            RefusalKind::Rejected => "rejected",
            RefusalKind::Faulted | RefusalKind::TooManySteps => "faulted",
            RefusalKind::TimedOut => "timed out",
            RefusalKind::Crashed => "crashed",
            RefusalKind::Nonsense => "error",
            RefusalKind::NotAsked => "-",
        }
    }

    /// Returns the kind of a [`RefusalKind::word`] that a recording holds.
    pub fn stored(word: &str) -> Option<RefusalKind> {
        RefusalKind::STORED.into_iter().find(|kind| kind.word() == word)
    }

    /// Returns whether the refusal is a failure of the engine: neither a rejection nor something that it does not support.
    pub const fn is_failure(self) -> bool {
        !matches!(
            self,
            RefusalKind::Unsupported | RefusalKind::Rejected | RefusalKind::NotAsked
        )
    }
}

/// A session of an engine that executes programs.
pub struct FunctionSession<'e>(EngineSession<'e>);

impl<'e> FunctionSession<'e> {
    /// Opens a session.
    ///
    /// # Errors
    /// The engine cannot open a session: [`Engine::session`].
    pub fn open(engine: &'e dyn Engine) -> Result<FunctionSession<'e>, EngineError> {
        EngineSession::open(engine).map(FunctionSession)
    }

    /// Returns the values of the variables that the program observes, in their order.
    ///
    /// # Errors
    /// The [`Refusal`] of an engine that gives no values.
    pub fn run(&mut self, dialect: DialectName, program: &ConversionProgram) -> Result<Vec<Value>, Refusal> {
        let (source, observe) = (program.source(), program.observations());
        let request = RunRequest::once(dialect, &source, &observe);
        // An engine that cannot be started again after a crash refuses all that follows.
        let outcome = self
            .0
            .run(&request)
            .unwrap_or_else(|error| Outcome::crashed(error.to_string()));
        values(outcome, program)
    }

    /// Returns the result of each call of a function. Runs all calls in one program, since compilers take their time to
    /// start; where the engine gives no values for that, runs each call in a program of its own. Where an engine rejects a program with a
    /// sign behind the type of a literal, the types are left out, since the call is asked about and not the literal.
    pub fn results(
        &mut self,
        dialect: DialectName,
        signature: &Signature,
        calls: &[Vec<Value>],
    ) -> Vec<Result<Value, Refusal>> {
        if let Ok(values) = self.list(dialect, signature, calls) {
            return values.into_iter().map(Ok).collect();
        }
        calls
            .iter()
            .map(|call| {
                let values = self.list(dialect, signature, std::slice::from_ref(call));
                values.map(|mut values| values.swap_remove(0))
            })
            .collect()
    }

    /// Runs one program with these calls.
    fn list(
        &mut self,
        dialect: DialectName,
        signature: &Signature,
        calls: &[Vec<Value>],
    ) -> Result<Vec<Value>, Refusal> {
        let Signature { function, result, .. } = signature;
        let program = program::listed(function, *result, calls, literal);
        let given = self.run(dialect, &program);
        match &given {
            Err(refusal) if refusal.kind == RefusalKind::Rejected && program.source().contains("#-") => {
                let untyped = program::listed(function, *result, calls, untyped_literal);
                self.run(dialect, &untyped).or(given)
            }
            _ => given,
        }
    }
}

/// Returns the values of the variables that a program observes from its outcome, or the reason why there are none.
fn values(outcome: Outcome, program: &ConversionProgram) -> Result<Vec<Value>, Refusal> {
    let line = match &outcome {
        Outcome::Rejected { diagnostics } => line_of(diagnostics, &program.source()),
        _ => None,
    };
    let kind = refusal_kind(&outcome);
    let detail = match outcome {
        Outcome::Executed { values, .. } => return in_order(values, program),
        Outcome::Accepted { .. } => "it accepts programs and executes none".to_owned(),
        Outcome::Unsupported { reason } | Outcome::NotImplemented { reason } => reason,
        Outcome::Rejected { diagnostics } => first_message(&diagnostics),
        Outcome::Faulted { fault, .. } => fault.as_str().to_owned(),
        Outcome::Crashed { reason } | Outcome::Unusable { reason } => reason,
        Outcome::TimedOut { .. } => outcome.to_string(),
        Outcome::Error { message } => message,
        Outcome::Rendered { .. } => "it rendered what it was to run".to_owned(),
    };
    Err(Refusal { kind, detail, line })
}

/// Returns the kind of the reason why an outcome has no values; [`RefusalKind::NotAsked`] where it has some.
pub(crate) fn refusal_kind(outcome: &Outcome) -> RefusalKind {
    match outcome {
        Outcome::Executed { .. } => RefusalKind::NotAsked,
        Outcome::Accepted { .. } | Outcome::Unsupported { .. } | Outcome::NotImplemented { .. } => {
            RefusalKind::Unsupported
        }
        Outcome::Rejected { .. } => RefusalKind::Rejected,
        Outcome::Faulted { fault, .. } if *fault == Fault::StepLimit => RefusalKind::TooManySteps,
        Outcome::Faulted { .. } => RefusalKind::Faulted,
        Outcome::Crashed { .. } | Outcome::Unusable { .. } => RefusalKind::Crashed,
        Outcome::TimedOut { .. } => RefusalKind::TimedOut,
        Outcome::Error { .. } | Outcome::Rendered { .. } => RefusalKind::Nonsense,
    }
}

/// Returns values in the order in which the program lists its observed variables; engines may answer in another.
fn in_order(mut values: Vec<(String, Value)>, program: &ConversionProgram) -> Result<Vec<Value>, Refusal> {
    let asked = &program.observed;
    if values.len() != asked.len() || values.iter().zip(asked).any(|((key, _), name)| key != name) {
        let place = |key: &str| asked.iter().position(|name| name == key);
        values.retain(|(key, _)| place(key).is_some());
        values.sort_by_key(|(key, _)| place(key));
        values.dedup_by(|(one, _), (other, _)| one == other);
    }
    if values.len() != asked.len() {
        let detail = format!("values of {} of {} variables", values.len(), asked.len());
        return Err(Refusal {
            kind: RefusalKind::Nonsense,
            detail,
            line: None,
        });
    }
    Ok(values.into_iter().map(|(_, value)| value).collect())
}

/// Returns the text of the first diagnostic.
fn first_message(diagnostics: &[Diagnostic]) -> String {
    match diagnostics.first() {
        Some(Diagnostic {
            code: Some(code),
            message,
            ..
        }) => format!("{code}: {message}"),
        Some(first) => first.message.clone(),
        None => "without a diagnostic".to_owned(),
    }
}

/// Returns the line of a program to which the first diagnostic points.
fn line_of(diagnostics: &[Diagnostic], source: &str) -> Option<String> {
    let line = diagnostics.first()?.line?;
    let text = source.lines().nth(line.saturating_sub(1) as usize)?;
    Some(text.trim().to_owned())
}
