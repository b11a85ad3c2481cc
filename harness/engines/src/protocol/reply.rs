//! The messages that an engine sends back.

use crate::{Ability, Diagnostic, Grade, NamedValue, Outcome};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// One line from an engine.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "type", rename_all = "lowercase")]
pub enum Reply {
    /// Answers `hello`.
    Hello(HelloReply),
    /// The program is accepted; nothing was executed.
    Accepted {
        /// The request's id.
        id: u64,
        /// The warnings, each with `severity` `warning`, sorted by line, column and code.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        diagnostics: Vec<Diagnostic>,
    },
    /// The program ran to the end of its last scan.
    Executed {
        /// The request's id.
        id: u64,
        /// Each value under the name by which it was asked for, as a typed literal in its canonical spelling.
        values: BTreeMap<String, String>,
        /// The warnings of the compiler, each with `severity` `warning`, sorted by line, column and code.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        diagnostics: Vec<Diagnostic>,
    },
    /// The program is rejected.
    Rejected {
        /// The request's id.
        id: u64,
        /// The diagnostics, sorted by line, column and code; all that a person would want at once.
        diagnostics: Vec<Diagnostic>,
    },
    /// The program stopped at a run-time fault.
    Faulted {
        /// The request's id.
        id: u64,
        /// The kind of the fault: `division-by-zero`, `subscript-range`, `subrange`, `null-dereference`, `invalid-address`, `recursion` or `step-limit`, which cases expect, or the compiler's
        /// own words for any other.
        #[cfg_attr(test, schemars(extend("enum" = ["division-by-zero", "subscript-range", "subrange", "null-dereference", "invalid-address", "recursion", "step-limit"])))]
        fault: String,
        /// The line, from 1.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, schemars(range(min = 1)))]
        line: Option<u32>,
        /// The values observed so far.
        #[serde(default)]
        values: BTreeMap<String, String>,
        /// The warnings of the compiler, each with `severity` `warning`, sorted by line, column and code.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        diagnostics: Vec<Diagnostic>,
    },
    /// The program as normalised source.
    Rendered {
        /// The request's id.
        id: u64,
        /// The whole source.
        text: String,
    },
    /// The engine cannot answer this request.
    Unsupported {
        /// The request's id.
        id: u64,
        /// The reason, as a fragment.
        reason: String,
        /// Whether it is the compiler that reports a construct of the program as not implemented. Such an answer fails a case where
        /// a document of the compiler promises the construct.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        not_implemented: bool,
    },
    /// The request could not be understood; the engine lives on.
    Error {
        /// The request's id, where it could be read.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<u64>,
        /// The reason why the request could not be understood.
        message: String,
    },
}

/// The identity of the engine.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct HelloReply {
    /// The version of the protocol that the engine speaks.
    pub protocol: u32,
    /// The engine's name.
    pub name: String,
    /// The engine's version.
    pub version: String,
    /// The dialects that the engine speaks.
    pub dialects: Vec<String>,
    /// The abilities of the engine.
    pub abilities: Vec<Ability>,
    /// The best grade that can be asked of the engine's rejections: `code` where its diagnostics have the registry's codes and
    /// the lines, `line` where only the lines are sure, `rejected` where it only says that a program is rejected.
    #[serde(default)]
    pub grade: Grade,
}

impl Reply {
    /// Returns an error about the request with this id.
    pub(super) fn error(id: Option<u64>, message: impl Into<String>) -> Reply {
        Reply::Error {
            id,
            message: message.into(),
        }
    }

    /// Returns the `id` of the request that the reply answers; `None` where the reply repeats none.
    pub fn id(&self) -> Option<u64> {
        match self {
            Reply::Hello(_) => None,
            Reply::Error { id, .. } => *id,
            Reply::Accepted { id, .. } | Reply::Executed { id, .. } | Reply::Rejected { id, .. } => Some(*id),
            Reply::Faulted { id, .. } | Reply::Rendered { id, .. } | Reply::Unsupported { id, .. } => {
                Some(*id)
            }
        }
    }

    /// Returns the `type` of the reply on the wire, such as `accepted`.
    pub fn word(&self) -> &'static str {
        match self {
            Reply::Hello(_) => "hello",
            Reply::Accepted { .. } => "accepted",
            Reply::Executed { .. } => "executed",
            Reply::Rejected { .. } => "rejected",
            Reply::Faulted { .. } => "faulted",
            Reply::Rendered { .. } => "rendered",
            Reply::Unsupported { .. } => "unsupported",
            Reply::Error { .. } => "error",
        }
    }

    /// Returns the reply that reports an outcome. The protocol has no words for a crash or a time limit, since a dead engine
    /// cannot speak: where an engine survives one, the reply is an error.
    pub fn from_outcome(id: u64, outcome: Outcome) -> Reply {
        match outcome {
            Outcome::Accepted { warnings } => Reply::Accepted {
                id,
                diagnostics: warnings,
            },
            Outcome::Executed { values, warnings } => Reply::Executed {
                id,
                values: literals(values),
                diagnostics: warnings,
            },
            Outcome::Rejected { diagnostics } => Reply::Rejected { id, diagnostics },
            Outcome::Faulted {
                fault,
                line,
                values,
                warnings,
            } => Reply::Faulted {
                id,
                fault: fault.as_str().to_owned(),
                line,
                values: literals(values),
                diagnostics: warnings,
            },
            Outcome::Rendered { text } => Reply::Rendered { id, text },
            Outcome::Unsupported { reason } => Reply::Unsupported {
                id,
                reason,
                not_implemented: false,
            },
            Outcome::NotImplemented { reason } => Reply::Unsupported {
                id,
                reason,
                not_implemented: true,
            },
            Outcome::Crashed { reason } => Reply::error(Some(id), format!("the engine crashed: {reason}")),
            Outcome::TimedOut { .. } | Outcome::Unusable { .. } => {
                Reply::error(Some(id), outcome.to_string())
            }
            Outcome::Error { message } => Reply::error(Some(id), message),
        }
    }
}

fn literals(values: Vec<NamedValue>) -> BTreeMap<String, String> {
    values
        .into_iter()
        .map(|(name, value)| (name, value.to_string()))
        .collect()
}
