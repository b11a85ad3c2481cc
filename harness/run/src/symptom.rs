//! Classifies the deviation of an engine in a case by a symptom, from the expected and the actual facts.

mod normalize;
mod rejection;

use crate::{CaseEvent, Fact, Grade, Verdict};
use normalize::normalize_message;
use rejection::rejection;
use std::fmt;
use stickler_types::{Diagnostic, Fault};

/// A symptom; cases of one rule with the same symptom most probably have one cause. The words of the symptoms are those of
/// findings.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Symptom {
    /// The engine crashed; holds its normalized message.
    Crash(String),
    /// The engine accepts a program and makes of it what cannot be built or dies; holds the normalized message.
    Unusable(String),
    /// The engine gave no answer in time.
    Hang,
    /// The engine gave an invalid answer; holds the normalized description.
    Error(String),
    /// The engine rejects a program that must be accepted; holds its code or normalized message, or nothing where it gave
    /// neither.
    Rejected(String),
    /// The engine does not implement a construct that a document promises; holds its normalized message.
    NotImplemented(String),
    /// The engine accepts a program that must be rejected; holds the expected code, or nothing where any will do.
    NotRejected(String),
    /// The engine rejects the program for another reason.
    OtherCode {
        /// The expected code.
        code: String,
        /// The code or normalized message of the first diagnostic that is not expected; empty where there is none.
        reported: String,
    },
    /// The engine reports a mistake without its place: with no line, or at line 1, column 1; holds the code or normalized
    /// message of the diagnostic.
    NoPlace(String),
    /// The engine reports the mistake on another line; holds the expected code.
    OtherLine(String),
    /// The engine reports some of the mistakes; holds the code of a missing one.
    Incomplete(String),
    /// The engine reports all mistakes and another one; holds the code or normalized message of the latter.
    Surplus(String),
    /// The engine does not warn of what it must warn of; holds the expected code.
    NotWarned(String),
    /// The engine warns on a line that must have no diagnostic; holds the code or normalized message of the warning.
    Warned(String),
    /// The engine stops with a fault where it must stop with none or with another one; holds the actual fault, or the
    /// engine's own words for it, normalized.
    Fault(String),
    /// The engine stops with the expected fault, but names another line or none; holds the fault.
    FaultLine(String),
    /// The engine continues where the program must stop with a fault; holds the expected fault.
    NotFaulted(String),
    /// The engine computes a wrong value.
    Value,
    /// The engine gives a value of another type than that of its variable.
    OtherType,
    /// The engine does not give a value.
    Missing,
    /// The engine renders another text.
    Text,
}

impl Symptom {
    /// Returns the symptom of a case that did not come out as expected. `strict` is the worst grade of a rejection that
    /// still passed.
    pub fn of(case: &CaseEvent, strict: Grade) -> Symptom {
        Symptom::of_facts(case.actual_verdict(), (&case.expected, &case.got), strict)
    }

    /// Returns the symptom of a verdict, the expected and the actual facts. `strict` is the worst grade of a rejection that
    /// still passed.
    pub fn of_facts(verdict: Verdict, (expected, got): (&[Fact], &[Fact]), strict: Grade) -> Symptom {
        if let [Fact::Unusable { reason }] = got {
            return Symptom::Unusable(normalize_message(reason));
        }
        let words = got.iter().find_map(|fact| match (verdict, fact) {
            (Verdict::Crash, Fact::Crashed { reason: text })
            | (Verdict::Error, Fact::Error { message: text }) => Some(normalize_message(text)),
            (Verdict::Crash | Verdict::Error, _) => None,
            (_, Fact::NotImplemented { reason, .. }) => Some(normalize_message(reason)),
            _ => None,
        });
        match (verdict, words) {
            (Verdict::Crash, words) => return Symptom::Crash(words.unwrap_or_default()),
            (Verdict::Timeout, _) => return Symptom::Hang,
            (Verdict::Error, words) => return Symptom::Error(words.unwrap_or_default()),
            (_, Some(words)) => return Symptom::NotImplemented(words),
            (_, None) => {}
        }
        let is_missing = |fact: &Fact| matches!(fact, Fact::MissingValue { .. });
        match (rejects(expected), rejects(got)) {
            (true, true) => rejection(&diagnostics(expected), &diagnostics(got), strict),
            (true, false) => Symptom::NotRejected(first_reason(expected)),
            // The program may be rejected, but a diagnostic names a line without a mistake.
            (false, true) if expected.contains(&Fact::AcceptedOrRejected) => {
                Symptom::Surplus(first_reason(got))
            }
            (false, true) => Symptom::Rejected(first_reason(got)),
            (false, false) => fault(expected, got)
                .or_else(|| value(expected, got))
                .or_else(|| fault_line(expected, got, strict))
                .or_else(|| got.iter().any(is_missing).then_some(Symptom::Missing))
                .or_else(|| warning(expected, got))
                .unwrap_or(Symptom::Text),
        }
    }

    /// Returns the symptom as a part of a file name.
    pub fn word(&self) -> String {
        match self {
            // The message of a crash would fill the name of the file.
            Symptom::Crash(_) | Symptom::Unusable(_) | Symptom::Error(_) | Symptom::NotImplemented(_) => {
                self.words().0.to_owned()
            }
            _ => match self.words() {
                (word, "") => word.to_owned(),
                (word, about) => format!("{word}-{about}"),
            },
        }
    }

    /// Returns the word of the symptom, and the code, message or fault that it holds.
    fn words(&self) -> (&'static str, &str) {
        match self {
            Symptom::Crash(words) => ("crash", words),
            Symptom::Unusable(words) => ("unusable", words),
            Symptom::Hang => ("hang", ""),
            Symptom::Error(words) => ("error", words),
            Symptom::Rejected(reason) => ("rejected", reason),
            Symptom::NotImplemented(words) => ("not-implemented", words),
            Symptom::NotRejected(code) => ("not-rejected", code),
            Symptom::OtherCode { code, .. } => ("not", code),
            Symptom::NoPlace(code) => ("no-place-of", code),
            Symptom::OtherLine(code) => ("line-of", code),
            Symptom::Incomplete(code) => ("incomplete", code),
            Symptom::Surplus(reason) => ("surplus", reason),
            Symptom::NotWarned(code) => ("not-warned", code),
            Symptom::Warned(reason) => ("warned", reason),
            Symptom::Fault(fault) => ("fault", fault),
            Symptom::FaultLine(fault) => ("line-of", fault),
            Symptom::NotFaulted(fault) => ("not-faulted", fault),
            Symptom::Value => ("value", ""),
            Symptom::OtherType => ("other-type", ""),
            Symptom::Missing => ("missing", ""),
            Symptom::Text => ("text", ""),
        }
    }

    /// Returns the symptom as a sentence; `{}` is what it holds, which otherwise follows in brackets.
    const fn sentence(&self) -> &'static str {
        match self {
            Symptom::Crash(_) => "it dies",
            Symptom::Unusable(_) => "it accepts a program and makes nothing of use of it",
            Symptom::Hang => "it gives no answer",
            Symptom::Error(_) => "its answer makes no sense",
            Symptom::Rejected(_) => "it rejects what must be accepted",
            Symptom::NotImplemented(_) => "it does not implement what is promised",
            Symptom::NotRejected(_) => "it accepts what must be rejected",
            Symptom::OtherCode { .. } => "it rejects, but for another reason than {}",
            Symptom::NoPlace(_) => "it does not report the place of a mistake",
            Symptom::OtherLine(_) => "it names another place for {}",
            Symptom::Incomplete(_) => "it does not report every mistake ({} is missing)",
            Symptom::Surplus(_) => "it reports more mistakes than there are",
            Symptom::NotWarned(_) => "it does not warn",
            Symptom::Warned(_) => "it warns where there is nothing to warn of",
            Symptom::Fault(_) => "it stops ({}) where the program must not, or with another fault",
            Symptom::FaultLine(_) => "it does not report the line where the program stops",
            Symptom::NotFaulted(_) => "it goes on where the program must stop",
            Symptom::Value => "it computes another value",
            Symptom::OtherType => "it gives a value of another type than that of its variable",
            Symptom::Missing => "it does not show a value",
            Symptom::Text => "it gives back another text",
        }
    }
}

impl fmt::Display for Symptom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (_, held) = self.words();
        let in_brackets = match self {
            Symptom::OtherCode { reported, .. } => reported,
            _ if self.sentence().contains("{}") => "",
            _ => held,
        };
        f.write_str(&self.sentence().replace("{}", held))?;
        match in_brackets {
            "" => Ok(()),
            words => write!(f, " ({words})"),
        }
    }
}

fn rejects(facts: &[Fact]) -> bool {
    let rejects = |fact: &Fact| {
        matches!(
            fact,
            Fact::Diagnostic(_) | Fact::Rejected | Fact::RejectedSilently
        )
    };
    facts.iter().any(rejects)
}

fn diagnostics(facts: &[Fact]) -> Vec<&Diagnostic> {
    facts.iter().filter_map(Fact::diagnostic).collect()
}

/// Returns the code of a diagnostic; without a code, the normalized message.
fn reason(diagnostic: &Diagnostic) -> String {
    match &diagnostic.code {
        Some(code) => code.clone(),
        None => normalize_message(&diagnostic.message),
    }
}

fn first_reason(facts: &[Fact]) -> String {
    Fact::first_error(facts).map(reason).unwrap_or_default()
}

/// Returns the symptom where warnings differ. A missing warning counts before one that is not expected, which may be its other form.
fn warning(expected: &[Fact], got: &[Fact]) -> Option<Symptom> {
    let unmet = |these: &[Fact], others: &[Fact]| {
        these.iter().find_map(|fact| match fact {
            Fact::Warning(warning) if !others.contains(fact) => Some(reason(warning)),
            _ => None,
        })
    };
    let missing = unmet(expected, got).map(Symptom::NotWarned);
    missing.or_else(|| unmet(got, expected).map(Symptom::Warned))
}

/// Returns the fault among these facts, with its line.
fn fault_of(facts: &[Fact]) -> Option<(Fault, Option<u32>)> {
    facts.iter().find_map(|fact| match fact {
        Fact::Fault { fault, line } => Some((*fault, *line)),
        _ => None,
    })
}

fn fault(expected: &[Fact], got: &[Fact]) -> Option<Symptom> {
    match (fault_of(expected), fault_of(got)) {
        (None, None) => None,
        (Some((wanted, _)), Some((reported, _))) if wanted == reported => None,
        (_, Some((Fault::Own(words), _))) => {
            let normal = normalize_message(words);
            // A code is a word with a digit.
            Some(Symptom::Fault(if normal.is_empty() {
                words.to_owned()
            } else {
                normal
            }))
        }
        (_, Some((reported, _))) => Some(Symptom::Fault(reported.to_string())),
        (Some((wanted, _)), None) => Some(Symptom::NotFaulted(wanted.to_string())),
    }
}

/// Returns the symptom of the expected fault on another line, where lines are compared.
fn fault_line(expected: &[Fact], got: &[Fact], strict: Grade) -> Option<Symptom> {
    let ((fault, wanted), (_, reported)) = (fault_of(expected)?, fault_of(got)?);
    (strict != Grade::Rejected && wanted != reported).then(|| Symptom::FaultLine(fault.to_string()))
}

fn value(expected: &[Fact], got: &[Fact]) -> Option<Symptom> {
    let differ = |wanted: &Fact, reported: &Fact| match (wanted, reported) {
        (
            Fact::Value { name, value },
            Fact::Value {
                name: same,
                value: other,
            },
        ) => name == same && value != other,
        (Fact::Value { name, .. }, Fact::OtherValue { name: same }) => name == same,
        _ => false,
    };
    let type_of = |fact: &Fact| match fact {
        Fact::Value { value, .. } => Some(value.type_name().to_owned()),
        _ => None,
    };
    let differing = expected.iter().find_map(|wanted| {
        let reported = got.iter().find(|reported| differ(wanted, reported))?;
        Some((type_of(wanted), type_of(reported)))
    });
    differing.map(
        |(wanted, reported)| match reported.is_some() && wanted != reported {
            true => Symptom::OtherType,
            false => Symptom::Value,
        },
    )
}
