//! Finds and starts engines by their names on the command line.

use crate::arguments::Arguments;
use crate::exit::{NoSuchEngine, SpeaksNone};
use anyhow::Context;
use clap::CommandFactory;
use std::collections::BTreeMap;
use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use stickler_configuration::{ConfigurationFile, EngineKind};
use stickler_engines::{
    Compiler, CompilerSearch, DependencyPaths, DescribedEngine, Description, Engine, EngineError, Identity,
    ProcessEngine, ProcessLimits, Reference,
};
use stickler_export::Kind;
use stickler_types::{DialectName, join};

/// The name of the reference, the engine that is always present.
pub const REFERENCE: &str = "reference";

/// The prefix before the command line of an engine that is a process.
pub const COMMAND: &str = "cmd:";

/// Changes a command line to accept any word for a dialect: the dialects of the file are not yet known, and a rejected word
/// would hide the arguments behind it.
fn with_any_dialect(command: clap::Command) -> clap::Command {
    let any = |argument: clap::Arg| match argument.get_id().as_str() {
        "dialect" => argument.value_parser(clap::value_parser!(OsString)),
        _ => argument,
    };
    command.mut_args(any).mut_subcommands(with_any_dialect)
}

/// The file that `--config` names.
static FILE: OnceLock<PathBuf> = OnceLock::new();

/// Reads `stickler.toml`, or the file that the command line names, before the command line itself is parsed, which may name
/// dialects that the file defines.
///
/// # Errors
/// A [`ConfigurationError`](stickler_configuration::ConfigurationError) where the file cannot be used.
pub fn configure() -> anyhow::Result<()> {
    if let Some(file) = named_file() {
        // The command line is read once.
        let _ = FILE.set(file);
    }
    match (FILE.get(), env::current_dir()) {
        // Without a working directory there is no file to read; a command that needs the directory reports that.
        (None, Err(_)) => Ok(()),
        _ => configuration().map(|_| ()),
    }
}

/// Returns the argument of `--cases`, if the command has that option. Other mistakes of the command line are reported later.
pub fn named_cases() -> Option<Option<PathBuf>> {
    let command = with_any_dialect(Arguments::command()).ignore_errors(true);
    let matches = command.try_get_matches().ok()?;
    match matches.subcommand() {
        // Without a command all cases are run.
        None => Some(None),
        Some((_, of_command)) => Some(of_command.try_get_one::<PathBuf>("cases").ok()?.cloned()),
    }
}

/// Returns the argument of `--config`. Other mistakes of the command line are reported later.
fn named_file() -> Option<PathBuf> {
    let mentions = |word: OsString| word.to_string_lossy().starts_with("--config");
    if !env::args_os().any(mentions) {
        return None;
    }
    let command = with_any_dialect(Arguments::command()).ignore_errors(true);
    let matches = command.try_get_matches().ok()?;
    matches.try_get_one::<PathBuf>("config").ok()?.cloned()
}

/// Returns the file that `--config` names.
pub fn config_file() -> Option<&'static Path> {
    FILE.get().map(PathBuf::as_path)
}

/// Reads `stickler.toml`, or the file that `--config` names.
///
/// # Errors
/// A [`ConfigurationError`](stickler_configuration::ConfigurationError) where the file cannot be used; no working directory.
pub fn configuration() -> anyhow::Result<ConfigurationFile> {
    Ok(match FILE.get() {
        Some(file) => ConfigurationFile::read(file)?,
        None => ConfigurationFile::find(&env::current_dir().context("there is no working directory")?)?,
    })
}

/// Returns the engine of a name: `reference`, one that `stickler.toml` names, a compiler for which there is an adapter, or
/// `cmd:COMMAND LINE` for a program that speaks the wire protocol.
///
/// # Errors
/// [`NoSuchEngine`] where no engine has the name; an [`EngineError`] where the compiler is not on this machine, or the program
/// cannot be started or does not answer `hello`; a file `stickler.toml` that cannot be used.
pub fn by_name(name: &str) -> anyhow::Result<Box<dyn Engine>> {
    distinct(name, &[], &configuration()?)
}

/// An engine, and the name by which it was asked for.
pub struct NamedEngine {
    /// The engine.
    pub engine: Box<dyn Engine>,
    /// The argument of `--engine` that names it.
    pub asked_for: String,
}

impl NamedEngine {
    /// Returns the identity of the engine.
    pub fn identity(&self) -> &Identity {
        self.engine.identity()
    }
}

/// Returns the engines of the given names, each once; the reference where none is named. No two of them have the same name in
/// reports: an engine that calls itself as another does gets a number, as in `my-compiler-2`.
///
/// # Errors
/// The error of [`by_name`] for the first name that has one.
pub fn by_names(names: &[String]) -> anyhow::Result<Vec<NamedEngine>> {
    let reference = [REFERENCE.to_owned()];
    let names = if names.is_empty() { &reference[..] } else { names };
    let configuration = configuration()?;
    let mut engines: Vec<NamedEngine> = Vec::with_capacity(names.len());
    for (index, name) in names.iter().enumerate() {
        if names[..index].contains(name) {
            continue;
        }
        // The reference never gets a number, so no engine before it may be called so.
        let taken: Vec<&str> = names
            .iter()
            .map(String::as_str)
            .filter(|name| *name == REFERENCE)
            .chain(engines.iter().map(|named| named.identity().name.as_str()))
            .collect();
        let engine = distinct(name, &taken, &configuration)?;
        engines.push(NamedEngine {
            engine,
            asked_for: name.clone(),
        });
    }
    Ok(engines)
}

/// Returns the features that stickler.toml declares engines to lack, by the name of the engine.
///
/// # Errors
/// A file `stickler.toml` that cannot be used.
pub fn declared_lacks(engines: &[NamedEngine]) -> anyhow::Result<BTreeMap<String, Vec<String>>> {
    let configuration = configuration()?;
    let declared = engines.iter().filter_map(|named| {
        let entry = configuration.engine(&named.asked_for)?;
        Some((named.identity().name.clone(), entry.lacks.clone()))
    });
    Ok(declared.collect())
}

/// Returns the kind of the answers of an engine in [support data](stickler_export::Questions): the reference is Stickler's model.
pub fn kind(identity: &Identity) -> Kind {
    match identity.name.as_str() {
        REFERENCE => Kind::Chosen,
        _ => Kind::Measured,
    }
}

/// Returns the name that support data has for an engine as a source.
pub fn source(identity: &Identity) -> String {
    format!("engine: {} {}", identity.name, identity.version)
}

/// Returns the names of dialects in a list.
pub fn listed(dialects: &[DialectName]) -> String {
    join(dialects, ", ")
}

/// Returns the requested dialects that an engine speaks.
///
/// # Errors
/// [`SpeaksNone`] where the engine speaks none of the dialects.
pub fn spoken(identity: &Identity, asked: &[DialectName]) -> anyhow::Result<Vec<DialectName>> {
    let speaks = |dialect: &DialectName| identity.speaks(*dialect);
    let spoken: Vec<DialectName> = asked.iter().copied().filter(speaks).collect();
    if spoken.is_empty() {
        return Err(SpeaksNone {
            engine: identity.name.clone(),
            asked: listed(asked),
            spoken: listed(&identity.dialects),
            hint: match identity.dialects.iter().find(|dialect| dialect.is_custom()) {
                Some(own) => format!(", a dialect of stickler.toml, which is asked for with --dialect {own}"),
                None => String::new(),
            },
        }
        .into());
    }
    Ok(spoken)
}

/// Returns the engine of a name, under an identity whose name is not taken.
fn distinct(
    name: &str,
    taken: &[&str],
    configuration: &ConfigurationFile,
) -> anyhow::Result<Box<dyn Engine>> {
    if let Some(line) = name.strip_prefix(COMMAND) {
        let engine = ProcessEngine::start(line, ProcessLimits::default())?;
        let name = free(&engine.identity().name, taken);
        return Ok(Box::new(engine.named(name)));
    }
    let sought = seek(name, &free(name, taken), configuration).ok_or_else(|| no_such(name, configuration))?;
    Ok(sought.engine?)
}

/// Searches for the engine of a name other than `cmd:…`, to be called `called`; `None` where no engine has the name.
pub fn seek(name: &str, called: &str, configuration: &ConfigurationFile) -> Option<CompilerSearch> {
    if name == REFERENCE {
        return Some(CompilerSearch {
            located: Vec::new(),
            engine: Ok(Box::new(Reference::default())),
        });
    }
    Some(match configuration.engine(name).map(|entry| &entry.kind) {
        Some(EngineKind::Compiler { compiler, places }) => compiler.seek(called, name, places),
        Some(EngineKind::Command { line, reproduce }) => CompilerSearch {
            located: Vec::new(),
            engine: start((line, reproduce.as_deref()), called, configuration),
        },
        Some(EngineKind::Described(description)) => described(called, description, configuration),
        None => Compiler::from_word(name)?.seek(called, name, &DependencyPaths::default()),
    })
}

/// Starts the program of a command line in the folder of the configuration file.
fn start(
    (line, reproduce): (&str, Option<&str>),
    called: &str,
    configuration: &ConfigurationFile,
) -> Result<Box<dyn Engine>, EngineError> {
    let folder = configuration.folder().unwrap_or(Path::new(""));
    let engine = ProcessEngine::start_in(folder, line, ProcessLimits::default())?;
    let engine = engine.named(called.to_owned());
    Ok(match reproduce {
        Some(command) => Box::new(engine.reproduced_by(command, folder)),
        None => Box::new(engine),
    })
}

/// Makes an engine from a description of stickler.toml; also returns which of its programs were found.
fn described(called: &str, description: &Description, configuration: &ConfigurationFile) -> CompilerSearch {
    let folder = configuration.folder().unwrap_or(Path::new(""));
    let engine = DescribedEngine::start(called, description.clone(), folder);
    CompilerSearch {
        located: DescribedEngine::programs(description, folder),
        engine: engine.map(|engine| Box::new(engine) as Box<dyn Engine>),
    }
}

/// Returns every name by which an engine can be asked for: `reference`, those of the file, and the compilers with an adapter.
pub fn names(configuration: &ConfigurationFile) -> Vec<&str> {
    let own = configuration.engines().map(|(name, _)| name);
    let mut names: Vec<&str> = std::iter::once(REFERENCE).chain(own).collect();
    let others = Compiler::ALL.map(Compiler::as_str).into_iter();
    names.extend(others.filter(|name| configuration.engine(name).is_none()));
    names
}

/// Returns the error that no engine has the name, with the most similar name and the list of all.
pub fn no_such(name: &str, configuration: &ConfigurationFile) -> NoSuchEngine {
    let names = names(configuration);
    NoSuchEngine {
        name: name.to_owned(),
        meant: stickler_types::dialect_file::nearest(name, names.iter().copied()).map(str::to_owned),
        known: stickler_types::dialect_file::list(names),
    }
}

fn free(own: &str, taken: &[&str]) -> String {
    let numbered = (2..).map(|number| format!("{own}-{number}"));
    let mut names = std::iter::once(own.to_owned()).chain(numbered);
    let free = names.find(|name| !taken.contains(&name.as_str()));
    free.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::{by_name, by_names, free};
    use stickler_mdtest::assert_fits;

    #[test]
    fn an_engine_that_is_named_twice_is_used_once() {
        let names = ["reference".to_owned(), "reference".to_owned()];
        assert_eq!(by_names(&names).unwrap().len(), 1);
        assert_eq!(by_names(&[]).unwrap().len(), 1);
    }

    #[test]
    fn a_name_that_no_engine_has_is_an_error() {
        let names = ["reference".to_owned(), "nobody".to_owned()];
        let error = by_names(&names).err().unwrap().to_string();
        assert_fits(&error, "…`nobody`…`cmd:COMMAND LINE`…");
        assert!(by_name("cmd:no-such-program-anywhere").is_err());
    }

    #[test]
    fn engines_that_call_themselves_the_same_are_told_apart() {
        assert_eq!(free("st", &["reference"]), "st");
        assert_eq!(free("st", &["st", "st-2"]), "st-3");
    }
}
