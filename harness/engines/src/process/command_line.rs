//! The command line that starts an engine.

use crate::EngineError;
use std::path::{Path, PathBuf};

/// A program and its arguments, and how they were written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct CommandLine {
    /// The line as a person wrote it, for messages.
    pub(super) written: String,
    /// The program to start: a path, or a name that is looked up in PATH.
    pub(super) program: String,
    /// The arguments of the program.
    pub(super) arguments: Vec<String>,
    /// The folder in which the program is started; `None` for the current folder.
    pub(super) folder: Option<PathBuf>,
}

impl CommandLine {
    /// Splits a line into words as a POSIX shell does; quotes and backslashes keep blanks inside a word, and nothing is
    /// expanded.
    ///
    /// # Errors
    /// [`EngineError`] where a quote stays open, or there is no word.
    pub(crate) fn split(line: &str) -> Result<CommandLine, EngineError> {
        let wrong = |reason: &str| EngineError::NotStarted {
            engine: format!("`cmd:{line}`"),
            reason: reason.to_owned(),
        };
        let words = shlex::split(line).ok_or_else(|| {
            wrong("a quote or a backslash has no end; quote the command line as for a shell")
        })?;
        let mut words = words.into_iter();
        let program = words
            .next()
            .filter(|program| !program.is_empty())
            .ok_or_else(|| wrong("the command is missing; write it behind `cmd:`"))?;
        Ok(CommandLine {
            written: line.to_owned(),
            program,
            arguments: words.collect(),
            folder: None,
        })
    }

    /// Sets the folder in which the command is started. A program with a path is looked up from there, and a bare name on PATH.
    pub(crate) fn inside(mut self, folder: &Path) -> CommandLine {
        if self.program.contains(std::path::is_separator) {
            self.program = folder.join(&self.program).to_string_lossy().into_owned();
        }
        self.folder = Some(folder.to_owned());
        self
    }

    /// Returns the command of a program and its arguments that were not written as a line.
    pub(crate) fn of(program: String, arguments: Vec<String>) -> CommandLine {
        CommandLine {
            written: program.clone(),
            program,
            arguments,
            folder: None,
        }
    }

    /// Returns the error that this command could not be started.
    pub(super) fn not_started(&self, reason: String) -> EngineError {
        EngineError::NotStarted {
            engine: format!("`cmd:{}`", self.written),
            reason,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::CommandLine;
    use std::path::Path;

    #[test]
    fn quotes_and_backslashes_keep_blanks_inside_a_word() {
        let line =
            CommandLine::split(r#"'my tools/adapter' --name "two words" three\ words $HOME *"#).unwrap();
        assert_eq!(line.program, "my tools/adapter");
        assert_eq!(
            line.arguments,
            ["--name", "two words", "three words", "$HOME", "*"]
        );
    }

    #[test]
    fn a_program_with_a_path_is_sought_from_the_folder_and_one_without_is_not() {
        let inside = |line: &str| CommandLine::split(line).unwrap().inside(Path::new("/here"));
        assert_eq!(inside("bin/adapter x/y").program, "/here/bin/adapter");
        assert_eq!(inside("bin/adapter x/y").arguments, ["x/y"]);
        assert_eq!(inside("/opt/adapter").program, "/opt/adapter");
        assert_eq!(inside("python3 adapter.py").program, "python3");
    }

    #[test]
    fn a_line_without_a_command_or_without_its_closing_quote_is_an_error() {
        for line in ["", "  ", "''", "adapter 'open", "adapter \\"] {
            let error = CommandLine::split(line).unwrap_err().to_string();
            assert!(error.contains(&format!("`cmd:{line}`")), "{error}");
        }
    }
}
