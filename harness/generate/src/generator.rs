//! The generator: random programs that are well-typed by construction, terminate by construction, and keep to what documents
//! settle.
//!
//! | file | decides |
//! |---|---|
//! | `settings` | what the caller may ask for |
//! | `constructs` | which constructs and types one program uses |
//! | `profile` | what a dialect has: types, implicit conversions, conversion functions whose results documents give |
//! | `literals` | values, biased towards boundaries |
//! | `builder` | the program so far, and the rest of the budget |
//! | `scope` | what can be read and written in the program organization unit (POU) under construction |
//! | `declarations`, `routines` | types and variables; functions and function blocks |
//! | `type_context` | how the type of an expression is determined where it stands |
//! | `expressions`, `places`, `operations`, `standard`, `calls` | expressions of a given type |
//! | `statements`, `assignments`, `loops` | statements |
//! | `checksum` | the end of main, where all values are combined |

mod assignments;
mod builder;
mod calls;
mod checksum;
mod constructs;
mod declarations;
mod expressions;
mod literals;
mod loops;
mod operations;
mod places;
mod profile;
mod routines;
mod scope;
mod settings;
mod standard;
mod statements;
mod type_context;

pub use builder::program;
pub(crate) use profile::DialectProfile;
pub use settings::GeneratorSettings;
pub(crate) use type_context::TypeContext;
