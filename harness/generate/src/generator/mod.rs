//! The generator: random programs that are well-typed by construction, end by construction, and keep to what documents settle.
//!
//! | file | decides |
//! |---|---|
//! | `settings` | what the caller may ask |
//! | `features` | which constructs and types one program has |
//! | `language` | what a dialect has: types, implicit conversions, functions whose results documents give |
//! | `literals` | values, biased to boundaries |
//! | `maker` | what is being made: the program so far, and what is left of the budget |
//! | `scope` | the POU in hand: what can be read and written in it |
//! | `declarations`, `routines` | types and variables; functions and function blocks |
//! | `expressions`, `places`, `operations`, `standard`, `calls` | expressions of a wanted type |
//! | `statements`, `assignments`, `loops` | statements |
//! | `checksum` | the end of main, where everything flows together |

mod assignments;
mod calls;
mod checksum;
mod declarations;
mod expressions;
mod features;
mod language;
mod literals;
mod loops;
mod maker;
mod operations;
mod places;
mod routines;
mod scope;
mod settings;
mod standard;
mod statements;

pub use maker::program;
pub use settings::Settings;
