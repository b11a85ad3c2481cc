//! The smoke set, `smoke.toml`, which says what its keys mean.

use crate::{Ability, Observation};
use serde::Deserialize;
use std::collections::BTreeMap;

const SMOKE_SET: &str = include_str!("smoke.toml");

/// The questions of the smoke set, and their programs.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SmokeSet {
    programs: BTreeMap<String, String>,
    pub(super) questions: Vec<SmokeQuestion>,
}

/// One question, and the answer that must come back.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SmokeQuestion {
    /// The rule that must hold, as a sentence without its full stop.
    pub(super) rule: String,
    pub(super) ask: Ask,
    pub(super) expect: SmokeExpectation,
}

/// The request of a question; programs by their names.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Ask {
    Check(String),
    Run(SmokeRun),
    Render(String),
    NoDialect,
    FurtherKey,
    Line(String),
}

/// A program to run.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SmokeRun {
    pub(super) program: String,
    #[serde(default = "one")]
    pub(super) scans: u32,
    observe: Vec<String>,
}

fn one() -> u32 {
    1
}

/// The answer that must come back.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum SmokeExpectation {
    Accepted,
    Rejected { line: Option<u32> },
    Values(Vec<String>),
    Rendered,
    Refused,
    Error,
}

impl SmokeSet {
    /// The name of the plain program.
    pub(super) const PLAIN: &str = "plain";

    /// Reads the smoke set.
    ///
    /// # Errors
    /// None in practice: each validation reads the same text.
    pub(super) fn read() -> Result<SmokeSet, String> {
        toml::from_str(SMOKE_SET).map_err(|error| error.to_string())
    }

    /// Returns a program.
    pub(super) fn program(&self, name: &str) -> &str {
        self.programs.get(name).map_or("", String::as_str)
    }
}

impl SmokeQuestion {
    /// Returns the abilities that an engine needs to be asked this question.
    pub(super) fn needs(&self) -> &'static [Ability] {
        match &self.ask {
            Ask::Run(run) if run.scans == 1 => &[Ability::Execute],
            Ask::Run(_) => &[Ability::Execute, Ability::Scans],
            Ask::Render(_) => &[Ability::Render],
            Ask::Check(_) | Ask::NoDialect | Ask::FurtherKey => &[Ability::Check],
            Ask::Line(_) => &[],
        }
    }
}

impl SmokeRun {
    /// Returns the observed variables, each with its key and its type.
    pub(super) fn observed(&self) -> impl Iterator<Item = (&str, &str)> {
        self.observe.iter().filter_map(|asked| asked.split_once(' '))
    }

    /// Returns what is sent to observe the variables.
    pub(super) fn observe(&self) -> Vec<Observation> {
        let message = |(key, type_name): (&str, &str)| {
            let (name, after) = key.split_once('@').unwrap_or((key, ""));
            Observation {
                after: after.parse().ok(),
                ..Observation::last(name, type_name)
            }
        };
        self.observed().map(message).collect()
    }
}
