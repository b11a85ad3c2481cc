//! The folder in which findings are kept: one folder each, which appears whole or not at all.

use crate::finding::{FORMAT, Finding};
use serde::de::DeserializeOwned;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The finding itself, without its programs.
const FINDING: &str = "finding.json";
/// The reduced program.
const PROGRAM: &str = "program.st";
/// The program as it was found.
const ORIGINAL: &str = "original.st";
/// The bytes that the target judges.
const INPUT: &str = "input";

/// The reason for which a finding cannot be kept or read.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// A file or folder cannot be written.
    #[error("cannot write {path}: {error}")]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// The reason.
        error: io::Error,
    },
    /// A file or folder cannot be read.
    #[error("cannot read {path}: {error}")]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// The reason.
        error: io::Error,
    },
    /// A file says nothing of a campaign.
    #[error("{path} is of no campaign that this version of Stickler knows: {reason}")]
    NotACampaign {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
    /// A folder holds no finding.
    #[error("{path} is no finding: {reason}")]
    NoFinding {
        /// The folder or file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
}

impl StoreError {
    fn writing(path: &Path) -> impl FnOnce(io::Error) -> StoreError {
        let path = path.to_owned();
        move |error| StoreError::Write { path, error }
    }

    fn reading(path: &Path) -> impl FnOnce(io::Error) -> StoreError {
        let path = path.to_owned();
        move |error| StoreError::Read { path, error }
    }
}

/// A folder of findings.
#[derive(Clone, Debug)]
pub struct Store {
    folder: PathBuf,
}

/// The result of saving a finding.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Saved {
    /// The finding was written, alone or in the place of one that was worth less.
    Written,
    /// An earlier campaign has saved the finding already, and as small.
    Known,
}

impl Store {
    /// The folder, made where it is missing. A file is written into it and taken away again, for it is better to hear
    /// before a campaign than after it that nothing can be saved.
    ///
    /// # Errors
    /// [`StoreError::Write`].
    pub fn open(folder: &Path) -> Result<Store, StoreError> {
        fs::create_dir_all(folder).map_err(StoreError::writing(folder))?;
        let trial = folder.join(format!(".trial-{}", std::process::id()));
        fs::write(&trial, b"?").map_err(StoreError::writing(folder))?;
        fs::remove_file(&trial).map_err(StoreError::writing(&trial))?;
        Ok(Store {
            folder: folder.to_owned(),
        })
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the folder in which a finding of this name is kept.
    pub fn place(&self, id: &str) -> PathBuf {
        self.folder.join(id)
    }

    /// Saves a finding, unless one of its name is there that is worth as much. A reader sees the old folder or the new
    /// one, whole.
    ///
    /// # Errors
    /// [`StoreError::Write`]; then nothing is left of the attempt.
    pub fn save(&self, finding: &Finding) -> Result<Saved, StoreError> {
        let (place, known) = self.readable_place(&finding.id);
        if let Some(known) = &known
            && !finding.improves_on(known)
        {
            return Ok(Saved::Known);
        }
        let own = std::process::id();
        let fresh = self.folder.join(format!(".{}-{own}", finding.id));
        write_all(finding, &fresh).inspect_err(|_| discard(&fresh))?;
        let old = self.folder.join(format!(".{}-{own}-old", finding.id));
        if known.is_some() {
            fs::rename(&place, &old)
                .map_err(StoreError::writing(&place))
                .inspect_err(|_| discard(&fresh))?;
        }
        fs::rename(&fresh, &place)
            .map_err(StoreError::writing(&place))
            .inspect_err(|_| {
                discard(&fresh);
                // Where even this fails, the old finding is in the folder whose name begins with a point.
                let _ = fs::rename(&old, &place);
            })?;
        discard(&old);
        Ok(Saved::Written)
    }

    /// The first place for this name that is free or holds a finding. What another version left there, or a person, is not
    /// ours to remove; then the name gets a number.
    fn readable_place(&self, id: &str) -> (PathBuf, Option<Finding>) {
        let mut place = self.place(id);
        let mut number = 1_u32;
        while place.exists() {
            if let Ok(finding) = load(&place) {
                return (place, Some(finding));
            }
            number += 1;
            place = self.place(&format!("{id}-{number}"));
        }
        (place, None)
    }

    /// Every finding in the folder, by name, and what is wrong with folders that hold none. Names that begin with a point
    /// are no findings.
    ///
    /// # Errors
    /// [`StoreError::Read`] where the folder itself cannot be read.
    pub fn findings(folder: &Path) -> Result<(Vec<Finding>, Vec<StoreError>), StoreError> {
        let mut places: Vec<PathBuf> = Vec::new();
        for entry in fs::read_dir(folder).map_err(StoreError::reading(folder))? {
            let entry = entry.map_err(StoreError::reading(folder))?;
            let hidden = entry.file_name().to_string_lossy().starts_with('.');
            if !hidden && entry.path().is_dir() {
                places.push(entry.path());
            }
        }
        places.sort();
        let mut findings = Vec::new();
        let mut errors = Vec::new();
        for place in places {
            match load(&place) {
                Ok(finding) => findings.push(finding),
                Err(error) => errors.push(error),
            }
        }
        Ok((findings, errors))
    }
}

/// Reads one finding.
///
/// # Errors
/// [`StoreError::Read`]; [`StoreError::NoFinding`] where the folder holds something else, or what another version of
/// Stickler wrote in a form that this one does not know.
pub fn load(place: &Path) -> Result<Finding, StoreError> {
    let path = place.join(FINDING);
    let no_finding = |reason: String| StoreError::NoFinding {
        path: place.to_owned(),
        reason,
    };
    let text = match fs::read_to_string(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound && place.is_dir() => {
            return Err(no_finding(format!("it has no {FINDING}")));
        }
        other => other.map_err(StoreError::reading(&path))?,
    };
    let mut finding: Finding =
        of_format(&text, FORMAT, FINDING, "; find it again by its seed").map_err(no_finding)?;
    finding.program = optional(&place.join(PROGRAM))?;
    finding.original = optional(&place.join(ORIGINAL))?;
    finding.input = optional_bytes(&place.join(INPUT))?.unwrap_or_default();
    Ok(finding)
}

/// Reads the JSON of a file that says which form it has.
///
/// # Errors
/// What is wrong with it: another form, with a hint, or none, or a mistake.
pub(crate) fn of_format<T: DeserializeOwned>(
    text: &str,
    format: u32,
    file: &str,
    hint: &str,
) -> Result<T, String> {
    let wrong = |error: serde_json::Error| format!("{file}: {error}");
    let json: serde_json::Value = serde_json::from_str(text).map_err(wrong)?;
    let by = json.get("stickler").and_then(serde_json::Value::as_str);
    let by = by.map(|version| format!(", written by Stickler {version}"));
    let by = by.unwrap_or_default();
    match json.get("format").and_then(serde_json::Value::as_u64) {
        Some(own) if own == u64::from(format) => serde_json::from_value(json).map_err(wrong),
        Some(own) => Err(format!(
            "its form is {own}{by}; this version reads {format}{hint}"
        )),
        None => Err(format!("{file} does not say its `format`{by}")),
    }
}

fn write_all(finding: &Finding, place: &Path) -> Result<(), StoreError> {
    discard(place);
    fs::create_dir(place).map_err(StoreError::writing(place))?;
    let json = serde_json::to_string_pretty(finding).map_err(|error| StoreError::Write {
        path: place.join(FINDING),
        error: error.into(),
    })?;
    let files = [
        (INPUT, Some(&finding.input[..])),
        (ORIGINAL, finding.original.as_deref().map(str::as_bytes)),
        (PROGRAM, finding.program.as_deref().map(str::as_bytes)),
        (FINDING, Some(json.as_bytes())),
    ];
    for (name, bytes) in files {
        let Some(bytes) = bytes else { continue };
        let path = place.join(name);
        write_through(&path, bytes).map_err(StoreError::writing(&path))?;
    }
    Ok(())
}

/// Writes a file and waits until the disk has it: some file systems say only then that they are full.
fn write_through(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = fs::File::create(path)?;
    io::Write::write_all(&mut file, bytes)?;
    file.sync_all()
}

/// Takes away what an attempt left. Where that fails too, its name begins with a point, and no reader looks at it.
fn discard(place: &Path) {
    let _ = fs::remove_dir_all(place);
}

fn optional(path: &Path) -> Result<Option<String>, StoreError> {
    let bytes = optional_bytes(path)?;
    Ok(bytes.map(|bytes| String::from_utf8_lossy(&bytes).into_owned()))
}

fn optional_bytes(path: &Path) -> Result<Option<Vec<u8>>, StoreError> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(StoreError::reading(path)(error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use stickler_mdtest::assert_fits;

    fn store() -> (tempfile::TempDir, Store) {
        let folder = tempfile::tempdir().unwrap();
        let store = Store::open(&folder.path().join("deep/findings")).unwrap();
        (folder, store)
    }

    #[test]
    fn what_is_saved_is_read_again() {
        let (_folder, store) = store();
        let finding = sample::finding("a", "crash", &["FOR"], 9);
        assert_eq!(store.save(&finding).unwrap(), Saved::Written);
        assert_eq!(load(&store.place(&finding.id)).unwrap(), finding);
        let (all, errors) = Store::findings(store.folder()).unwrap();
        assert_eq!((all.len(), errors.len()), (1, 0));
    }

    #[test]
    fn only_a_finding_that_is_worth_more_takes_the_place_of_another() {
        let (_folder, store) = store();
        let large = sample::finding("a", "crash", &["FOR"], 30);
        let small = sample::finding("a", "crash", &["FOR"], 9);
        assert_eq!(store.save(&large).unwrap(), Saved::Written);
        assert_eq!(store.save(&small).unwrap(), Saved::Written);
        assert_eq!(store.save(&large).unwrap(), Saved::Known);
        assert_eq!(load(&store.place(&small.id)).unwrap(), small);
        let names = fs::read_dir(store.folder()).unwrap().count();
        assert_eq!(names, 1, "nothing else is left");
    }

    #[test]
    fn what_another_version_wrote_is_named_and_not_misread() {
        let (_folder, store) = store();
        let place = store.place("old");
        fs::create_dir(&place).unwrap();
        fs::write(place.join(FINDING), r#"{"format": 99, "stickler": "9.0.0"}"#).unwrap();
        let error = load(&place).unwrap_err().to_string();
        assert_fits(&error, "…its form is 99, written by Stickler 9.0.0…");
        fs::write(place.join(FINDING), "{").unwrap();
        assert_fits(&load(&place).unwrap_err().to_string(), "…finding.json: EOF…");
        fs::remove_file(place.join(FINDING)).unwrap();
        assert_fits(&load(&place).unwrap_err().to_string(), "…it has no finding.json…");
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_an_error_before_the_campaign() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        let error = Store::open(&file.join("findings")).unwrap_err().to_string();
        assert!(error.starts_with("cannot write "), "{error}");
    }
}
