//! Engines that a table describes: commands, the meaning of their exit codes, and the forms of diagnostics and values.
//!
//! Such an engine does what the adapters of this crate do, as far as a table can express it: it writes a program into a private
//! folder, calls the compiler as a person would, and reads its output.

mod call;
mod description;
mod pattern;
mod reproduction;
mod template;
mod values;

use super::command::CommandTemplate;
use super::dependencies::{FoundBy, FoundDependency, executable, on_path};
use super::fingerprint::Fingerprint;
use super::locate::{self, faulted, speaks_not, unsupported, without_colours};
use super::probe_variable::{ProbeVariables, translate_with};
use super::settings::run_written;
use super::source::{main_program, observed_scans};
use crate::engine::no_rendering;
use crate::process::Folder;
use crate::{
    Ability, Diagnostic, Engine, EngineError, Grade, Identity, NamedValue, NoReproduction, Outcome,
    Reproduction, RunRequest, Session,
};
use call::{DescribedCall, Execution};
pub use description::Description;
pub(super) use description::Parsed;
pub(super) use pattern::DiagnosticPattern;
use regex_lite::Regex;
use std::collections::BTreeMap;
use std::env;
use std::path::{Path, PathBuf};
use stickler_types::{Code, DialectName};
use template::{HERE, SCANS, fixed};
use values::Printed;

/// A compiler whose command line a table describes.
pub struct DescribedEngine {
    identity: Identity,
    description: Description,
    /// The folder of `stickler.toml`.
    here: PathBuf,
}

impl DescribedEngine {
    /// Makes an engine of a description, to be called `called`; `here` is the folder to which its paths are relative.
    ///
    /// # Errors
    /// [`EngineError`] where one of its programs is missing, or does not say its version.
    pub fn start(
        called: &str,
        description: Description,
        here: &Path,
    ) -> Result<DescribedEngine, EngineError> {
        let not_started = |reason| EngineError::NotStarted {
            engine: format!("`{called}`"),
            reason,
        };
        for (key, template) in description.commands() {
            located(key, template, here).map_err(not_started)?;
        }
        let mut engine = DescribedEngine {
            identity: Identity {
                name: called.to_owned(),
                version: "unknown".to_owned(),
                dialects: description.dialects.keys().map(|dialect| dialect.0).collect(),
                abilities: abilities(&description),
                grade: description.grade.unwrap_or_else(|| best_grade(&description)),
                lacks: lacking(&description),
            },
            description,
            here: here.to_owned(),
        };
        if let Some(version) = engine.version().map_err(not_started)? {
            engine.identity.version = version;
        }
        Ok(engine)
    }

    /// Returns the programs of the commands that are on this machine.
    pub fn programs(description: &Description, here: &Path) -> Vec<FoundDependency> {
        let commands = description.commands().into_iter();
        commands
            .filter_map(|(key, template)| located(key, template, here).ok().flatten())
            .collect()
    }

    /// Returns the version that the command `version` prints: the first number with a point in it, or otherwise the first line.
    fn version(&self) -> Result<Option<String>, String> {
        let Some(template) = &self.description.version else {
            return Ok(None);
        };
        let folder = Folder::new()?;
        let call = DescribedCall {
            engine: self,
            folder: &folder,
            dialect: "",
        };
        let ended = call
            .run(&template.0, 0)
            .map_err(|outcome| format!("`version`: {outcome}"))?;
        if !ended.status.success() {
            return Err(format!("`version`: {}", ended.crashed()));
        }
        let said = locate::said(&ended).ok_or("`version` prints nothing")?;
        let said = without_colours(&said);
        // The expression is a constant that a test compiles; without it the whole line is the version.
        let number = Regex::new(r"\d+(\.\d+)+[0-9A-Za-z.+-]*").ok();
        let number = number.and_then(|number| Some(number.find(&said)?.as_str().to_owned()));
        Ok(Some(number.unwrap_or(said)))
    }
}

/// Returns the path of the program of a command; `None` for a program that a call itself makes.
fn located(
    key: &'static str,
    template: &CommandTemplate,
    here: &Path,
) -> Result<Option<FoundDependency>, String> {
    let Some(program) = fixed(template, here).0 else {
        return Ok(None);
    };
    let (path, by) = match program.components().count() {
        1 if !program.has_root() => {
            let name = program.to_string_lossy();
            let found = on_path(&name, env::var_os("PATH").as_deref());
            let found = found.ok_or_else(|| format!("there is no `{name}` on PATH, which `{key}` names"))?;
            (found, FoundBy::Path)
        }
        _ if !program.is_file() => {
            let shown = program.display();
            return Err(format!("there is no `{shown}`, which `{key}` names"));
        }
        _ => {
            let by = FoundBy::Configuration("stickler.toml".to_owned());
            (executable(program)?, by)
        }
    };
    Ok(Some(FoundDependency { key, path, by }))
}

fn abilities(description: &Description) -> Vec<Ability> {
    let mut abilities = vec![Ability::Check];
    if let Some(run) = &description.run {
        abilities.push(Ability::Execute);
        if run.0.has(SCANS) {
            abilities.push(Ability::Scans);
        }
    }
    if description.render.is_some() {
        abilities.push(Ability::Render);
    }
    abilities
}

/// Returns the best grade that the pattern of the diagnostics allows. Codes of the compiler's own are compared where the description says
/// what they mean.
fn best_grade(description: &Description) -> Grade {
    match &description.diagnostic {
        Some(pattern) if !pattern.0.tells("line") => Grade::Rejected,
        Some(pattern)
            if pattern.0.tells("code") && Code::ALL.iter().any(|code| description.codes.say(*code)) =>
        {
            Grade::Code
        }
        Some(_) => Grade::Line,
        None => Grade::Rejected,
    }
}

/// Returns the codes of the registry that no code of the compiler means, where some do: their rejections are judged by lines.
fn lacking(description: &Description) -> Vec<Code> {
    let is_by_codes = description.grade.is_none() && best_grade(description) == Grade::Code;
    let codes = Code::ALL.iter().copied().filter(|_| is_by_codes);
    codes.filter(|code| !description.codes.say(*code)).collect()
}

impl Engine for DescribedEngine {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let folder = locate::session_folder(&self.identity)?;
        Ok(Box::new(DescribedSession { engine: self, folder }))
    }

    /// Returns a digest of the description, its programs, the files that its commands name, and the version that it reports.
    fn fingerprint(&self) -> Option<String> {
        let mut fingerprint = Fingerprint::of("described")
            .text(&format!("{:?}", self.description))
            .text(&self.identity.version);
        for located in DescribedEngine::programs(&self.description, &self.here) {
            fingerprint = fingerprint.program(&located.path);
        }
        for (_, template) in self.description.commands() {
            for file in fixed(template, &self.here).1 {
                fingerprint = fingerprint.text(&file.to_string_lossy()).file(&file);
            }
        }
        fingerprint.finish()
    }

    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        self.description.reproduce(request, ability)
    }

    fn tools(&self) -> Vec<(String, PathBuf)> {
        let programs = DescribedEngine::programs(&self.description, &self.here).into_iter();
        let programs = programs.map(|found| (reproduction::program_variable(&found.path), found.path));
        programs.chain([(HERE.to_owned(), self.here.clone())]).collect()
    }
}

/// A session: a folder in which one program at a time is compiled and run.
struct DescribedSession<'e> {
    engine: &'e DescribedEngine,
    folder: Folder,
}

impl Session for DescribedSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match self.try_check(dialect, source) {
            Ok(warnings) => Outcome::Accepted { warnings },
            Err(outcome) => outcome,
        }
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.try_render(dialect, source).unwrap_or_else(|outcome| outcome)
    }
}

impl DescribedSession<'_> {
    /// Checks a program and returns its warnings.
    fn try_check(&self, dialect: DialectName, source: &str) -> Result<Vec<Diagnostic>, Outcome> {
        let description = &self.engine.description;
        let call = self.call(dialect)?;
        call.write(dialect, source)?;
        match (
            description.check.as_ref().or(description.compile.as_ref()),
            &description.run,
        ) {
            (Some(commands), _) => call.all(commands),
            // A compiler that only runs programs accepts a program by running it.
            (None, Some(run)) => call.execute(&run.0, 1).map(|execution| execution.warnings),
            (None, None) => Ok(Vec::new()),
        }
    }

    fn try_render(&self, dialect: DialectName, source: &str) -> Result<Outcome, Outcome> {
        let Some(render) = &self.engine.description.render else {
            return Err(no_rendering());
        };
        let call = self.call(dialect)?;
        call.write(dialect, source)?;
        let ended = call.run(&render.0, 0)?;
        call.accepted(&ended)?;
        Ok(Outcome::Rendered { text: ended.stdout })
    }

    /// Executes a program, with what is set between scans written into it.
    fn try_run(&self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let check = |request: &RunRequest<'_>| self.try_check(request.dialect, request.source);
        run_written(request, |request| self.try_run_written(request), check)
    }

    /// Executes a program, with copies of observed values that are no variables of their own.
    fn try_run_written(&self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let description = &self.engine.description;
        let (Some(run), Some(main)) = (&description.run, main_program(request)) else {
            return self
                .try_check(request.dialect, request.source)
                .map(|warnings| Outcome::Accepted { warnings });
        };
        takes_scans(&run.0, request)?;
        let call = self.call(request.dialect)?;
        let probes = ProbeVariables::of(request);
        let (mut warnings, mut executions): (_, BTreeMap<u32, Execution>) =
            translate_with(request, &main, probes.list(), |text| {
                call.write(request.dialect, text)?;
                let warnings = match &description.compile {
                    Some(compile) => call.all(compile)?,
                    None => Vec::new(),
                };
                let executions = observed_scans(request)
                    .into_iter()
                    .map(|scan| Ok((scan, call.execute(&run.0, scan)?)));
                Ok((warnings, executions.collect::<Result<_, Outcome>>()?))
            })?;
        let outcome = self.outcome(request, &probes, &executions)?;
        if let Some((_, last)) = executions.pop_last() {
            warnings.extend(last.warnings);
        }
        Ok(outcome.with_warnings(warnings))
    }

    /// Returns the outcome of the executions, one for each scan after which a value is observed.
    fn outcome(
        &self,
        request: &RunRequest<'_>,
        probes: &ProbeVariables,
        executions: &BTreeMap<u32, Execution>,
    ) -> Result<Outcome, Outcome> {
        let Some(pattern) = &self.engine.description.value else {
            return Ok(Outcome::ACCEPTED);
        };
        let printed: BTreeMap<u32, Printed<'_>> = executions
            .iter()
            .map(|(&scan, execution)| (scan, Printed::read(&pattern.0, &execution.text)))
            .collect();
        let fault = executions.get(&request.scans).and_then(|last| last.fault);
        let mut values: Vec<NamedValue> = Vec::with_capacity(request.observe.len());
        for asked in request.observe {
            let shown = printed
                .get(&asked.after.unwrap_or(request.scans))
                .ok_or("there was no such scan".to_owned())
                .and_then(|printed| printed.value(probes.variable(asked), asked, request));
            match (shown, fault) {
                (Ok(value), _) => values.push((asked.key().to_string(), value)),
                (Err(reason), None) => return Err(unsupported(reason)),
                // The fault may have come before the value was printed.
                (Err(_), Some(_)) => {}
            }
        }
        Ok(match fault {
            None => Outcome::executed(values),
            Some(fault) => faulted(fault, values),
        })
    }

    fn call(&self, dialect: DialectName) -> Result<DescribedCall<'_>, Outcome> {
        let word = self
            .engine
            .description
            .word(dialect)
            .ok_or_else(|| speaks_not(dialect))?;
        Ok(DescribedCall {
            engine: self.engine,
            folder: &self.folder,
            dialect: word,
        })
    }
}

/// Checks that a command makes the scans of a request.
///
/// # Errors
/// [`Outcome::Unsupported`] where it cannot.
fn takes_scans(run: &CommandTemplate, request: &RunRequest<'_>) -> Result<(), Outcome> {
    if !request.clock.is_empty() {
        return Err(unsupported("its commands take no clock"));
    }
    if request.needs_scans() && !run.has(SCANS) {
        return Err(unsupported("its command `run` takes no number of scans"));
    }
    Ok(())
}
