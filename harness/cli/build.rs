//! Packs the folder of cases into an archive, which the program carries for places where no clone is.

use flate2::{Compression, GzBuilder};
use std::error::Error;
use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};
use std::{env, io};
use tar::{Builder, HeaderMode};
use walkdir::WalkDir;

fn main() -> Result<(), Box<dyn Error>> {
    let manifest = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let cases = manifest.join("../../conformance-cases");
    // Of a folder, Cargo looks at all files in it.
    println!("cargo:rerun-if-changed={}", cases.display());
    let (archive, files) = packed(&cases)?;
    let mut hasher = DefaultHasher::new();
    hasher.write(&archive);
    fs::write(PathBuf::from(env::var("OUT_DIR")?).join("cases.tar.gz"), &archive)?;
    let version = env::var("CARGO_PKG_VERSION")?;
    println!(
        "cargo:rustc-env=STICKLER_CASES={version}-{:016x}",
        hasher.finish()
    );
    println!("cargo:rustc-env=STICKLER_CASE_FILES={files}");
    Ok(())
}

/// Returns the archive of a folder, which is the same wherever and whenever it is made, and the number of files in it. Hidden files are
/// left out.
fn packed(folder: &Path) -> io::Result<(Vec<u8>, usize)> {
    // The header of the compressed archive has no date unless one is set.
    let mut archive = Builder::new(GzBuilder::new().write(Vec::new(), Compression::best()));
    archive.mode(HeaderMode::Deterministic);
    let mut files = 0;
    let is_hidden = |name: &str| name.starts_with('.');
    let entries = WalkDir::new(folder).sort_by_file_name().into_iter();
    for entry in entries.filter_entry(|entry| !entry.file_name().to_str().is_some_and(is_hidden)) {
        let entry = entry?;
        if entry.file_type().is_file() {
            let name = entry.path().strip_prefix(folder).map_err(io::Error::other)?;
            archive.append_path_with_name(entry.path(), name)?;
            files += 1;
        }
    }
    Ok((archive.into_inner()?.finish()?, files))
}
