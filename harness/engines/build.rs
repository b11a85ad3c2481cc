//! A digest of the source of the adapters, so that what an engine answered is never taken for what it would answer to others.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::Path;

/// What decides how an engine is asked and its answer is read: this crate, and the values that it reads.
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

/// Takes a file, or all that is in a folder, in the order of the names.
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
