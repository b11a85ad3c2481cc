//! How an engine's outcome differs from what must come, in a few words that stay the same while a program gets smaller.

use std::fmt;
use std::str::FromStr;
use stickler_engines::Outcome;
use stickler_types::Fault;

/// A way in which an engine does not do what it must.
///
/// `Display` writes the word that `FromStr` reads: `crash`, `hang`, `error`, `rejected:P4035`, `not-rejected:P4026`,
/// `value:INT`, `missing:INT`, `fault:subscript-range`, `no-fault:division-by-zero`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Symptom {
    /// It died.
    Crash,
    /// It did not answer in time.
    Hang,
    /// It answered nonsense, or found a defect of its own.
    Error,
    /// It rejects an acceptable program, with this code; empty where it tells none.
    Rejected(String),
    /// It accepts a program that must be rejected with this code.
    NotRejected(String),
    /// A value of this type is wrong.
    Value(String),
    /// A value of this type that was asked for is not told.
    Missing(String),
    /// It stops with a fault where the program has none, or has another.
    Fault(Fault),
    /// It goes on where the program must stop with this fault.
    NotFaulted(Fault),
}

impl Symptom {
    /// Every symptom of an outcome, the most telling first: of values that of each type, in the order of `expected`.
    ///
    /// What an engine says it does not support is no symptom, and neither is it that one which only checks tells no values.
    #[must_use]
    pub fn all(expected: &Outcome, got: &Outcome) -> Vec<Symptom> {
        let symptom = match (expected, got) {
            (_, Outcome::Crashed { .. }) => Symptom::Crash,
            (_, Outcome::TimedOut { .. }) => Symptom::Hang,
            (_, Outcome::Error { .. }) => Symptom::Error,
            (_, Outcome::Unsupported { .. }) => return Vec::new(),
            (Outcome::Rejected { .. }, Outcome::Rejected { .. }) => return Vec::new(),
            (_, Outcome::Rejected { .. }) => return rejections(got).map(Symptom::Rejected).collect(),
            (Outcome::Rejected { .. }, _) => return rejections(expected).map(Symptom::NotRejected).collect(),
            (Outcome::Faulted { fault, .. }, Outcome::Faulted { fault: other, .. }) if fault == other => {
                return Vec::new();
            }
            (_, Outcome::Faulted { fault, .. }) => Symptom::Fault(*fault),
            (Outcome::Faulted { fault, .. }, Outcome::Executed { .. }) => Symptom::NotFaulted(*fault),
            (Outcome::Executed { values: expected }, Outcome::Executed { values: got }) => {
                return values(expected, got);
            }
            _ => return Vec::new(),
        };
        vec![symptom]
    }

    /// The first of [`Symptom::all`].
    #[must_use]
    pub fn first(expected: &Outcome, got: &Outcome) -> Option<Symptom> {
        Symptom::all(expected, got).into_iter().next()
    }

    /// Whether an outcome shows this symptom, among others perhaps.
    #[must_use]
    pub fn shows(&self, expected: &Outcome, got: &Outcome) -> bool {
        Symptom::all(expected, got).contains(self)
    }
}

/// The codes of a rejection, each once; one empty code where none is told.
fn rejections(outcome: &Outcome) -> impl Iterator<Item = String> {
    let mut codes: Vec<String> = match outcome {
        Outcome::Rejected { diagnostics } => {
            let told = diagnostics
                .iter()
                .filter_map(|diagnostic| diagnostic.code.clone());
            told.collect()
        }
        _ => Vec::new(),
    };
    let mut seen = Vec::new();
    codes.retain(|code| {
        let new = !seen.contains(code);
        seen.push(code.clone());
        new
    });
    if codes.is_empty() {
        codes.push(String::new());
    }
    codes.into_iter()
}

fn values(
    expected: &[(String, stickler_types::Value)],
    got: &[(String, stickler_types::Value)],
) -> Vec<Symptom> {
    let mut symptoms = Vec::new();
    for (name, value) in expected {
        let symptom = match got.iter().find(|(told, _)| told == name) {
            Some((_, told)) if told == value => continue,
            Some(_) => Symptom::Value(value.type_name().to_owned()),
            None => Symptom::Missing(value.type_name().to_owned()),
        };
        if !symptoms.contains(&symptom) {
            symptoms.push(symptom);
        }
    }
    symptoms
}

impl fmt::Display for Symptom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Symptom::Crash => f.write_str("crash"),
            Symptom::Hang => f.write_str("hang"),
            Symptom::Error => f.write_str("error"),
            Symptom::Rejected(code) if code.is_empty() => f.write_str("rejected"),
            Symptom::Rejected(code) => write!(f, "rejected:{code}"),
            Symptom::NotRejected(code) if code.is_empty() => f.write_str("not-rejected"),
            Symptom::NotRejected(code) => write!(f, "not-rejected:{code}"),
            Symptom::Value(ty) => write!(f, "value:{ty}"),
            Symptom::Missing(ty) => write!(f, "missing:{ty}"),
            Symptom::Fault(fault) => write!(f, "fault:{fault}"),
            Symptom::NotFaulted(fault) => write!(f, "no-fault:{fault}"),
        }
    }
}

/// A word that names no symptom.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownSymptom(String);

impl fmt::Display for UnknownSymptom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "`{}` is no symptom; write `crash`, `hang`, `error`, `rejected:CODE`, `not-rejected:CODE`, `value:TYPE`, \
             `missing:TYPE`, `fault:FAULT` or `no-fault:FAULT`",
            self.0
        )
    }
}

impl std::error::Error for UnknownSymptom {}

impl FromStr for Symptom {
    type Err = UnknownSymptom;

    fn from_str(word: &str) -> Result<Symptom, UnknownSymptom> {
        let (kind, what) = word.split_once(':').unwrap_or((word, ""));
        let unknown = || UnknownSymptom(word.to_owned());
        let fault = || what.parse::<Fault>().map_err(|_| unknown());
        Ok(match kind {
            "crash" if what.is_empty() => Symptom::Crash,
            "hang" if what.is_empty() => Symptom::Hang,
            "error" if what.is_empty() => Symptom::Error,
            "rejected" => Symptom::Rejected(what.to_owned()),
            "not-rejected" => Symptom::NotRejected(what.to_owned()),
            "value" if !what.is_empty() => Symptom::Value(what.to_owned()),
            "missing" if !what.is_empty() => Symptom::Missing(what.to_owned()),
            "fault" => Symptom::Fault(fault()?),
            "no-fault" => Symptom::NotFaulted(fault()?),
            _ => return Err(unknown()),
        })
    }
}
