//! The difference between the outcome of an engine and the expected one, in a few words that stay the same while a program
//! gets smaller.

use std::fmt;
use std::str::FromStr;
use stickler_engines::{Diagnostic, Outcome};
use stickler_types::{Code, Fault, Value, distinct, join};

/// A way in which an engine deviates from the expected outcome.
///
/// `Display` writes the word that `FromStr` reads: `crash`, `hang`, `error`, `rejected:P4035`, `not-rejected:P4026`,
/// `value:INT`, `missing:INT`, `fault:subscript-range`, `no-fault:division-by-zero`; for a compiler without codes
/// `rejected:` and the first words of its message.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum OutcomeSymptom {
    /// The engine crashed.
    Crash,
    /// The engine did not answer in time.
    Hang,
    /// The answer was malformed, or the engine reported a defect of its own.
    Error,
    /// The engine rejects a valid program, with this code, or with this message; empty if it gives neither.
    Rejected(String),
    /// The engine accepts a program that must be rejected with this code.
    NotRejected(String),
    /// A value of this type is wrong.
    Value(String),
    /// A requested value of this type is missing.
    Missing(String),
    /// The engine stops with a fault where the program has none, or another one.
    Fault(Fault),
    /// The engine continues where the program must stop with this fault.
    NotFaulted(Fault),
}

impl OutcomeSymptom {
    /// Returns every symptom of an outcome, the most important first; of wrong values one for each type, and checksums last.
    pub fn all(expected: &Outcome, got: &Outcome) -> Vec<OutcomeSymptom> {
        let deviations = deviations(expected, got).into_iter();
        deviations.map(|(symptom, _)| symptom).collect()
    }

    /// Returns whether `wanted`, as named by a person, means this symptom: it is the same, or the code in front of the
    /// reason, as `rejected:P0002` is of `rejected:P0002 expected a type`.
    pub fn is_meant_by(&self, wanted: &OutcomeSymptom) -> bool {
        match (self, wanted) {
            (OutcomeSymptom::Rejected(own), OutcomeSymptom::Rejected(code)) => {
                own == code
                    || own
                        .strip_prefix(code.as_str())
                        .is_some_and(|reason| reason.starts_with(' '))
            }
            _ => self == wanted,
        }
    }

    /// Returns whether an outcome shows this symptom, possibly among others.
    pub fn shows(&self, expected: &Outcome, got: &Outcome) -> bool {
        OutcomeSymptom::all(expected, got).contains(self)
    }
}

/// Returns how the outcome of an engine deviates from the values that a program must give, with a message for a person: its most important
/// symptom. `None` for an engine that gives them, or that says that it cannot.
pub fn deviation(expected: &[(String, Value)], got: &Outcome) -> Option<(OutcomeSymptom, String)> {
    let expected = Outcome::executed(expected.to_vec());
    deviations(&expected, got).into_iter().next()
}

/// Returns how an outcome deviates from the expected one, each symptom once with a message for a person, the most important first. A
/// checksum, which the generator computes from everything else, comes last: it differs because something else does, which tells more.
///
/// A program that an engine does not support is no deviation, nor are values missing from an engine that only checks programs.
fn deviations(expected: &Outcome, got: &Outcome) -> Vec<(OutcomeSymptom, String)> {
    let (symptom, message) = match (expected, got) {
        (_, Outcome::Crashed { reason }) => (OutcomeSymptom::Crash, format!("died: {reason}")),
        (_, Outcome::Unusable { .. }) => (OutcomeSymptom::Crash, got.to_string()),
        (_, Outcome::TimedOut { .. }) => (OutcomeSymptom::Hang, got.to_string()),
        (_, Outcome::Error { message }) => (OutcomeSymptom::Error, message.clone()),
        (_, Outcome::Unsupported { .. } | Outcome::NotImplemented { .. })
        | (Outcome::Rejected { .. }, Outcome::Rejected { .. }) => return Vec::new(),
        (_, Outcome::Rejected { diagnostics }) => {
            let message = match diagnostics.first() {
                Some(first) => format!("expected to be accepted, rejected: {}", diagnostic_line(first)),
                None => "expected to be accepted, rejected without a reason".to_owned(),
            };
            let names = names(diagnostics, code_or_message).into_iter();
            return names
                .map(|name| (OutcomeSymptom::Rejected(name), message.clone()))
                .collect();
        }
        (Outcome::Rejected { diagnostics }, _) => {
            let message = || "expected to be rejected, accepted".to_owned();
            let names = names(diagnostics, code).into_iter();
            return names
                .map(|name| (OutcomeSymptom::NotRejected(name), message()))
                .collect();
        }
        (Outcome::Faulted { fault, .. }, Outcome::Faulted { fault: other, .. }) if fault == other => {
            return Vec::new();
        }
        (_, Outcome::Faulted { fault, line, .. }) => {
            let line = line.map(|line| format!(" on line {line}")).unwrap_or_default();
            let message = format!("expected to run to its end, got the fault {fault}{line}");
            (OutcomeSymptom::Fault(*fault), message)
        }
        (Outcome::Faulted { fault, .. }, Outcome::Executed { .. }) => {
            let message = format!("expected the fault {fault}, ran to its end");
            (OutcomeSymptom::NotFaulted(*fault), message)
        }
        (Outcome::Executed { values: expected, .. }, Outcome::Executed { values: got, .. }) => {
            return differing_values(expected, got);
        }
        (Outcome::Executed { .. }, Outcome::Rendered { .. }) => {
            let message = "answered `rendered` where it was to run".to_owned();
            (OutcomeSymptom::Error, message)
        }
        _ => return Vec::new(),
    };
    vec![(symptom, message)]
}

/// Writes a diagnostic in one line.
pub fn diagnostic_line(diagnostic: &Diagnostic) -> String {
    let code = diagnostic.code.as_deref().unwrap_or("error");
    let line = diagnostic.line.map(|line| format!(" on line {line}"));
    format!("{code}{}: {}", line.unwrap_or_default(), diagnostic.message)
}

/// Returns the values that differ or are missing, the first of each type, and checksums last.
fn differing_values(expected: &[(String, Value)], got: &[(String, Value)]) -> Vec<(OutcomeSymptom, String)> {
    let find = |name: &str| {
        let mut got = got.iter();
        got.find(|(other, _)| other == name).map(|(_, value)| value)
    };
    let mut differing: Vec<_> = expected
        .iter()
        .filter(|(name, value)| find(name) != Some(value))
        .collect();
    differing.sort_by_key(|(name, _)| name.starts_with("checksum"));
    let mut deviations: Vec<(OutcomeSymptom, String)> = Vec::new();
    for (name, value) in differing {
        let ty = value.type_name().to_owned();
        let (symptom, got) = match find(name) {
            Some(other) => (OutcomeSymptom::Value(ty), other.to_string()),
            None => (OutcomeSymptom::Missing(ty), "no value".to_owned()),
        };
        if deviations.iter().all(|(known, _)| *known != symptom) {
            deviations.push((symptom, format!("{name}: expected {value}, got {got}")));
        }
    }
    deviations
}

/// Returns each name of the diagnostics of a rejection once; an empty one if no diagnostic has a name.
fn names(diagnostics: &[Diagnostic], name: fn(&Diagnostic) -> String) -> Vec<String> {
    let mut names = distinct(diagnostics.iter().map(name).filter(|name| !name.is_empty()));
    if names.is_empty() {
        names.push(String::new());
    }
    names
}

/// Returns the code of a diagnostic; empty if it has none.
fn code(diagnostic: &Diagnostic) -> String {
    diagnostic.code.clone().unwrap_or_default()
}

/// Returns the code of a diagnostic; without a code, the normalized message. The code for syntax errors is followed by the
/// normalized message, because it stands for all errors of a parser.
fn code_or_message(diagnostic: &Diagnostic) -> String {
    match &diagnostic.code {
        Some(code) if code == Code::SyntaxError.as_str() => {
            format!("{code} {}", normalize_message(&diagnostic.message))
                .trim_end()
                .to_owned()
        }
        Some(code) => code.clone(),
        None => normalize_message(&diagnostic.message),
    }
}

/// Normalizes the message of a compiler: keeps its first words, and drops quoted text, names and numbers, so that the
/// message of a smaller program compares equal.
fn normalize_message(message: &str) -> String {
    const MAX_WORDS: usize = 6;
    let quote = |character: char| "'\"`".contains(character);
    // Every other piece is quoted.
    let said = message.lines().next().unwrap_or_default().split(quote).step_by(2);
    let words = said.flat_map(str::split_whitespace);
    let plain = |word: &&str| {
        word.bytes()
            .all(|byte| byte.is_ascii_alphabetic() || b",.:;()-".contains(&byte))
    };
    let words = words
        .filter(plain)
        .map(|word| {
            word.trim_matches(|end: char| !end.is_ascii_alphabetic())
                .to_ascii_lowercase()
        })
        .filter(|word| !word.is_empty())
        .take(MAX_WORDS);
    join(words, " ")
}

impl fmt::Display for OutcomeSymptom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OutcomeSymptom::Crash => f.write_str("crash"),
            OutcomeSymptom::Hang => f.write_str("hang"),
            OutcomeSymptom::Error => f.write_str("error"),
            OutcomeSymptom::Rejected(code) if code.is_empty() => f.write_str("rejected"),
            OutcomeSymptom::Rejected(code) => write!(f, "rejected:{code}"),
            OutcomeSymptom::NotRejected(code) if code.is_empty() => f.write_str("not-rejected"),
            OutcomeSymptom::NotRejected(code) => write!(f, "not-rejected:{code}"),
            OutcomeSymptom::Value(ty) => write!(f, "value:{ty}"),
            OutcomeSymptom::Missing(ty) => write!(f, "missing:{ty}"),
            OutcomeSymptom::Fault(fault) => write!(f, "fault:{fault}"),
            OutcomeSymptom::NotFaulted(fault) => write!(f, "no-fault:{fault}"),
        }
    }
}

/// The error for a word that names no symptom.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error(
    "`{0}` is no symptom; write `crash`, `hang`, `error`, `rejected:CODE`, `not-rejected:CODE`, `value:TYPE`, `missing:TYPE`, \
     `fault:FAULT` or `no-fault:FAULT`"
)]
pub struct UnknownSymptom(String);

impl FromStr for OutcomeSymptom {
    type Err = UnknownSymptom;

    fn from_str(word: &str) -> Result<OutcomeSymptom, UnknownSymptom> {
        let (kind, what) = word.split_once(':').unwrap_or((word, ""));
        let unknown = || UnknownSymptom(word.to_owned());
        let fault = || what.parse::<Fault>().map_err(|_| unknown());
        Ok(match kind {
            "crash" if what.is_empty() => OutcomeSymptom::Crash,
            "hang" if what.is_empty() => OutcomeSymptom::Hang,
            "error" if what.is_empty() => OutcomeSymptom::Error,
            "rejected" => OutcomeSymptom::Rejected(what.to_owned()),
            "not-rejected" => OutcomeSymptom::NotRejected(what.to_owned()),
            "value" if !what.is_empty() => OutcomeSymptom::Value(what.to_owned()),
            "missing" if !what.is_empty() => OutcomeSymptom::Missing(what.to_owned()),
            "fault" => OutcomeSymptom::Fault(fault()?),
            "no-fault" => OutcomeSymptom::NotFaulted(fault()?),
            _ => return Err(unknown()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::check_examples;

    #[test]
    fn golden_symptoms() {
        check_examples("tests/symptoms.md", |example| {
            let symptom = |name: &str| example.text(name).parse::<OutcomeSymptom>().unwrap();
            match example.wanted() {
                "normalized" => normalize_message(example.text("message")),
                _ => symptom("shown").is_meant_by(&symptom("wanted")).to_string(),
            }
        });
    }

    #[test]
    fn a_rejection_is_named_by_its_code_or_by_what_it_says() {
        let diagnostic = |code: Option<&str>, message: &str| Diagnostic {
            code: code.map(str::to_owned),
            message: message.to_owned(),
            ..Diagnostic::default()
        };
        let rejected = Outcome::Rejected {
            diagnostics: vec![
                diagnostic(Some("P0002"), "expected 'END_IF', found v5"),
                diagnostic(Some("P4035"), "no INT"),
                diagnostic(None, "invalid operand"),
            ],
        };
        let all: Vec<String> = OutcomeSymptom::all(&Outcome::ACCEPTED, &rejected)
            .iter()
            .map(ToString::to_string)
            .collect();
        let names = [
            "rejected:P0002 expected found",
            "rejected:P4035",
            "rejected:invalid operand",
        ];
        assert_eq!(all, names);
        let must = OutcomeSymptom::all(&rejected, &Outcome::ACCEPTED);
        assert_eq!(must[0].to_string(), "not-rejected:P0002");
    }
}
