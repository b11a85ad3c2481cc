//! Collects the checker's diagnostics.

use stickler_syntax::diagnostic::{Diagnostics, SpannedDiagnostic};
use stickler_syntax::source::Span;
use stickler_types::Code;

/// Collects diagnostics; can be muted while something is lowered once more.
#[derive(Debug, Default)]
pub(super) struct Reporter {
    diagnostics: Diagnostics,
    muted: bool,
    /// The number of errors so far, the muted ones included.
    errors: usize,
}

impl Reporter {
    /// Reports something wrong at a place.
    pub(super) fn report(&mut self, code: Code, span: Span, message: impl Into<String>) {
        self.push(SpannedDiagnostic::new(code, span, message));
    }

    /// Reports a diagnostic that is already made, with its suggestion.
    pub(super) fn push(&mut self, diagnostic: SpannedDiagnostic) {
        self.errors += usize::from(diagnostic.code.severity().is_error());
        if !self.muted {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Mutes or unmutes; returns the state before.
    pub(super) fn mute(&mut self, muted: bool) -> bool {
        std::mem::replace(&mut self.muted, muted)
    }

    /// Returns how many errors have been reported so far, the muted ones included.
    pub(super) fn errors(&self) -> usize {
        self.errors
    }

    /// Returns whether an error has been reported that was not muted.
    pub(super) fn has_errors(&self) -> bool {
        self.diagnostics.has_errors()
    }

    /// Returns all diagnostics in the order of the text.
    pub(super) fn finish(self) -> Vec<SpannedDiagnostic> {
        self.diagnostics.into_list()
    }
}
