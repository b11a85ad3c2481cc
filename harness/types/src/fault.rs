//! The faults that stop an execution.

use crate::words::words;
use std::fmt;
use std::str::FromStr;

words! {
    /// The reason why an execution stopped before its end.
    ///
    /// Basis: Stickler's wire protocol; the standard leaves run-time errors to the implementer.
    Fault {
        /// An integer division, or a modulo, by zero.
        DivisionByZero = "division-by-zero",
        /// An array subscript outside its declared bounds.
        SubscriptRange = "subscript-range",
        /// A value outside the limits of the subrange that was to hold it.
        Subrange = "subrange",
        /// The program did not end within the permitted number of steps.
        StepLimit = "step-limit",
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// The error of a word that names no [`Fault`].
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error(
    "unknown fault `{0}`; the faults are `division-by-zero`, `subscript-range`, `subrange` and `step-limit`"
)]
pub struct UnknownFault(pub String);

impl FromStr for Fault {
    type Err = UnknownFault;

    /// Parses exactly the words that [`Fault::as_str`] returns.
    fn from_str(text: &str) -> Result<Fault, UnknownFault> {
        Fault::from_word(text).ok_or_else(|| UnknownFault(text.to_owned()))
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
            assert!(
                message.contains(&format!("`{fault}`")),
                "{message} does not name {fault}"
            );
        }
    }
}
