//! A private folder in which a compiler works, removed with all that it left there.

use super::group::lock;
use std::fs::{self, Metadata, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use tempfile::TempDir;

/// The paths of all folders that have not been removed yet.
static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes every folder. Meant for a program that is about to end without dropping them, as at Ctrl-C; the processes that work
/// in them must be gone.
pub(super) fn remove_all() {
    for folder in std::mem::take(&mut *lock(&FOLDERS)) {
        // A folder that cannot be removed now cannot be removed later either.
        let _ = fs::remove_dir_all(folder);
    }
}

/// A folder that only this user can read. Dropping it removes it.
pub(crate) struct Folder {
    folder: TempDir,
}

impl Folder {
    /// Creates a folder among the temporary files of the system.
    ///
    /// # Errors
    /// A fragment that says why the folder could not be created.
    pub(crate) fn new() -> Result<Folder, String> {
        let folder = tempfile::Builder::new()
            .prefix("stickler-")
            .tempdir()
            .map_err(|error| format!("no folder for temporary files could be made: {error}"))?;
        lock(&FOLDERS).push(folder.path().to_owned());
        Ok(Folder { folder })
    }

    /// Returns the path of the folder.
    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Writes a file in the folder, in place of one of the same name.
    ///
    /// # Errors
    /// A fragment that says why it could not be written.
    pub(crate) fn write(&self, name: &str, text: &str) -> Result<PathBuf, String> {
        let path = self.path().join(name);
        if write_over(&path, text).is_err() {
            // The file may hold something else than this program wrote.
            let _ = fs::remove_file(&path);
            fs::write(&path, text)
                .map_err(|error| format!("{} could not be written: {error}", path.display()))?;
        }
        Ok(path)
    }
}

/// Overwrites the content of an existing file. On some systems removing a file and creating a new one takes longer than
/// everything else in a call of a compiler but its start, and a file that is truncated first is written to the disk at once.
///
/// # Errors
/// Errors of the system; also where the path is not a plain file, such as a link that a compiler left, whose target is unknown.
fn write_over(path: &Path, text: &str) -> io::Result<()> {
    let there = fs::symlink_metadata(path)?;
    if !is_plain(&there) {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    let mut file = OpenOptions::new().write(true).open(path)?;
    file.write_all(text.as_bytes())?;
    let length = text.len() as u64;
    match there.len() > length {
        true => file.set_len(length),
        false => Ok(()),
    }
}

/// Tells whether the metadata is that of a file which has no other name.
#[cfg(unix)]
fn is_plain(there: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    there.is_file() && there.nlink() == 1
}

/// Tells whether the metadata is that of a file. Systems other than Unix do not tell whether it has other names.
#[cfg(not(unix))]
fn is_plain(there: &Metadata) -> bool {
    there.is_file()
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
    use std::fs;

    #[test]
    fn a_folder_goes_with_all_that_is_in_it() {
        let folder = Folder::new().unwrap();
        let path = folder.write("a.st", "text").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "text");
        assert!(folder.write("no/such/folder.st", "").is_err());
        drop(folder);
        assert!(!path.exists());
    }

    #[test]
    fn a_file_that_is_written_again_holds_the_new_text_alone() {
        let folder = Folder::new().unwrap();
        for text in ["text", "a longer text", "short", "", "text"] {
            let path = folder.write("a.st", text).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
    }

    #[cfg(unix)]
    #[test]
    fn what_a_compiler_left_in_the_place_of_a_file_is_replaced_and_not_written_to() {
        use std::os::unix::fs::symlink;
        let (folder, elsewhere) = (Folder::new().unwrap(), Folder::new().unwrap());
        let other = elsewhere.write("other", "another's").unwrap();
        let path = folder.path().join("a.st");
        let leave: [&dyn Fn(); 3] = [
            &|| symlink(&other, &path).unwrap(),
            &|| fs::hard_link(&other, &path).unwrap(),
            &|| symlink("/no/such/file", &path).unwrap(),
        ];
        for leave in leave {
            leave();
            folder.write("a.st", "text").unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), "text");
            assert!(!path.is_symlink());
            assert_eq!(fs::read_to_string(&other).unwrap(), "another's");
            fs::remove_file(&path).unwrap();
        }
    }
}
