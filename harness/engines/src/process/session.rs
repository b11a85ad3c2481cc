//! A conversation with a process, which is started anew after each failure.

use super::ProcessLimits;
use super::command_line::CommandLine;
use super::connection::{Connection, Failure};
use super::greeting::{too_much, with_words};
use super::message::{self, Verb};
use super::{milliseconds, time_limit};
use crate::protocol::Request;
use crate::{Identity, Observation, Outcome, RunRequest, Session};
use std::time::Duration;
use stickler_types::DialectName;

/// A session of an engine in a process, which lives as long as it answers.
pub(super) struct ProcessSession<'e> {
    command: &'e CommandLine,
    limits: &'e ProcessLimits,
    identity: &'e Identity,
    /// The connection to the process; `None` after a failure, until the next request.
    connection: Option<Connection>,
    /// The id of the last request.
    id: u64,
}

impl<'e> ProcessSession<'e> {
    /// Returns a session with a process that has answered `hello`.
    pub(super) fn new(
        command: &'e CommandLine,
        limits: &'e ProcessLimits,
        identity: &'e Identity,
        connection: Connection,
    ) -> ProcessSession<'e> {
        ProcessSession {
            command,
            limits,
            identity,
            connection: Some(connection),
            id: 0,
        }
    }

    /// Returns the name by which the process knows the dialect. A dialect that it does not know is sent under its own name, so
    /// that the process can say so.
    fn asked_in(&self, dialect: DialectName) -> DialectName {
        self.identity.asked_in(dialect).unwrap_or(dialect)
    }

    fn next_id(&mut self) -> u64 {
        self.id += 1;
        self.id
    }

    fn ask(&mut self, request: &Request, verb: Verb, observe: &[Observation]) -> Outcome {
        let mut connection = match self.connection.take() {
            Some(connection) => connection,
            None => match self.command.greet(self.limits) {
                Ok((connection, _)) => connection,
                Err(error) => {
                    return Outcome::crashed(error.to_string());
                }
            },
        };
        let limit = time_limit(self.limits.reply);
        match connection.exchange(message::line(request), limit) {
            Ok(line) => match message::outcome(&line, self.id, verb, observe) {
                Ok(outcome) => {
                    self.connection = Some(connection);
                    outcome
                }
                // Output that is still to come would be taken for the answer to a later request.
                Err(message) => Outcome::Error { message },
            },
            Err(failure) => self.failed(failure, connection, limit),
        }
    }

    fn failed(&self, failure: Failure, connection: Connection, limit: Duration) -> Outcome {
        match failure {
            Failure::Ended => Outcome::crashed(connection.end()),
            Failure::TimedOut => Outcome::TimedOut {
                after_ms: milliseconds(limit),
            },
            Failure::Memory(limit) => Outcome::crashed(with_words(too_much(limit), &connection.kill())),
            Failure::Flood => Outcome::Error {
                message: format!("its answer is longer than {} bytes", self.limits.line),
            },
        }
    }
}

impl Session for ProcessSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        let request = &RunRequest {
            dialect: self.asked_in(request.dialect),
            ..*request
        };
        let message = message::run(self.next_id(), request);
        self.ask(&message, Verb::Run, request.observe)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        let dialect = self.asked_in(dialect);
        let message = Request::Check(message::program(self.next_id(), dialect, source));
        self.ask(&message, Verb::Check, &[])
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        let dialect = self.asked_in(dialect);
        let message = Request::Render(message::program(self.next_id(), dialect, source));
        self.ask(&message, Verb::Render, &[])
    }
}

impl Drop for ProcessSession<'_> {
    fn drop(&mut self) {
        if let Some(connection) = self.connection.take() {
            connection.leave(message::line(&Request::Bye));
        }
    }
}
