//! Checks whether an adapter keeps to the wire protocol, and separately whether its compiler answers as it must.
//!
//! An adapter is asked the questions of a [smoke set](smoke). An answer that the protocol forbids is a fault of the adapter,
//! and until it is mended nothing that the adapter says about its compiler counts; a valid answer that is not right is a fault
//! of the compiler, or of how the adapter reads it.

mod reply;
mod smoke;

use crate::process::{CommandLine, Connection, Failure, ProcessLimits, line, milliseconds};
use crate::protocol::{ProgramRequest, Reply, Request, RunMessage};
use crate::{Ability, EngineError, Identity, Outcome};
pub use reply::OTHER_TYPE;
use smoke::{Ask, SmokeExpectation, SmokeQuestion, SmokeSet};
use std::path::Path;
use stickler_types::DialectName;

/// The verdict on the answer to one question.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CheckVerdict {
    /// The answer is right.
    Right,
    /// The adapter does not keep to the protocol.
    Broken,
    /// The adapter keeps to the protocol, and what it says about the compiler is not right.
    Wrong,
    /// The adapter says that it does not support this.
    Skipped,
}

/// One question and the verdict on its answer.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Check {
    /// The rule that must hold, as a sentence without its full stop.
    pub rule: String,
    /// The verdict on the answer.
    pub judgement: CheckVerdict,
    /// The violation of the rule, or the reason why the check was skipped, as a fragment; `None` where the answer is right.
    pub problem: Option<String>,
    /// The deviations that are allowed and may be mistakes, as fragments.
    pub notes: Vec<String>,
    /// The line that was sent, where it helps to find the cause.
    pub sent: Option<String>,
    /// The line that came back, where it helps to find the cause.
    pub received: Option<String>,
}

/// The result of validating an adapter.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Validation {
    /// The identity that the adapter gives in its answer to `hello`.
    pub identity: Identity,
    /// The checks, in the order in which the questions were asked.
    pub checks: Vec<Check>,
}

impl Validation {
    /// Returns the number of checks with this verdict.
    pub fn count(&self, judgement: CheckVerdict) -> usize {
        let of = |check: &&Check| check.judgement == judgement;
        self.checks.iter().filter(of).count()
    }
}

/// Starts the adapter of a command line, in a folder where one is named, and asks it the questions of the smoke set.
///
/// # Errors
/// [`EngineError`] where the adapter cannot be started or does not answer `hello` as the protocol has it; then nothing else can
/// be asked.
pub fn validate(
    folder: Option<&Path>,
    command_line: &str,
    limits: ProcessLimits,
) -> Result<Validation, EngineError> {
    let command = CommandLine::split(command_line)?;
    let command = match folder {
        Some(folder) => command.inside(folder),
        None => command,
    };
    let (connection, identity) = command.greet(&limits)?;
    let smoke = SmokeSet::read().map_err(|reason| EngineError::NotStarted {
        engine: identity.name.clone(),
        reason,
    })?;
    let mut conversation = Conversation {
        smoke: &smoke,
        command: &command,
        limits: &limits,
        identity: &identity,
        connection: Some(connection),
        id: 0,
    };
    let mut checks: Vec<Check> = smoke
        .questions
        .iter()
        .map(|question| conversation.check(question))
        .collect();
    for &dialect in identity.dialects.iter().skip(1) {
        checks.push(conversation.further_dialect(dialect));
    }
    checks.push(conversation.second_process());
    checks.push(conversation.farewell());
    Ok(Validation { identity, checks })
}

/// A conversation with the adapter, which is opened anew after each failure.
struct Conversation<'v> {
    smoke: &'v SmokeSet,
    command: &'v CommandLine,
    limits: &'v ProcessLimits,
    identity: &'v Identity,
    connection: Option<Connection>,
    id: u64,
}

impl Conversation<'_> {
    fn check(&mut self, question: &SmokeQuestion) -> Check {
        let lacking = question
            .needs()
            .iter()
            .find(|ability| !self.identity.can(**ability));
        if let Some(ability) = lacking {
            return skipped(&question.rule, *ability);
        }
        self.id += 1;
        let (line, verb) = self.request(&question.ask);
        let types = match &question.ask {
            Ask::Run(run) => run.observed().collect(),
            _ => Vec::new(),
        };
        self.ask(question.rule.clone(), line, verb, &question.expect, &types)
    }

    /// Checks a plain program in another dialect.
    fn further_dialect(&mut self, dialect: DialectName) -> Check {
        let rule = format!("`check` of a plain program is answered by `accepted` in {dialect}");
        if !self.identity.can(Ability::Check) {
            return skipped(&rule, Ability::Check);
        }
        self.id += 1;
        let line = self.check_of_plain(dialect.as_str());
        self.ask(rule, line, "check", &SmokeExpectation::Accepted, &[])
    }

    /// Checks whether a second process can run beside the first: a run has one for each worker.
    fn second_process(&mut self) -> Check {
        let rule = "two of its processes live side by side".to_owned();
        match self.command.greet(self.limits) {
            Ok((second, _)) => {
                let first = self.connection.replace(second);
                self.id += 1;
                let asked = self.check_of_plain(self.identity.dialects[0].as_str());
                let expect = match self.identity.can(Ability::Check) {
                    true => SmokeExpectation::Accepted,
                    false => SmokeExpectation::Refused,
                };
                let check = self.ask(rule, asked, "check", &expect, &[]);
                // Whether a process ends at `bye` is judged by the second; a process that is killed may leave folders behind.
                if let Some(first) = first {
                    first.leave(line(&Request::Bye));
                }
                check
            }
            Err(error) => broken(rule, error.to_string()),
        }
    }

    /// Checks whether the adapter ends at `bye`.
    fn farewell(&mut self) -> Check {
        let rule = "it ends at `bye`".to_owned();
        let Some(connection) = self.connection.take() else {
            return broken(rule, "it had ended before".to_owned());
        };
        match connection.leave(line(&Request::Bye)) {
            true => right(rule),
            false => broken(rule, "it lives on, and has to be killed".to_owned()),
        }
    }

    fn program(&self, dialect: &str, name: &str) -> ProgramRequest {
        ProgramRequest {
            id: self.id,
            dialect: dialect.to_owned(),
            source: self.smoke.program(name).to_owned(),
        }
    }

    fn check_of_plain(&self, dialect: &str) -> Vec<u8> {
        line(&Request::Check(self.program(dialect, SmokeSet::PLAIN)))
    }

    /// Returns the line of a question, and the word for its verb.
    fn request(&self, ask: &Ask) -> (Vec<u8>, &'static str) {
        let dialect = self.identity.dialects[0].as_str();
        match ask {
            Ask::Check(name) => (line(&Request::Check(self.program(dialect, name))), "check"),
            Ask::Render(name) => (line(&Request::Render(self.program(dialect, name))), "render"),
            Ask::NoDialect => (self.check_of_plain("no-dialect"), "check"),
            Ask::FurtherKey => {
                let source = self.smoke.program(SmokeSet::PLAIN);
                let further = serde_json::json!({
                    "type": "check", "id": self.id, "dialect": dialect, "source": source, "colour": {"of": ["green"]}
                });
                (format!("{further}\n").into_bytes(), "check")
            }
            Ask::Line(text) => (format!("{text}\n").into_bytes(), "a line"),
            Ask::Run(run) => {
                let message = RunMessage {
                    id: self.id,
                    dialect: dialect.to_owned(),
                    source: self.smoke.program(&run.program).to_owned(),
                    scans: run.scans,
                    observe: run.observe(),
                    clock: Vec::new(),
                    set: Vec::new(),
                };
                (line(&Request::Run(message)), "run")
            }
        }
    }

    /// Sends a line and judges the answer.
    fn ask(
        &mut self,
        rule: String,
        sent: Vec<u8>,
        verb: &str,
        expect: &SmokeExpectation,
        types: &[(&str, &str)],
    ) -> Check {
        let shown = String::from_utf8_lossy(&sent).trim_end().to_owned();
        let mut check = match self.exchange(sent) {
            Ok(line) => self.judged(rule, &line, verb, expect, types),
            Err(words) => broken(rule, words),
        };
        if check.judgement != CheckVerdict::Right {
            check.sent = Some(shown);
        } else if check.notes.is_empty() {
            check.received = None;
        }
        check
    }

    fn exchange(&mut self, line: Vec<u8>) -> Result<Vec<u8>, String> {
        let mut connection = match self.connection.take() {
            Some(connection) => connection,
            None => {
                self.command
                    .greet(self.limits)
                    .map_err(|error| error.to_string())?
                    .0
            }
        };
        match connection.exchange(line, self.limits.reply) {
            Ok(reply) => {
                self.connection = Some(connection);
                Ok(reply)
            }
            Err(Failure::Ended) => Err(connection.end()),
            Err(Failure::TimedOut) => {
                let limit = milliseconds(self.limits.reply);
                Err(format!("it does not answer within {}", Outcome::limit(limit)))
            }
            Err(Failure::Memory(limit)) => Err(format!("it held more than {} MiB of memory", limit >> 20)),
            Err(Failure::Flood) => Err(format!("its answer is longer than {} bytes", self.limits.line)),
        }
    }

    fn judged(
        &mut self,
        rule: String,
        line: &[u8],
        verb: &str,
        expect: &SmokeExpectation,
        types: &[(&str, &str)],
    ) -> Check {
        let received = Some(String::from_utf8_lossy(line).trim_end().to_owned());
        let (judgement, problem, notes) = match reply::read(line) {
            // Output that is still to come would be taken for the answer to a later request.
            Err(words) => {
                self.connection = None;
                (CheckVerdict::Broken, Some(words), Vec::new())
            }
            Ok(reply) if !self.answers(&reply, expect) => {
                self.connection = None;
                let words = format!("it repeats another `id` than {}", self.id);
                (CheckVerdict::Broken, Some(words), Vec::new())
            }
            Ok(reply) => {
                let (judgement, problem) = reply::judge(&reply, expect, verb, self.identity.grade, types);
                let further = reply::further_keys(line, &reply);
                let note = |key: String| format!("`{key}` is no key of `{}` and passed over", reply.word());
                (judgement, problem, further.into_iter().map(note).collect())
            }
        };
        Check {
            rule,
            judgement,
            problem,
            notes,
            sent: None,
            received,
        }
    }

    /// Checks whether the reply repeats the `id`. A line that is no request has no `id` that must be read.
    fn answers(&self, reply: &Reply, expect: &SmokeExpectation) -> bool {
        matches!(expect, SmokeExpectation::Error) || reply.id() == Some(self.id)
    }
}

fn right(rule: String) -> Check {
    Check {
        rule,
        judgement: CheckVerdict::Right,
        problem: None,
        notes: Vec::new(),
        sent: None,
        received: None,
    }
}

fn broken(rule: String, words: String) -> Check {
    Check {
        judgement: CheckVerdict::Broken,
        problem: Some(words),
        ..right(rule)
    }
}

fn skipped(rule: &str, ability: Ability) -> Check {
    Check {
        judgement: CheckVerdict::Skipped,
        problem: Some(format!("it does not claim the ability `{ability}`")),
        ..right(rule.to_owned())
    }
}
