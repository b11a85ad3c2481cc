//! The errors of the compiler: the part of the compiled text that each is about, and the registry's codes for them.

use crate::Diagnostic;
use crate::adapters::Compiler;

/// The part of the compiled text that an error is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ErrorPart {
    /// The program at this place of the pack.
    Program(usize),
    /// This line of the functions that show the values of programs.
    Functions(u32),
    /// Other text, or an unknown part.
    Elsewhere,
}

/// An error, and the part that it is about.
pub(super) type LocatedDiagnostic = (ErrorPart, Diagnostic);

/// Returns the diagnostics with the registry's codes, sorted by line, column and code, each once.
pub(super) fn sorted(diagnostics: impl Iterator<Item = Diagnostic>) -> Vec<Diagnostic> {
    let mut diagnostics: Vec<Diagnostic> = diagnostics.map(translated).collect();
    diagnostics.sort_by(|a, b| (a.line, a.column, &a.code).cmp(&(b.line, b.column, &b.code)));
    diagnostics.dedup();
    diagnostics
}

/// Returns the diagnostic with the registry's code where the compiler's own means the same.
fn translated(diagnostic: Diagnostic) -> Diagnostic {
    let own = diagnostic.code.as_deref().unwrap_or_default();
    match Compiler::Rusty.data().code(own) {
        Some(code) => Diagnostic {
            code: Some(code.as_str().to_owned()),
            message: format!("{own}: {}", diagnostic.message),
            ..diagnostic
        },
        None => diagnostic,
    }
}
