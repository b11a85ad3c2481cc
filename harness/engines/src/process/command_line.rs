//! The command line that starts an engine.

use crate::EngineError;

/// A program and its arguments, and how they were written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct CommandLine {
    /// As a person wrote it, for messages.
    pub(super) written: String,
    /// The program to start: a path, or a name that is looked up in PATH.
    pub(super) program: String,
    /// Its arguments.
    pub(super) arguments: Vec<String>,
}

impl CommandLine {
    /// Splits a line into words as a POSIX shell does; quotes and backslashes keep blanks inside a word, and nothing is
    /// expanded.
    ///
    /// # Errors
    /// Where a quote stays open, or there is no word.
    pub(super) fn split(line: &str) -> Result<CommandLine, EngineError> {
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
        })
    }

    /// A program and its arguments that nobody wrote in a line.
    pub(crate) fn of(program: String, arguments: Vec<String>) -> CommandLine {
        CommandLine {
            written: program.clone(),
            program,
            arguments,
        }
    }

    /// The error that this command could not be started.
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
    fn a_line_without_a_command_or_without_its_closing_quote_is_an_error() {
        for line in ["", "  ", "''", "adapter 'open", "adapter \\"] {
            let error = CommandLine::split(line).unwrap_err().to_string();
            assert!(error.contains(&format!("`cmd:{line}`")), "{error}");
        }
    }
}
