//! Why a case is on no page.

use std::fmt;

/// Why a case is left out of an export.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Reason {
    /// Its program must be rejected, and such programs were not asked for.
    Rejected,
    /// No document says whether its program is accepted, and such programs were not asked for.
    Open,
    /// A person named it.
    Named,
    /// It was not drawn.
    Sampled,
    /// It needs several scans, a clock, or variables that are set from outside.
    Scans,
    /// Its program must stop at a fault: an array of results ends there as well.
    Fault,
    /// It asks for its program to be given back as text.
    Rendered,
    /// Its program shares something with a configuration or with the machine, or is not whole.
    Shares,
    /// It has no program.
    NoProgram,
    /// It has several programs.
    SeveralPrograms,
    /// Its program may end before its last statement.
    Returns,
    /// Its program has a section of variables that several programs cannot share.
    Section,
    /// It expects the zero that is less than zero; comparison takes the two for one.
    NegativeZero,
    /// No document says what must come, and what comes has a type that no numbers can be made of without a conversion.
    Unseen,
    /// A mistake in it keeps a compiler from reading what stands behind it.
    Unreadable,
    /// It must be rejected, and what is wrong may stand in a POU or type of its own.
    RejectedUnits,
}

impl Reason {
    /// Every reason, in the order in which they are told.
    pub const ALL: [Reason; 16] = [
        Reason::Rejected,
        Reason::Open,
        Reason::Named,
        Reason::Sampled,
        Reason::Scans,
        Reason::Fault,
        Reason::Rendered,
        Reason::Shares,
        Reason::NoProgram,
        Reason::SeveralPrograms,
        Reason::Returns,
        Reason::Section,
        Reason::NegativeZero,
        Reason::Unseen,
        Reason::Unreadable,
        Reason::RejectedUnits,
    ];
}

impl fmt::Display for Reason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Reason::Rejected => "must be rejected by the compiler (--with rejected exports them too)",
            Reason::Open => "may be accepted or rejected: no document says (--with open exports them too)",
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
            Reason::RejectedUnits => {
                "must be rejected, and have POUs or types of their own in which the mistake may be"
            }
        })
    }
}
