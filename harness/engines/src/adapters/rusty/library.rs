//! RuSTy's standard library, linked as a shared library.
//!
//! The functions that are written in Structured Text are in the static library only, where RuSTy is built by cargo alone; the
//! package script of RuSTy makes the shared library that it distributes of the static one. The static one itself cannot be linked
//! with every program, since a program defines some functions of the standard library again.
//!
//! Basis: rusty: `libs/stdlib/build.rs` and `scripts/build.sh` of its repository.

use crate::adapters::Compiler;
use crate::adapters::locate::first_error;
use crate::adapters::recipe::{Purpose, Recipe, Workplace};
use crate::process::Folder;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// The file of the static library.
const STATIC: &str = "libiec61131std.a";

/// The file of the shared library.
const SHARED: &str = "libiec61131std.so";

/// Returns the recipe that makes the shared library of all of the static one.
fn sharing() -> Recipe {
    let (all, no_more) = match cfg!(target_os = "macos") {
        true => ("-Wl,-all_load", ""),
        false => ("-Wl,--whole-archive", "-Wl,--no-whole-archive"),
    };
    let values = [("all", all), ("no-more", no_more)];
    Recipe::default().step(Compiler::Rusty, Purpose::Build, "share", &values)
}

/// Adds the command of a shell that puts the shared library into its folder.
pub(super) fn share(recipe: Recipe) -> Recipe {
    let (library, make) = ("$RUSTY_LIB", sharing().commands().join(""));
    let variables = ["RUSTY_LIB", "CC"].map(str::to_owned);
    recipe.shell(
        &variables,
        format!("if [ -f \"{library}/{STATIC}\" ]; then {make}; else cp \"{library}/{SHARED}\" .; fi"),
    )
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

    /// Puts the shared library, which is made of the static one where there is one, into a workplace.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn place(&self, workplace: &Workplace<'_>) -> Result<(), String> {
        let shared = self.shared.get_or_init(|| self.make(workplace));
        let folder = match shared.as_ref().map_err(Clone::clone)? {
            SharedLibrary::Made(folder) => folder.path(),
            SharedLibrary::Found(folder) => folder,
        };
        for name in [SHARED, "libiec61131std.dylib"] {
            let (from, to) = (folder.join(name), workplace.folder.path().join(name));
            if from.is_file() && !to.exists() {
                let linked = std::fs::hard_link(&from, &to).or_else(|_| std::fs::copy(&from, &to).map(drop));
                linked.map_err(|error| format!("`{}` could not be copied: {error}", from.display()))?;
            }
        }
        Ok(())
    }

    fn make(&self, workplace: &Workplace<'_>) -> Result<SharedLibrary, String> {
        let archive = self.folder.join(STATIC);
        if !archive.is_file() {
            let found = [SHARED, "libiec61131std.dylib"]
                .iter()
                .any(|name| self.folder.join(name).is_file());
            return match found {
                true => Ok(SharedLibrary::Found(self.folder.clone())),
                false => Err(format!(
                    "`{}` has neither {STATIC} nor {SHARED}; name the folder that has one by STICKLER_RUSTY_LIB",
                    self.folder.display()
                )),
            };
        }
        let made = workplace.elsewhere()?;
        let ended = made
            .step(&sharing(), Purpose::Build, &[])
            .map_err(|outcome| outcome.to_string())?;
        match ended.status.success() {
            true => Ok(SharedLibrary::Made(made.folder)),
            false => Err(format!(
                "no shared library can be made of `{}`: {}",
                archive.display(),
                first_error(&ended)
            )),
        }
    }
}
