//! Values that change their type: the implicit rule, the catalogue of conversion functions, and their exact
//! arithmetic. Each fact is said once; the checker, the machine and the command line all ask here.

mod bcd;
mod catalogue;
#[cfg(test)]
mod exactness;
mod implicit;
mod moment;
pub(crate) mod real;
mod rule;
mod text;

pub use catalogue::{ConversionFunction, Parameter, ResultType, conversion_function_name, function};
pub use implicit::implicit;
pub use rule::{Conversion, ConversionRule, Rounding};
