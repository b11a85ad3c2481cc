//! The compiler in a process of Node, which translates one program after another.

use crate::adapters::codes::sorted;
use crate::adapters::locate::failed;
use crate::process::{CommandLine, Connection, Failure, Folder, ToolLimits, milliseconds, time_limit};
use crate::{Diagnostic, Outcome, Severity};
use serde::Deserialize;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use stickler_types::Code;

/// The script that Node runs.
const SCRIPT: &str = include_str!("translator.mjs");

/// The longest answer of the script, in bytes: the C++ of a program is many times as long as the program.
const MAX_ANSWER_LEN: usize = 64 << 20;

/// The processes of Node that are started for as many programs as are translated at once, and live as long as they answer.
pub(super) struct Translator {
    command: CommandLine,
    /// The processes that translate nothing now: Node is slow to start.
    idle: Mutex<Vec<Connection>>,
    /// The folder of the script.
    _script: Folder,
}

/// The answer of the script.
#[derive(Deserialize)]
pub(super) struct Translated {
    #[serde(default)]
    success: bool,
    #[serde(default)]
    diagnostics: Vec<TranslatorDiagnostic>,
    #[serde(default)]
    pub(super) program: String,
    #[serde(default)]
    pub(super) header: String,
    /// The exception that the compiler threw, if any.
    crash: Option<String>,
}

/// A diagnostic of the compiler. Line 0 stands for an unknown line.
#[derive(Deserialize)]
struct TranslatorDiagnostic {
    message: String,
    line: u32,
    column: u32,
    severity: String,
}

impl Translated {
    /// Returns the diagnostics, sorted, each once.
    pub(super) fn diagnostics(&self) -> Vec<Diagnostic> {
        let reported = self.diagnostics.iter();
        sorted(reported.map(TranslatorDiagnostic::diagnostic).collect())
    }
}

impl TranslatorDiagnostic {
    /// Returns the diagnostic. The compiler has no codes; what it cannot read is Stickler's P0002.
    ///
    /// Basis: strucpp: `src/frontend/parser-error-message-provider.ts`, and the messages of its lexer; measured.
    fn diagnostic(&self) -> Diagnostic {
        let is_unread = ["unexpected character: ", "Unexpected ", "Expected "]
            .iter()
            .any(|beginning| self.message.starts_with(beginning));
        let severity = match self.severity.as_str() {
            "error" => Severity::Error,
            _ => Severity::Warning,
        };
        Diagnostic {
            severity,
            code: is_unread.then(|| Code::SyntaxError.as_str().to_owned()),
            line: Some(self.line).filter(|&line| line > 0),
            column: Some(self.column).filter(|&column| self.line > 0 && column > 0),
            message: self.message.clone(),
            ..Diagnostic::default()
        }
    }
}

impl Translator {
    /// Returns the translator of a compiler's module.
    ///
    /// # Errors
    /// A fragment that says why the script could not be written.
    pub(super) fn new(node: &Path, module: &Path) -> Result<Translator, String> {
        let folder = Folder::new()?;
        let script = folder.write("translator.mjs", SCRIPT)?;
        let arguments = [script.as_path(), module].map(|path| path.to_string_lossy().into_owned());
        Ok(Translator {
            command: CommandLine::of(node.to_string_lossy().into_owned(), arguments.to_vec()),
            idle: Mutex::new(Vec::new()),
            _script: folder,
        })
    }

    /// Translates a program to C++.
    pub(super) fn translate(&self, source: &str) -> Result<Translated, Outcome> {
        let translated = self.ask(source)?;
        if let Some(reason) = translated.crash {
            return Err(Outcome::Crashed { reason });
        }
        if !translated.success {
            return Err(rejected(translated.diagnostics()));
        }
        Ok(translated)
    }

    fn ask(&self, source: &str) -> Result<Translated, Outcome> {
        let limit = time_limit(ToolLimits::default().time);
        let idle = || self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        let waiting = idle().pop();
        let mut translator = match waiting {
            Some(translator) => translator,
            None => Connection::open(&self.command, MAX_ANSWER_LEN).map_err(failed)?,
        };
        let mut line = serde_json::json!({ "source": source }).to_string().into_bytes();
        line.push(b'\n');
        match translator.exchange(line, limit) {
            Ok(reply) => {
                idle().push(translator);
                serde_json::from_slice(&reply)
                    .map_err(|error| failed(format!("its translator answered nonsense: {error}")))
            }
            Err(Failure::Ended) => Err(Outcome::crashed(translator.end())),
            Err(Failure::TimedOut) => Err(Outcome::TimedOut {
                after_ms: milliseconds(limit),
            }),
            Err(Failure::Memory(limit)) => Err(Outcome::crashed(format!(
                "it held more than {} MiB of memory",
                limit >> 20
            ))),
            Err(Failure::Flood) => Err(Outcome::crashed(format!(
                "it wrote more than {MAX_ANSWER_LEN} bytes"
            ))),
        }
    }
}

/// Returns the rejection for these diagnostics; warnings reject nothing.
fn rejected(diagnostics: Vec<Diagnostic>) -> Outcome {
    match diagnostics.iter().any(Diagnostic::is_error) {
        true => Outcome::rejected(diagnostics),
        false => Outcome::crashed("it fails without saying why"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_reject_and_warnings_do_not() {
        let answer = r#"{"success":false,"program":"","header":"","diagnostics":[
            {"message":"Undeclared variable 'Q'","line":4,"column":2,"severity":"error"},
            {"message":"narrowing","line":3,"column":7,"severity":"warning"},
            {"message":"unexpected character: ->#<- at offset: 7, skipped 1 characters.","line":0,"column":0,"severity":"error"}]}"#;
        let translated: Translated = serde_json::from_str(answer).unwrap();
        let Outcome::Rejected { diagnostics } = rejected(translated.diagnostics()) else {
            panic!("not rejected")
        };
        let places: Vec<_> = diagnostics
            .iter()
            .map(|diagnostic| (diagnostic.line, diagnostic.column, diagnostic.code.as_deref()))
            .collect();
        assert_eq!(places, [(None, None, Some("P0002")), (Some(4), Some(2), None)]);
        assert!(matches!(rejected(Vec::new()), Outcome::Crashed { .. }));
        let accepted = r#"{"success":true,"diagnostics":[{"message":"narrowing","line":3,"column":7,"severity":"warning"}]}"#;
        let accepted: Translated = serde_json::from_str(accepted).unwrap();
        let warnings = accepted.diagnostics();
        assert_eq!(warnings.len(), 1);
        assert_eq!(
            (warnings[0].severity, warnings[0].line),
            (Severity::Warning, Some(3))
        );
    }
}
