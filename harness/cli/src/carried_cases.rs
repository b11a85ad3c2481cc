//! The cases that the program carries, for places where no clone is: unpacked into the user's cache folder when they are first needed.

use anyhow::Context;
use flate2::read::GzDecoder;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::{Duration, SystemTime};
use tar::Archive;
use walkdir::WalkDir;

/// The archive of the folder of cases as it was when the program was built.
const ARCHIVE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/cases.tar.gz"));

/// The version of the program and a hash of the archive, so that no two programs share a folder unless their cases are the same.
const EDITION: &str = env!("STICKLER_CASES");

/// The number of files in the archive, in digits.
const FILES: &str = env!("STICKLER_CASE_FILES");

/// The time after which the cases of another program are removed when no program has used them.
const MAX_UNUSED: Duration = Duration::from_secs(30 * 24 * 60 * 60);

/// The minimum time between two writes of the note that the cases are used.
const NOTE_INTERVAL: Duration = Duration::from_secs(24 * 60 * 60);

/// The extension of the empty file beside a folder of cases that is written when they are used.
const USED: &str = "used";

/// The folder with the cases, once this process has looked for it: commands ask several times.
static UNPACKED: OnceLock<PathBuf> = OnceLock::new();

/// Returns the folder with the cases of the program, which is called `name`, in the user's cache folder. Unpacks them unless they are there.
///
/// # Errors
/// No cache folder, or one that cannot be written to.
pub fn unpacked(name: &str) -> anyhow::Result<PathBuf> {
    if let Some(folder) = UNPACKED.get() {
        return Ok(folder.clone());
    }
    let hint = "the cases inside the program cannot be used; name a folder of cases with --cases DIR";
    let cache = dirs::cache_dir().with_context(|| format!("there is no folder for caches: {hint}"))?;
    let editions = cache.join("stickler").join("cases");
    let edition = editions.join(EDITION);
    if !is_complete(&edition) {
        unpack(&edition, name)
            .with_context(|| format!("cannot unpack into {}: {hint}", edition.display()))?;
        clean(&editions, &edition, SystemTime::now());
    }
    note_use(&edition, SystemTime::now());
    Ok(UNPACKED.get_or_init(|| edition.join(name)).clone())
}

/// Removes the cases that were not used for a long time, but not those that were just unpacked: an old note of their use may have outlived
/// a folder that was deleted.
fn clean(editions: &Path, unpacked: &Path, now: SystemTime) {
    note_use(unpacked, now);
    remove_unused(editions, now);
}

/// Returns whether a folder has as many files as the archive: programs that tidy up caches delete single files.
fn is_complete(edition: &Path) -> bool {
    let entries = WalkDir::new(edition).into_iter().flatten();
    let files = entries.filter(|entry| entry.file_type().is_file()).count();
    FILES.parse() == Ok(files)
}

/// Unpacks the archive beside the folder and moves it there, so that another process never meets a part of it.
fn unpack(edition: &Path, name: &str) -> io::Result<()> {
    let parent = edition.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(parent)?;
    let made = tempfile::tempdir_in(parent)?;
    let mut archive = Archive::new(GzDecoder::new(ARCHIVE));
    archive.set_preserve_mtime(false);
    archive.unpack(made.path().join(name))?;
    if edition.exists() {
        fs::remove_dir_all(edition)?;
    }
    match fs::rename(made.path(), edition) {
        // Another process may have been quicker.
        Err(error) if !is_complete(edition) => Err(error),
        _ => Ok(()),
    }
}

/// Returns the file that tells by its time when a folder of cases was last used.
fn note_of(edition: &Path) -> PathBuf {
    // The name of an edition has points, so that an extension cannot be set.
    let name = edition.file_name().unwrap_or_default().to_string_lossy();
    edition.with_file_name(format!("{name}.{USED}"))
}

/// Returns the time since a file or folder was last changed; nothing where that is not known.
fn age(path: &Path, now: SystemTime) -> Option<Duration> {
    let changed = fs::symlink_metadata(path).ok()?.modified().ok()?;
    now.duration_since(changed).ok()
}

/// Notes that the cases are used, unless that was noted a short time ago.
fn note_use(edition: &Path, now: SystemTime) {
    let note = note_of(edition);
    if age(&note, now).is_none_or(|age| age > NOTE_INTERVAL) {
        // At worst the cases are unpacked once more.
        let _ = fs::write(note, "");
    }
}

/// Removes the cases of other programs, and what an unpacking that was stopped left, where they were not used for a long time. A program
/// whose cases are removed unpacks them again. What cannot be removed stays.
fn remove_unused(editions: &Path, now: SystemTime) {
    let entries = fs::read_dir(editions).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        let note = note_of(&path);
        let unused = age(&note, now).or_else(|| age(&path, now));
        if !path.is_symlink() && path.is_dir() && unused.is_some_and(|age| age > MAX_UNUSED) {
            let _ = remove(&path, editions);
            let _ = fs::remove_file(note);
        }
    }
}

/// Removes a folder, which no other process ever sees without a part of its files.
fn remove(folder: &Path, beside: &Path) -> io::Result<()> {
    let aside = tempfile::tempdir_in(beside)?;
    fs::rename(folder, aside.path().join("unused"))?;
    aside.close()
}

#[cfg(test)]
mod tests {
    use super::{MAX_UNUSED, NOTE_INTERVAL, clean, note_of, note_use, remove_unused};
    use std::fs;
    use std::time::{Duration, SystemTime};

    #[test]
    fn only_folders_that_no_program_has_used_for_long_are_removed() {
        let folder = tempfile::tempdir().expect("a folder");
        let elsewhere = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        for name in ["0.1.0-old", "0.1.0-used", ".tmpleft"] {
            fs::create_dir(path(name)).expect("a folder");
            fs::write(path(name).join("case.st"), "").expect("a file");
        }
        fs::write(path("a file"), "").expect("a file");
        #[cfg(unix)]
        std::os::unix::fs::symlink(elsewhere.path(), path("a link")).expect("a link");
        let now = SystemTime::now();
        let later = now + MAX_UNUSED + Duration::from_secs(60);
        remove_unused(folder.path(), now);
        assert!(path("0.1.0-old").is_dir() && path(".tmpleft").is_dir());
        note_use(&path("0.1.0-used"), now);
        let noted = |time: SystemTime| {
            let note = fs::File::options()
                .append(true)
                .open(note_of(&path("0.1.0-used")));
            note.expect("the note").set_modified(time).expect("a time");
        };
        noted(now - MAX_UNUSED - NOTE_INTERVAL);
        clean(folder.path(), &path("0.1.0-used"), now);
        assert!(path("0.1.0-used/case.st").is_file());
        noted(later - NOTE_INTERVAL);
        remove_unused(folder.path(), later);
        assert!(!path("0.1.0-old").exists() && !path(".tmpleft").exists());
        assert!(path("0.1.0-used/case.st").is_file() && path("a file").is_file());
        assert!(elsewhere.path().is_dir());
        remove_unused(folder.path(), later + MAX_UNUSED);
        assert!(!path("0.1.0-used").exists() && !note_of(&path("0.1.0-used")).exists());
    }
}
