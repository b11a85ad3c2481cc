//! What the caller of the generator may ask.

use stickler_types::DialectName;

/// What kind of program is wanted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Settings {
    /// The dialect; `None` lets the input choose.
    pub dialect: Option<DialectName>,
    /// Whether the program may use what documents leave open.
    pub open: bool,
    /// How many statements the program has at most, those of its checksums not counted.
    pub statements: usize,
}

impl Default for Settings {
    /// Any dialect, nothing open, at most 80 statements.
    fn default() -> Settings {
        Settings {
            dialect: None,
            open: false,
            statements: 80,
        }
    }
}
