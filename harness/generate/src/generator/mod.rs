//! The generator: random programs that are well-typed by construction, end by construction, and keep to what documents settle.
//!
//! | file | decides |
//! |---|---|
//! | `settings` | what the caller may ask |
//! | `language` | what a dialect has: types, implicit conversions, functions whose results documents give |
//! | `literals` | values, biased to boundaries |
//! | `maker` | what is being made: the program so far, the POU in hand, what is left of the budget |
//! | `expressions` | expressions of a wanted type |
//! | `statements` | statements |
//! | `checksum` | the end of main, where everything flows together |

mod checksum;
mod expressions;
mod language;
mod literals;
mod maker;
mod settings;
mod statements;

pub use maker::program;
pub use settings::Settings;
