//! `stickler engines`: lists the engines: where each was found, its abilities, and what is missing.

use crate::arguments::EnginesArguments;
use crate::exit::Exit;
use crate::output::{self, BOLD};
use crate::{engines, interrupt};
use serde_json::{Value as Json, json};
use std::io::{self, Write};
use stickler_configuration::{ConfigurationFile, EngineKind};
use stickler_engines::{Compiler, CompilerSearch, EngineError, FoundDependency, Identity};
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
        listed.sort_by_key(|engine| engine.identity().is_none());
    }
    for (number, engine) in listed.iter().enumerate() {
        match arguments.json {
            true => output::json_line(out, &engine.json())?,
            false => write_entry(engine, number > 0, out)?,
        }
    }
    let missing = listed.iter().any(|engine| engine.identity().is_none());
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

/// An entry of the list.
struct ListedEngine<'n> {
    name: &'n str,
    /// The engine, or the reason for which it cannot be used.
    sought: CompilerSearch,
    /// The compiler by whose adapter the engine runs, if it has one of Stickler's.
    compiler: Option<Compiler>,
    /// The place at which `stickler.toml` names the engine.
    named_in: Option<&'n str>,
    /// The address of the engine's project.
    project: Option<&'n str>,
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
        ListedEngine {
            name,
            sought,
            compiler,
            named_in: entry.map(|entry| entry.written.as_str()),
            project,
        }
    }

    /// Returns the identity of an engine that can be used.
    fn identity(&self) -> Option<&Identity> {
        self.sought.engine.as_ref().ok().map(|engine| engine.identity())
    }

    /// Returns the reason for which the engine cannot be used.
    fn problem(&self) -> Option<String> {
        self.sought.engine.as_ref().err().map(problem)
    }

    fn json(&self) -> Json {
        let identity = self.identity();
        let place = |found: &FoundDependency| json!({ "key": found.key, "path": found.path.display().to_string(), "found_by": found.by.to_string() });
        output::without_nulls(json!({
            "name": self.name,
            "here": identity.is_some(),
            "adapter": self.compiler.map(Compiler::as_str),
            "version": identity.map(|identity| &identity.version),
            "dialects": identity.map_or_else(Vec::new, |identity| words(&identity.dialects)),
            "abilities": identity.map_or_else(Vec::new, |identity| words(&identity.abilities)),
            "grade": identity.map(|identity| identity.grade.as_str()),
            "named_in": self.named_in,
            "places": self.sought.located.iter().map(place).collect::<Vec<_>>(),
            "problem": self.problem(),
            "project": self.project,
        }))
    }
}

fn words(names: &[impl ToString]) -> Vec<String> {
    names.iter().map(ToString::to_string).collect()
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
    let state = match engine.identity().map(|identity| identity.version.as_str()) {
        None => "not here",
        Some("") => "version not known",
        Some(version) => version,
    };
    writeln!(out, "{BOLD}{}{BOLD:#}  {state}", engine.name)?;
    let mut row = |label: &str, text: &str| writeln!(out, "  {label:LABEL_WIDTH$}  {text}");
    if let Some(named_in) = engine.named_in {
        row("named in", named_in)?;
    }
    for found in &engine.sought.located {
        row(found.key, &format!("{} ({})", found.path.display(), found.by))?;
    }
    if let Some(identity) = engine.identity() {
        row("dialects", &words(&identity.dialects).join(", "))?;
        row("can", &words(&identity.abilities).join(", "))?;
        row("judged by", identity.grade.as_str())?;
    }
    if let Some(problem) = engine.problem() {
        let text = wrap(&problem);
        for (number, line) in text.lines().enumerate() {
            row(if number == 0 { "problem" } else { "" }, line)?;
        }
        if let Some(project) = engine.project {
            row("install", project)?;
        }
    }
    Ok(())
}
