//! A source file as bytes: whatever stands in it, it is read.

use anyhow::Context;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// The bytes of a file, or of stdin where the path is `-`, and the name to show for it.
///
/// # Errors
/// A file that cannot be read, or that is no text.
pub fn read(path: &Path) -> anyhow::Result<(Vec<u8>, String)> {
    if path.as_os_str() == "-" {
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).context("cannot read stdin")?;
        return Ok((bytes, "<stdin>".to_owned()));
    }
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok((bytes, path.display().to_string()))
}
