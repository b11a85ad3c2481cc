//! The opening of a conversation: `hello`, and the identity of the engine that answers.

use super::ProcessLimits;
use super::command_line::CommandLine;
use super::connection::{Connection, Failure};
use super::message;
use super::milliseconds;
use crate::protocol::{HelloReply, PROTOCOL, Reply, Request};
use crate::{Ability, EngineError, Grade, Identity, Outcome};
use serde_json::Value as Json;
use stickler_types::DialectName;

impl CommandLine {
    /// Starts a process and asks for its identity.
    ///
    /// # Errors
    /// [`EngineError`] where the process cannot be started, or answers anything but a `hello` of this protocol.
    pub(crate) fn greet(&self, limits: &ProcessLimits) -> Result<(Connection, Identity), EngineError> {
        let mut connection = Connection::open(self, limits.line)
            .map_err(|reason| self.not_started(reason))?
            .within(limits.memory);
        let hello = message::line(&Request::Hello { protocol: PROTOCOL });
        let reply = match connection.exchange(hello, limits.hello) {
            Ok(reply) => reply,
            Err(failure) => return Err(self.not_started(unanswered(failure, connection, limits))),
        };
        match understood(&reply) {
            Ok(hello) => Ok((connection, identity(hello)?)),
            Err(reason) => {
                let words = connection.kill();
                Err(self.not_started(with_words(reason, &words)))
            }
        }
    }
}

fn unanswered(failure: Failure, connection: Connection, limits: &ProcessLimits) -> String {
    match failure {
        Failure::Ended => format!("it did not answer `hello`: {}", connection.end()),
        Failure::TimedOut => {
            let limit = milliseconds(limits.hello);
            let within = format!("it did not answer `hello` within {}", Outcome::limit(limit));
            with_words(within, &connection.kill())
        }
        Failure::Memory(limit) => with_words(too_much(limit), &connection.kill()),
        Failure::Flood => {
            let flood = format!("its answer to `hello` is longer than {} bytes", limits.line);
            with_words(flood, &connection.kill())
        }
    }
}

/// Returns the message about a process that held more memory than `limit`, in bytes.
pub(super) fn too_much(limit: u64) -> String {
    format!("it held more than {} MiB of memory", limit >> 20)
}

pub(super) fn with_words(reason: String, words: &str) -> String {
    match words {
        "" => reason,
        words => format!("{reason}; its stderr ends: {words}"),
    }
}

/// Parses the answer to `hello`. Abilities that this version does not know are ignored: an engine may be newer.
fn understood(line: &[u8]) -> Result<HelloReply, String> {
    let nonsense = || {
        format!(
            "it answered `hello` by {}, which is no `hello` of the protocol",
            message::excerpt(line)
        )
    };
    let mut json: Json = serde_json::from_slice(line).map_err(|_| nonsense())?;
    if let Some(Json::Array(abilities)) = json.get_mut("abilities") {
        abilities.retain(|name| serde_json::from_value::<Ability>(name.clone()).is_ok());
    }
    if let Some(Json::String(grade)) = json.get("grade") {
        grade
            .parse::<Grade>()
            .map_err(|error| format!("it answered `hello` with a wrong `grade`: {error}"))?;
    }
    match serde_json::from_value::<Reply>(json) {
        Ok(Reply::Hello(hello)) if hello.protocol == PROTOCOL => Ok(hello),
        Ok(Reply::Hello(hello)) => Err(format!(
            "it speaks protocol {}, and protocol {PROTOCOL} is spoken here",
            hello.protocol
        )),
        Ok(Reply::Error { message, .. }) => Err(format!("it answered `hello` by an error: {message}")),
        Ok(_) | Err(_) => Err(nonsense()),
    }
}

/// Returns the identity of the engine that answered. Dialects that this version does not know are ignored, as long as there are
/// others.
fn identity(hello: HelloReply) -> Result<Identity, EngineError> {
    let known = |name: &String| name.parse::<DialectName>().ok();
    let identity = Identity {
        name: harmless(&hello.name),
        version: harmless(&hello.version),
        dialects: hello.dialects.iter().filter_map(known).collect(),
        abilities: hello.abilities,
        grade: hello.grade,
        lacks: Vec::new(),
    };
    if identity.dialects.is_empty() {
        let spoken: Vec<String> = hello.dialects.iter().map(|name| harmless(name)).collect();
        return Err(EngineError::SpeaksNone {
            engine: identity.name,
            known: DialectName::ALL.map(DialectName::as_str).join(", "),
            spoken: match spoken.is_empty() {
                true => "nothing".to_owned(),
                false => spoken.join(", "),
            },
        });
    }
    Ok(identity)
}

/// Returns the text with control characters spelled out (`\u{1b}`): an engine's name is printed on terminals and in reports,
/// where it must neither move the cursor nor begin a line.
fn harmless(text: &str) -> String {
    let spelled = |character: char| match character.is_control() {
        true => character.escape_unicode().to_string(),
        false => character.to_string(),
    };
    text.chars().map(spelled).collect()
}
