//! IronPLC: `ironplcc` compiles a program to bytecode, and `ironplcvm` runs it and prints its variables.
//!
//! `ironplcc compile` analyses as `ironplcc check` does before it generates code, so its diagnostics are those of both.
//!
//! Basis: ironplc: `ironplcc --help`, `ironplcvm --help`; measured on version 0.239.

mod characters;
mod codes;
mod diagnostics;
mod dump;
mod options;
mod readback;
mod reproduction;
mod texts;

use super::dependencies::{Dependency, DependencySearch};
use super::fingerprint::Fingerprint;
use super::locate::{self, call, failed, faulted, unsupported};
use super::probe_variable::translate_with;
use super::source::main_program;
use crate::process::{Ended, Folder};
use crate::{
    Ability, Engine, EngineError, Grade, Identity, NamedValue, NoReproduction, Outcome, Reproduction,
    RunRequest, Session,
};
use dump::Dump;
use options::options;
use readback::{ReadbackError, Readbacks, RunHints};
pub(super) use reproduction::reproduce;
use std::path::{Path, PathBuf};
use stickler_types::{DialectName, Fault};
use texts::ReadableTexts;

const COMPILER: Dependency = Dependency {
    key: "ironplcc",
    variable: "STICKLER_IRONPLCC",
    name: "ironplcc",
};

const MACHINE: Dependency = Dependency {
    key: "ironplcvm",
    variable: "STICKLER_IRONPLCVM",
    name: "ironplcvm",
};

/// The dependencies of the adapter.
pub(super) const DEPENDENCIES: &[Dependency] = &[COMPILER, MACHINE];

/// The compiler and its virtual machine.
pub(super) struct Ironplc {
    identity: Identity,
    compiler: PathBuf,
    machine: PathBuf,
    texts: ReadableTexts,
}

impl Ironplc {
    /// Finds the compiler and its virtual machine.
    ///
    /// # Errors
    /// A fragment that says which program is missing, or what the compiler did when it was asked for its version.
    pub(super) fn find(called: &str, search: &mut DependencySearch<'_>) -> Result<Ironplc, String> {
        let compiler = search.program(COMPILER)?;
        let machine = search.program(MACHINE)?;
        let version = locate::version(&compiler, &["version"], &Folder::new()?)?;
        let version = version.rsplit(' ').next().unwrap_or_default().to_owned();
        let identity = Identity {
            name: called.to_owned(),
            version,
            dialects: dialects(),
            abilities: vec![Ability::Check, Ability::Execute, Ability::Render, Ability::Scans],
            // The registry's codes are those of this compiler.
            grade: Grade::Code,
            lacks: codes::lacking(&compiler),
        };
        Ok(Ironplc {
            identity,
            compiler,
            machine,
            texts: ReadableTexts::default(),
        })
    }
}

impl Engine for Ironplc {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let folder = locate::session_folder(&self.identity)?;
        Ok(Box::new(IronplcSession { engine: self, folder }))
    }

    fn fingerprint(&self) -> Option<String> {
        Fingerprint::of("ironplc")
            .program(&self.compiler)
            .program(&self.machine)
            .finish()
    }

    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        reproduce(request, ability)
    }

    fn tools(&self) -> Vec<(String, PathBuf)> {
        vec![COMPILER.at(&self.compiler), MACHINE.at(&self.machine)]
    }
}

/// A session: a folder in which one program at a time is compiled and run.
struct IronplcSession<'e> {
    engine: &'e Ironplc,
    folder: Folder,
}

impl Session for IronplcSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match self.compile(dialect, source) {
            Ok(_) => Outcome::ACCEPTED,
            Err(outcome) => outcome,
        }
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        self.echo(dialect, source).unwrap_or_else(|outcome| outcome)
    }
}

/// Returns the dialects that the compiler speaks: its presets, and the defined dialects that extend one.
fn dialects() -> Vec<DialectName> {
    let presets = [
        DialectName::IRONPLC_ED2,
        DialectName::IRONPLC_ED3,
        DialectName::IRONPLC_RUSTY,
    ];
    let defined = DialectName::defined().into_iter();
    let defined = defined.filter(|dialect| presets.contains(&dialect.base()));
    presets.into_iter().chain(defined).collect()
}

/// Checks that a request needs nothing between scans.
///
/// # Errors
/// [`Outcome::Unsupported`] where it does.
fn takes_no_settings(request: &RunRequest<'_>) -> Result<(), Outcome> {
    match request.clock.is_empty() && request.set.is_empty() {
        true => Ok(()),
        false => Err(unsupported(
            "ironplcvm takes neither a clock nor values between scans",
        )),
    }
}

impl IronplcSession<'_> {
    /// Executes a program, with probe variables for values that the dump does not show. Where the compiler does not accept the
    /// probe variables, the program is compiled without them, to tell whether it is accepted itself.
    fn try_run(&self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let unreadable = self.engine.texts.unreadable(self, request);
        self.run_with(request, RunHints::without(unreadable))
    }

    /// Executes a program with the probe variables that hints ask for, until every value is read.
    fn run_with(&self, request: &RunRequest<'_>, hints: RunHints) -> Result<Outcome, Outcome> {
        takes_no_settings(request)?;
        let mut readbacks = Readbacks::of(request, hints);
        loop {
            let container = self.compile_with_probes(request, &readbacks)?;
            let scans = Scans {
                session: self,
                container: &container,
            };
            // A second run is needed for texts that turn out to be long, and for names that several variables have.
            match scans.outcome(request, &readbacks) {
                Ok(RunResult::Done(early @ Outcome::Faulted { .. }))
                | Err(early @ Outcome::Crashed { .. })
                    if !readbacks.probes().is_empty() =>
                {
                    return Err(self.without_probes(request, early));
                }
                Ok(RunResult::Done(outcome)) => return Ok(outcome),
                Ok(RunResult::Retry(hints)) => readbacks = Readbacks::of(request, hints),
                Err(outcome) => return Err(outcome),
            }
        }
    }

    /// Returns the outcome of a program that ended early with its probe variables: what it does by itself, or
    /// [`Outcome::Error`] where it runs to its end without them, so that only its values cannot be read.
    fn without_probes(&self, request: &RunRequest<'_>, early: Outcome) -> Outcome {
        let container = self.compile(request.dialect, request.source);
        let alone = container.and_then(|container| {
            let session = self;
            let container = &container;
            Scans { session, container }.execute(request.scans)
        });
        match alone {
            Ok(ExecutionEnd::Finished(_)) => failed(format!(
                "its values cannot be read: the program runs to its end, and not with variables that copy them: {early}"
            )),
            Ok(ExecutionEnd::Faulted(..)) => early,
            Err(outcome) => outcome,
        }
    }

    fn compile_with_probes(
        &self,
        request: &RunRequest<'_>,
        readbacks: &Readbacks,
    ) -> Result<PathBuf, Outcome> {
        let Some(main) = main_program(request) else {
            return self.compile(request.dialect, request.source);
        };
        translate_with(request, &main, readbacks.probes(), |text| {
            self.compile(request.dialect, text)
        })
    }

    /// Compiles a program and returns the path of its bytecode.
    fn compile(&self, dialect: DialectName, source: &str) -> Result<PathBuf, Outcome> {
        let container = self.folder.path().join("program.iplc");
        let arguments = ["compile", "program.st", "-o", "program.iplc", "--dialect"];
        // The bytecode of an earlier program must not be taken for that of this one.
        let _ = std::fs::remove_file(&container);
        let ended = self.on_program(&arguments, dialect, source)?;
        match ended.code()? {
            0 if container.is_file() => Ok(container),
            0 => Err(failed("it accepted the program and wrote no bytecode".to_owned())),
            _ => Err(rejected(&ended)),
        }
    }

    /// Renders a program as `ironplcc echo` does.
    fn echo(&self, dialect: DialectName, source: &str) -> Result<Outcome, Outcome> {
        let ended = self.on_program(&["echo", "program.st", "--dialect"], dialect, source)?;
        match ended.code()? {
            0 => Ok(Outcome::Rendered { text: ended.stdout }),
            _ => Ok(rejected(&ended)),
        }
    }

    /// Runs the compiler on a program; the options of the dialect are the last arguments.
    fn on_program(&self, arguments: &[&str], dialect: DialectName, source: &str) -> Result<Ended, Outcome> {
        let options = options(dialect)?;
        self.folder.write("program.st", source).map_err(failed)?;
        let arguments: Vec<&str> = arguments.iter().copied().chain(options).collect();
        call(&self.engine.compiler, &arguments, &self.folder)
    }
}

/// Returns the outcome of a compiler that ended with an exit code other than 0.
fn rejected(ended: &Ended) -> Outcome {
    let diagnostics = diagnostics::read(&ended.stderr);
    // 1 means diagnostics; 101 is a panic of a Rust program.
    if ended.status.code() != Some(1) || diagnostics.is_empty() {
        return ended.crashed();
    }
    diagnostics::outcome(diagnostics)
}

/// The result of running a program and reading its values back.
enum RunResult {
    Done(Outcome),
    /// Some value was not shown; the next run has the probe variables that these hints ask for.
    Retry(RunHints),
}

/// The end of one execution.
enum ExecutionEnd {
    /// All scans were made; holds the output.
    Finished(String),
    /// A fault came first; holds the fault and the output.
    Faulted(Fault, String),
}

/// A compiled program that is run for one number of scans after another.
struct Scans<'s> {
    session: &'s IronplcSession<'s>,
    container: &'s Path,
}

impl Scans<'_> {
    /// Runs the program once for each scan after which a value is observed.
    fn outcome(&self, request: &RunRequest<'_>, readbacks: &Readbacks) -> Result<RunResult, Outcome> {
        let last = self.execute(request.scans)?;
        let mut values: Vec<NamedValue> = Vec::with_capacity(request.observe.len());
        for asked in request.observe {
            let earlier = match asked.after {
                Some(scan) if scan != request.scans => Some(self.execute(scan)?),
                _ => None,
            };
            match earlier.as_ref().unwrap_or(&last) {
                ExecutionEnd::Finished(text) => match readbacks.value(asked, &Dump::read(text)) {
                    Ok(value) => values.push((asked.key().to_string(), value)),
                    Err(ReadbackError::Retry(hints)) => return Ok(RunResult::Retry(hints)),
                    Err(ReadbackError::Unsupported(reason)) => return Err(unsupported(reason)),
                    Err(ReadbackError::Failed(reason)) => return Err(failed(reason)),
                },
                // The probe variables hold the values from before the fault; values that only they would show are left out.
                ExecutionEnd::Faulted(_, text) => {
                    values.extend(
                        readbacks
                            .simple(asked, &Dump::read(text))
                            .map(|value| (asked.key().to_string(), value)),
                    );
                }
            }
        }
        Ok(RunResult::Done(match last {
            ExecutionEnd::Finished(_) => Outcome::executed(values),
            ExecutionEnd::Faulted(fault, _) => faulted(fault, values),
        }))
    }

    fn execute(&self, scans: u32) -> Result<ExecutionEnd, Outcome> {
        let scans = scans.to_string();
        let container = self.container.as_os_str();
        let arguments = [
            "run".as_ref(),
            container,
            "--scans".as_ref(),
            scans.as_ref(),
            "--dump-vars".as_ref(),
        ];
        let ended = locate::execute(&self.session.engine.machine, &arguments, &self.session.folder)?;
        match ended.code()? {
            0 => Ok(ExecutionEnd::Finished(ended.stdout)),
            1 => match fault(&ended.stderr) {
                Some(fault) => Ok(ExecutionEnd::Faulted(fault, ended.stdout)),
                None => Err(failed(format!(
                    "it stopped for a reason that no fault is named after: {}",
                    ended.stderr.trim()
                ))),
            },
            _ => Err(ended.crashed()),
        }
    }
}

/// Returns the fault of a trap.
///
/// Basis: ironplc: problem codes of the virtual machine.
fn fault(stderr: &str) -> Option<Fault> {
    let code = stderr.find("V4").and_then(|at| stderr.get(at..at + 5))?;
    match code {
        "V4001" => Some(Fault::DivisionByZero),
        "V4003" => Some(Fault::StepLimit),
        "V4005" => Some(Fault::SubscriptRange),
        _ => None,
    }
}

#[cfg(all(test, unix))]
pub(super) mod tests;
