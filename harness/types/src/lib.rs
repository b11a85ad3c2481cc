//! Elementary data types, typed values, IEC literals, dialect names and diagnostic codes.
//!
//! Everything else in Stickler leans on this crate: the reference computes with the types that stand here, the suite writes
//! its expectations as [`Value`]s, and the wire protocol carries them in the one canonical spelling that [`Value`]'s `Display`
//! gives. It knows neither the syntax of Structured Text beyond single literals, nor cases.

pub mod boundaries;
pub mod choices;
pub mod code;
pub mod definition;
pub mod dialect_name;
pub mod elementary;
pub mod fault;
pub mod literal;
pub mod value;
mod words;
mod wrap;
mod written_value;

pub use choices::{
    BitStringText, ConversionChoices, MatrixWord, OutOfRange, RealText, Rounding, TextReading,
};
pub use code::{Code, UnknownCode};
pub use definition::{Definition, Stated};
pub use dialect_name::{BuiltIn, DefinedDialect, DialectName, UnknownDialect};
pub use elementary::{ElementaryType, Family};
pub use fault::{Fault, UnknownFault};
pub use literal::LiteralError;
pub use value::Value;
pub use wrap::wrap;
pub use written_value::WrittenValue;
