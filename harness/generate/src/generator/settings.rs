//! Settings of the generator.

use stickler_types::DialectName;

/// The kind of program to generate.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct GeneratorSettings {
    /// The dialect; `None` lets the input choose.
    pub dialect: Option<DialectName>,
    /// Whether the program may use constructs that documents leave open.
    pub open: bool,
    /// What the program shall do without, by the words of [`features`](crate::features::features), in any case. The generator avoids most of
    /// it; whether a program has something nevertheless is asked afterwards.
    pub lacking: Vec<String>,
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
