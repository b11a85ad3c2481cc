//! What the documents of a system say, as far as exact arithmetic and the generator of programs compute with it.
//!
//! A word names a rule that a document states; `stickler-exact` implements each, independently of the reference. A new system whose
//! documents state another rule needs one there; one whose tables say all needs none.

use crate::choice::{choices, choices_of_words};
use crate::words::words;
use crate::{OutOfRange, Rounding};

words! {
    /// The document by which pairs of types convert implicitly.
    DocumentedImplicit {
        /// IronPLC's matrices of integer, real and bit-string widening.
        Ironplc = "ironplc-matrices",
        /// No pair converts.
        None = "none",
        /// PLCnext Engineer's coloured table.
        Plcnext = "plcnext-table",
        /// STruC++'s page on its type system, and its tests.
        Strucpp = "strucpp-pages",
        /// RuSTy's tests and its page on data types.
        Rusty = "rusty-tests",
        /// The matrix that was measured on CODESYS and TwinCAT.
        Codesys = "codesys-matrix",
        /// The Logix manual.
        Logix = "logix-manual",
        /// Control Expert's table.
        ControlExpert = "control-expert-table",
        /// The figures of the third edition.
        ThirdEdition = "third-edition",
        /// No document decides any pair.
        Open = "open",
    }
}

words! {
    /// The document that states what conversion functions give.
    DocumentedFunctions {
        /// IronPLC's pages.
        Ironplc = "ironplc",
        /// The ForgeIEC page on matiec.
        Matiec = "matiec",
        /// PLCnext Engineer's page.
        Plcnext = "plcnext",
        /// STruC++'s tests and the tables of the standard.
        Strucpp = "strucpp",
        /// RuSTy's tests.
        Rusty = "rusty",
        /// Control Expert's help.
        ControlExpert = "control-expert",
        /// Omron's manuals.
        Omron = "omron",
        /// The third edition.
        ThirdEdition = "third-edition",
        /// Tables of the suite alone.
        InTables = "in-tables",
    }
}

choices_of_words! { DocumentedImplicit, DocumentedFunctions, }

/// Declares the choices of `choices.toml`, which the build script puts into its call.
macro_rules! documents {
    ($($choices:tt)*) => {
        choices! {
            /// The statements of the documents of a system; by default there are none.
            #[derive(Clone, PartialEq, Eq, Debug)]
            Documents { $($choices)* } beside {
                /// The page of the vendor about real numbers, where recordings count for more.
                page_on_reals: Option<PageOnReals> = None;
            }
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/documents.rs"));

/// What a vendor's page says of real numbers that become integers or bit strings.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PageOnReals {
    /// The page and section, in the form of a case file.
    pub basis: String,
    /// The rounding.
    pub rounding: Rounding,
    /// The result for a number outside of the target.
    pub out_of_range: OutOfRange,
}
