//! The folder that holds the tables' files: bringing it up to date, and saying where it is not.

use crate::families;
use crate::text::text;
use std::io;
use std::path::{Path, PathBuf};

/// The folder of the tables, seen from the root of the repository.
pub const FOLDER: &str = "conformance-cases/conversion";

/// A generated file: its name, and what it must hold.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// The name within the folder.
    pub name: String,
    /// The whole text.
    pub text: String,
}

/// Every generated file.
///
/// # Errors
/// What [`families::all`] says.
pub fn files() -> Result<Vec<File>, String> {
    let tables = families::all()?;
    let files = tables.iter().map(|table| File {
        name: format!("{}.toml", table.name),
        text: text(table),
    });
    Ok(files.collect())
}

/// A file that the folder has otherwise, or does not have.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// Its path.
    pub path: PathBuf,
    /// What it holds; empty where it is missing.
    pub found: String,
    /// What it must hold.
    pub wanted: String,
}

/// The files that the folder does not have as they must be.
///
/// # Errors
/// Where a file that is there cannot be read.
pub fn differences(folder: &Path, files: &[File]) -> io::Result<Vec<Difference>> {
    let mut differences = Vec::new();
    for file in files {
        let path = folder.join(&file.name);
        let found = match std::fs::read_to_string(&path) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(error),
        };
        if found != file.text {
            differences.push(Difference {
                path,
                found,
                wanted: file.text.clone(),
            });
        }
    }
    Ok(differences)
}

/// Writes the files that differ; the others keep their time of change.
///
/// # Errors
/// Where a file cannot be written.
pub fn write(differences: &[Difference]) -> io::Result<()> {
    for difference in differences {
        std::fs::write(&difference.path, &difference.wanted)?;
    }
    Ok(())
}
