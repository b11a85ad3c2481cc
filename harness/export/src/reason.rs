//! The reasons for which a case is on no page.

use std::fmt;
use stickler_syntax::Indivisible;

/// The reason for which a case is left out of an export.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Reason {
    /// The program must be rejected, and such cases were not requested.
    Rejected,
    /// No source in Stickler says whether the program is accepted, and such cases were not requested.
    Open,
    /// The command line leaves the case out by its id.
    Named,
    /// The case was not drawn for the sample.
    Sampled,
    /// The case needs several scans, a clock, or variables that are set from outside.
    Scans,
    /// The program must stop at a fault, which would also end the array of results.
    Fault,
    /// The case expects its program in normal form.
    Rendered,
    /// The program shares variables with a configuration or with the machine, or is incomplete.
    Shares,
    /// The source text has no program.
    NoProgram,
    /// The source text has several programs.
    SeveralPrograms,
    /// The program may end before its last statement.
    Returns,
    /// The program has a section of variables that several programs cannot share.
    Section,
    /// The case expects -0.0, which compares equal to 0.0.
    NegativeZero,
    /// No document demands a value, and the observed value's type cannot be encoded as numbers without a conversion.
    Unseen,
    /// A mistake in the program keeps a compiler from parsing the cases after it.
    Unreadable,
    /// The compiler must warn, which no array of results and no note of an outcome tells.
    Warned,
    /// The program must be rejected, and its mistake may be in a POU or type of its own.
    RejectedUnits,
}

impl fmt::Display for Reason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Reason::Rejected => "must be rejected by the compiler (--with rejected exports them too)",
            Reason::Open => {
                "may be accepted or rejected: no source in Stickler says (--with open exports them too)"
            }
            Reason::Named => "named by --without",
            Reason::Sampled => "not drawn by --sample",
            Reason::Scans => "need several scans, a clock, or variables that are set from outside",
            Reason::Fault => "must stop at a fault, and a page would stop with them",
            Reason::Rendered => "ask for the program as text",
            Reason::Shares => "share something with a configuration or the machine, or are not whole",
            Reason::NoProgram => "have no program",
            Reason::SeveralPrograms => "have several programs",
            Reason::Returns => "may end before their last statement",
            Reason::Section => "have variables that are retained, temporary, or passed to a program",
            Reason::NegativeZero => "expect -0.0, which no comparison tells from 0.0",
            Reason::Unseen => "record a text, a character, a date or a time of day, which makes no number",
            Reason::Unreadable => {
                "cannot be read by a compiler, which would not read what stands behind them"
            }
            Reason::Warned => "must be accepted with a warning, which is not imported",
            Reason::RejectedUnits => {
                "must be rejected, and have POUs or types of their own in which the mistake may be"
            }
        })
    }
}

impl From<Indivisible> for Reason {
    fn from(reason: Indivisible) -> Reason {
        match reason {
            Indivisible::Shares => Reason::Shares,
            Indivisible::NoProgram => Reason::NoProgram,
            Indivisible::SeveralPrograms => Reason::SeveralPrograms,
            Indivisible::Returns => Reason::Returns,
            Indivisible::Section => Reason::Section,
        }
    }
}
