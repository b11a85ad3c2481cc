//! Checks whether an adapter keeps to the wire protocol, and separately whether its compiler answers as it must.
//!
//! An adapter is asked the questions of a [smoke set](smoke). An answer that the protocol forbids is a fault of the adapter,
//! and until it is mended nothing that the adapter says about its compiler counts; a valid answer that is not right is a fault
//! of the compiler, or of how the adapter reads it.

mod reply;
mod smoke;

use crate::process::{CommandLine, Connection, Failure, ProcessLimits};
use crate::protocol::{ObserveMessage, ProgramRequest, Reply, Request, RunMessage};
use crate::{Ability, EngineError, Identity, Outcome};
use smoke::{Ask, PLAIN, QUESTIONS, SmokeExpectation, SmokeQuestion};
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
    #[must_use]
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
    let mut conversation = Conversation {
        command: &command,
        limits: &limits,
        identity: &identity,
        connection: Some(connection),
        id: 0,
    };
    let mut checks: Vec<Check> = QUESTIONS
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
            return skipped(question.rule, *ability);
        }
        self.id += 1;
        let dialect = self.identity.dialects[0];
        let (line, verb) = request(&question.ask, self.id, dialect);
        let types = observed(&question.ask);
        self.ask(question.rule.to_owned(), line, verb, &question.expect, &types)
    }

    /// Checks a plain program in another dialect.
    fn further_dialect(&mut self, dialect: DialectName) -> Check {
        let rule = format!("`check` of a plain program is answered by `accepted` in {dialect}");
        if !self.identity.can(Ability::Check) {
            return skipped(&rule, Ability::Check);
        }
        self.id += 1;
        let (line, verb) = request(&Ask::Check(PLAIN), self.id, dialect);
        self.ask(rule, line, verb, &SmokeExpectation::Accepted, &[])
    }

    /// Checks whether a second process can run beside the first: a run has one for each worker.
    fn second_process(&mut self) -> Check {
        let rule = "two of its processes live side by side".to_owned();
        match self.command.greet(self.limits) {
            Ok((second, _)) => {
                let first = self.connection.replace(second);
                self.id += 1;
                let (asked, verb) = request(&Ask::Check(PLAIN), self.id, self.identity.dialects[0]);
                let expect = match self.identity.can(Ability::Check) {
                    true => SmokeExpectation::Accepted,
                    false => SmokeExpectation::Refused,
                };
                let check = self.ask(rule, asked, verb, &expect, &[]);
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

    /// Sends a line and judges the answer.
    fn ask(
        &mut self,
        rule: String,
        sent: Vec<u8>,
        verb: &str,
        expect: &SmokeExpectation,
        types: &[(String, &str)],
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
                let limit = u64::try_from(self.limits.reply.as_millis()).unwrap_or(u64::MAX);
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
        types: &[(String, &str)],
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

fn line(request: &Request) -> Vec<u8> {
    // A request holds nothing but texts and numbers, which always have a form in JSON.
    let mut line = serde_json::to_vec(request).unwrap_or_default();
    line.push(b'\n');
    line
}

/// Returns the line of a question, and the word for its verb.
fn request(ask: &Ask, id: u64, dialect: DialectName) -> (Vec<u8>, &'static str) {
    let program = |dialect: &str, source: &str| ProgramRequest {
        id,
        dialect: dialect.to_owned(),
        source: source.to_owned(),
    };
    match ask {
        Ask::Check(source) => (line(&Request::Check(program(dialect.as_str(), source))), "check"),
        Ask::Render(source) => (
            line(&Request::Render(program(dialect.as_str(), source))),
            "render",
        ),
        Ask::NoDialect => (line(&Request::Check(program("no-dialect", PLAIN))), "check"),
        Ask::FurtherKey => {
            let further = serde_json::json!({
                "type": "check", "id": id, "dialect": dialect.as_str(), "source": PLAIN, "colour": {"of": ["green"]}
            });
            (format!("{further}\n").into_bytes(), "check")
        }
        Ask::Line(text) => (format!("{text}\n").into_bytes(), "a line"),
        Ask::Run {
            source,
            scans,
            observe,
        } => {
            let observe = observe.iter().map(|(name, type_name, after)| ObserveMessage {
                name: (*name).to_owned(),
                type_name: (*type_name).to_owned(),
                after: *after,
            });
            let message = RunMessage {
                id,
                dialect: dialect.as_str().to_owned(),
                source: (*source).to_owned(),
                scans: *scans,
                observe: observe.collect(),
                clock: Vec::new(),
                set: Vec::new(),
            };
            (line(&Request::Run(message)), "run")
        }
    }
}

/// Returns the type of each observed value, by its key.
fn observed(ask: &Ask) -> Vec<(String, &'static str)> {
    let Ask::Run { observe, .. } = ask else {
        return Vec::new();
    };
    let key = |(name, type_name, after): &smoke::SmokeVariable| {
        let key = after.map_or((*name).to_owned(), |scan| format!("{name}@{scan}"));
        (key, *type_name)
    };
    observe.iter().map(key).collect()
}
