//! The generator: random programs that are well-typed by construction, terminate by construction, and keep to what documents
//! settle.
//!
//! | file | decides |
//! |---|---|
//! | `constructs` | which constructs and types one program uses |
//! | `profile` | what a dialect has: types, implicit conversions, conversion functions whose results documents give |
//! | `literals` | values, biased towards boundaries |
//! | `builder` | the program so far, and the rest of the budget |
//! | `scope` | what can be read and written in the program organization unit (POU) under construction |
//! | `declarations`, `routines` | types and variables; functions and function blocks |
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
mod standard;
mod statements;

pub use builder::program;
pub(crate) use profile::DialectProfile;
use stickler_types::DialectName;

/// The kind of program to generate.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct GeneratorSettings {
    /// The dialect; `None` lets the input choose.
    pub dialect: Option<DialectName>,
    /// Whether the program may use constructs that documents leave open.
    pub open: bool,
    /// The features that the program shall not use, by the words of [`features`](crate::features::features), in any case. The generator avoids most of
    /// it; whether a program has something nevertheless is asked afterwards.
    pub lacking: Vec<String>,
}

impl GeneratorSettings {
    /// Returns settings for a dialect, the others being the defaults.
    pub fn of(dialect: DialectName) -> GeneratorSettings {
        GeneratorSettings {
            dialect: Some(dialect),
            ..GeneratorSettings::default()
        }
    }
}

/// The way in which the place of an expression determines its type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum TypeContext {
    /// An operand of something that takes several types: the text alone must determine the type.
    Exact,
    /// The second operand of an operator, whose type is that of the first.
    Operand,
    /// The right side of an assignment.
    Assigned,
    /// An argument of a parameter.
    Argument,
    /// An initial value.
    Initial,
}
