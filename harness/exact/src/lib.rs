//! The expected results of type conversion functions, computed by exact arithmetic.
//!
//! This crate is the suite's oracle: the generator of row tables, `stickler sweep` and the property tests use it. The
//! reference implementation never uses it, and it never uses the reference. It computes with integers and exact fractions
//! only, so that every number is rounded at most once, at the end, by a rule that the documentation here states.
//!
//! Architecture Invariant: there is no floating point arithmetic outside of tests.
//!
//! | question | answered by |
//! |---|---|
//! | which functions does a dialect have, and between which types? | [`functions`], [`signatures`] |
//! | what must a call give, and which document says so? | [`expected`] |
//! | what does the vendor's page say where recordings say something else? | [`stated_by_vendor`] |
//! | what would it give by other rules? | [`value()`] with other choices than those of the dialect |
//! | the same, for billions of operands? | [`Bulk`] |
//! | which types become others without a call? | [`implicit()`] |
//! | what does a value become without a call? | [`implicit_result()`] |
//! | which signature has the function of a call? | [`signature_of`] |
//! | what does a function of real numbers give, SIN or EXPT? | [`nearest_result`] |
//! | which real number is nearest to a decimal one? | [`nearest_decimal`] |
//!
//! ```
//! use stickler_exact::{expected, signatures};
//! use stickler_types::{DialectName, Value};
//!
//! let signature = &signatures("DINT_TO_INT", DialectName::MATIEC)[0];
//! let operand = Value::parse("DINT#100000").expect("a typed literal");
//! let given = expected(signature, &[operand], DialectName::MATIEC);
//! assert_eq!(given.value.to_string(), "INT#-31072");
//! assert_eq!(given.basis, Some("forgeiec-conversion-functions: Range and precision"));
//! ```
//!
//! Where no document states the result of a call, the answer is *open*: [`Expected::basis`] is `None`, and the value is
//! what IEC 60559 and two's complement suggest, by the choices of the dialect.
//!
//! Basis: the documents that each rule names; rule: not-stated for what is open.

#![cfg_attr(not(test), deny(clippy::float_arithmetic))]

mod basis;
mod bcd;
mod bulk;
mod calendar;
mod catalogue;
mod character;
mod elementary;
#[cfg(test)]
mod fractions;
mod implicit;
mod integer;
mod moment;
mod quotient;
mod real;
mod signature;
mod text;
mod value;

pub use basis::{Expected, expected, is_overridden, page_has_truncation, stated_by_vendor};
pub use bulk::Bulk;
pub use catalogue::{functions, signature_of, signatures};
pub use elementary::{elementary_result, elementary_signatures, nearest_result};
pub use implicit::{ImplicitResult, implicit, implicit_result};
pub use signature::{Operation, Signature};
pub use text::nearest_decimal;
pub use value::value;
