//! The errors of the compiler: the part of the compiled text that each is about, and the registry's codes for them.

use crate::Diagnostic;
use crate::adapters::{Compiler, codes};

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

/// Returns the diagnostics with the registry's codes, sorted, each once.
pub(super) fn sorted(diagnostics: impl Iterator<Item = Diagnostic>) -> Vec<Diagnostic> {
    let codes = &Compiler::Rusty.data().codes;
    codes::sorted(
        diagnostics
            .map(|diagnostic| codes.translated(diagnostic))
            .collect(),
    )
}
