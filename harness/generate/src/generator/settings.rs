//! What the caller of the generator may ask.

use stickler_types::DialectName;

/// What kind of program is wanted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct GeneratorSettings {
    /// The dialect; `None` lets the input choose.
    pub dialect: Option<DialectName>,
    /// Whether the program may use what documents leave open.
    pub open: bool,
    /// How many statements the program has at most, those of its checksums not counted.
    pub statements: usize,
}

impl Default for GeneratorSettings {
    /// Any dialect, nothing open, at most 80 statements.
    fn default() -> GeneratorSettings {
        GeneratorSettings {
            dialect: None,
            open: false,
            statements: 80,
        }
    }
}
