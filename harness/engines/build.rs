//! Computes a digest of the sources of the adapters, so that a cached answer is never taken for one that changed adapters would
//! give.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::Path;

/// The sources that decide how an engine is asked and how its answers are read: this crate, and the crate of the value types.
const SOURCES: [&str; 2] = ["src", "../types/src"];

fn main() -> io::Result<()> {
    let mut hasher = DefaultHasher::new();
    for source in SOURCES {
        println!("cargo::rerun-if-changed={source}");
        take(Path::new(source), &mut hasher)?;
    }
    println!("cargo::rustc-env=STICKLER_ADAPTERS={:016x}", hasher.finish());
    Ok(())
}

/// Hashes a file, or everything in a folder, in the order of the file names.
fn take(path: &Path, hasher: &mut DefaultHasher) -> io::Result<()> {
    if !path.is_dir() {
        path.file_name().hash(hasher);
        fs::read(path)?.hash(hasher);
        return Ok(());
    }
    let mut inside: Vec<_> = fs::read_dir(path)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<io::Result<_>>()?;
    inside.sort();
    inside.iter().try_for_each(|path| take(path, hasher))
}
