//! The files of a suite's folder: finds them, tells their kind, and reads their texts.

use std::io::Read;
use std::path::{Path, PathBuf};
use stickler_types::join;

use serde::de::DeserializeOwned;
use walkdir::WalkDir;

use crate::error::{Mistake, in_file};
use crate::place::Lines;
use crate::{CaseFileError, toml_text};

/// The length of the longest case file that is read, in bytes.
const MAX_FILE_LEN: u64 = 16 << 20;

/// The folder of recordings of compilers below a root, whose tables are no case files.
pub const RECORDINGS: &str = "recordings";

/// The root of a suite.
#[derive(Debug)]
pub(crate) struct Root {
    path: PathBuf,
    /// The name of the folder itself, with which the paths in reports begin.
    name: String,
}

/// The message for a path that is given as a case file but has another extension.
pub(crate) const NO_CASE_FILE: &str = "a case file ends in .st or .toml";

/// A case file.
#[derive(Debug)]
pub(crate) struct CaseFile {
    pub(crate) path: PathBuf,
    /// The path below the root, with forward slashes.
    pub(crate) below_root: String,
    /// The path as reports show it: with the root's name.
    pub(crate) shown: String,
    pub(crate) kind: FileKind,
}

/// The kind of a case file, which its extension tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// An annotated program, `*.st`; the id of its case is the id of the file.
    Program,
    /// A table, `*.toml`; the ids of its cases begin with the id of the file and `::`.
    Table,
}

impl FileKind {
    /// Returns the extension of such files, without the point.
    pub const fn extension(self) -> &'static str {
        match self {
            FileKind::Program => "st",
            FileKind::Table => "toml",
        }
    }
}

/// The case files below a root, and the mistakes met while listing them.
#[derive(Debug, Default)]
pub(crate) struct Listing {
    pub(crate) files: Vec<CaseFile>,
    pub(crate) errors: Vec<CaseFileError>,
    pub(crate) remarks: Vec<CaseFileError>,
}

impl Root {
    pub(crate) fn new(path: &Path) -> Root {
        // `.` has no name of its own; what it stands for has.
        let named = path.file_name().map(|name| name.to_os_string());
        let named = named.or_else(|| Some(path.canonicalize().ok()?.file_name()?.to_os_string()));
        let name = named.map_or_else(
            || "conformance-cases".to_owned(),
            |name| name.to_string_lossy().into_owned(),
        );
        Root {
            path: path.to_owned(),
            name,
        }
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Returns a path below the root as reports show it.
    pub(crate) fn shown(&self, below_root: &str) -> String {
        format!("{}/{below_root}", self.name)
    }

    /// Reads a file of the suite's own by `read`, which returns what it holds and its mistakes; a suite without the file has nothing of it.
    pub(crate) fn read_own<T: Default>(
        &self,
        below_root: &str,
        read: impl FnOnce(&str) -> (T, Vec<Mistake>),
    ) -> (T, Vec<CaseFileError>) {
        let path = self.path.join(below_root);
        if !path.exists() {
            return (T::default(), Vec::new());
        }
        let (held, mistakes) = match self::read(&path) {
            Ok(text) => read(&text),
            Err(mistake) => (T::default(), vec![mistake]),
        };
        (held, in_file(mistakes, &self.shown(below_root)))
    }

    /// Reads a file of the suite's own in TOML, whose content `check` turns into what the suite holds, and what is wrong with it.
    pub(crate) fn read_toml<F: DeserializeOwned, T: Default>(
        &self,
        below_root: &str,
        check: impl FnOnce(F, &Lines) -> (T, Vec<Mistake>),
    ) -> (T, Vec<CaseFileError>) {
        self.read_own(below_root, |text| {
            let lines = Lines::new(text);
            match toml_text::read(text, 0, &lines) {
                Ok(content) => check(content, &lines),
                Err(mistake) => (T::default(), vec![mistake]),
            }
        })
    }

    /// Returns the case file at `path`.
    pub(crate) fn case_file(&self, path: &Path) -> Result<CaseFile, CaseFileError> {
        let below = path
            .strip_prefix(&self.path)
            .map(Path::to_owned)
            .or_else(|_| self.below_by_real_path(path));
        let Ok(below) = below else {
            let message = format!("the file is not below {}", self.path.display());
            return Err(Mistake::new(1, message).in_file(&path.to_string_lossy()));
        };
        self.case_file_below(path, slashes(&below))
            .map_err(|below_root| Mistake::new(1, NO_CASE_FILE).in_file(&self.shown(&below_root)))
    }

    /// Returns the case file at `path`, whose path below the root is `below_root`; the latter if it is none.
    fn case_file_below(&self, path: &Path, below_root: String) -> Result<CaseFile, String> {
        match kind(&below_root) {
            Some(kind) => Ok(CaseFile {
                path: path.to_owned(),
                shown: self.shown(&below_root),
                below_root,
                kind,
            }),
            None => Err(below_root),
        }
    }

    /// Returns `path` relative to the root after resolving both, because one of them may be relative or go through a link.
    fn below_by_real_path(&self, path: &Path) -> Result<PathBuf, ()> {
        let root = self.path.canonicalize().map_err(drop)?;
        let path = path.canonicalize().map_err(drop)?;
        path.strip_prefix(root).map(Path::to_owned).map_err(drop)
    }
}

fn slashes(path: &Path) -> String {
    let parts = path.components().map(|part| part.as_os_str().to_string_lossy());
    join(parts, "/")
}

/// Returns the names of the files in a folder with this extension, without it and in their order; none where there is no such
/// folder.
pub(crate) fn names(folder: &Path, extension: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|own| own == extension));
    let mut names: Vec<String> = paths
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    names
}

/// Returns the kind of a file by its name; `None` for the suite's own files, for recordings and for all others.
pub(crate) fn kind(below_root: &str) -> Option<FileKind> {
    match below_root {
        _ if is_own(below_root) => None,
        _ if below_root.ends_with(".st") => Some(FileKind::Program),
        _ if below_root.ends_with(".toml") => Some(FileKind::Table),
        _ => None,
    }
}

/// Returns whether a file is one of the suite's own, a recording or the description of a dialect.
fn is_own(below_root: &str) -> bool {
    const OWN: [&str; 7] = [
        "suite.toml",
        "dialects.toml",
        "features.toml",
        "sources.toml",
        "places.toml",
        "statements.toml",
        "withdrawn.toml",
    ];
    let folder = below_root.split_once('/').map(|(folder, _)| folder);
    let is_listed = folder.is_some_and(|folder| [RECORDINGS, "dialects"].contains(&folder));
    OWN.contains(&below_root) || (is_listed && below_root.ends_with(".toml"))
}

/// Lists all case files below the root, ordered by path. Skips hidden files and folders.
pub(crate) fn list(root: &Root) -> Listing {
    let mut listing = Listing::default();
    let is_hidden = |name: &std::ffi::OsStr| name.as_encoded_bytes().starts_with(b".");
    let walk = WalkDir::new(root.path()).into_iter();
    for entry in walk.filter_entry(|entry| entry.depth() == 0 || !is_hidden(entry.file_name())) {
        match entry {
            Ok(entry) if entry.file_type().is_dir() => note_folder_without_readme(root, &entry, &mut listing),
            Ok(entry) => add(root, entry.path(), &mut listing),
            Err(error) => {
                let path = error.path().unwrap_or(root.path());
                let shown = path
                    .strip_prefix(root.path())
                    .map_or_else(|_| slashes(path), slashes);
                let message = match error.io_error() {
                    Some(error) => format!("cannot be read: {error}"),
                    None => error.to_string(),
                };
                let shown = root.shown(&shown);
                listing
                    .errors
                    .push(Mistake::new(1, message).in_file(shown.trim_end_matches('/')));
            }
        }
    }
    let by_path = |a: &CaseFile, b: &CaseFile| a.below_root.split('/').cmp(b.below_root.split('/'));
    listing.files.sort_unstable_by(by_path);
    listing
}

fn add(root: &Root, path: &Path, listing: &mut Listing) {
    let below_root = path.strip_prefix(&root.path).map(slashes).unwrap_or_default();
    match root.case_file_below(path, below_root) {
        Ok(file) => listing.files.push(file),
        Err(below_root) if is_own(&below_root) || below_root.ends_with(".md") => {}
        Err(below_root) => {
            let message = "the file is neither a case file (.st, .toml) nor a README.md";
            let remark = Mistake::new(1, message).in_file(&root.shown(&below_root));
            listing.remarks.push(remark);
        }
    }
}

fn note_folder_without_readme(root: &Root, folder: &walkdir::DirEntry, listing: &mut Listing) {
    // Folders below the areas belong to their area.
    if folder.depth() <= 1 && !folder.path().join("README.md").is_file() {
        let below = folder
            .path()
            .strip_prefix(root.path())
            .map(slashes)
            .unwrap_or_default();
        let shown = root.shown(&below);
        let message = "the folder has no README.md that says what is claimed there";
        listing
            .remarks
            .push(Mistake::new(1, message).in_file(shown.trim_end_matches('/')));
    }
}

/// Reads the text of a file.
///
/// # Errors
/// If the file cannot be read, is too long, or is not UTF-8.
pub(crate) fn read(path: &Path) -> Result<String, Mistake> {
    let unreadable = |error: std::io::Error| Mistake::new(1, format!("cannot be read: {error}"));
    let file = std::fs::File::open(path).map_err(unreadable)?;
    // With room for the whole file, and one byte more for its end, it is read at once.
    let len = file.metadata().map_or(0, |metadata| metadata.len());
    let mut bytes = Vec::with_capacity(len.min(MAX_FILE_LEN) as usize + 1);
    file.take(MAX_FILE_LEN + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    if bytes.len() as u64 > MAX_FILE_LEN {
        return Err(Mistake::new(
            1,
            format!("the file is longer than {} MiB", MAX_FILE_LEN >> 20),
        ));
    }
    String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes()[..valid]
            .iter()
            .filter(|&&byte| byte == b'\n')
            .count();
        let message = format!("the text is not UTF-8: byte {valid} begins no character");
        Mistake::new(u32::try_from(line).unwrap_or(u32::MAX), message)
    })
}
