//! Comparing what an engine did with what the evaluator gives.

use stickler_engines::{Diagnostic, Outcome};
use stickler_generate::reduce::OutcomeSymptom;
use stickler_types::{DialectName, Value};

/// A program that an engine is asked to run, with the values that it must give.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JudgedProgram<'a> {
    /// The dialect of the program.
    pub(crate) dialect: DialectName,
    /// The text of the program.
    pub(crate) text: &'a str,
    /// The variables that are observed at the end of one scan, with the values that they must have.
    pub(crate) values: &'a [(String, Value)],
    /// Whether an engine must accept the program and give these values. Where something happens that no document settles, it need
    /// not.
    pub(crate) binds: bool,
}

/// The result of a comparison.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Agreement {
    /// The engine did what it must.
    Agrees,
    /// The engine says that it cannot do this.
    Unsupported,
    /// The engine did something else than it must.
    Disagrees(EngineDisagreement),
}

/// The way in which an engine did something else than it must.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct EngineDisagreement {
    /// The text of a [`OutcomeSymptom`], which stays the same when the program is made smaller.
    pub(crate) symptom: String,
    /// A message for a person.
    pub(crate) message: String,
}

impl Agreement {
    fn disagrees(symptom: OutcomeSymptom, message: impl Into<String>) -> Agreement {
        Agreement::Disagrees(EngineDisagreement {
            symptom: symptom.to_string(),
            message: message.into(),
        })
    }

    /// Returns the symptom of a disagreement.
    pub(crate) fn symptom(&self) -> Option<&str> {
        match self {
            Agreement::Disagrees(disagreement) => Some(&disagreement.symptom),
            Agreement::Agrees | Agreement::Unsupported => None,
        }
    }
}

/// Compares an outcome with what was asked. Where an engine is not bound, only what no program excuses counts: to die, to
/// hang, to answer nonsense.
pub(crate) fn compare(question: JudgedProgram<'_>, outcome: &Outcome) -> Agreement {
    let JudgedProgram {
        values: expected,
        binds,
        ..
    } = question;
    match outcome {
        Outcome::Unsupported { .. } | Outcome::NotImplemented { .. } => Agreement::Unsupported,
        Outcome::Accepted { .. } => Agreement::Agrees,
        Outcome::Executed { values, .. } if binds => values_agree(expected, values),
        Outcome::Rejected { diagnostics } if binds => rejected(diagnostics),
        Outcome::Faulted { fault, line, .. } if binds => {
            let line = line.map(|line| format!(" on line {line}")).unwrap_or_default();
            Agreement::disagrees(
                OutcomeSymptom::Fault(*fault),
                format!("expected to run to its end, got the fault {fault}{line}"),
            )
        }
        Outcome::Executed { .. } | Outcome::Rejected { .. } | Outcome::Faulted { .. } => Agreement::Agrees,
        Outcome::Rendered { .. } => {
            Agreement::disagrees(OutcomeSymptom::Error, "answered `rendered` where it was to run")
        }
        Outcome::Crashed { reason } => Agreement::disagrees(OutcomeSymptom::Crash, format!("died: {reason}")),
        Outcome::Unusable { .. } => Agreement::disagrees(OutcomeSymptom::Crash, outcome.to_string()),
        Outcome::TimedOut { .. } => Agreement::disagrees(OutcomeSymptom::Hang, outcome.to_string()),
        Outcome::Error { message } => Agreement::disagrees(OutcomeSymptom::Error, message.as_str()),
    }
}

fn rejected(diagnostics: &[Diagnostic]) -> Agreement {
    let message = match diagnostics.first() {
        Some(first) => format!("expected to be accepted, rejected: {}", diagnostic(first)),
        None => "expected to be accepted, rejected without a reason".to_owned(),
    };
    Agreement::disagrees(OutcomeSymptom::rejected(diagnostics), message)
}

/// Writes a diagnostic in one line.
pub(crate) fn diagnostic(diagnostic: &Diagnostic) -> String {
    let mut text = diagnostic.code.clone().unwrap_or_else(|| "error".to_owned());
    if let Some(line) = diagnostic.line {
        text.push_str(&format!(" on line {line}"));
    }
    text.push_str(": ");
    text.push_str(&diagnostic.message);
    text
}

fn values_agree(expected: &[(String, Value)], got: &[(String, Value)]) -> Agreement {
    let differing = expected
        .iter()
        .filter(|(name, value)| find(got, name) != Some(value));
    // A checksum differs because something else does, which tells more.
    let Some((name, value)) = differing.min_by_key(|(name, _)| is_checksum(name)) else {
        return Agreement::Agrees;
    };
    let ty = value.type_name();
    match find(got, name) {
        Some(other) => Agreement::disagrees(
            OutcomeSymptom::Value(ty.to_owned()),
            format!("{name}: expected {value}, got {other}"),
        ),
        None => Agreement::disagrees(
            OutcomeSymptom::Missing(ty.to_owned()),
            format!("{name}: expected {value}, got no value"),
        ),
    }
}

fn find<'v>(values: &'v [(String, Value)], name: &str) -> Option<&'v Value> {
    values
        .iter()
        .find(|(other, _)| other == name)
        .map(|(_, value)| value)
}

/// Returns whether the generator computes this variable from everything else.
fn is_checksum(name: &str) -> bool {
    name.starts_with("checksum")
}
