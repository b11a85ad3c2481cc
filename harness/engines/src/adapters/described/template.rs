//! Command lines with placeholders for what differs from program to program, such as `st --check {file}`.

use crate::shell_quote;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A placeholder in a command, such as `{file}`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Placeholder {
    /// The file of the program.
    File,
    /// The compiler's own word for the dialect.
    Dialect,
    /// The private folder in which the command works.
    Folder,
    /// The number of scans.
    Scans,
    /// The folder of `stickler.toml`.
    Here,
}

impl Placeholder {
    const ALL: [(&'static str, Placeholder); 5] = [
        ("file", Placeholder::File),
        ("dialect", Placeholder::Dialect),
        ("folder", Placeholder::Folder),
        ("scans", Placeholder::Scans),
        ("here", Placeholder::Here),
    ];

    fn named(word: &str) -> Option<Placeholder> {
        let found = Placeholder::ALL.iter().find(|(name, _)| *name == word);
        found.map(|(_, placeholder)| *placeholder)
    }
}

/// A piece of a word.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Piece {
    Text(String),
    Placeholder(Placeholder),
}

/// A command: words, each made of pieces. The first word is the program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CommandTemplate {
    words: Vec<Vec<Piece>>,
}

/// The values of the placeholders in one call.
#[derive(Clone, Copy, Debug)]
pub(super) struct Filling<'f> {
    pub(super) file: &'f str,
    pub(super) dialect: &'f str,
    pub(super) folder: &'f Path,
    pub(super) scans: u32,
    pub(super) here: &'f Path,
}

impl<'f> Filling<'f> {
    /// Returns the values for what is the same in every call.
    fn of_no_call(here: &'f Path) -> Filling<'f> {
        Filling {
            file: "",
            dialect: "",
            folder: Path::new(""),
            scans: 0,
            here,
        }
    }
}

impl FromStr for CommandTemplate {
    type Err = String;

    /// Splits a line into words as a POSIX shell does; no shell takes part, and nothing is expanded but placeholders such as
    /// `{file}`. `{{` and `}}` stand for braces.
    fn from_str(line: &str) -> Result<CommandTemplate, String> {
        let words = shlex::split(line).ok_or("a quote or a backslash has no end")?;
        if words.first().is_none_or(String::is_empty) {
            return Err("the command is empty".to_owned());
        }
        let words = words.iter().map(|word| pieces(word)).collect::<Result<_, _>>()?;
        Ok(CommandTemplate { words })
    }
}

/// Splits one word into its pieces.
fn pieces(word: &str) -> Result<Vec<Piece>, String> {
    let mut pieces = Vec::new();
    let mut text = String::new();
    let mut rest = word;
    while let Some(at) = rest.find(['{', '}']) {
        text.push_str(&rest[..at]);
        let brace = &rest[at..=at];
        rest = &rest[at + 1..];
        if let Some(behind) = rest.strip_prefix(brace) {
            text.push_str(brace);
            rest = behind;
            continue;
        }
        let (name, behind) = rest
            .split_once('}')
            .filter(|_| brace == "{")
            .ok_or_else(|| format!("a `{brace}` in `{word}` stands alone; write it twice for itself"))?;
        let placeholder = Placeholder::named(name).ok_or_else(|| {
            let known = Placeholder::ALL.map(|(name, _)| format!("`{{{name}}}`"));
            format!("`{{{name}}}` stands for nothing; there are {}", known.join(", "))
        })?;
        pieces.push(Piece::Text(std::mem::take(&mut text)));
        pieces.push(Piece::Placeholder(placeholder));
        rest = behind;
    }
    text.push_str(rest);
    pieces.push(Piece::Text(text));
    Ok(pieces)
}

impl CommandTemplate {
    /// Tells whether the template contains this placeholder.
    pub(super) fn has(&self, placeholder: Placeholder) -> bool {
        let place = Piece::Placeholder(placeholder);
        self.words.iter().any(|pieces| pieces.contains(&place))
    }

    /// Returns the program and its arguments. A program with a path is looked up from the folder of `stickler.toml`.
    pub(super) fn filled(&self, filling: &Filling<'_>) -> (PathBuf, Vec<String>) {
        let mut words = self.words.iter().map(|pieces| word(pieces, filling));
        let program = words.next().unwrap_or_default();
        let program = match program.contains(std::path::is_separator) {
            true => filling.here.join(program),
            false => PathBuf::from(program),
        };
        (program, words.collect())
    }

    /// Returns the program, where it has no placeholder that differs from call to call.
    pub(super) fn program(&self, here: &Path) -> Option<PathBuf> {
        let fixed = |piece: &Piece| matches!(piece, Piece::Text(_) | Piece::Placeholder(Placeholder::Here));
        if !self.words.first()?.iter().all(fixed) {
            return None;
        }
        Some(self.filled(&Filling::of_no_call(here)).0)
    }

    /// Returns the files that the arguments name in every call.
    pub(super) fn files(&self, here: &Path) -> Vec<PathBuf> {
        let arguments = self.filled(&Filling::of_no_call(here)).1.into_iter();
        // A file without a path would be looked up in the folder of a call.
        let paths = arguments.map(PathBuf::from).filter(|path| path.is_absolute());
        paths.filter(|path| path.is_file()).collect()
    }
}

/// The variable of a shell script for the folder of `stickler.toml`.
pub(super) const HERE: &str = "HERE";

/// A command as a person types it into a shell.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct ShellCommand {
    /// The name of the program; one without a folder is a program of the compiler, any other is made by an earlier command.
    pub(super) program: String,
    /// The arguments, quoted for the shell; the folder of `stickler.toml` is [`HERE`].
    pub(super) arguments: String,
}

impl CommandTemplate {
    /// Returns the command for a shell in the folder of a reproduction. No path of this machine is in it, unless an argument of
    /// the template itself is one.
    pub(super) fn for_shell(&self, filling: &Filling<'_>) -> ShellCommand {
        let program = self.words.first().map_or(&[][..], Vec::as_slice);
        let made = program.contains(&Piece::Placeholder(Placeholder::Folder));
        let filled = PathBuf::from(word(program, filling));
        let name = filled.file_name().unwrap_or_default().to_string_lossy();
        let arguments = self.words.iter().skip(1);
        let arguments: Vec<String> = arguments.map(|pieces| shell_word(pieces, filling)).collect();
        ShellCommand {
            program: if made {
                format!("./{name}")
            } else {
                name.into_owned()
            },
            arguments: arguments.join(" "),
        }
    }
}

/// Returns a word for a shell.
fn shell_word(pieces: &[Piece], filling: &Filling<'_>) -> String {
    let mut shell = String::new();
    for piece in pieces {
        match piece {
            Piece::Placeholder(Placeholder::Here) => {
                // Writing into a String does not fail.
                let _ = write!(shell, "\"${HERE}\"");
            }
            Piece::Text(text) if text.is_empty() => {}
            piece => shell.push_str(&shell_quote(&word(std::slice::from_ref(piece), filling))),
        }
    }
    if shell.is_empty() { "''".to_owned() } else { shell }
}

fn word(pieces: &[Piece], filling: &Filling<'_>) -> String {
    let mut word = String::new();
    for piece in pieces {
        match piece {
            Piece::Text(text) => word.push_str(text),
            Piece::Placeholder(Placeholder::File) => word.push_str(filling.file),
            Piece::Placeholder(Placeholder::Dialect) => word.push_str(filling.dialect),
            Piece::Placeholder(Placeholder::Folder) => word.push_str(&filling.folder.to_string_lossy()),
            Piece::Placeholder(Placeholder::Scans) => word.push_str(&filling.scans.to_string()),
            Piece::Placeholder(Placeholder::Here) => word.push_str(&filling.here.to_string_lossy()),
        }
    }
    word
}

#[cfg(test)]
mod tests {
    use super::*;

    fn template(line: &str) -> Result<CommandTemplate, String> {
        line.parse()
    }

    fn filled(line: &str) -> (PathBuf, Vec<String>) {
        template(line).unwrap().filled(&Filling {
            file: "program.st",
            dialect: "ed 2",
            folder: Path::new("/private"),
            scans: 3,
            here: Path::new("/ours"),
        })
    }

    #[test]
    fn placeholders_are_filled_inside_words_and_never_split_them() {
        let (program, arguments) =
            filled("st '--dialect={dialect}' {file} -o {folder}/out -n{scans} {{{here}}} ''");
        assert_eq!(program, Path::new("st"));
        let expected = [
            "--dialect=ed 2",
            "program.st",
            "-o",
            "/private/out",
            "-n3",
            "{/ours}",
            "",
        ];
        assert_eq!(arguments, expected);
    }

    #[test]
    fn a_program_with_a_path_is_sought_from_the_folder_of_the_file() {
        assert_eq!(filled("bin/st").0, Path::new("/ours/bin/st"));
        assert_eq!(filled("/opt/st").0, Path::new("/opt/st"));
        assert_eq!(filled("{folder}/program").0, Path::new("/private/program"));
        let here = Path::new("/ours");
        assert_eq!(
            template("bin/st {file}").unwrap().program(here),
            Some("/ours/bin/st".into())
        );
        assert_eq!(template("{folder}/program").unwrap().program(here), None);
    }

    #[test]
    fn what_stands_for_nothing_is_told() {
        for (line, part) in [
            (
                "st {fiel}",
                "`{fiel}` stands for nothing; there are `{file}`, `{dialect}`",
            ),
            ("st {file", "stands alone"),
            ("st file}", "stands alone"),
            ("st 'file", "no end"),
            ("", "empty"),
            ("'' x", "empty"),
        ] {
            let error = template(line).unwrap_err();
            assert!(error.contains(part), "{error}");
        }
        assert!(template("st -n{scans}").unwrap().has(Placeholder::Scans));
        assert!(!template("st scans").unwrap().has(Placeholder::Scans));
    }
}
