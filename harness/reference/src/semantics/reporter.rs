//! Collects the checker's diagnostics.

use crate::diagnostic::{Diagnostics, SpannedDiagnostic};
use crate::source::Span;
use stickler_types::Code;

/// Collects diagnostics; can be muted while something is lowered once more.
#[derive(Debug, Default)]
pub(super) struct Reporter {
    diagnostics: Diagnostics,
    muted: bool,
    reported: usize,
}

impl Reporter {
    /// Reports something wrong at a place.
    pub(super) fn report(&mut self, code: Code, span: Span, message: impl Into<String>) {
        self.push(SpannedDiagnostic::new(code, span, message));
    }

    /// Reports a diagnostic that is already made, with its suggestion.
    pub(super) fn push(&mut self, diagnostic: SpannedDiagnostic) {
        self.reported += 1;
        if !self.muted {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Mutes or unmutes; returns the state before.
    pub(super) fn mute(&mut self, muted: bool) -> bool {
        std::mem::replace(&mut self.muted, muted)
    }

    /// Returns how many diagnostics have been reported so far, the muted ones included.
    pub(super) fn reported(&self) -> usize {
        self.reported
    }

    /// Returns whether nothing has been reported yet.
    pub(super) fn is_empty(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// Returns all diagnostics in the order of the text.
    pub(super) fn finish(self) -> Vec<SpannedDiagnostic> {
        self.diagnostics.into_list()
    }
}
