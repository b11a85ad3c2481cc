//! The answers of compilers, kept in a folder from one run to the next: a file for each compiler as it is, which its fingerprint
//! names.
//!
//! A cache is never worth a run. What cannot be read is said and not used; what cannot be written is said, and the run goes on.
//! Each answer stands on a line of its own with a digest of itself, so that no half line, and no line into which another was
//! written, is taken for an answer; lines are only ever added, each by one call of the system, so that several runs may do so at
//! once. The folder has a bound: see [`Cache::open`].

mod file;

use file::Kept;
use std::collections::HashMap;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use stickler_run::AnswerStore;

/// The answers of one compiler, which [`Cache::open`] reads from its file.
pub struct Cache {
    path: PathBuf,
    answers: HashMap<String, String>,
    keeping: Mutex<Keeping>,
}

/// The file to which new answers are added.
struct Keeping {
    /// `None` once it could not be written.
    file: Option<File>,
    /// Messages for a person, in whole sentences.
    notes: Vec<String>,
}

impl Cache {
    /// Opens the cache of the compiler `engine`, as it is with this fingerprint, in a folder, which is made where it is not
    /// there. Of the files in the folder those that were used last are kept, eight of them; of a file that grows beyond
    /// 64 MiB the newer half.
    ///
    /// Nothing goes wrong here but what [`Cache::notes`] tells: then the cache is empty, or keeps nothing.
    pub fn open(folder: &Path, engine: &str, fingerprint: &str) -> Cache {
        let path = folder.join(file::name(engine, fingerprint));
        let mut notes = Vec::new();
        let Kept { answers, file } = file::open(&path, fingerprint, file::MAX_FILE_SIZE, &mut notes);
        file::remove_old(folder, &path);
        Cache {
            path,
            answers,
            keeping: Mutex::new(Keeping { file, notes }),
        }
    }

    /// Returns messages for a person, in whole sentences; each is returned once.
    pub fn notes(&self) -> Vec<String> {
        std::mem::take(&mut self.lock().notes)
    }

    fn lock(&self) -> MutexGuard<'_, Keeping> {
        self.keeping.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl AnswerStore for Cache {
    fn get(&self, question: &str) -> Option<&str> {
        self.answers.get(question).map(String::as_str)
    }

    fn put(&self, question: &str, answers: &str) {
        let mut keeping = self.lock();
        let Some(file) = &mut keeping.file else {
            return;
        };
        if let Err(error) = file.write_all(file::written(question, answers).as_bytes()) {
            keeping.file = None;
            let note = format!(
                "{} cannot be written, and keeps no more results: {error}",
                self.path.display()
            );
            keeping.notes.push(note);
        }
    }
}

#[cfg(test)]
mod tests;
