//! Reads source files as bytes, whatever their encoding.

use anyhow::Context;
use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// Reads the bytes of a file, or of stdin where the path is `-`; also returns the name to show for it.
///
/// # Errors
/// A file or stdin that cannot be read.
pub fn read(path: &Path) -> anyhow::Result<(Vec<u8>, String)> {
    if path.as_os_str() == "-" {
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).context("cannot read stdin")?;
        return Ok((bytes, "<stdin>".to_owned()));
    }
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok((bytes, path.display().to_string()))
}

/// Reads a text file; `None` where there is none.
///
/// # Errors
/// A file that cannot be read.
pub fn text_if_any(path: &Path) -> anyhow::Result<Option<String>> {
    match fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error).with_context(|| format!("cannot read {}", path.display())),
    }
}
