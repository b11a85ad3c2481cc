//! The errors of literals.

/// The reason why a text is not a literal of the requested type.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum LiteralError {
    /// The text does not follow the grammar of the literal.
    #[error("expected {expected} at byte {at}")]
    Malformed {
        /// The byte offset at which reading stopped.
        at: usize,
        /// The text that was expected there.
        expected: &'static str,
    },
    /// The literal is well formed, but its type has no such value.
    #[error("the value at byte {at} is outside the range of {range}")]
    Overflow {
        /// The byte offset at which the value begins.
        at: usize,
        /// The range that the value had to fit.
        range: &'static str,
    },
    /// A `$` in a character string begins no escape sequence of the standard.
    #[error("unknown escape at byte {at}")]
    Escape {
        /// The byte offset of the `$`.
        at: usize,
    },
    /// A character is too wide for a string of single-byte characters.
    #[error("the character at byte {at} does not fit a single byte")]
    Character {
        /// The byte offset of the character.
        at: usize,
    },
}

impl LiteralError {
    pub(crate) const fn malformed(at: usize, expected: &'static str) -> LiteralError {
        LiteralError::Malformed { at, expected }
    }

    pub(crate) const fn overflow(at: usize, range: &'static str) -> LiteralError {
        LiteralError::Overflow { at, range }
    }

    /// Returns the byte offset of the error in the literal.
    pub const fn offset(&self) -> usize {
        match *self {
            LiteralError::Malformed { at, .. }
            | LiteralError::Overflow { at, .. }
            | LiteralError::Escape { at }
            | LiteralError::Character { at } => at,
        }
    }

    /// Returns the same error for a text that has `by` more bytes in front.
    pub const fn shifted(mut self, by: usize) -> LiteralError {
        match &mut self {
            LiteralError::Malformed { at, .. }
            | LiteralError::Overflow { at, .. }
            | LiteralError::Escape { at }
            | LiteralError::Character { at } => *at += by,
        }
        self
    }
}
