//! `stickler reproduce`: writes all that shows a case on a compiler without Stickler.

mod subject;

use crate::arguments::ReproduceArguments;
use crate::exit::Exit;
use crate::{engines, interrupt, output};
use anyhow::{Context, anyhow, bail};
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use stickler_configuration::{ConfigurationFile, EngineKind};
use stickler_engines::{
    Ability, Compiler, Description, Engine, NoReproduction, Reproduction, RunRequest, reproduce_and_run,
    shell_quote,
};
use subject::ReproducedProgram;

/// Writes the program, the files around it, the script and a README; runs the script where the compiler is here.
///
/// # Errors
/// No such case or file; an engine that nobody knows, that has no command line of its own, or that would not run the program; a
/// folder that is not empty or cannot be written.
pub fn execute(arguments: &ReproduceArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    interrupt::at_once()?;
    let configuration = engines::configuration()?;
    let compiler = KnownCompiler::named(&arguments.engine, &configuration)?;
    let subjects = ReproducedProgram::all(arguments)?;
    let shown = first_shown(&subjects, &compiler, &arguments.engine);
    let (subject, reproduction) = shown.map_err(|error| match in_other_dialect(arguments, &compiler) {
        Some(key) => anyhow!("{error}; it shows `{key}`"),
        None => error,
    })?;
    let folder = &arguments.folder;
    make_empty(folder)?;
    let here = find(&arguments.engine, &configuration);
    let (reproduction, printed) = match &here {
        Some(engine) => shown_here(&**engine, subject)?,
        None => (reproduction, None),
    };
    if let [_, _, ..] = subjects[..] {
        output::note(format!("this is the case in {}", subject.case.dialect));
    }
    let unwritten = || format!("cannot write to {}", folder.display());
    let names = reproduction.write(folder).with_context(unwritten)?;
    let page = ReproductionPage {
        subject,
        engine: &arguments.engine,
        program: &names[0],
        printed: here
            .as_ref()
            .zip(printed.as_deref())
            .map(|(engine, text)| (engine.identity().version.as_str(), text)),
    };
    fs::write(folder.join(README), page.text()).with_context(unwritten)?;
    writeln!(
        out,
        "{} has {} and {README}.\n",
        folder.display(),
        names.join(", ")
    )?;
    page.write(out)?;
    let script = folder.join("run.sh");
    writeln!(
        out,
        "To see it again: sh {}",
        shell_quote(&script.to_string_lossy())
    )?;
    Ok(Exit::AsExpected)
}

/// A compiler whose command line Stickler knows, whether it is here or not.
enum KnownCompiler<'c> {
    Adapter(Compiler),
    Described(&'c Description),
    /// One that speaks the wire protocol; holds the command of its key `reproduce`.
    Spoken(&'c str),
}

impl KnownCompiler<'_> {
    /// Returns the compiler of a name.
    ///
    /// # Errors
    /// No engine has the name, or it has no command line of its own.
    fn named<'c>(name: &str, configuration: &'c ConfigurationFile) -> anyhow::Result<KnownCompiler<'c>> {
        let entry = configuration.engine(name).map(|entry| &entry.kind);
        match (entry, Compiler::from_word(name)) {
            (Some(EngineKind::Compiler { compiler, .. }), _) => Ok(KnownCompiler::Adapter(*compiler)),
            (None, Some(compiler)) => Ok(KnownCompiler::Adapter(compiler)),
            (Some(EngineKind::Described(description)), _) => Ok(KnownCompiler::Described(description)),
            (Some(EngineKind::Command { reproduce, .. }), _) => match reproduce {
                Some(command) => Ok(KnownCompiler::Spoken(command)),
                None => Err(NoReproduction::NoTools(name.to_owned()).into()),
            },
            (None, None) if name == engines::REFERENCE || name.starts_with(engines::COMMAND) => {
                Err(NoReproduction::NoTools(name.to_owned()).into())
            }
            (None, None) => Err(engines::no_such(name, configuration).into()),
        }
    }

    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        match self {
            KnownCompiler::Adapter(compiler) => compiler.reproduce(request, ability),
            KnownCompiler::Described(description) => description.reproduce(request, ability),
            KnownCompiler::Spoken(command) => Ok(Reproduction::by_command(command, request)),
        }
    }
}

/// Returns the first subject that the compiler shows, and its reproduction.
///
/// # Errors
/// The reason why it shows none.
fn first_shown<'s>(
    subjects: &'s [ReproducedProgram],
    compiler: &KnownCompiler<'_>,
    engine: &str,
) -> anyhow::Result<(&'s ReproducedProgram, Reproduction)> {
    let mut reason = None;
    for subject in subjects {
        match compiler.reproduce(&subject.case.request(), subject.ability(None)) {
            Ok(reproduction) => return Ok((subject, reproduction)),
            Err(error) => reason = reason.or(Some(error)),
        }
    }
    let reason = reason.map_or_else(String::new, |reason| format!(": {reason}"));
    bail!("{engine} does not show this program{reason}")
}

/// Returns the key of a case that was named with a dialect, in another dialect in which the compiler shows it.
fn in_other_dialect(arguments: &ReproduceArguments, compiler: &KnownCompiler<'_>) -> Option<String> {
    let (id, _) = arguments.case.rsplit_once('@')?;
    let subjects = ReproducedProgram::of_case(id, arguments).ok()?;
    let (subject, _) = first_shown(&subjects, compiler, &arguments.engine).ok()?;
    Some(subject.heading().0)
}

/// Makes a folder, which must be empty where it is there.
fn make_empty(folder: &Path) -> anyhow::Result<()> {
    let shown = folder.display();
    fs::create_dir_all(folder).with_context(|| format!("cannot make the folder {shown}"))?;
    let mut entries = fs::read_dir(folder).with_context(|| format!("cannot read {shown}"))?;
    match entries.next() {
        None => Ok(()),
        Some(_) => bail!("{shown} is not empty; name a folder that is, or none that is there"),
    }
}

/// Finds a compiler; says on stderr why not where it is not here.
fn find(name: &str, configuration: &ConfigurationFile) -> Option<Box<dyn Engine>> {
    let engine = engines::seek(name, name, configuration)?.engine;
    let engine = engine.map_err(|error| output::note(format!("the files are not tried: {error}")));
    engine.ok()
}

/// Returns the reproduction of a program, by what the engine does with it, and what its script prints; says on stderr why not where
/// it does not end.
fn shown_here(
    engine: &dyn Engine,
    subject: &ReproducedProgram,
) -> Result<(Reproduction, Option<String>), NoReproduction> {
    let request = subject.case.request();
    let session = engine.session().ok();
    let outcome = session.map(|mut session| session.run(&request));
    let ability = subject.ability(outcome.as_ref());
    let (reproduction, printed) = reproduce_and_run(engine, &request, ability)?;
    let printed = printed.map_err(|reason| output::note(format!("run.sh: {reason}")));
    Ok((reproduction, printed.ok().map(|printed| printed.text)))
}

/// The name of the file.
const README: &str = "README.md";

/// The facts that are printed about a reproduction.
struct ReproductionPage<'p> {
    subject: &'p ReproducedProgram,
    /// The name of the engine.
    engine: &'p str,
    /// The name of the file of the program.
    program: &'p str,
    /// The version of the compiler that is here, and what the script printed.
    printed: Option<(&'p str, &'p str)>,
}

impl ReproductionPage<'_> {
    /// Returns the text of the README.
    fn text(&self) -> String {
        let (heading, title) = self.subject.heading();
        let mut text = format!("# `{heading}` on {}\n\n", self.engine);
        if !title.is_empty() {
            text.push_str(&format!("{title}.\n\n"));
        }
        text.push_str(&format!(
            "`sh run.sh` gives `{}` to {}, with the compiler's own tools alone. The variables at the head of `run.sh` say where \
             these are.\n\n",
            self.program, self.engine
        ));
        for (what, shown) in self.results() {
            text.push_str(&format!("{what}:\n\n{}\n", indented(&shown)));
        }
        text.push_str(&format!("Lines are those of `{}`.\n", self.program));
        text
    }

    /// Writes the expectation and the output.
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        for (what, shown) in self.results() {
            writeln!(out, "{what}:\n\n{}", indented(&shown))?;
        }
        Ok(())
    }

    /// Returns the expectation and the output, each with what it is.
    fn results(&self) -> Vec<(String, String)> {
        let mut results = Vec::new();
        if let Some((facts, basis)) = self.subject.expected() {
            results.push((format!("Expected, by {basis}"), facts));
        }
        if let Some((version, text)) = self.printed {
            let text = if text.is_empty() { "(nothing)" } else { text };
            results.push((format!("Printed with {} {version}", self.engine), text.to_owned()));
        }
        results
    }
}

/// Returns a text as a block of Markdown, which no text can end.
fn indented(text: &str) -> String {
    let lines = text.lines().map(|line| match line.trim_end() {
        "" => "\n".to_owned(),
        line => format!("    {line}\n"),
    });
    lines.collect()
}
