//! Tests of `stickler.toml` as people write it.

mod dialects;
mod file;

use std::fs;
use std::path::Path;
use stickler_configuration::ConfigurationFile;
use stickler_mdtest::fits;

/// Returns the configuration of a temporary folder whose file has this text.
fn read(text: &str) -> Result<ConfigurationFile, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("stickler.toml"), text).unwrap();
    ConfigurationFile::find(folder.path()).map_err(|error| error.to_string())
}

fn mistake(text: &str) -> String {
    read(text).unwrap_err()
}

/// Reads each file of `tests/mistakes/*.md`, behind which stands what must be told.
#[test]
fn a_mistake_is_told_with_its_place_and_what_was_meant() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mistakes");
    let mut failures = Vec::new();
    for name in ["dialects.md", "engines.md"] {
        let text = fs::read_to_string(folder.join(name)).unwrap();
        for part in text.split("```toml\n").skip(1) {
            let (file, behind) = part.split_once("```\n").unwrap();
            let expected = behind.trim().strip_prefix("> ").unwrap();
            let message = mistake(file);
            if !fits(&format!("stickler.toml:{expected}"), &message) {
                failures.push(format!("{name}:\n{file}> {expected}\ngives\n> {message}\n"));
            }
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}
