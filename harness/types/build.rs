//! Puts the files of the documented dialects into the crate: every `conformance-cases/dialects/*.toml`, in the order of their key
//! `order`, and a constant for the name of each.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases/dialects");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(&folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            println!("cargo::rerun-if-changed={}", path.display());
            files.push((order(&fs::read_to_string(&path)?), path));
        }
    }
    files.sort();
    let output = Path::new(&env::var_os("OUT_DIR").unwrap_or_default()).join("dialects.rs");
    fs::write(output, source(&files).map_err(io::Error::other)?)
}

/// Returns the number behind `order =`; files without one come last.
fn order(text: &str) -> u32 {
    let mut lines = text
        .lines()
        .filter_map(|line| line.strip_prefix("order")?.trim_start().strip_prefix('='));
    let number = lines.next().and_then(|number| number.trim().parse().ok());
    number.unwrap_or(u32::MAX)
}

/// Returns the table of the files, and the constants.
fn source(files: &[(u32, PathBuf)]) -> Result<String, std::fmt::Error> {
    let (mut table, mut constants) = (String::new(), String::new());
    for (index, (_, path)) in files.iter().enumerate() {
        let name = path
            .file_stem()
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        writeln!(
            table,
            "    ({name:?}, include_str!({:?})),",
            path.display().to_string()
        )?;
        let constant = name.to_uppercase().replace('-', "_");
        writeln!(constants, "    /// The dialect `{name}`.")?;
        writeln!(
            constants,
            "    pub const {constant}: DialectName = DialectName({index});"
        )?;
    }
    let length = files.len();
    Ok(format!(
        "/// The name and the file of each documented system.\nconst EMBEDDED: [(&str, &str); {length}] = [\n{table}];\n\n\
         impl DialectName {{\n{constants}}}\n"
    ))
}
