//! Finds and reads `stickler.toml`.

use crate::engines::{EngineEntry, TableContext, entry};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{fs, io};
use stickler_types::dialect_file::{ConfigurationMistake, definitions, mistake, table};
use stickler_types::{DialectName, ElementaryType};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The name of the configuration file.
pub const FILE_NAME: &str = "stickler.toml";

/// The keys at the top level of the file.
const KEYS: [&str; 2] = ["engines", "dialects"];

/// The contents of `stickler.toml`; empty if there is no such file.
#[derive(Clone, Debug, Default)]
pub struct ConfigurationFile {
    path: Option<PathBuf>,
    engines: BTreeMap<String, EngineEntry>,
    dialects: Vec<DialectName>,
}

impl ConfigurationFile {
    /// Reads the file in `folder`, or in the nearest folder above it that has one. Its dialects are
    /// [defined](DialectName::define) for the whole process; reading the file again does not define them a second time.
    ///
    /// # Errors
    /// [`ConfigurationError`] if a file exists that cannot be used.
    pub fn find(folder: &Path) -> Result<ConfigurationFile, ConfigurationError> {
        // A link to a file counts; a folder of that name is somebody else's.
        let found = folder
            .ancestors()
            .map(|folder| folder.join(FILE_NAME))
            .find(|path| path.is_file());
        match found {
            None => Ok(ConfigurationFile::default()),
            // What lies here is called by its name alone.
            Some(path) if path.parent() == Some(folder) => {
                ConfigurationFile::read_as(&path, Path::new(FILE_NAME))
            }
            Some(path) => ConfigurationFile::read(&path),
        }
    }

    /// Reads a file and defines its dialects.
    ///
    /// # Errors
    /// [`ConfigurationError`] if the file cannot be used.
    pub fn read(path: &Path) -> Result<ConfigurationFile, ConfigurationError> {
        ConfigurationFile::read_as(path, path)
    }

    /// Reads a file that messages call `shown`.
    fn read_as(path: &Path, shown: &Path) -> Result<ConfigurationFile, ConfigurationError> {
        let unreadable = |source: io::Error| ConfigurationError::Unreadable {
            path: shown.to_owned(),
            source,
        };
        let text = fs::read_to_string(path).map_err(unreadable)?;
        let path = std::path::absolute(path).map_err(unreadable)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let (engines, dialects) = contents(&text, folder, shown).map_err(|mistake| {
            let (line, column) = position(&text, mistake.span.start);
            ConfigurationError::Mistake {
                path: shown.to_owned(),
                line,
                column,
                message: mistake.message,
            }
        })?;
        Ok(ConfigurationFile {
            path: Some(path),
            engines,
            dialects,
        })
    }

    /// Returns the absolute path of the file; `None` if there is none.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Returns the folder of the file, in which the commands of its engines are started; `None` if there is no file.
    pub fn folder(&self) -> Option<&Path> {
        self.path.as_deref().and_then(Path::parent)
    }

    /// Returns the engine of this name, if the file has it.
    pub fn engine(&self, name: &str) -> Option<&EngineEntry> {
        self.engines.get(name)
    }

    /// Returns the dialects that the file defines, in its order.
    pub fn dialects(&self) -> &[DialectName] {
        &self.dialects
    }

    /// Returns the engines of the file, in the order of their names.
    pub fn engines(&self) -> impl Iterator<Item = (&str, &EngineEntry)> {
        self.engines.iter().map(|(name, entry)| (name.as_str(), entry))
    }
}

/// Parses the text of a file; defines its dialects before it reads the engines, which may name them.
fn contents(
    text: &str,
    folder: &Path,
    shown: &Path,
) -> Result<(BTreeMap<String, EngineEntry>, Vec<DialectName>), ConfigurationMistake> {
    let document = DeTable::parse(text).map_err(|error| mistake(&error, 0..0, "of the file", &[]))?;
    let document = document.get_ref();
    if let Some((key, _)) = document
        .iter()
        .find(|(key, _)| !KEYS.contains(&key.get_ref().as_ref()))
    {
        let word = key.get_ref().as_ref();
        return Err(ConfigurationMistake::unknown_key(
            key.span(),
            word,
            "of the file",
            &KEYS,
        ));
    }
    let written = |span: &Range<usize>| format!("{}:{}", shown.display(), position(text, span.start).0);
    let place = TableContext {
        folder,
        written: &written,
    };
    let dialects = match document.get("dialects") {
        Some(value) => dialects(value, place)?,
        None => Vec::new(),
    };
    let mut engines = BTreeMap::new();
    if let Some(value) = document.get("engines") {
        for (name, value) in table("engines", value)?.iter() {
            let (name, entry) = entry(name, value, place)?;
            engines.insert(name, entry);
        }
    }
    Ok((engines, dialects))
}

/// Defines the dialects of the table `[dialects]`.
fn dialects(
    value: &Spanned<DeValue<'_>>,
    place: TableContext<'_>,
) -> Result<Vec<DialectName>, ConfigurationMistake> {
    // All of them are right before the first is defined.
    let definitions = definitions(table("dialects", value)?, place.written, converts)?;
    let define = |(definition, span)| {
        DialectName::define(definition).map_err(|taken| ConfigurationMistake::at(span, taken.to_string()))
    };
    definitions.into_iter().map(define).collect()
}

/// Returns whether a conversion function for a pair of types exists, in a dialect that has all types.
fn converts(from: ElementaryType, to: ElementaryType) -> bool {
    !stickler_exact::signatures(&format!("{from}_TO_{to}"), DialectName::IRONPLC_ED3).is_empty()
}

/// Returns the line and column of a byte offset in a text, from 1; the column in Unicode scalar values.
fn position(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let start = before.rfind('\n').map_or(0, |feed| feed + 1);
    (line, before[start..].chars().count() + 1)
}

/// The error of a configuration file that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ConfigurationError {
    /// The file cannot be read.
    #[error("cannot read {}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// The contents of the file are wrong.
    #[error("{}:{line}:{column}: {message}", path.display())]
    Mistake {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column, from 1, in Unicode scalar values.
        column: usize,
        /// A description of the mistake and of what to do, as a sentence without its full stop.
        message: String,
    },
}
