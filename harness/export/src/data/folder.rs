//! The folder of support data: the data, its schema and its types for TypeScript, and a package for npm and one for PyPI.

use super::SupportData;
use crate::ExportError;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// The file of the data; a folder that has it is one of support data.
pub const DATA: &str = "stickler-data.json";

/// The word in the files of packages for which the version is written.
const VERSION: &str = "0.0.0";

/// Writes data into a folder, which is empty, does not exist yet, or has earlier data, which is replaced.
///
/// # Errors
/// [`ExportError::NoData`] before anything is written; [`ExportError::Write`].
pub fn write_data(data: &SupportData<'_>, folder: &Path) -> Result<(), ExportError> {
    let is_occupied = match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_some() && !folder.join(DATA).is_file(),
        Err(error) if error.kind() == ErrorKind::NotFound => false,
        Err(error) => return Err(ExportError::Read(folder.to_owned(), error)),
    };
    if is_occupied {
        return Err(ExportError::NoData(folder.to_owned()));
    }
    let json =
        serde_json::to_string(data).map_err(|error| ExportError::Write(folder.join(DATA), error.into()))?;
    let types = include_str!("types.d.ts");
    let readme = include_str!("package/README.md");
    for (name, text) in [
        (DATA, &*json),
        ("stickler-data.schema.json", include_str!("schema.json")),
        ("stickler-data.d.ts", types),
        ("npm/package.json", include_str!("package/package.json")),
        ("npm/index.json", &json),
        ("npm/index.d.ts", types),
        ("npm/README.md", readme),
        ("pypi/pyproject.toml", include_str!("package/pyproject.toml")),
        ("pypi/README.md", readme),
        ("pypi/stickler_data/__init__.py", include_str!("package/init.py")),
        ("pypi/stickler_data/data.json", &json),
        ("pypi/stickler_data/py.typed", ""),
    ] {
        let path = folder.join(name);
        let versioned = [name.ends_with("package.json"), name.ends_with(".toml")].contains(&true);
        let text = if versioned {
            text.replace(VERSION, data.version)
        } else {
            text.to_owned()
        };
        let created = path.parent().map_or(Ok(()), fs::create_dir_all);
        created
            .and_then(|()| fs::write(&path, text))
            .map_err(|error| ExportError::Write(path, error))?;
    }
    Ok(())
}
