//! Facts: what a case expects and what an engine did, as typed data until a report prints them.

use serde::{Deserialize, Serialize};
use std::fmt;
use stickler_types::{Diagnostic, Fault, Fnv1a, Outcome, Value, join};

/// One thing that a case expects, or that an engine did.
///
/// `Display` gives the words in which every report shows a fact: one line, or one line of text for each line of a rendered
/// source. As JSON a fact is an object tagged by `fact`, such as `{"fact":"value","name":"r","value":"INT#5"}`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "fact", rename_all = "kebab-case")]
pub enum Fact {
    /// The program is accepted.
    Accepted,
    /// The program is accepted by an engine that did not execute it, although the case expects values or a fault of its execution.
    NotExecuted,
    /// The program is rejected, with any diagnostics.
    Rejected,
    /// The program is rejected, and the engine gives no diagnostic.
    RejectedSilently,
    /// The program may be accepted or rejected: no document decides.
    AcceptedOrRejected,
    /// The engine reports an error. An expected diagnostic has a line and a code and no message; so has an actual one
    /// that matches it.
    Diagnostic(Diagnostic),
    /// The engine accepts the program with a warning. An expected warning, and an actual one that matches it, has a line and a code and
    /// no message.
    Warning(Diagnostic),
    /// The engine gave further diagnostics, which are only counted.
    MoreDiagnostics {
        /// The number of further diagnostics.
        number: usize,
    },
    /// The execution stops with a fault.
    Fault {
        /// The kind of fault; in JSON its word, which may be one of the compiler.
        #[cfg_attr(feature = "schema", schemars(with = "String"))]
        fault: Fault,
        /// The line (from 1) on which it stops; `None` where the engine does not name it.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        line: Option<u32>,
    },
    /// A variable has a value.
    Value {
        /// The variable by the name under which it was asked for: `q`, `a[1]`, `q@3` after the third scan.
        name: String,
        /// The value of the variable; in JSON a typed literal.
        #[cfg_attr(feature = "schema", schemars(with = "String"))]
        #[serde(deserialize_with = "stickler_types::deserialize_expected")]
        value: Value,
    },
    /// The engine did not give the value of a variable.
    MissingValue {
        /// The name of the variable.
        name: String,
    },
    /// A variable differs from the expected value, and the engine cannot tell what value it has.
    OtherValue {
        /// The name of the variable.
        name: String,
    },
    /// The engine rendered a source; holds the lines of its bodies.
    Rendered {
        /// The lines of the bodies; at least one.
        lines: Vec<String>,
    },
    /// Rendering a program gave no text.
    NotRendered {
        /// Whether the program was itself the result of rendering.
        again: bool,
        /// The message of the first diagnostic, where the program was rejected, and the line of a rendered one.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rejection: Option<String>,
    },
    /// Rendering a rendered program changed its text.
    RenderedOtherwise {
        /// The first line (from 1) of the text that changed.
        line: usize,
        /// The text of that line after rendering again.
        text: String,
    },
    /// The rendered program behaves differently from the program.
    RenderedMeansOther,
    /// The engine states that it does not support the request.
    Unsupported {
        /// The engine's reason, as a fragment.
        reason: String,
    },
    /// The engine does not take the minimal program of a feature that the program uses.
    Lacks {
        /// The key of the feature in `features.toml`.
        feature: String,
        /// The feature in the words of a sentence.
        title: String,
        /// The basis of the case, where it is a document that promises this compiler a program which uses no other feature.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        promised_by: Option<String>,
    },
    /// The engine also rejects a program with the same constructs and without a mistake, so that its rejection tells nothing.
    RejectsAlso {
        /// The id of the case with that program.
        case: String,
    },
    /// The compiler states that it does not implement a construct of the program.
    NotImplemented {
        /// The compiler's message, as a fragment.
        reason: String,
        /// The basis of the case, where it is a document that promises the construct of this compiler.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        promised_by: Option<String>,
    },
    /// The program is accepted, and what the compiler made of it cannot be built or dies.
    Unusable {
        /// The reason why the result is of no use, as a fragment: `the C that it wrote cannot be built: …`.
        reason: String,
    },
    /// The engine crashed.
    Crashed {
        /// The signal, exit code or message that is known of the crash, as a fragment.
        reason: String,
    },
    /// The engine did not answer in time.
    TimedOut {
        /// The time limit, in milliseconds.
        after_ms: u64,
    },
    /// The engine did not understand the request, or its answer is invalid.
    Error {
        /// The description of the error, as a fragment.
        message: String,
    },
    /// A report left out the text of further facts.
    LeftOut {
        /// The number of lines of text that were left out.
        lines: usize,
    },
}

impl Fact {
    /// Returns the text of several facts: their lines in order, joined by line feeds.
    pub fn text(facts: &[Fact]) -> String {
        join(facts, "\n")
    }

    /// Returns a fingerprint of several facts: a hash of their text, the same on every machine and in every version.
    pub fn fingerprint(facts: &[Fact]) -> u32 {
        let mut hash = Fnv1a::default();
        for fact in facts {
            hash.write(format!("{fact}\n"));
        }
        hash.folded()
    }

    /// Returns the error, where the fact is one.
    pub fn diagnostic(&self) -> Option<&Diagnostic> {
        match self {
            Fact::Diagnostic(diagnostic) => Some(diagnostic),
            _ => None,
        }
    }

    /// Returns the error among some facts that says most: the first one, or the first behind it on its line. Of a statement with a wrong part
    /// a compiler often says first, at its beginning, what only follows; of what it cannot read it says it last.
    pub fn first_error(facts: &[Fact]) -> Option<&Diagnostic> {
        let mut errors = facts.iter().filter_map(Fact::diagnostic);
        let first = errors.next()?;
        let is_unread = first.code.as_deref().is_some_and(|code| code.starts_with("P0"));
        let mut inner = errors.filter(|error| error.line == first.line && error.column > first.column);
        match first.column {
            Some(_) if !is_unread => inner.next().or(Some(first)),
            _ => Some(first),
        }
    }

    /// Returns how many lines the text of the fact has.
    pub fn lines(&self) -> usize {
        match self {
            Fact::Rendered { lines } => lines.len(),
            _ => 1,
        }
    }

    /// Returns the texts of foreign origin, which may have any length.
    pub(crate) fn texts_mut(&mut self) -> Vec<&mut String> {
        match self {
            Fact::Rendered { lines } => lines.iter_mut().collect(),
            Fact::Diagnostic(diagnostic) | Fact::Warning(diagnostic) => {
                let Diagnostic {
                    message,
                    code,
                    suggestion,
                    ..
                } = diagnostic;
                std::iter::once(message).chain(code).chain(suggestion).collect()
            }
            Fact::NotRendered { rejection: text, .. } => text.iter_mut().collect(),
            Fact::RenderedOtherwise { text, .. }
            | Fact::Unsupported { reason: text }
            | Fact::NotImplemented { reason: text, .. }
            | Fact::Unusable { reason: text }
            | Fact::Crashed { reason: text }
            | Fact::Error { message: text } => vec![text],
            _ => Vec::new(),
        }
    }
}

impl fmt::Display for Fact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fact::Accepted => f.write_str("accepted"),
            Fact::NotExecuted => f.write_str("accepted, and not executed"),
            Fact::Rejected => f.write_str("rejected"),
            Fact::RejectedSilently => f.write_str("rejected, with no diagnostic"),
            Fact::AcceptedOrRejected => f.write_str("accepted or rejected"),
            Fact::Diagnostic(diagnostic) | Fact::Warning(diagnostic) => write_diagnostic(f, diagnostic),
            Fact::MoreDiagnostics { number } => write!(f, "and {number} diagnostics more"),
            Fact::Fault {
                fault,
                line: Some(line),
            } => write!(f, "line {line}: fault {fault}"),
            Fact::Fault { fault, line: None } => write!(f, "fault {fault}"),
            Fact::Value { name, value } => write!(f, "{} = {value}", OneLine(name)),
            Fact::MissingValue { name } => write!(f, "{} is missing", OneLine(name)),
            Fact::OtherValue { name } => write!(f, "{} is another value", OneLine(name)),
            Fact::Rendered { lines } => f.write_str(&join(lines.iter().map(|line| OneLine(line)), "\n")),
            Fact::NotRendered { again, rejection } => {
                f.write_str(if *again {
                    "rendering the rendered text"
                } else {
                    "rendering"
                })?;
                match rejection {
                    Some(message) => write!(f, " was rejected: {}", OneLine(message)),
                    None => f.write_str(" gave no text"),
                }
            }
            Fact::RenderedOtherwise { line, text } => {
                write!(f, "rendered again, line {line} of the text is: {}", OneLine(text))
            }
            Fact::RenderedMeansOther => f.write_str("the rendered program does something else"),
            Fact::Unsupported { reason } => write!(f, "unsupported: {}", OneLine(reason)),
            Fact::Lacks { title, .. } => write!(f, "the engine lacks {}", OneLine(title)),
            Fact::RejectsAlso { case } => {
                write!(f, "rejected, as {}, which has no mistake", OneLine(case))
            }
            Fact::NotImplemented { reason, promised_by } => {
                f.write_str("not implemented")?;
                if let Some(basis) = promised_by {
                    write!(f, ", though promised by {}", OneLine(basis))?;
                }
                write!(f, ": {}", OneLine(reason))
            }
            Fact::Unusable { reason } => write!(f, "accepted, but {}", OneLine(reason)),
            Fact::Crashed { reason } => write!(f, "crashed: {}", OneLine(reason)),
            Fact::TimedOut { after_ms } => write!(f, "no answer within {}", Outcome::limit(*after_ms)),
            Fact::Error { message } => write!(f, "error: {}", OneLine(message)),
            Fact::LeftOut { lines } => write!(f, "... {lines} lines more"),
        }
    }
}

/// Writes `line 6: error P4035: …`, or `line 6: warning C0195: …`; every report begins with the place.
fn write_diagnostic(f: &mut fmt::Formatter<'_>, diagnostic: &Diagnostic) -> fmt::Result {
    match diagnostic.line {
        Some(line) => write!(f, "line {line}: ")?,
        None => f.write_str("somewhere: ")?,
    }
    write!(f, "{} ", diagnostic.severity.as_str())?;
    let code = match (&diagnostic.code, diagnostic.message.as_str()) {
        (Some(code), _) => code,
        (None, "") => return f.write_str("of any code"),
        (None, _) => "without a code",
    };
    write!(f, "{}", OneLine(code))?;
    match diagnostic.message.as_str() {
        "" => Ok(()),
        message => write!(f, ": {}", OneLine(message)),
    }
}

/// Shows a text of foreign origin on one line: each line end becomes a blank.
struct OneLine<'t>(&'t str);

impl fmt::Display for OneLine<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.contains(['\n', '\r']) {
            false => f.write_str(self.0),
            true => f.write_str(&self.0.replace(['\n', '\r'], " ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Written down once: logs of other versions have it.
    const OF_R_IS_5: u32 = 2_529_423_079;

    #[test]
    fn a_fingerprint_is_the_same_for_ever() {
        assert_eq!(Fact::fingerprint(&[]), Fnv1a::default().folded());
        let value = |name: &str| Fact::Value {
            name: name.to_owned(),
            value: Value::parse("INT#5").unwrap(),
        };
        assert_eq!(Fact::fingerprint(&[value("r")]), OF_R_IS_5);
        assert_ne!(Fact::fingerprint(&[value("q")]), OF_R_IS_5);
    }
}
