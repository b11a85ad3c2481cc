//! Settings of the generator.

use stickler_types::DialectName;

/// The kind of program to generate.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct GeneratorSettings {
    /// The dialect; `None` lets the input choose.
    pub dialect: Option<DialectName>,
    /// Whether the program may use constructs that documents leave open.
    pub open: bool,
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
