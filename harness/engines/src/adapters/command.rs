//! Command lines with placeholders for what differs from program to program or from machine to machine, such as
//! `{IEC2C} -I {MATIEC_LIB} program.st`.
//!
//! An adapter executes a command, and a reproduction prints it as a person types it into a shell.

use crate::shell_quote;
use std::borrow::Cow;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use stickler_types::join;

/// A piece of a word.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Piece {
    Text(String),
    /// The name of a placeholder.
    Placeholder(String),
}

/// A command: words, each made of pieces. The first word is the program.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct CommandTemplate {
    words: Vec<Vec<Piece>>,
}

/// The value of a placeholder in one call.
pub(super) enum Filling<'f> {
    /// A value that a shell gets as it is.
    Text(Cow<'f, OsStr>),
    /// A path of this machine, for which a shell has a variable of this name.
    Variable(&'f str, &'f Path),
}

impl<'f> Filling<'f> {
    /// Returns a text as a value.
    pub(super) fn text(text: impl Into<Cow<'f, str>>) -> Filling<'f> {
        Filling::Text(match text.into() {
            Cow::Borrowed(text) => Cow::Borrowed(OsStr::new(text)),
            Cow::Owned(text) => Cow::Owned(text.into()),
        })
    }
}

/// Gives placeholders their values, by their names.
pub(super) type Fill<'f> = dyn Fn(&str) -> Filling<'f> + 'f;

impl CommandTemplate {
    /// Splits a line into words as a POSIX shell does; no shell takes part, and nothing is expanded but the `known` placeholders,
    /// such as `{file}`. `{{` and `}}` stand for braces.
    ///
    /// # Errors
    /// A fragment that says what is wrong with the line.
    pub(super) fn parse(line: &str, known: &[&str]) -> Result<CommandTemplate, String> {
        let words = shlex::split(line).ok_or("a quote or a backslash has no end")?;
        if words.first().is_none_or(String::is_empty) {
            return Err("the command is empty".to_owned());
        }
        let words = words.iter().map(|word| pieces(word, known));
        Ok(CommandTemplate {
            words: words.collect::<Result<_, _>>()?,
        })
    }

    /// Tells whether the command has this placeholder.
    pub(super) fn has(&self, name: &str) -> bool {
        self.placeholders().any(|placeholder| placeholder == name)
    }

    /// Returns the names of the placeholders, as often as they stand in the command.
    pub(super) fn placeholders(&self) -> impl Iterator<Item = &str> {
        placeholders(&self.words)
    }

    /// Returns the names of the placeholders in the program.
    pub(super) fn placeholders_of_program(&self) -> impl Iterator<Item = &str> {
        placeholders(self.words.get(..1).unwrap_or_default())
    }

    /// Returns the names of the placeholders in the arguments.
    pub(super) fn placeholders_of_arguments(&self) -> impl Iterator<Item = &str> {
        placeholders(self.words.get(1..).unwrap_or_default())
    }

    /// Returns the program and its arguments.
    pub(super) fn filled(&self, fill: &Fill<'_>) -> (PathBuf, Vec<OsString>) {
        let mut words = self.words.iter().map(|pieces| filled(pieces, fill));
        (words.next().unwrap_or_default().into(), words.collect())
    }

    /// Returns the program as a shell types it, and the arguments. No path of this machine is in them, unless the line itself
    /// has one.
    pub(super) fn for_shell(&self, fill: &Fill<'_>) -> (String, String) {
        let mut words = self.words.iter().map(|pieces| shell_word(pieces, fill));
        let program = words.next().unwrap_or_default();
        (program, join(words, " "))
    }
}

fn placeholders(words: &[Vec<Piece>]) -> impl Iterator<Item = &str> {
    words.iter().flatten().filter_map(|piece| match piece {
        Piece::Text(_) => None,
        Piece::Placeholder(name) => Some(name.as_str()),
    })
}

/// Splits one word into its pieces.
fn pieces(word: &str, known: &[&str]) -> Result<Vec<Piece>, String> {
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
        if !known.contains(&name) {
            let known = join(known.iter().map(|name| format!("`{{{name}}}`")), ", ");
            return Err(format!("`{{{name}}}` stands for nothing; there are {known}"));
        }
        pieces.push(Piece::Text(std::mem::take(&mut text)));
        pieces.push(Piece::Placeholder(name.to_owned()));
        rest = behind;
    }
    text.push_str(rest);
    pieces.push(Piece::Text(text));
    Ok(pieces)
}

fn filled(pieces: &[Piece], fill: &Fill<'_>) -> OsString {
    let mut word = OsString::new();
    for piece in pieces {
        match piece {
            Piece::Text(text) => word.push(text),
            Piece::Placeholder(name) => match fill(name) {
                Filling::Text(text) => word.push(text),
                Filling::Variable(_, path) => word.push(path),
            },
        }
    }
    word
}

/// Returns a word for a shell: quoted where it must be, and between double quotes where it has variables.
fn shell_word(pieces: &[Piece], fill: &Fill<'_>) -> String {
    let (mut plain, mut expanded) = (String::new(), String::new());
    let mut has_variables = false;
    for (at, piece) in pieces.iter().enumerate() {
        let text = match piece {
            Piece::Text(text) => Cow::Borrowed(text.as_str()),
            Piece::Placeholder(name) => match fill(name) {
                Filling::Text(text) => text.to_string_lossy().into_owned().into(),
                Filling::Variable(name, _) => {
                    has_variables = true;
                    let goes_on =
                        |text: &str| text.starts_with(|next: char| next.is_alphanumeric() || next == '_');
                    match pieces.get(at + 1) {
                        Some(Piece::Text(text)) if goes_on(text) => {
                            expanded.push_str(&format!("${{{name}}}"))
                        }
                        _ => expanded.push_str(&format!("${name}")),
                    }
                    continue;
                }
            },
        };
        for character in text.chars() {
            if matches!(character, '"' | '\\' | '$' | '`') {
                expanded.push('\\');
            }
            expanded.push(character);
        }
        plain.push_str(&text);
    }
    match has_variables {
        true => format!("\"{expanded}\""),
        false => shell_quote(&plain).into_owned(),
    }
}
