//! RuSTy's standard library, linked as a shared library.
//!
//! The functions that are written in Structured Text are in the static library only, where RuSTy is built by cargo alone; the
//! package script of RuSTy makes the shared library that it distributes of the static one. The static one itself cannot be linked
//! with every program, since a program defines some functions of the standard library again.
//!
//! Basis: rusty: `libs/stdlib/build.rs` and `scripts/build.sh` of its repository.

use super::LIBRARY;
use crate::adapters::builder::Builder;
use crate::adapters::locate::{call, first_error};
use crate::process::Folder;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// The file of the static library.
pub(super) const STATIC: &str = "libiec61131std.a";

/// The file of the shared library.
pub(super) const SHARED: &str = "libiec61131std.so";

/// The libraries of the system that the standard library needs.
pub(super) const NEEDED: [&str; 3] = ["-lm", "-lpthread", "-ldl"];

/// Returns the options by which a linker takes all of an archive, before and behind it.
pub(super) const fn whole_archive() -> (&'static str, &'static str) {
    match cfg!(target_os = "macos") {
        true => ("-Wl,-all_load", ""),
        false => ("-Wl,--whole-archive", "-Wl,--no-whole-archive"),
    }
}

/// The standard library of one RuSTy.
pub(super) struct StandardLibrary {
    /// The folder in which it was found.
    folder: PathBuf,
    /// The folder of the shared library; made when first needed.
    shared: OnceLock<Result<SharedLibrary, String>>,
}

/// The folder of a shared library.
enum SharedLibrary {
    /// Made of the static library.
    Made(Folder),
    /// Distributed without the static one.
    Found(PathBuf),
}

impl StandardLibrary {
    /// Returns the library of a folder.
    pub(super) fn new(folder: PathBuf) -> StandardLibrary {
        StandardLibrary {
            folder,
            shared: OnceLock::new(),
        }
    }

    /// Returns the folder in which the library was found.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the folder of the shared library, which is made of the static one where there is one.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn shared(&self, builder: &Builder) -> Result<&Path, String> {
        let shared = self.shared.get_or_init(|| self.make(builder));
        match shared.as_ref().map_err(Clone::clone)? {
            SharedLibrary::Made(folder) => Ok(folder.path()),
            SharedLibrary::Found(folder) => Ok(folder),
        }
    }

    fn make(&self, builder: &Builder) -> Result<SharedLibrary, String> {
        let archive = self.folder.join(STATIC);
        if !archive.is_file() {
            let found = [SHARED, "libiec61131std.dylib"]
                .iter()
                .any(|name| self.folder.join(name).is_file());
            return match found {
                true => Ok(SharedLibrary::Found(self.folder.clone())),
                false => Err(format!(
                    "`{}` has neither {STATIC} nor {SHARED}; name the folder that has one by {}",
                    self.folder.display(),
                    LIBRARY.variable
                )),
            };
        }
        let folder = Folder::new()?;
        let (before, behind) = whole_archive();
        let mut arguments: Vec<OsString> = ["-shared", "-o", SHARED, before].map(OsString::from).to_vec();
        arguments.push(archive.clone().into());
        arguments.extend(
            [behind]
                .iter()
                .filter(|word| !word.is_empty())
                .map(OsString::from),
        );
        arguments.extend(NEEDED.map(OsString::from));
        let ended = call(builder.compiler(), &arguments, &folder).map_err(|outcome| outcome.to_string())?;
        match ended.status.success() {
            true => Ok(SharedLibrary::Made(folder)),
            false => Err(format!(
                "no shared library can be made of `{}`: {}",
                archive.display(),
                first_error(&ended)
            )),
        }
    }
}
