//! The record of a case in a manifest: all that is needed to judge and report the case later, without the suite.

use serde::{Deserialize, Serialize};
use std::sync::Arc;
use stickler_engines::protocol::ObserveMessage;
use stickler_suite::{Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedValue};
use stickler_types::{Code, DialectName, Observation, Question, Value};

/// The record of a case. Its program is that of the suite, not that of a page.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(crate) struct CaseRecord {
    pub(crate) id: String,
    title: String,
    basis: String,
    file: String,
    line: u32,
    area: String,
    source: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    question: Option<Question>,
    accepted: RequiredAcceptance,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    diagnostics: Vec<(u32, String)>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    values: Vec<ValueRecord>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    observe: Vec<ObserveMessage>,
}

/// The demand on the acceptance of the program.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum RequiredAcceptance {
    Required,
    Rejected,
    Open,
}

/// The value that a variable must have, as a typed literal, and the line of the case file that states it.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
struct ValueRecord {
    name: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    after: Option<u32>,
    value: String,
    line: u32,
}

impl CaseRecord {
    pub(crate) fn of(case: &Case) -> CaseRecord {
        let expectation = &*case.expectation;
        let values = expectation.values.iter().map(|value| ValueRecord {
            name: value.name.to_string(),
            after: value.after,
            value: value.value.to_string(),
            line: value.line,
        });
        let diagnostics = expectation.diagnostics.iter();
        CaseRecord {
            id: case.id.to_string(),
            title: case.title.to_string(),
            basis: case.basis.to_string(),
            file: case.file.to_string(),
            line: case.line,
            area: case.area.to_string(),
            source: case.source.to_string(),
            question: case.question.as_deref().cloned(),
            accepted: match expectation.accepted {
                Acceptance::Required => RequiredAcceptance::Required,
                Acceptance::Rejected => RequiredAcceptance::Rejected,
                Acceptance::Observed => RequiredAcceptance::Open,
            },
            diagnostics: diagnostics
                .map(|reported| (reported.line, reported.code.as_str().to_owned()))
                .collect(),
            values: values.collect(),
            observe: case.observe.iter().map(ObserveMessage::from).collect(),
        }
    }

    /// Returns the case of the record.
    ///
    /// # Errors
    /// A fragment that names an invalid value or diagnostic code of the record.
    pub(crate) fn case(&self, dialect: DialectName) -> Result<Case, String> {
        let values = self.values.iter().map(|record| {
            let value = Value::parse_expected(&record.value)
                .map_err(|error| format!("`{}` of {} is no value: {error}", record.value, self.id))?;
            Ok(ExpectedValue {
                name: record.name.as_str().into(),
                after: record.after,
                value,
                line: record.line,
            })
        });
        let diagnostics = self.diagnostics.iter().map(|(line, code)| {
            let known = code.parse::<Code>();
            Ok(ExpectedDiagnostic {
                line: *line,
                code: known.map_err(|_| format!("`{code}` of {} is no code", self.id))?,
            })
        });
        Ok(Case {
            title: self.title.as_str().into(),
            basis: self.basis.as_str().into(),
            file: self.file.as_str().into(),
            area: self.area.as_str().into(),
            line: self.line,
            expectation: Arc::new(Expectation {
                accepted: match self.accepted {
                    RequiredAcceptance::Required => Acceptance::Required,
                    RequiredAcceptance::Rejected => Acceptance::Rejected,
                    RequiredAcceptance::Open => Acceptance::Observed,
                },
                diagnostics: diagnostics.collect::<Result<_, String>>()?,
                values: values.collect::<Result<_, String>>()?,
                ..Expectation::default()
            }),
            observe: self.observe.iter().map(Observation::from).collect(),
            question: self.question.clone().map(Arc::new),
            ..Case::of_program(&self.id, dialect, &self.source)
        })
    }
}
