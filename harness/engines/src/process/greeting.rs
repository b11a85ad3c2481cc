//! The opening of a conversation: `hello`, and the identity of the engine that answers.

use super::ProcessLimits;
use super::command_line::CommandLine;
use super::connection::{Connection, Failure};
use super::message;
use crate::protocol::{HelloReply, HelloRequest, PROTOCOL, Reply, Request};
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
        let hello = message::line(&Request::Hello(HelloRequest { protocol: PROTOCOL }));
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
            let limit = u64::try_from(limits.hello.as_millis()).unwrap_or(u64::MAX);
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
        Ok(Reply::Error(error)) => Err(format!("it answered `hello` by an error: {}", error.message)),
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

#[cfg(test)]
mod tests {
    use super::{identity, understood};
    use crate::{Ability, Grade};
    use stickler_types::DialectName;

    #[test]
    fn what_a_newer_engine_knows_besides_is_passed_over() {
        let answer =
            br#"{"type":"hello","protocol":1,"name":"new","version":"9","dialects":["matiec","klingon"],
            "abilities":["check","sing"],"grade":"line","colour":"green"}"#;
        let identity = identity(understood(answer).unwrap()).unwrap();
        assert_eq!(identity.name, "new");
        assert_eq!(identity.dialects, [DialectName::MATIEC]);
        assert_eq!(identity.abilities, [Ability::Check]);
        assert_eq!(identity.grade, Grade::Line);
    }

    #[test]
    fn an_engine_that_speaks_nothing_known_is_told_with_what_it_speaks() {
        for (dialects, spoken) in [(r#"["melsec","klingon"]"#, "melsec, klingon"), ("[]", "nothing")] {
            let answer = format!(
                r#"{{"type":"hello","protocol":1,"name":"far","version":"9","dialects":{dialects},"abilities":[]}}"#
            );
            let error = identity(understood(answer.as_bytes()).unwrap()).unwrap_err();
            let error = error.to_string();
            assert!(error.starts_with("engine far speaks none of"), "{error}");
            assert!(
                error.ends_with(&format!("; it says that it speaks: {spoken}")),
                "{error}"
            );
        }
    }

    #[test]
    fn a_name_moves_no_cursor_and_begins_no_line() {
        let answer = br#"{"type":"hello","protocol":1,"name":"\u001b[31mred\u0007","version":"1\n2 \u00e4",
            "dialects":["matiec"],"abilities":[]}"#;
        let identity = identity(understood(answer).unwrap()).unwrap();
        assert_eq!(identity.name, "\\u{1b}[31mred\\u{7}");
        assert_eq!(identity.version, "1\\u{a}2 \u{e4}");
        assert_eq!(identity.grade, Grade::Code, "where nothing is said");
    }

    #[test]
    fn an_answer_that_is_no_hello_of_this_protocol_is_told() {
        let answers: [(&[u8], &str); 6] = [
            (b"Usage: adapter FILE", "`Usage: adapter FILE`"),
            (br#"{"type":"accepted","id":1}"#, "no `hello`"),
            (br#"{"type":"hello","protocol":1}"#, "no `hello`"),
            (br#"{"type":"error","message":"who are you"}"#, "who are you"),
            (
                br#"{"type":"hello","protocol":2,"name":"a","version":"","dialects":[],"abilities":[]}"#,
                "it speaks protocol 2",
            ),
            (
                br#"{"type":"hello","protocol":1,"name":"a","version":"","dialects":[],"abilities":[],"grade":"lines"}"#,
                "the grades are `code`, `line` and `rejected`",
            ),
        ];
        for (answer, part) in answers {
            let reason = understood(answer).unwrap_err();
            assert!(reason.contains(part), "{reason}");
        }
    }
}
