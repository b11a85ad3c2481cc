//! Settings of the generator.

use stickler_types::DialectName;

/// The kind of program to generate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct GeneratorSettings {
    /// The dialect; `None` lets the input choose.
    pub dialect: Option<DialectName>,
    /// Whether the program may use constructs that documents leave open.
    pub open: bool,
    /// The maximum number of statements of the program, without those of its checksums.
    pub statements: usize,
}

impl GeneratorSettings {
    /// Returns settings for a dialect, the others being the defaults.
    #[must_use]
    pub fn of(dialect: DialectName) -> GeneratorSettings {
        GeneratorSettings {
            dialect: Some(dialect),
            ..GeneratorSettings::default()
        }
    }
}

impl Default for GeneratorSettings {
    /// Returns settings for any dialect, nothing open, and at most 80 statements.
    fn default() -> GeneratorSettings {
        GeneratorSettings {
            dialect: None,
            open: false,
            statements: 80,
        }
    }
}
