//! Values that change their type: the implicit rule, the catalogue of conversion functions, and their exact
//! arithmetic. Each fact is said once; the checker, the machine and the command line all ask here.

mod bcd;
mod catalogue;
mod choices;
#[cfg(test)]
mod exactness;
mod implicit;
mod moment;
mod reading;
pub(crate) mod real;
mod rule;
mod text;
mod writing;

pub use catalogue::{ConversionFunction, Parameter, ResultType, conversion_function_name, function};
pub use choices::{BitStringText, ConversionChoices, Outside, RealText, Rounding, TextReading};
pub use implicit::implicit;
pub use rule::{Conversion, ConversionRule};
