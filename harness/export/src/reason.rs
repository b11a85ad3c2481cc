//! The reasons for which a case is on no page.

use stickler_syntax::Indivisible;
use stickler_types::words;

words! {
    /// The reason for which a case is left out of an export.
    Reason {
        /// The program must be rejected, and such cases were not requested.
        Rejected = "must be rejected by the compiler (--with rejected exports them too)",
        /// No source in Stickler says whether the program is accepted, and such cases were not requested.
        Open = "may be accepted or rejected: no source in Stickler says (--with open exports them too)",
        /// The command line leaves the case out by its id.
        Named = "named by --without",
        /// The case was not drawn for the sample.
        Sampled = "not drawn by --sample",
        /// The case needs several scans, a clock, or variables that are set from outside.
        Scans = "need several scans, a clock, or variables that are set from outside",
        /// The program must stop at a fault, which would also end the array of results.
        Fault = "must stop at a fault, and a page would stop with them",
        /// The case expects its program in normal form.
        Rendered = "ask for the program as text",
        /// The program shares variables with a configuration or with the machine, or is incomplete.
        Shares = "share something with a configuration or the machine, or are not whole",
        /// The source text has no program.
        NoProgram = "have no program",
        /// The source text has several programs.
        SeveralPrograms = "have several programs",
        /// The program may end before its last statement.
        Returns = "may end before their last statement",
        /// The program has a section of variables that several programs cannot share.
        Section = "have variables that are retained, temporary, or passed to a program",
        /// The case expects -0.0, which compares equal to 0.0.
        NegativeZero = "expect -0.0, which no comparison tells from 0.0",
        /// No document demands a value, and the observed value's type cannot be encoded as numbers without a conversion.
        Unseen = "record a text, a character, a date or a time of day, which makes no number",
        /// A mistake in the program keeps a compiler from parsing the cases after it.
        Unreadable = "cannot be read by a compiler, which would not read what stands behind them",
        /// The compiler must warn, which no array of results and no note of an outcome tells.
        Warned = "must be accepted with a warning, which is not imported",
        /// The program must be rejected, and its mistake may be in a POU or type of its own.
        RejectedUnits = "must be rejected, and have POUs or types of their own in which the mistake may be",
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
