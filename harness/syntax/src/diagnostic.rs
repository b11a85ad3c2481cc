//! Diagnostics with byte spans, as the lexer, the parser and the checker collect them.

use crate::source::Span;
use stickler_types::Code;

/// An error or a warning; its code says which.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SpannedDiagnostic {
    /// The kind of error.
    pub code: Code,
    /// The place: the value's span for a type error.
    pub span: Span,
    /// The message: a lower-case fragment without a full stop.
    pub message: String,
    /// Text that replaces exactly `span` and makes the program acceptable.
    pub suggestion: Option<String>,
}

impl SpannedDiagnostic {
    /// Makes a diagnostic without a suggestion.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> SpannedDiagnostic {
        SpannedDiagnostic {
            code,
            span,
            message: message.into(),
            suggestion: None,
        }
    }
}

/// Returns whether a diagnostic is an error, for which the text is rejected.
pub fn has_errors(diagnostics: &[SpannedDiagnostic]) -> bool {
    diagnostics
        .iter()
        .any(|diagnostic| diagnostic.code.severity().is_error())
}

/// A list of diagnostics that stays bounded, whatever the input is.
#[derive(Default, Debug)]
pub struct Diagnostics {
    list: Vec<SpannedDiagnostic>,
}

impl Diagnostics {
    /// The most diagnostics of one stage about one text.
    const MAX: usize = 20_000;

    /// Adds a diagnostic; when the list is full, a last [`Code::LimitExceeded`] says so, and what follows is left out.
    pub fn report(&mut self, code: Code, span: Span, message: impl FnOnce() -> String) {
        match self.list.len() {
            length if length < Self::MAX => self.list.push(SpannedDiagnostic::new(code, span, message())),
            _ => self.overflow(span),
        }
    }

    /// Adds a diagnostic that is already made.
    pub fn push(&mut self, diagnostic: SpannedDiagnostic) {
        match self.list.len() {
            length if length < Self::MAX => self.list.push(diagnostic),
            _ => self.overflow(diagnostic.span),
        }
    }

    fn overflow(&mut self, span: Span) {
        if self.list.len() == Self::MAX {
            let message = format!("more than {} errors; the rest is left out", Self::MAX);
            self.list
                .push(SpannedDiagnostic::new(Code::LimitExceeded, span, message));
        }
    }

    /// Returns whether a diagnostic is an error.
    pub fn has_errors(&self) -> bool {
        has_errors(&self.list)
    }

    /// Returns the diagnostics in the order of the text.
    pub fn into_list(mut self) -> Vec<SpannedDiagnostic> {
        self.list.sort_by_key(|diagnostic| diagnostic.span.start);
        self.list
    }
}

/// Quotes a piece of source text in a message, cut where it is long.
pub fn quoted(text: &str) -> String {
    const MAX_CHARACTERS: usize = 40;
    match text.char_indices().nth(MAX_CHARACTERS) {
        Some((end, _)) => ["`", text.get(..end).unwrap_or_default(), "…`"].concat(),
        None => ["`", text, "`"].concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flood_of_diagnostics_ends_with_a_word_about_it() {
        let mut diagnostics = Diagnostics::default();
        for start in (0..).take(2 * Diagnostics::MAX) {
            diagnostics.report(Code::SyntaxError, Span { start, end: start }, String::new);
        }
        let list = diagnostics.into_list();
        assert_eq!(list.len(), Diagnostics::MAX + 1);
        assert_eq!(list.last().map(|last| last.code), Some(Code::LimitExceeded));
    }
}
