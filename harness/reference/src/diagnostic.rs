//! Diagnostics as the stages of the reference collect them, with byte spans.

use crate::source::Span;
use stickler_types::Code;

/// Something wrong with a source text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// What kind of thing is wrong.
    pub code: Code,
    /// Where: the value's span for a type error.
    pub span: Span,
    /// What is wrong here, as a lower-case fragment without a full stop.
    pub message: String,
    /// Text that replaces exactly `span` and makes the program acceptable.
    pub suggestion: Option<String>,
}

impl Diagnostic {
    /// A diagnostic without a suggestion.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic { code, span, message: message.into(), suggestion: None }
    }
}
