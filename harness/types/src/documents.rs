//! What the documents of a system say, as far as exact arithmetic and the generator of programs compute with it.
//!
//! A word names a rule that a document states; `stickler-exact` implements each, independently of the reference. A new system whose
//! documents state another rule needs one there; one whose tables say all needs none.

use crate::choice::choices;
pub use crate::options::{DocumentedFunctions, DocumentedImplicit};
use crate::{OutOfRange, Rounding};

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
