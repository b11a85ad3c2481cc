//! The messages that are sent to an engine.

use crate::Observation;
use serde::{Deserialize, Serialize};

/// One line to an engine.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "type", rename_all = "lowercase")]
pub enum Request {
    /// Opens a conversation; answered by `hello`.
    Hello {
        /// The version of the protocol that the caller speaks.
        protocol: u32,
    },
    /// Executes a program; answered by `executed`, `rejected`, `faulted`, `unsupported`, `error`, or, by an
    /// engine that can only check, `accepted`.
    Run(RunMessage),
    /// Checks a program; answered by `accepted`, `rejected`, `unsupported` or `error`.
    Check(ProgramRequest),
    /// Asks for normalised source; answered by `rendered`, `rejected`, `unsupported` or `error`.
    Render(ProgramRequest),
    /// Ends the conversation; not answered.
    Bye,
}

/// A program to check or to render.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ProgramRequest {
    /// The id of the request, which the reply repeats.
    pub id: u64,
    /// The dialect's name.
    pub dialect: String,
    /// The whole source text.
    pub source: String,
}

/// A program to execute.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RunMessage {
    /// The id of the request, which the reply repeats.
    pub id: u64,
    /// The dialect's name.
    pub dialect: String,
    /// The whole source text.
    pub source: String,
    /// The number of scans to run; 1 where none is given.
    #[serde(default = "one_scan")]
    pub scans: u32,
    /// The variables whose values are wanted.
    #[serde(default)]
    pub observe: Vec<Observation>,
    /// The simulated time before each scan.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub clock: Vec<ClockMessage>,
    /// Variables written between scans.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub set: Vec<SetMessage>,
}

/// The simulated time before a scan.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ClockMessage {
    /// The scan (from 1).
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub before: u32,
    /// The time since the start, as a TIME or LTIME literal.
    pub value: String,
}

/// A variable written before a scan.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SetMessage {
    /// The scan (from 1).
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub before: u32,
    /// The variable or path.
    pub name: String,
    /// The value that is written, as a typed literal.
    pub value: String,
}

fn one_scan() -> u32 {
    1
}
