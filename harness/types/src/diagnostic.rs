//! The diagnostics of compilers: errors and warnings.

use crate::{Code, words};
use serde::{Deserialize, Serialize};
use std::fmt;

words! {
    /// The weight of a diagnostic.
    #[derive(Default, Serialize, Deserialize)]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[serde(rename_all = "lowercase")]
    Severity {
        /// The program is rejected.
        #[default]
        Error = "error",
        /// The program is accepted all the same.
        Warning = "warning",
    }
}

impl Severity {
    /// Returns whether this is [`Severity::Error`].
    pub fn is_error(&self) -> bool {
        *self == Severity::Error
    }
}

/// A diagnostic that an engine reports for a program. A foreign engine may report only the message; the reference always
/// reports a registered code and the whole span.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Diagnostic {
    /// A code of Stickler's registry, or the engine's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// The weight; an error where it is absent.
    #[serde(default, skip_serializing_if = "Severity::is_error")]
    pub severity: Severity,
    /// The line, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub line: Option<u32>,
    /// The column, from 1, in Unicode scalar values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub column: Option<u32>,
    /// The line on which the span ends, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub end_line: Option<u32>,
    /// The column after the last character of the span.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(range(min = 1)))]
    pub end_column: Option<u32>,
    /// A description of the problem, for a person.
    #[serde(default)]
    pub message: String,
    /// A text that replaces exactly the span and makes the program acceptable.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub suggestion: Option<String>,
}

impl Diagnostic {
    /// Returns whether the program is rejected because of this diagnostic.
    pub fn is_error(&self) -> bool {
        self.severity.is_error()
    }

    /// Returns the code, if the registry has it.
    pub fn registered_code(&self) -> Option<Code> {
        self.code.as_deref()?.parse().ok()
    }
}

impl fmt::Display for Diagnostic {
    /// Writes `P4035 on line 6, column 13: …` without the unknown parts; `error` or `warning` stands in for a missing code.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code.as_deref().unwrap_or(self.severity.as_str()))?;
        if let Some(line) = self.line {
            write!(f, " on line {line}")?;
            if let Some(column) = self.column {
                write!(f, ", column {column}")?;
            }
        }
        write!(f, ": {}", self.message)
    }
}
