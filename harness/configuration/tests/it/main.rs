//! Tests of `stickler.toml` as people write it.

mod dialects;
mod file;

use std::fs;
use stickler_configuration::ConfigurationFile;

/// Returns the configuration of a temporary folder whose file has this text.
fn read(text: &str) -> Result<ConfigurationFile, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("stickler.toml"), text).unwrap();
    ConfigurationFile::find(folder.path()).map_err(|error| error.to_string())
}

fn mistake(text: &str) -> String {
    read(text).unwrap_err()
}
