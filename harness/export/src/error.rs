//! The errors of writing an export, and of reading its results.

use std::io;
use std::path::PathBuf;
use stickler_run::DefinedHeader;

/// The errors of writing an export, and of reading its results.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The folder holds files, and what it was to hold before is not among them; holds a fragment that says so, which may be empty.
    #[error("{} is not empty{}; name an empty folder, or one that is not there yet", .0.display(), .1)]
    Occupied(PathBuf, String),
    /// The folder holds no export.
    #[error(
        "{} holds no export (there is no {} in it); name the folder that `stickler export` wrote with --export DIR",
        .0.display(), crate::MANIFEST
    )]
    NoExport(PathBuf),
    /// A file cannot be read.
    #[error("cannot read {}", .0.display())]
    Read(PathBuf, #[source] io::Error),
    /// A file or folder cannot be written.
    #[error("cannot write {}", .0.display())]
    Write(PathBuf, #[source] io::Error),
    /// A page has a character that XML cannot hold; holds its place.
    #[error(
        "{}: the character U+{:04X} fits into no XML 1.0, and so into no project; leave its case out with --without CASE, or paste \
         the pages", .0, u32::from(*.1)
    )]
    Character(String, char),
    /// A page cannot be read in the dialect of the export, and so not be divided for a project; holds its place and the mistake.
    #[error("{}: {}; a project needs pages without such errors: leave the case out with --without CASE", .0, .1)]
    Syntax(String, String),
    /// The manifest cannot be understood.
    #[error("{}: {}; export again", .0.display(), .1)]
    Manifest(PathBuf, String),
    /// The dialect of the export is not defined, or has changed; holds its name and its earlier definition.
    #[error(
        "stickler.toml does not define the dialect `{}` as it did when {} was exported: {}, but for {}; export again, or name the \
         file of then with --config FILE",
        .1.name, .0.display(), .1.extends, if .1.overrides.is_empty() { "nothing".to_owned() } else { .1.overrides.join(", ") }
    )]
    Defined(PathBuf, Box<DefinedHeader>),
    /// A line of the file of answers cannot be understood; holds its place and the mistake.
    #[error("{}: {}", .0, .1)]
    Answer(String, String),
}
