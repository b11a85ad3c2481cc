//! `stickler engines`: lists the engines: where each was found, its abilities, and what is missing.

use crate::arguments::EnginesArguments;
use crate::exit::Exit;
use crate::output::{self, BOLD};
use crate::{engines, interrupt};
use serde::Serialize;
use std::io::{self, Write};
use stickler_configuration::{ConfigurationFile, EngineKind};
use stickler_engines::{Compiler, CompilerSearch, EngineError, FoundDependency};
use stickler_types::wrap;
use stickler_workers::WorkerPool;

/// Lists the engines that need no command line, or the named ones. A compiler that is not on this machine is a failure only
/// where it was named.
///
/// # Errors
/// A name that no engine has; a `stickler.toml` that cannot be used.
pub fn execute(arguments: &EnginesArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    interrupt::at_once()?;
    let configuration = engines::configuration()?;
    let names: Vec<&str> = match &arguments.engine[..] {
        [] => engines::names(&configuration),
        named => named.iter().map(String::as_str).collect(),
    };
    let mut listed = seek_all(&names, &configuration)?;
    // Whoever names nothing wants to see what is here.
    if arguments.engine.is_empty() {
        listed.sort_by_key(|engine| !engine.here);
    }
    for (number, engine) in listed.iter().enumerate() {
        match arguments.json {
            true => output::json_line(out, engine)?,
            false => write_entry(engine, number > 0, out)?,
        }
    }
    let missing = listed.iter().any(|engine| engine.problem.is_some());
    Ok(Exit::EngineNotRun.when(missing && !arguments.engine.is_empty()))
}

/// Searches for all engines at once: each asks a compiler for its version, and some compilers take a second to answer.
fn seek_all<'n>(
    names: &[&'n str],
    configuration: &'n ConfigurationFile,
) -> anyhow::Result<Vec<ListedEngine<'n>>> {
    WorkerPool::new(names.len()).map(
        names.iter(),
        || Ok(()),
        |(), &name| {
            let sought = engines::seek(name, name, configuration);
            let sought = sought.ok_or_else(|| engines::no_such(name, configuration))?;
            Ok(ListedEngine::new(name, sought, configuration))
        },
    )
}

/// The entry of one engine in the list; the fields are those of the JSON object.
#[derive(Serialize)]
struct ListedEngine<'n> {
    name: &'n str,
    /// Whether the engine can be used.
    here: bool,
    /// Stickler's own adapter by which the engine runs, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    adapter: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    version: Option<String>,
    dialects: Vec<&'static str>,
    abilities: Vec<String>,
    /// The grade at which the engine's rejections are judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    grade: Option<&'static str>,
    /// The place at which `stickler.toml` names the engine.
    #[serde(skip_serializing_if = "Option::is_none")]
    named_in: Option<&'n str>,
    places: Vec<FoundPlace>,
    /// The reason for which the engine cannot be used.
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<String>,
    /// The address of the engine's project.
    #[serde(skip_serializing_if = "Option::is_none")]
    project: Option<&'n str>,
}

/// The place of a program or folder of an engine.
#[derive(Serialize)]
struct FoundPlace {
    key: &'static str,
    path: String,
    found_by: String,
}

impl From<FoundDependency> for FoundPlace {
    fn from(located: FoundDependency) -> FoundPlace {
        FoundPlace {
            key: located.key,
            path: located.path.display().to_string(),
            found_by: located.by.to_string(),
        }
    }
}

impl<'n> ListedEngine<'n> {
    fn new(name: &'n str, sought: CompilerSearch, configuration: &'n ConfigurationFile) -> ListedEngine<'n> {
        let entry = configuration.engine(name);
        let (compiler, project) = match entry.map(|entry| &entry.kind) {
            Some(EngineKind::Compiler { compiler, .. }) => (Some(*compiler), Some(compiler.project())),
            Some(EngineKind::Described(description)) => (None, description.project()),
            Some(EngineKind::Command { .. }) => (None, None),
            None => {
                let compiler = Compiler::from_word(name);
                (compiler, compiler.map(Compiler::project))
            }
        };
        let identity = sought.engine.as_ref().ok().map(|engine| engine.identity());
        let dialects = identity
            .map(|identity| &identity.dialects[..])
            .unwrap_or_default();
        let abilities = identity
            .map(|identity| &identity.abilities[..])
            .unwrap_or_default();
        ListedEngine {
            name,
            here: identity.is_some(),
            adapter: compiler.map(Compiler::as_str),
            version: identity.map(|identity| identity.version.clone()),
            dialects: dialects.iter().map(|dialect| dialect.as_str()).collect(),
            abilities: abilities.iter().map(ToString::to_string).collect(),
            grade: identity.map(|identity| identity.grade.as_str()),
            named_in: entry.map(|entry| entry.written.as_str()),
            problem: sought.engine.as_ref().err().map(problem),
            places: sought.located.into_iter().map(FoundPlace::from).collect(),
            project,
        }
    }
}

/// Returns the message of an error without the engine's name, which stands above it.
fn problem(error: &EngineError) -> String {
    match error {
        EngineError::NotStarted { reason, .. } => reason.clone(),
        EngineError::SpeaksNone { .. } => error.to_string(),
    }
}

/// The width of the column of labels, in characters.
const LABEL_WIDTH: usize = 10;

fn write_entry(engine: &ListedEngine<'_>, gap: bool, out: &mut dyn Write) -> io::Result<()> {
    if gap {
        writeln!(out)?;
    }
    let state = match &engine.version {
        None => "not here",
        Some(version) if version.is_empty() => "version not known",
        Some(version) => version,
    };
    writeln!(out, "{BOLD}{}{BOLD:#}  {state}", engine.name)?;
    let mut row = |label: &str, text: &str| writeln!(out, "  {label:LABEL_WIDTH$}  {text}");
    if let Some(named_in) = engine.named_in {
        row("named in", named_in)?;
    }
    for place in &engine.places {
        row(place.key, &format!("{} ({})", place.path, place.found_by))?;
    }
    if engine.here {
        row("dialects", &engine.dialects.join(", "))?;
        row("can", &engine.abilities.join(", "))?;
        row("judged by", engine.grade.unwrap_or_default())?;
    }
    if let Some(problem) = &engine.problem {
        let text = wrap(problem);
        for (number, line) in text.lines().enumerate() {
            row(if number == 0 { "problem" } else { "" }, line)?;
        }
        if let Some(project) = engine.project {
            row("install", project)?;
        }
    }
    Ok(())
}
