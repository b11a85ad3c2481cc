//! Elementary data types, typed values, IEC literals, dialect names, diagnostic codes, and what is asked of an engine and
//! answered.
//!
//! Everything else in Stickler leans on this crate: the reference computes with the types that stand here, the suite writes
//! its expectations as [`Value`]s, and the wire protocol carries them in the one canonical spelling that [`Value`]'s `Display`
//! gives. A [`RunRequest`] with its [`Observation`]s travels from a case to every engine, and an [`Outcome`] with its
//! [`Diagnostic`]s back to the judge. It knows neither the syntax of Structured Text beyond single literals, nor cases.

pub mod boundaries;
pub mod choices;
pub mod code;
pub mod definition;
pub mod dialect_name;
pub mod elementary;
pub mod fault;
mod hash;
pub mod literal;
pub mod outcome;
mod random;
pub mod request;
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
pub use hash::Fnv1a;
pub use literal::LiteralError;
pub use outcome::{Diagnostic, NamedValue, Outcome};
pub use random::SplitMix64;
pub use request::{ClockSetting, Observation, ObservationKey, RunRequest, Setting};
pub use value::Value;
pub use wrap::wrap;
pub use written_value::WrittenValue;
