//! Elementary data types, typed values, IEC literals, dialect names, diagnostic codes, and the requests and outcomes that
//! the harness and the engines exchange.
//!
//! Every other crate uses this one. It does not know cases, nor the syntax of Structured Text beyond literals.
//!
//! | what | where |
//! |---|---|
//! | an elementary data type: range, width, family | [`ElementaryType`], [`Family`] |
//! | a typed value and its one canonical spelling, which the wire protocol carries | [`Value`] |
//! | a value with the literal that a program writes for it | [`WrittenValue`] |
//! | the values at which conversions go wrong | [`boundaries`] |
//! | a dialect's name, and its rules, which its file states | [`DialectName`], [`Dialect`] |
//! | the files of dialects | [`dialect_file`] |
//! | what dialects choose differently | [`ConversionChoices`], [`MatrixWord`] |
//! | a diagnostic code, explained in `harness/types/codes` | [`Code`] |
//! | what is asked of an engine, and what it answers | [`RunRequest`], [`Observation`]; [`Outcome`], [`Diagnostic`], [`Fault`] |
//! | what a program asks a compiler about its conversions | [`Question`], [`ConversionCall`] |
//! | what a source says against the claims of others, and who publishes it; what it prints without a case | [`Contradiction`], [`Relation`], [`PrintedResult`] |
//! | the versions of a compiler for which a claim holds | [`Versions`] |
//! | what answered when a compiler was recorded | [`RecordingOrigin`] |
//! | hashes and random numbers that are the same in every version | [`Fnv1a`], [`SplitMix64`] |

pub mod boundaries;
mod choice;
pub mod choices;
pub mod code;
mod contradiction;
mod declared_features;
pub mod diagnostic;
pub mod dialect;
pub mod dialect_file;
pub mod dialect_name;
mod distinct;
pub mod documents;
pub mod elementary;
pub mod fault;
pub mod generic;
mod hash;
pub mod literal;
mod near;
mod near_value;
mod numbers;
mod observed_value;
mod options;
pub mod outcome;
mod question;
mod random;
mod recording_origin;
pub mod request;
mod text;
pub mod value;
mod versions;
mod word_table;
mod words;
mod wrap;
mod written_value;

pub use choices::{ConversionChoices, MatrixWord, RealText};
pub use code::{Code, UnknownCode};
pub use contradiction::{Contradiction, PrintedResult, Relation};
pub use declared_features::DeclaredFeatures;
pub use diagnostic::{Diagnostic, Severity};
pub use dialect::{Dialect, DialectKind, Stated};
pub use dialect_name::{DialectName, TakenName, UnknownDialect};
pub use distinct::{distinct, grouped_by, grouped_by_key, sorted};
pub use documents::Documents;
pub use elementary::{ElementaryType, Family};
pub use fault::{Fault, UnknownFault};
pub use generic::GenericType;
pub use hash::Fnv1a;
pub use literal::LiteralError;
pub use near::{join, joined};
pub use numbers::{counted, grouped};
pub use observed_value::deserialize_expected;
pub use options::{
    BitStringAsBool, BitStringText, BitsAsInteger, BitsAsReal, ComparedTypes, ConstantTypes,
    ImplicitWarnings, MomentText, MomentUnits, OperandTypes, OutOfRange, ResultSigns, Rounding, ShiftCounts,
    TextReading,
};
pub use outcome::{Acceptance, NamedValue, Outcome};
pub use question::{ConversionCall, Question, TypePair, UnknownQuestion, is_part};
pub use random::SplitMix64;
pub use recording_origin::RecordingOrigin;
pub use request::{ClockSetting, Observation, ObservationKey, RunRequest, Setting};
pub use text::shortened;
pub use value::Value;
pub use versions::{Versions, version_numbers};
pub use word_table::WordTable;
pub use wrap::{wrap, wrap_within};
pub use written_value::WrittenValue;
