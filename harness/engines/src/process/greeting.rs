//! The opening of a conversation: `hello`, and who answers it.

use super::ProcessLimits;
use super::command_line::CommandLine;
use super::connection::{Connection, Failure};
use super::message;
use crate::protocol::{HelloReply, HelloRequest, PROTOCOL, Reply, Request};
use crate::{Ability, EngineError, Identity};
use serde_json::Value as Json;
use stickler_types::DialectName;

impl CommandLine {
    /// Starts a process and asks who it is.
    ///
    /// # Errors
    /// Where it cannot be started, or answers anything but a `hello` of this protocol.
    pub(super) fn greet(&self, limits: &ProcessLimits) -> Result<(Connection, Identity), EngineError> {
        let mut connection =
            Connection::open(self, limits.line).map_err(|reason| self.not_started(reason))?;
        let hello = message::line(&Request::Hello(HelloRequest { protocol: PROTOCOL }));
        let reply = match connection.exchange(hello, limits.hello) {
            Ok(reply) => reply,
            Err(failure) => return Err(self.not_started(unanswered(failure, connection, limits))),
        };
        match identity(&reply) {
            Ok(identity) => Ok((connection, identity)),
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
            let within = format!("it did not answer `hello` within {} ms", limits.hello.as_millis());
            with_words(within, &connection.kill())
        }
        Failure::Flood => {
            let flood = format!("its answer to `hello` is longer than {} bytes", limits.line);
            with_words(flood, &connection.kill())
        }
    }
}

fn with_words(reason: String, words: &str) -> String {
    match words {
        "" => reason,
        words => format!("{reason}; its stderr ends: {words}"),
    }
}

/// Who answered. Dialects and abilities that this version does not know are passed over: an engine may be newer.
fn identity(line: &[u8]) -> Result<Identity, String> {
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
    match serde_json::from_value::<Reply>(json) {
        Ok(Reply::Hello(hello)) if hello.protocol == PROTOCOL => Ok(from_hello(hello)),
        Ok(Reply::Hello(hello)) => Err(format!(
            "it speaks protocol {}, and protocol {PROTOCOL} is spoken here",
            hello.protocol
        )),
        Ok(Reply::Error(error)) => Err(format!("it answered `hello` by an error: {}", error.message)),
        Ok(_) | Err(_) => Err(nonsense()),
    }
}

fn from_hello(hello: HelloReply) -> Identity {
    let known = |name: &String| name.parse::<DialectName>().ok();
    Identity {
        name: hello.name,
        version: hello.version,
        dialects: hello.dialects.iter().filter_map(known).collect(),
        abilities: hello.abilities,
    }
}

#[cfg(test)]
mod tests {
    use super::identity;
    use crate::Ability;
    use stickler_types::DialectName;

    #[test]
    fn what_a_newer_engine_knows_besides_is_passed_over() {
        let hello =
            br#"{"type":"hello","protocol":1,"name":"new","version":"9","dialects":["matiec","klingon"],
            "abilities":["check","sing"],"colour":"green"}"#;
        let identity = identity(hello).unwrap();
        assert_eq!(identity.name, "new");
        assert_eq!(identity.dialects, [DialectName::Matiec]);
        assert_eq!(identity.abilities, [Ability::Check]);
    }

    #[test]
    fn an_answer_that_is_no_hello_of_this_protocol_is_told() {
        let answers: [(&[u8], &str); 5] = [
            (b"Usage: adapter FILE", "`Usage: adapter FILE`"),
            (br#"{"type":"accepted","id":1}"#, "no `hello`"),
            (br#"{"type":"hello","protocol":1}"#, "no `hello`"),
            (br#"{"type":"error","message":"who are you"}"#, "who are you"),
            (
                br#"{"type":"hello","protocol":2,"name":"a","version":"","dialects":[],"abilities":[]}"#,
                "it speaks protocol 2",
            ),
        ];
        for (answer, part) in answers {
            let reason = identity(answer).unwrap_err();
            assert!(reason.contains(part), "{reason}");
        }
    }
}
