//! Reads source files as bytes, whatever their encoding.

use anyhow::Context;
use std::fs;
use std::io::{self, Read};
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
