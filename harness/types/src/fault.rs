//! The faults that stop an execution.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;
use std::sync::{Mutex, PoisonError};

/// The reason why an execution stopped before its end.
///
/// Basis: Stickler's wire protocol; the standard leaves run-time errors to the implementer.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Fault {
    /// An integer division, or a modulo, by zero.
    DivisionByZero,
    /// An array subscript outside its declared bounds.
    SubscriptRange,
    /// A value outside the limits of the subrange that was to hold it.
    Subrange,
    /// A reference, pointer or variable of an interface was followed that leads nowhere.
    NullDereference,
    /// A pointer was followed to where no variable lies, or not the whole of what it is to lead to: past the end of a variable, or to one
    /// of a function that has returned.
    InvalidAddress,
    /// A function or method was called while it was running.
    Recursion,
    /// The program did not end within the permitted number of steps.
    StepLimit,
    /// Another reason, in the compiler's own words; no case expects it.
    Own(&'static str),
}

/// The maximum number of characters of a compiler's own words.
const MAX_OWN_LEN: usize = 100;

/// The maximum number of compilers' own words that a process keeps.
const MAX_OWN: usize = 1000;

/// The compilers' own words so far, which live as long as the process, because a fault is copied into every outcome.
static OWN: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());

impl Fault {
    /// The faults that cases expect.
    pub const ALL: &'static [Fault] = &[
        Fault::DivisionByZero,
        Fault::SubscriptRange,
        Fault::Subrange,
        Fault::NullDereference,
        Fault::InvalidAddress,
        Fault::Recursion,
        Fault::StepLimit,
    ];

    /// Returns the word of the fault.
    pub const fn as_str(self) -> &'static str {
        match self {
            Fault::DivisionByZero => "division-by-zero",
            Fault::SubscriptRange => "subscript-range",
            Fault::Subrange => "subrange",
            Fault::NullDereference => "null-dereference",
            Fault::InvalidAddress => "invalid-address",
            Fault::StepLimit => "step-limit",
            Fault::Recursion => "recursion",
            Fault::Own(words) => words,
        }
    }

    /// Returns the fault that an engine reports by these words: one of [`Fault::ALL`], or else one of its own, of which the first line
    /// is kept.
    pub fn reported(words: &str) -> Fault {
        let line = words.trim().lines().next().unwrap_or_default().trim_end();
        if let Ok(known) = line.parse() {
            return known;
        }
        let line: String = line.chars().take(MAX_OWN_LEN).collect();
        let mut own = OWN.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = own.get(line.as_str()) {
            return Fault::Own(known);
        }
        if line.is_empty() || own.len() >= MAX_OWN {
            return Fault::Own("a fault of its own");
        }
        let kept: &'static str = Box::leak(line.into_boxed_str());
        own.insert(kept);
        Fault::Own(kept)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// A fault is written as its word, which may be one of a compiler.
impl Serialize for Fault {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Fault {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Fault, D::Error> {
        Cow::<'de, str>::deserialize(deserializer).map(|words| Fault::reported(&words))
    }
}

/// The error of a word that names none of [`Fault::ALL`].
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error(
    "unknown fault `{0}`; the faults are `division-by-zero`, `subscript-range`, `subrange`, `null-dereference`, `invalid-address`, `recursion` and `step-limit`"
)]
pub struct UnknownFault(pub String);

impl FromStr for Fault {
    type Err = UnknownFault;

    /// Parses exactly the words of [`Fault::ALL`].
    fn from_str(text: &str) -> Result<Fault, UnknownFault> {
        let mut known = Fault::ALL.iter().copied();
        known
            .find(|known| known.as_str() == text)
            .ok_or_else(|| UnknownFault(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fault_is_read_back_and_the_error_for_an_unknown_word_lists_all() {
        let message = "overflow".parse::<Fault>().unwrap_err().to_string();
        assert!(message.contains("`overflow`"), "{message}");
        for fault in Fault::ALL {
            assert_eq!(fault.to_string().parse(), Ok(*fault));
            assert_eq!(Fault::reported(fault.as_str()), *fault);
            assert!(
                message.contains(&format!("`{fault}`")),
                "{message} does not name {fault}"
            );
        }
    }

    #[test]
    fn a_compiler_may_use_words_of_its_own() {
        let overflow = Fault::reported(" integer overflow \nat line 5");
        assert_eq!(overflow.as_str(), "integer overflow");
        assert_eq!(overflow, Fault::reported("integer overflow"));
        assert_ne!(overflow, Fault::reported("overflow"));
        assert_eq!(Fault::reported("\n"), Fault::reported(""));
    }
}
