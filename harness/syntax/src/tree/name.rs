//! Identifiers.
//!
//! Basis: iec-61131-3: 6.1.2 (identifiers compare without regard to case).

use crate::source::Span;
use std::hash::{Hash, Hasher};

/// An identifier as written.
#[derive(Clone, Copy, Debug)]
pub struct Name<'s> {
    /// The identifier as written.
    pub text: &'s str,
    /// The place in the text.
    pub span: Span,
}

/// Returns `THIS` or `SUPER` for a name of the instance whose code is running, behind which `^` may stand; `None` for other names.
pub fn own_instance(name: &str) -> Option<&'static str> {
    let word = name.trim_end_matches('^');
    ["THIS", "SUPER"]
        .into_iter()
        .find(|own| own.eq_ignore_ascii_case(word))
}

impl<'s> Name<'s> {
    /// Returns the name of a type without the namespaces that qualify it: `CALENDAR` of `OSCAT_BASIC.CALENDAR`.
    pub fn unqualified(self) -> Name<'s> {
        let text = self.text.rsplit('.').next().unwrap_or(self.text).trim_start();
        // It is the end of a text that 32 bits measure.
        let start = self.span.end - text.len() as u32;
        let span = Span { start, ..self.span };
        Name { text, span }
    }

    /// Returns whether the identifier is this one, in any ASCII case.
    pub fn is(&self, name: &str) -> bool {
        self.text.eq_ignore_ascii_case(name)
    }
}

/// A word that compares and hashes without regard to ASCII case.
#[derive(Clone, Copy, Debug)]
pub struct CaseFolded<'s>(pub &'s str);

impl PartialEq for CaseFolded<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.0.eq_ignore_ascii_case(other.0)
    }
}

impl Eq for CaseFolded<'_> {}

impl Hash for CaseFolded<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        // Setting the bit that tells upper from lower case makes a few other characters alike too, which costs
        // a collision now and then and saves looking at each byte. Shifting the last characters into a word is
        // quicker than copying them into one (benchmark `render`).
        const LOWER: u64 = 0x2020_2020_2020_2020;
        let (words, rest) = self.0.as_bytes().as_chunks();
        for word in words {
            state.write_u64(u64::from_le_bytes(*word) | LOWER);
        }
        let rest = rest.iter().fold(0, |word, byte| word << 8 | u64::from(*byte));
        state.write_u64(rest | LOWER);
    }
}
