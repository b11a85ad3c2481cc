//! The cases that the program carries, for places where no clone is: unpacked into the user's cache folder when they are first needed.

use anyhow::Context;
use flate2::read::GzDecoder;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use tar::Archive;
use walkdir::WalkDir;

/// The archive of the folder of cases as it was when the program was built.
const ARCHIVE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/cases.tar.gz"));

/// The version of the program and a hash of the archive, so that no two programs share a folder unless their cases are the same.
const EDITION: &str = env!("STICKLER_CASES");

/// The number of files in the archive, in digits.
const FILES: &str = env!("STICKLER_CASE_FILES");

/// Returns the folder with the cases of the program, in the user's cache folder. Unpacks them unless they are there.
///
/// # Errors
/// No cache folder, or one that cannot be written to.
pub fn unpacked() -> anyhow::Result<PathBuf> {
    let hint = "the cases inside the program cannot be used; name a folder of cases with --cases DIR";
    let cache = dirs::cache_dir().with_context(|| format!("there is no folder for caches: {hint}"))?;
    let edition = cache.join("stickler").join("cases").join(EDITION);
    if !is_complete(&edition) {
        unpack(&edition).with_context(|| format!("cannot unpack into {}: {hint}", edition.display()))?;
    }
    Ok(edition.join(super::NAME))
}

/// Returns whether a folder has as many files as the archive: programs that tidy up caches delete single files.
fn is_complete(edition: &Path) -> bool {
    let entries = WalkDir::new(edition).into_iter().flatten();
    let files = entries.filter(|entry| entry.file_type().is_file()).count();
    FILES.parse() == Ok(files)
}

/// Unpacks the archive beside the folder and moves it there, so that another process never meets a part of it.
fn unpack(edition: &Path) -> io::Result<()> {
    let parent = edition.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(parent)?;
    let made = tempfile::tempdir_in(parent)?;
    let mut archive = Archive::new(GzDecoder::new(ARCHIVE));
    archive.set_preserve_mtime(false);
    archive.unpack(made.path().join(super::NAME))?;
    if edition.exists() {
        fs::remove_dir_all(edition)?;
    }
    match fs::rename(made.path(), edition) {
        // Another process may have been quicker.
        Err(error) if !is_complete(edition) => Err(error),
        _ => Ok(()),
    }
}
