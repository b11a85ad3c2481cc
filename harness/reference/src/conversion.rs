//! Values that change their type: the implicit rule, the catalogue of conversion functions, and their exact
//! arithmetic. Each fact is said once; the checker, the machine and the command line all ask here.
//!
//! From the name of a function to the values that it gives, as a sweep does it: [`function`] finds the function
//! of one argument, [`ConversionFunction::accepts`] says of each type whether it takes it,
//! [`ConversionFunction::results`] which types the result may have, and [`ConversionFunction::conversion`] makes
//! the conversion from one to the other, which [`Conversion::apply_to_slice`] applies to many values. The functions
//! of two arguments are those of [`concatenation()`].
//!
//! ```
//! use stickler_types::Dialect;
//! use stickler_reference::conversion;
//! use stickler_types::{DialectName, ElementaryType};
//!
//! let dialect = Dialect::of(DialectName::MATIEC);
//! let function = conversion::function("TRUNC_INT", &dialect).expect("the dialect has it");
//! let operand = ElementaryType::Real;
//! assert!(function.accepts(operand));
//! for result in function.results(operand) {
//!     let conversion = function.conversion(operand, result);
//!     assert_eq!(conversion.apply(2.7_f32.to_bits().into()), 2);
//! }
//!
//! let join = conversion::concatenation("CONCAT_DATE_TOD", &dialect).expect("the dialect has it");
//! assert_eq!(join.operands, [ElementaryType::Date, ElementaryType::Tod]);
//! assert_eq!(join.apply_two(86_400_000_000_000, 1_000_000_000), 86_401_000_000_000);
//! ```

mod bcd;
mod catalogue;
mod concatenation;
mod implicit;
mod listing;
mod moment;
mod reading;
pub(crate) mod real;
mod rule;
#[cfg(test)]
mod tests;
mod text;
mod writing;

pub use catalogue::{ConversionFunction, Parameter, ResultType, conversion_function_name, function};
pub use concatenation::{Concatenation, PARAMETERS, concatenation};
pub(crate) use implicit::literal_warning;
pub(crate) use implicit::{common_operand, of_operand};
pub use implicit::{implicit, implicit_warning};
pub use listing::{catalogue_names, functions};
pub use rule::{Conversion, ConversionRule};
pub(crate) use writing::formatted;
