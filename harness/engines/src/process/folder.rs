//! A private folder in which a compiler works, removed with all that it left there.

use super::group::lock;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use tempfile::TempDir;

/// Every folder that there is.
static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes every folder. For a program that is about to end without dropping them, as at Ctrl-C; those who work in
/// them must be gone.
pub(super) fn remove_all() {
    for folder in std::mem::take(&mut *lock(&FOLDERS)) {
        // What cannot be removed now, nobody can remove.
        let _ = std::fs::remove_dir_all(folder);
    }
}

/// A folder that only this user can look into. Dropping it removes it.
pub(crate) struct Folder {
    folder: TempDir,
}

impl Folder {
    /// A new folder among the temporary files of the system.
    ///
    /// # Errors
    /// A fragment that says why there is none.
    pub(crate) fn new() -> Result<Folder, String> {
        let folder = tempfile::Builder::new()
            .prefix("stickler-")
            .tempdir()
            .map_err(|error| format!("no folder for temporary files could be made: {error}"))?;
        lock(&FOLDERS).push(folder.path().to_owned());
        Ok(Folder { folder })
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Writes a file in it, in place of one of the same name.
    ///
    /// # Errors
    /// A fragment that says why it could not be written.
    pub(crate) fn write(&self, name: &str, text: &str) -> Result<PathBuf, String> {
        let path = self.path().join(name);
        // A file that is cut to nothing and written again some systems bring to the disk at once; a new one they do not.
        let _ = std::fs::remove_file(&path);
        std::fs::write(&path, text)
            .map_err(|error| format!("{} could not be written: {error}", path.display()))?;
        Ok(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // The folder removes itself behind this.
        lock(&FOLDERS).retain(|folder| folder != self.folder.path());
    }
}

#[cfg(test)]
mod tests {
    use super::Folder;

    #[test]
    fn a_folder_goes_with_all_that_is_in_it() {
        let folder = Folder::new().unwrap();
        let path = folder.write("a.st", "text").unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "text");
        assert!(folder.write("no/such/folder.st", "").is_err());
        drop(folder);
        assert!(!path.exists());
    }
}
