//! The record of a case in a manifest: all that is needed to judge and report the case later, without the suite.

use serde::{Deserialize, Serialize};
use std::sync::Arc;
use stickler_suite::{Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedValue};
use stickler_types::{Code, DialectName, Observation, Question};

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
    accepted: Acceptance,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    diagnostics: Vec<(u32, String)>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    values: Vec<ExpectedValue>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    observe: Vec<Observation>,
}

impl CaseRecord {
    pub(crate) fn of(case: &Case) -> CaseRecord {
        let expectation = &*case.expectation;
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
            accepted: expectation.accepted,
            diagnostics: diagnostics
                .map(|reported| (reported.line, reported.code.as_str().to_owned()))
                .collect(),
            values: expectation.values.clone(),
            observe: case.observe.to_vec(),
        }
    }

    /// Returns the case of the record.
    ///
    /// # Errors
    /// A fragment that names an invalid diagnostic code of the record.
    pub(crate) fn case(&self, dialect: DialectName) -> Result<Case, String> {
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
                accepted: self.accepted,
                diagnostics: diagnostics.collect::<Result<_, String>>()?,
                values: self.values.clone(),
                ..Expectation::default()
            }),
            observe: self.observe.clone().into(),
            question: self.question.clone().map(Arc::new),
            ..Case::of_program(&self.id, dialect, &self.source)
        })
    }
}
