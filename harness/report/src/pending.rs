//! A file that appears under its name only when it is complete.

use crate::ReportError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file that is written under a temporary name and renamed when it is complete. Dropping it before removes the temporary
/// file.
pub(crate) struct PendingFile {
    path: PathBuf,
    temporary: PathBuf,
    writer: Option<BufWriter<File>>,
}

impl PendingFile {
    /// Creates the temporary file beside `path`, and removes the file of an earlier run at `path`, since the files of a
    /// folder all belong to one run.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the folder or the file cannot be written.
    pub(crate) fn create(path: PathBuf) -> Result<PendingFile, ReportError> {
        let mut name = std::ffi::OsString::from(".");
        name.push(path.file_name().unwrap_or_default());
        name.push(".part");
        let temporary = path.with_file_name(name);
        let file = File::create(&temporary).map_err(ReportError::writing(&temporary))?;
        let pending = PendingFile {
            temporary,
            path,
            writer: Some(BufWriter::with_capacity(1 << 16, file)),
        };
        match fs::remove_file(&pending.path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(ReportError::Write {
                path: pending.path.clone(),
                source: error,
            }),
            _ => Ok(pending),
        }
    }

    /// Returns the name that the file will have.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the whole content, and renames the file to its own name.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the content cannot be written or the file cannot be renamed.
    pub(crate) fn fill(mut self, content: &[u8]) -> Result<(), ReportError> {
        let path = self.path.clone();
        self.write_all(content).map_err(ReportError::writing(&path))?;
        self.commit()
    }

    /// Renames the complete file to its own name.
    ///
    /// # Errors
    /// [`ReportError::Write`] where the last bytes cannot be written or the file cannot be renamed.
    pub(crate) fn commit(mut self) -> Result<(), ReportError> {
        self.flush().map_err(ReportError::writing(&self.path))?;
        self.writer = None;
        fs::rename(&self.temporary, &self.path).map_err(ReportError::writing(&self.path))
    }
}

impl Write for PendingFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.writer {
            Some(writer) => writer.write(bytes),
            None => Err(io::ErrorKind::BrokenPipe.into()),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.as_mut().map_or(Ok(()), BufWriter::flush)
    }
}

impl Drop for PendingFile {
    fn drop(&mut self) {
        // After a commit the temporary name no longer exists, and nobody could act on another error here.
        let _ = fs::remove_file(&self.temporary);
    }
}

#[cfg(test)]
mod tests {
    use super::PendingFile;
    use std::fs;
    use std::io::Write;

    #[test]
    fn a_file_appears_only_when_it_is_complete() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("a.json");
        fs::write(&path, "old").expect("an old file");
        let mut pending = PendingFile::create(path.clone()).expect("a pending file");
        pending.write_all(b"new").expect("written");
        assert!(
            !path.exists(),
            "the old file is gone and the new one not yet there"
        );
        pending.commit().expect("committed");
        assert_eq!(fs::read(&path).expect("the new file"), b"new");
        assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 1);
    }

    #[test]
    fn an_abandoned_file_leaves_nothing() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        drop(PendingFile::create(folder.path().join("a.json")).expect("a pending file"));
        assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 0);
    }
}
