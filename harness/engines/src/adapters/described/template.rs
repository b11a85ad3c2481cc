//! The commands of a table: their placeholders, and the values that these have in a call.

use crate::adapters::command::{CommandTemplate, Filling};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// The placeholder for the number of scans.
pub(super) const SCANS: &str = "scans";

pub(super) use crate::reproduction::HERE;

impl FromStr for CommandTemplate {
    type Err = String;

    /// Parses a command in which `{file}`, the compiler's own word for the `{dialect}`, the private `{folder}` of the call, the
    /// number of `{scans}` and the folder of `stickler.toml`, `{here}`, are placeholders.
    fn from_str(line: &str) -> Result<CommandTemplate, String> {
        CommandTemplate::parse(line, &["file", "dialect", "folder", SCANS, "here"])
    }
}

/// The values of the placeholders in one call.
#[derive(Clone, Copy, Debug)]
pub(super) struct CallValues<'c> {
    pub(super) file: &'c str,
    pub(super) dialect: &'c str,
    pub(super) folder: &'c Path,
    pub(super) scans: u32,
    pub(super) here: &'c Path,
}

impl<'c> CallValues<'c> {
    /// Returns the value of a placeholder.
    pub(super) fn of(&self, name: &str) -> Filling<'c> {
        match name {
            "file" => Filling::text(self.file),
            "dialect" => Filling::text(self.dialect),
            "folder" => Filling::text(self.folder.to_string_lossy()),
            SCANS => Filling::text(self.scans.to_string()),
            _ => Filling::Variable(HERE, self.here),
        }
    }

    /// Returns the program and the arguments of a command. A program with a path is looked up from the folder of `stickler.toml`.
    pub(super) fn filled(&self, command: &CommandTemplate) -> (PathBuf, Vec<OsString>) {
        let (program, arguments) = command.filled(&|name| self.of(name));
        match program.components().count() {
            1 if !program.has_root() => (program, arguments),
            _ => (self.here.join(program), arguments),
        }
    }
}

/// Returns the program of a command, where it is the same in every call, and the files that the arguments name in every call.
pub(super) fn fixed(command: &CommandTemplate, here: &Path) -> (Option<PathBuf>, Vec<PathBuf>) {
    let values = CallValues {
        file: "",
        dialect: "",
        folder: Path::new(""),
        scans: 0,
        here,
    };
    let (program, arguments) = values.filled(command);
    let is_fixed = command.placeholders_of_program().all(|name| name == "here");
    // A file without a path would be looked up in the folder of a call.
    let paths = arguments.into_iter().map(PathBuf::from);
    let files = paths.filter(|path| path.is_absolute() && path.is_file());
    (is_fixed.then_some(program), files.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_with_a_path_is_sought_from_the_folder_of_the_file() {
        let values = CallValues {
            file: "program.st",
            dialect: "",
            folder: Path::new("/private"),
            scans: 3,
            here: Path::new("/ours"),
        };
        let program = |line: &str| values.filled(&line.parse().unwrap()).0;
        assert_eq!(program("bin/st -n{scans}"), Path::new("/ours/bin/st"));
        assert_eq!(program("st"), Path::new("st"));
        assert_eq!(program("/opt/st"), Path::new("/opt/st"));
        assert_eq!(program("{folder}/program"), Path::new("/private/program"));
        let fixed = |line: &str| fixed(&line.parse().unwrap(), Path::new("/ours")).0;
        assert_eq!(fixed("bin/st {file}"), Some("/ours/bin/st".into()));
        assert_eq!(fixed("{here}/st"), Some("/ours/st".into()));
        assert_eq!(fixed("{folder}/program"), None);
    }
}
