//! The meanings of the diagnostic codes of a compiler, and the outcomes that follow from its diagnostics.

use super::described::Parsed;
use super::locate::unsupported;
use crate::{Diagnostic, Outcome};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::str::FromStr;
use stickler_types::Code;

/// The meanings of a compiler's own diagnostic codes.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(transparent)]
pub(super) struct CompilerCodes(BTreeMap<String, Parsed<CodeMeaning>>);

impl CompilerCodes {
    /// Returns the meaning of the code of a diagnostic, where it is not about the program but about the compiler.
    pub(super) fn of_itself(&self, diagnostic: &Diagnostic) -> Option<&CodeMeaning> {
        let meaning = &self.0.get(diagnostic.code.as_ref()?)?.0;
        (!matches!(meaning, CodeMeaning::Code(_) | CodeMeaning::NeverReported)).then_some(meaning)
    }

    /// Returns the codes of the registry that the compiler documents and never reports.
    pub(super) fn never_reported(&self) -> impl Iterator<Item = Code> {
        let never = self
            .0
            .iter()
            .filter(|(_, meaning)| meaning.0 == CodeMeaning::NeverReported);
        never.filter_map(|(code, _)| code.parse().ok())
    }

    /// Returns whether one of the codes means the same as this code of the registry.
    pub(super) fn say(&self, sought: Code) -> bool {
        let mut meanings = self.0.values();
        meanings.any(|meaning| matches!(meaning.0, CodeMeaning::Code(code) if code == sought))
    }

    /// Returns the diagnostic with the code of the registry that means the same as the compiler's own, if there is one.
    pub(super) fn translated(&self, diagnostic: Diagnostic) -> Diagnostic {
        let meaning = diagnostic.code.as_ref().and_then(|code| self.0.get(code));
        match meaning.map(|meaning| &meaning.0) {
            Some(CodeMeaning::Code(code)) => Diagnostic {
                code: Some(code.as_str().to_owned()),
                message: described(&diagnostic),
                ..diagnostic
            },
            _ => diagnostic,
        }
    }

    /// Returns the outcome of a program with these errors: a rejection where one is about the program; otherwise
    /// [`Outcome::Crashed`] where the compiler reports a failure of its own, [`Outcome::NotImplemented`] where it reports that it
    /// does not implement a construct, and [`Outcome::Unsupported`] where it reports that it does not support the program.
    pub(super) fn outcome(&self, diagnostics: Vec<Diagnostic>) -> Outcome {
        let meanings: Option<Vec<&CodeMeaning>> = diagnostics
            .iter()
            .map(|diagnostic| self.of_itself(diagnostic))
            .collect();
        let Some(meanings) = meanings else {
            let diagnostics = diagnostics
                .into_iter()
                .map(|diagnostic| self.translated(diagnostic));
            return Outcome::Rejected {
                diagnostics: diagnostics.collect(),
            };
        };
        let first = |sought: CodeMeaning| {
            let at = meanings.iter().position(|meaning| **meaning == sought)?;
            Some(described(&diagnostics[at]))
        };
        if let Some(reason) = first(CodeMeaning::Crashed) {
            return Outcome::Crashed { reason };
        }
        match first(CodeMeaning::NotImplemented) {
            Some(reason) => Outcome::NotImplemented { reason },
            None => unsupported(first(CodeMeaning::Unsupported).unwrap_or_default()),
        }
    }
}

/// Returns diagnostics sorted by line, column and code, each once.
pub(super) fn sorted(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    diagnostics.sort_by(|a, b| (a.line, a.column, &a.code).cmp(&(b.line, b.column, &b.code)));
    diagnostics.dedup();
    diagnostics
}

/// Formats a diagnostic in one line, with the compiler's own code.
fn described(diagnostic: &Diagnostic) -> String {
    match &diagnostic.code {
        Some(code) => format!("{code}: {}", diagnostic.message),
        None => diagnostic.message.clone(),
    }
}

/// The meaning of a diagnostic code of the compiler's own.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum CodeMeaning {
    /// A code of the registry with the same meaning.
    Code(Code),
    /// The compiler cannot do what was asked.
    Unsupported,
    /// The compiler does not implement a construct of the program.
    NotImplemented,
    /// The compiler failed.
    Crashed,
    /// The compiler documents the code, and has no place that reports it.
    NeverReported,
}

impl FromStr for CodeMeaning {
    type Err = String;

    fn from_str(text: &str) -> Result<CodeMeaning, String> {
        match text {
            "unsupported" => Ok(CodeMeaning::Unsupported),
            "not-implemented" => Ok(CodeMeaning::NotImplemented),
            "crashed" => Ok(CodeMeaning::Crashed),
            "never-reported" => Ok(CodeMeaning::NeverReported),
            code => code.parse().map(CodeMeaning::Code).map_err(|_| {
                format!(
                    "`{text}` is no code of Stickler's; `stickler explain` lists them, and there are `unsupported`, \
                     `not-implemented`, `crashed` and `never-reported`"
                )
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Compiler;
    use super::*;

    #[test]
    fn a_code_that_is_never_reported_is_not_about_the_compiler_itself() {
        let codes = &Compiler::Ironplc.data().codes;
        let never: Vec<Code> = codes.never_reported().collect();
        assert!(never.contains(&Code::Std2013Feature));
        let reported = |code: &str| Diagnostic {
            code: Some(code.to_owned()),
            ..Diagnostic::default()
        };
        assert_eq!(codes.of_itself(&reported("P0010")), None);
        assert_eq!(codes.of_itself(&reported("P9998")), Some(&CodeMeaning::Crashed));
    }
}
