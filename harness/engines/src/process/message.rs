//! Builds the requests of the wire protocol, and turns its replies into outcomes.

use crate::protocol::{ClockMessage, ProgramRequest, Reply};
use crate::protocol::{Request, RunMessage, SetMessage};
use crate::{Diagnostic, NamedValue, Observation, Outcome, RunRequest};
use std::collections::BTreeMap;
use stickler_types::{DialectName, ElementaryType, Fault, Value};

/// The kind of a request, which decides the replies that it may have.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Verb {
    Run,
    Check,
    Render,
}

impl Verb {
    fn name(self) -> &'static str {
        match self {
            Verb::Run => "run",
            Verb::Check => "check",
            Verb::Render => "render",
        }
    }
}

/// Returns a request as one line with its line feed.
pub(crate) fn line(request: &Request) -> Vec<u8> {
    // A request holds nothing but texts and numbers, which always have a form in JSON.
    let mut line = serde_json::to_vec(request).unwrap_or_default();
    line.push(b'\n');
    line
}

/// Returns the request of `run`.
pub(super) fn run(id: u64, request: &RunRequest<'_>) -> Request {
    let clock = request.clock.iter().map(|step| ClockMessage {
        before: step.before,
        value: Value::plain(ElementaryType::Time, step.nanoseconds.cast_unsigned()).to_string(),
    });
    let set = request.set.iter().map(|setting| SetMessage {
        before: setting.before,
        name: setting.name.to_string(),
        value: setting.value.to_string(),
    });
    Request::Run(RunMessage {
        id,
        dialect: request.dialect.as_str().to_owned(),
        source: request.source.to_owned(),
        scans: request.scans,
        observe: request.observe.to_vec(),
        clock: clock.collect(),
        set: set.collect(),
    })
}

/// Returns the message of `check` and `render`.
pub(super) fn program(id: u64, dialect: DialectName, source: &str) -> ProgramRequest {
    ProgramRequest {
        id,
        dialect: dialect.as_str().to_owned(),
        source: source.to_owned(),
    }
}

/// Parses a reply line into the outcome of the request.
///
/// # Errors
/// A fragment that says why the line is no answer to this request. Then the conversation is out of step.
pub(super) fn outcome(line: &[u8], id: u64, verb: Verb, observe: &[Observation]) -> Result<Outcome, String> {
    let reply: Reply = serde_json::from_slice(line)
        .map_err(|error| format!("it answered {}, which is no reply: {error}", excerpt(line)))?;
    let (answered, word) = (reply.id(), reply.word());
    if answered.is_some_and(|answered| answered != id) {
        return Err(format!("it answered out of turn: {}", excerpt(line)));
    }
    match (reply, verb) {
        (Reply::Accepted { diagnostics, .. }, Verb::Run | Verb::Check) => Ok(Outcome::Accepted {
            warnings: warnings(diagnostics, word)?,
        }),
        (
            Reply::Executed {
                values, diagnostics, ..
            },
            Verb::Run,
        ) => Ok(Outcome::Executed {
            values: read_values(values, observe)?,
            warnings: warnings(diagnostics, word)?,
        }),
        (
            Reply::Faulted {
                fault,
                line,
                values,
                diagnostics,
                ..
            },
            Verb::Run,
        ) => Ok(Outcome::Faulted {
            fault: Fault::reported(&fault),
            line,
            values: read_values(values, observe)?,
            warnings: warnings(diagnostics, word)?,
        }),
        (Reply::Rendered { text, .. }, Verb::Render) => Ok(Outcome::Rendered { text }),
        (Reply::Rejected { diagnostics, .. }, _) => Ok(Outcome::rejected(diagnostics)),
        (
            Reply::Unsupported {
                reason,
                not_implemented,
                ..
            },
            _,
        ) => Ok(match not_implemented {
            true => Outcome::NotImplemented { reason },
            false => Outcome::Unsupported { reason },
        }),
        (Reply::Error { message, .. }, _) => Ok(Outcome::Error { message }),
        (Reply::Hello(_) | Reply::Accepted { .. } | Reply::Executed { .. }, _)
        | (Reply::Faulted { .. } | Reply::Rendered { .. }, _) => {
            Err(format!("it answered `{}` by `{word}`", verb.name()))
        }
    }
}

/// Returns the diagnostics of a program that was accepted, none of which is an error.
fn warnings(diagnostics: Vec<Diagnostic>, word: &str) -> Result<Vec<Diagnostic>, String> {
    match diagnostics.iter().find(|reported| reported.is_error()) {
        None => Ok(diagnostics),
        Some(error) => Err(format!(
            "it answered `{word}` with the error `{error}`; a diagnostic of an accepted program has the `severity` `warning`"
        )),
    }
}

/// Parses the values in the order in which they were asked for. A missing value is left out, since a fault may have come before
/// it; a value that was not asked for is ignored.
fn read_values(
    mut literals: BTreeMap<String, String>,
    observe: &[Observation],
) -> Result<Vec<NamedValue>, String> {
    let mut values = Vec::with_capacity(observe.len());
    for asked in observe {
        let key = asked.key().to_string();
        if let Some(literal) = literals.remove(&key) {
            let value = Value::parse_observed(&literal)
                .map_err(|error| format!("its value `{literal}` of `{key}` is no typed literal: {error}"))?;
            values.push((key, value));
        }
    }
    Ok(values)
}

/// The number of characters of a line that a message quotes at most.
const MAX_EXCERPT_LEN: usize = 120;

/// Returns the beginning of a line, between backquotes, without characters that would control a terminal.
pub(crate) fn excerpt(line: &[u8]) -> String {
    let text = String::from_utf8_lossy(line);
    let mut characters = text
        .trim_end()
        .chars()
        .filter(|character| !character.is_control());
    let beginning: String = characters.by_ref().take(MAX_EXCERPT_LEN).collect();
    let more = if characters.next().is_some() { "…" } else { "" };
    format!("`{beginning}{more}`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_line_is_quoted_in_part() {
        assert_eq!(excerpt(&[b'x'; 1000]).chars().count(), MAX_EXCERPT_LEN + 3);
        assert_eq!(excerpt(b"\x1b[31mred\n"), "`[31mred`");
    }
}
