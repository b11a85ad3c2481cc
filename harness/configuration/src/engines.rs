//! Reads the tables `[engines.NAME]`.

use serde::Deserialize;
use std::ops::Range;
use std::path::Path;
use stickler_engines::{Compiler, DependencyPaths, Description};
use stickler_suite::Features;
use stickler_types::dialect_file::{ConfigurationMistake, read, table, text};
use stickler_types::dialect_file::{list, nearest};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// An engine that `stickler.toml` names.
#[derive(Clone, Debug)]
pub struct EngineEntry {
    /// The file and line of its table, such as `stickler.toml:4`.
    pub written: String,
    /// The kind of the engine, with its settings.
    pub kind: EngineKind,
    /// The features of the language that it is declared to lack, by their keys.
    pub lacks: Vec<String>,
}

/// The kind of an engine of `stickler.toml`.
#[derive(Clone, Debug)]
pub enum EngineKind {
    /// A compiler with a built-in adapter.
    Compiler {
        /// The compiler.
        compiler: Compiler,
        /// The paths of the compiler's programs that the file states.
        places: DependencyPaths,
    },
    /// A program that speaks the wire protocol.
    Command {
        /// The command line, unchanged.
        line: String,
        /// The command by which a person gives a program to the compiler without the adapter.
        reproduce: Option<String>,
    },
    /// A compiler whose adapter is described by data.
    Described(Box<Description>),
}

/// The key of the features that an engine is declared to lack.
const LACKS: &str = "lacks";

/// The name of the built-in engine.
const REFERENCE: &str = "reference";

/// The position of the file's tables, for paths and messages.
#[derive(Clone, Copy)]
pub(crate) struct TableContext<'p> {
    /// The folder of the file, to which relative paths are relative.
    pub(crate) folder: &'p Path,
    /// Formats a position in the file for messages.
    pub(crate) written: &'p dyn Fn(&Range<usize>) -> String,
}

/// Reads the entry of one engine.
///
/// # Errors
/// A mistake in its name or its table.
pub(crate) fn entry(
    name: &Spanned<impl AsRef<str>>,
    value: &Spanned<DeValue<'_>>,
    place: TableContext<'_>,
) -> Result<(String, EngineEntry), ConfigurationMistake> {
    let span = name.span();
    let name = name.get_ref().as_ref();
    check_name(name, &span)?;
    let mut keys = table(&format!("engines.{name}"), value)?.clone();
    let lacks = keys
        .remove(LACKS)
        .map_or(Ok(Vec::new()), |value| features(&value))?;
    let keys = &keys;
    let kind = match (compiler(name, keys)?, keys.get("command")) {
        (Some(compiler), _) => EngineKind::Compiler {
            compiler,
            places: places(name, compiler, keys, place)?,
        },
        (None, Some(_)) => {
            let keys: CommandKeys = read(keys, value.span(), &format!("of `[engines.{name}]`"), &[LACKS])?;
            EngineKind::Command {
                line: keys.command,
                reproduce: keys.reproduce,
            }
        }
        (None, None) if keys.is_empty() => return Err(says_nothing(name, span)),
        (None, None) => EngineKind::Described(Box::new(description(name, keys, value.span())?)),
    };
    let written = (place.written)(&span);
    Ok((name.to_owned(), EngineEntry { written, kind, lacks }))
}

/// Reads the features that an engine is declared to lack.
fn features(value: &Spanned<DeValue<'_>>) -> Result<Vec<String>, ConfigurationMistake> {
    let Some(words) = value.get_ref().as_array() else {
        let message = format!("`{LACKS}` must be a list of features, such as [\"array\", \"lreal\"]");
        return Err(ConfigurationMistake::at(value.span(), message));
    };
    let known: Vec<&str> = Features::built_in().iter().map(|feature| &*feature.key).collect();
    let feature = |word: &Spanned<DeValue<'_>>| {
        let key = text(LACKS, word)?;
        if known.contains(&key) {
            return Ok(key.to_owned());
        }
        let meant = nearest(key, known.iter().copied());
        let meant = meant.map_or(String::new(), |meant| format!("; did you mean `{meant}`?"));
        let message = format!("there is no feature `{key}` (`stickler list --features` shows all){meant}");
        Err(ConfigurationMistake::at(word.span(), message))
    };
    words.iter().map(feature).collect()
}

/// Checks that a name means nothing else on the command line, and that it can be the name of a file.
fn check_name(name: &str, span: &Range<usize>) -> Result<(), ConfigurationMistake> {
    let wrong = |message: String| Err(ConfigurationMistake::at(span.clone(), message));
    if name == REFERENCE {
        return wrong(format!(
            "`{REFERENCE}` is the engine that is always there; give this one another name"
        ));
    }
    let plain = |character: char| character.is_ascii_alphanumeric() || "-_.".contains(character);
    if name.is_empty() || name.starts_with('.') || !name.chars().all(plain) {
        return wrong(format!(
            "`{name}` cannot be the name of an engine; it has letters, digits, `-`, `_` and `.`, and no `.` at its start"
        ));
    }
    Ok(())
}

/// Returns the compiler whose adapter the engine uses: the one that its key `adapter` or else its own name states.
fn compiler(name: &str, keys: &DeTable<'_>) -> Result<Option<Compiler>, ConfigurationMistake> {
    let Some(value) = keys.get("adapter") else {
        return Ok(Compiler::from_word(name));
    };
    let adapter = text("adapter", value)?;
    let unknown = || {
        let all = list(Compiler::ALL.map(Compiler::as_str));
        ConfigurationMistake::at(
            value.span(),
            format!("there is no adapter `{adapter}`; there are {all}"),
        )
    };
    Compiler::from_word(adapter).map(Some).ok_or_else(unknown)
}

/// Reads the paths of a compiler's programs from its table.
fn places(
    name: &str,
    compiler: Compiler,
    keys: &DeTable<'_>,
    place: TableContext<'_>,
) -> Result<DependencyPaths, ConfigurationMistake> {
    let mut places = DependencyPaths::default();
    if name != compiler.as_str() {
        places = places.without_variables();
    }
    let known: Vec<&str> = compiler
        .dependencies()
        .map(|dependency| dependency.key.as_str())
        .collect();
    for (key, value) in keys.iter() {
        match key.get_ref().as_ref() {
            "adapter" => {}
            word if known.contains(&word) => {
                let path = place.folder.join(text(word, value)?);
                places = places.named(word, path, (place.written)(&value.span()));
            }
            word => {
                let whose = format!(
                    "of `[engines.{name}]`, which has the adapter `{}`",
                    compiler.as_str()
                );
                return Err(ConfigurationMistake::unknown_key(
                    key.span(),
                    word,
                    &whose,
                    &known,
                ));
            }
        }
    }
    Ok(places)
}

/// The keys of an engine that speaks the wire protocol.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CommandKeys {
    command: String,
    reproduce: Option<String>,
}

/// Reads the description of a compiler.
fn description(
    name: &str,
    keys: &DeTable<'_>,
    span: Range<usize>,
) -> Result<Description, ConfigurationMistake> {
    let whose = format!("of `[engines.{name}]`");
    // These two would have made it another kind of engine.
    let description: Description = read(keys, span.clone(), &whose, &["command", "adapter", LACKS])?;
    description.check().map_err(|(key, message)| {
        let at = keys.iter().find(|(other, _)| other.get_ref() == key);
        ConfigurationMistake::at(
            at.map_or(span, |(key, _)| key.span()),
            format!("{message} ({whose})"),
        )
    })?;
    Ok(description)
}

fn says_nothing(name: &str, span: Range<usize>) -> ConfigurationMistake {
    let message = format!(
        "`[engines.{name}]` does not say what the engine is: by `command = \"…\"` a program that speaks the wire protocol, \
         by `adapter = \"…\"` one of {}, or by `check = \"…\"` and further keys a compiler that is described here",
        list(Compiler::ALL.map(Compiler::as_str))
    );
    ConfigurationMistake::at(span, message)
}
