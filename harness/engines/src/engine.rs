//! The interface of an engine: its identity, and sessions that answer requests.

use crate::{Grade, NoReproduction, Reproduction};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use stickler_types::{Code, DialectName, Outcome, RunRequest, words};

/// An implementation that runs programs: the reference, or a real compiler behind an adapter.
///
/// An engine is shared by all workers; what changes while it works lives in its sessions.
pub trait Engine: Send + Sync {
    /// Returns who this engine is and what it can do, which does not change while the engine lives.
    fn identity(&self) -> &Identity;

    /// Opens a session; a runner opens one a worker and keeps it for many requests.
    ///
    /// # Errors
    /// [`EngineError`] where the engine cannot be started (exit code 3 of the command line).
    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError>;

    /// Returns the files and commands by which a person runs a program on this engine without Stickler, and sees the values
    /// that `request` observes. `ability` tells what is run: [`Ability::Check`] shows whether the program is accepted,
    /// [`Ability::Execute`] and [`Ability::Scans`] execute it, [`Ability::Render`] prints it as normalised source.
    ///
    /// # Errors
    /// [`NoReproduction::NoTools`] for an engine without a command line of its own; [`NoReproduction::Unsupported`] where the
    /// engine does not speak the dialect, or would not do what the request needs.
    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        let _ = (request, ability);
        Err(NoReproduction::NoTools(self.identity().name.clone()))
    }

    /// Returns the programs and folders of the engine on this machine, by the variables that name them in its reproductions.
    /// What is missing is at its usual place.
    fn tools(&self) -> Vec<(String, PathBuf)> {
        Vec::new()
    }

    /// Returns a digest of everything that decides the engine's answers: its programs, their parts, their options, and how they
    /// are asked. As long as the digest stays the same, the engine answers the same, so that earlier answers can be reused.
    /// `None` where that cannot be known. Computing the digest takes a moment.
    fn fingerprint(&self) -> Option<String> {
        None
    }

    /// Returns how many programs [`Session::run_pack`] is best given at a time; 1 where it gains nothing.
    fn pack_size(&self) -> usize {
        1
    }
}

/// One conversation with an engine. Requests are independent: none may see what an earlier one left behind.
pub trait Session {
    /// Executes a program and gives the values asked for: [`Outcome::Executed`], `Rejected`, `Faulted`, or,
    /// from an engine that can only check, [`Outcome::ACCEPTED`].
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome;

    /// Executes several programs of one dialect with less work than one after the other. Returns the result for each program,
    /// in the order of the requests.
    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        vec![Packed::Alone; requests.len()]
    }

    /// Checks a program without executing it: [`Outcome::ACCEPTED`] or `Rejected`.
    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome;

    /// Renders a program as normalised source: [`Outcome::Rendered`] or `Rejected`; `Unsupported` by an engine that does not.
    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        let _ = (dialect, source);
        no_rendering()
    }
}

/// Returns the outcome of a request to render on an engine that does not.
pub(crate) fn no_rendering() -> Outcome {
    Outcome::Unsupported {
        reason: "it gives no normalised source".to_owned(),
    }
}

/// The result of a pack for one of its programs.
#[derive(Clone, PartialEq, Debug)]
pub enum Packed {
    /// The outcome that [`Session::run`] would give.
    Answered(Outcome),
    /// No outcome; the program should be run in a smaller pack.
    Unknown,
    /// No outcome, and no pack would give one: the program has to be run alone.
    Alone,
}

/// The name, version, dialects and abilities of an engine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Identity {
    /// A short name, such as `reference`; unique within a run.
    pub name: String,
    /// The version, in the engine's own words.
    pub version: String,
    /// The dialects that the engine documents itself to speak; see [`Identity::asked_in`] for those that extend them.
    pub dialects: Vec<DialectName>,
    /// The abilities of the engine.
    pub abilities: Vec<Ability>,
    /// The best grade that can be asked of the engine's rejections: how exactly it can say what is wrong with a program.
    pub grade: Grade,
    /// The diagnostic codes that this version of the engine does not have, so that nobody can ask it for them. Empty where that
    /// is unknown.
    pub lacks: Vec<Code>,
}

impl Identity {
    /// Tells whether the engine has this ability.
    pub fn can(&self, ability: Ability) -> bool {
        self.abilities.contains(&ability)
    }

    /// Tells whether the engine speaks this dialect, or the one that it extends.
    pub fn speaks(&self, dialect: DialectName) -> bool {
        self.asked_in(dialect).is_some()
    }

    /// Returns the dialect by whose name the engine is asked for programs of `dialect`: `dialect` itself where the engine
    /// documents itself to speak it, otherwise its base. A custom dialect is another name for what its base says the engine
    /// does, so an engine that has never heard of it is asked by the base. `None` where the engine speaks neither.
    pub fn asked_in(&self, dialect: DialectName) -> Option<DialectName> {
        let base = dialect.base();
        // Of a variant, an engine that does not know its options would do something else.
        let base = (!dialect.is_variant()).then_some(base);
        [Some(dialect), base]
            .into_iter()
            .flatten()
            .find(|dialect| self.dialects.contains(dialect))
    }
}

words! {
    /// An ability of an engine.
    #[derive(Serialize, Deserialize)]
    #[cfg_attr(test, derive(schemars::JsonSchema))]
    #[serde(rename_all = "lowercase")]
    Ability {
        /// The ability to say whether a program is accepted, and why not.
        Check = "check",
        /// The ability to execute programs and report values.
        Execute = "execute",
        /// The ability to render a program as normalised source.
        Render = "render",
        /// The ability to execute several scans, with a clock and inputs set between them, and to observe values after each scan;
        /// see [`RunRequest::needs_scans`].
        Scans = "scans",
    }
}

/// An engine that cannot be used at all (exit code 3 of the command line).
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// The engine could not be started.
    #[error("engine {engine} could not be started: {reason}")]
    NotStarted {
        /// The engine's name.
        engine: String,
        /// The reason, as a fragment.
        reason: String,
    },
    /// The engine names no dialect in which a request could be written.
    #[error(
        "engine {engine} speaks none of the dialects that Stickler knows ({known}); it says that it speaks: {spoken}"
    )]
    SpeaksNone {
        /// The engine's name.
        engine: String,
        /// The dialects that Stickler knows, in a list.
        known: String,
        /// The dialects that the engine names, in a list; `nothing` where it names none.
        spoken: String,
    },
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Dialect;

    #[test]
    fn who_does_not_know_a_defined_dialect_is_asked_by_its_base() {
        let define = |name| DialectName::define(Dialect::custom(name, DialectName::MATIEC, "here"));
        let (known, unknown) = (define("announced").unwrap(), define("unheard-of").unwrap());
        let identity = Identity {
            name: "compiler".to_owned(),
            version: String::new(),
            dialects: vec![DialectName::MATIEC, known],
            abilities: Vec::new(),
            grade: Grade::Code,
            lacks: Vec::new(),
        };
        assert_eq!(identity.asked_in(known), Some(known));
        assert_eq!(identity.asked_in(unknown), Some(DialectName::MATIEC));
        assert_eq!(identity.asked_in(DialectName::MATIEC), Some(DialectName::MATIEC));
        let variant = DialectName::define(Dialect {
            kind: stickler_types::DialectKind::Variant,
            ..Dialect::custom("matiec-with-an-option", DialectName::MATIEC, "here")
        });
        assert_eq!(identity.asked_in(variant.unwrap()), None);
        assert!(!identity.speaks(DialectName::PLCNEXT));
    }
}
