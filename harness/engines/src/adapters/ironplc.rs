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
mod texts;

use super::Compiler;
use super::adapter::Adapter;
use super::compilers::path;
use super::fingerprint::Fingerprint;
use super::locate::{failed, faulted, unsupported};
use super::probe_variable::{translate_with, with_shown_probes};
use super::recipe::{PROGRAM, Purpose, Recipe, Tools, Workplace};
use super::settings::copied_by_scan;
use super::source::{MainProgram, main_program, observed_scans};
use crate::process::Ended;
use crate::{Diagnostic, Identity, NamedValue, NoReproduction, Outcome, RunRequest};
use dump::Dump;
use options::options;
use readback::{ReadbackError, Readbacks, RunHints};
use std::collections::BTreeMap;
use std::path::PathBuf;
use stickler_types::{DialectName, Fault};
use texts::ReadableTexts;

/// The bytecode that the compiler writes.
const BYTECODE: &str = "program.iplc";

/// Returns the recipe that gives a program to a command of the compiler: `compile` or `render`.
///
/// # Errors
/// [`Outcome::Unsupported`] for a dialect that the compiler does not speak.
fn translation(command: &str, dialect: DialectName, text: &str) -> Result<Recipe, Outcome> {
    let options = options(dialect)?.join(" ");
    let values = [("options", &*options)];
    Ok(Recipe::of(PROGRAM, text).step(Compiler::Ironplc, Purpose::Translate, command, &values))
}

/// Returns the recipe that compiles a program.
///
/// # Errors
/// Fails as [`translation`] does.
fn compilation(dialect: DialectName, text: &str) -> Result<Recipe, Outcome> {
    Ok(translation("compile", dialect, text)?.makes(&[BYTECODE]))
}

/// Returns the recipe that compiles the text of a request and runs it anew for each scan after which a value is observed.
///
/// # Errors
/// [`Outcome::Unsupported`] for a dialect that the compiler does not speak.
fn execution(request: &RunRequest<'_>, text: &str, readbacks: &Readbacks) -> Result<Recipe, Outcome> {
    let runs = observed_scans(request);
    let compiled = compilation(request.dialect, text)?.legend(readbacks.probes());
    Ok(runs.iter().fold(compiled, |recipe, &scans| {
        let recipe = match runs.len() {
            1 => recipe,
            _ => recipe.shell(&[], format!("echo 'After scan {scans}:'")),
        };
        let values = [("scans", &*scans.to_string())];
        recipe.step(Compiler::Ironplc, Purpose::Execute(Some(scans)), "run", &values)
    }))
}

/// The adapter: the compiler and its virtual machine.
pub(super) struct Ironplc {
    compiler: PathBuf,
    machine: PathBuf,
    texts: ReadableTexts,
}

impl Adapter for Ironplc {
    const COMPILER: Compiler = Compiler::Ironplc;

    fn new(tools: &mut Tools) -> Result<Ironplc, String> {
        Ok(Ironplc {
            compiler: path(tools, "IRONPLCC"),
            machine: path(tools, "IRONPLCVM"),
            texts: ReadableTexts::default(),
        })
    }

    /// Adds the defined dialects that extend a preset, and the codes that this version does not have or never reports.
    fn identify(&self, identity: &mut Identity) {
        let defined = DialectName::defined().into_iter();
        let extends = |dialect: &DialectName| identity.dialects.contains(&dialect.base());
        let defined: Vec<DialectName> = defined.filter(extends).collect();
        identity.dialects.extend(defined);
        identity.lacks = codes::lacking(&self.compiler);
        identity
            .lacks
            .extend(Self::COMPILER.data().codes.never_reported());
    }

    fn fingerprint(&self, fingerprint: Fingerprint) -> Fingerprint {
        fingerprint.program(&self.compiler).program(&self.machine)
    }

    fn translation(dialect: DialectName, source: &str) -> Result<Recipe, Outcome> {
        compilation(dialect, source)
    }

    fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Recipe, NoReproduction> {
        takes_no_clock(request)?;
        let readbacks = Readbacks::of(request, RunHints::default());
        let text = with_shown_probes(request, main, readbacks.probes())?;
        Ok(execution(request, &text, &readbacks)?)
    }

    fn rendering(dialect: DialectName, source: &str) -> Result<Recipe, Outcome> {
        translation("render", dialect, source)
    }

    /// Executes a program, with probe variables for values that the dump does not show. Where the compiler does not accept the
    /// probe variables, the program is compiled without them, to tell whether it is accepted itself.
    fn run(&self, workplace: &Workplace<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let unreadable = self.texts.unreadable(workplace, request);
        let Some(copied) = copied_by_scan(request) else {
            return run_with(workplace, request, RunHints::without(unreadable));
        };
        let with_copies = RunRequest {
            source: &copied.text,
            observe: &copied.observe,
            ..*request
        };
        match run_with(workplace, &with_copies, RunHints::without(unreadable.clone())) {
            Ok(Outcome::Executed { values, warnings }) => {
                let named = request.observe.iter().zip(values);
                let named = named
                    .map(|(asked, (_, value))| (asked.key().to_string(), value))
                    .collect();
                Ok(Outcome::executed(named).with_warnings(warnings))
            }
            // What it does without the copies is its own.
            _ => run_with(workplace, request, RunHints::without(unreadable)),
        }
    }

    fn check(
        &self,
        workplace: &Workplace<'_>,
        dialect: DialectName,
        source: &str,
    ) -> Result<Vec<Diagnostic>, Outcome> {
        compile(workplace, &compilation(dialect, source)?)?;
        Ok(Vec::new())
    }

    fn render(
        &self,
        workplace: &Workplace<'_>,
        dialect: DialectName,
        source: &str,
    ) -> Result<Outcome, Outcome> {
        let recipe = translation("render", dialect, source)?;
        workplace.begin(&recipe)?;
        let ended = workplace.step(&recipe, Purpose::Translate, &[])?;
        match ended.code()? {
            0 => Ok(Outcome::Rendered { text: ended.stdout }),
            _ => Ok(rejected(&ended)),
        }
    }
}

/// Checks that a request sets no clock: the virtual machine's is that of the machine.
///
/// # Errors
/// [`Outcome::Unsupported`] where it does.
fn takes_no_clock(request: &RunRequest<'_>) -> Result<(), Outcome> {
    match request.clock.is_empty() {
        true => Ok(()),
        false => Err(unsupported("ironplcvm takes no clock")),
    }
}

/// Executes a program with the probe variables that hints ask for, until every value is read.
fn run_with(
    workplace: &Workplace<'_>,
    request: &RunRequest<'_>,
    hints: RunHints,
) -> Result<Outcome, Outcome> {
    takes_no_clock(request)?;
    let mut readbacks = Readbacks::of(request, hints);
    loop {
        let compiled = |text: &str| {
            let recipe = execution(request, text, &readbacks)?;
            compile(workplace, &recipe).map(|()| recipe)
        };
        let recipe = match main_program(request) {
            Some(main) => translate_with(request, &main, readbacks.probes(), compiled)?,
            None => compiled(request.source)?,
        };
        // A second run is needed for texts that turn out to be long, and for names that several variables have.
        match outcome(workplace, &recipe, request, &readbacks) {
            Ok(RunResult::Done(early @ Outcome::Faulted { .. })) | Err(early @ Outcome::Crashed { .. })
                if !readbacks.probes().is_empty() =>
            {
                return Err(without_probes(workplace, request, &readbacks, early));
            }
            Ok(RunResult::Done(outcome)) => return Ok(outcome),
            Ok(RunResult::Retry(hints)) => readbacks = Readbacks::of(request, hints),
            Err(outcome) => return Err(outcome),
        }
    }
}

/// Returns the outcome of a program that ended early with its probe variables: what it does by itself, or [`Outcome::Error`] where
/// it runs to its end without them, so that only its values cannot be read.
fn without_probes(
    workplace: &Workplace<'_>,
    request: &RunRequest<'_>,
    readbacks: &Readbacks,
    early: Outcome,
) -> Outcome {
    let alone = execution(request, request.source, readbacks).and_then(|recipe| {
        compile(workplace, &recipe)?;
        execute(workplace, &recipe, request.scans)
    });
    match alone {
        Ok(ExecutionEnd::Finished(_)) => failed(format!(
            "its values cannot be read: the program runs to its end, and not with variables that copy them: {early}"
        )),
        Ok(ExecutionEnd::Faulted(..)) => early,
        Err(outcome) => outcome,
    }
}

/// Compiles the program of a recipe.
fn compile(workplace: &Workplace<'_>, recipe: &Recipe) -> Result<(), Outcome> {
    workplace.begin(recipe)?;
    let ended = workplace.step(recipe, Purpose::Translate, &[])?;
    match ended.code()? {
        0 if workplace.folder.path().join(BYTECODE).is_file() => Ok(()),
        0 => Err(failed("it accepted the program and wrote no bytecode".to_owned())),
        _ => Err(rejected(&ended)),
    }
}

/// Returns the outcome of a compiler that ended with an exit code other than 0.
fn rejected(ended: &Ended) -> Outcome {
    let diagnostics = diagnostics::read(&ended.stderr);
    // 1 means diagnostics; 101 is a panic of a Rust program.
    if ended.status.code() != Some(1) || diagnostics.is_empty() {
        return ended.crashed();
    }
    Compiler::Ironplc.data().codes.outcome(diagnostics)
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

/// Runs a compiled program once for each scan after which a value is observed.
fn outcome(
    workplace: &Workplace<'_>,
    recipe: &Recipe,
    request: &RunRequest<'_>,
    readbacks: &Readbacks,
) -> Result<RunResult, Outcome> {
    let last = execute(workplace, recipe, request.scans)?;
    let scans = observed_scans(request).into_iter();
    let earlier: BTreeMap<u32, ExecutionEnd> = scans
        .filter(|scan| *scan != request.scans)
        .map(|scan| Ok((scan, execute(workplace, recipe, scan)?)))
        .collect::<Result<_, Outcome>>()?;
    let mut values: Vec<NamedValue> = Vec::with_capacity(request.observe.len());
    for asked in request.observe {
        let earlier = asked.after.and_then(|scan| earlier.get(&scan));
        match earlier.unwrap_or(&last) {
            ExecutionEnd::Finished(text) => match readbacks.value(asked, &Dump::read(text)) {
                Ok(value) => values.push((asked.key().to_string(), value)),
                Err(ReadbackError::Retry(hints)) => return Ok(RunResult::Retry(hints)),
                Err(ReadbackError::Unsupported(reason)) => return Err(unsupported(reason)),
                Err(ReadbackError::Failed(reason)) => return Err(failed(reason)),
            },
            // The probe variables hold the values from before the fault; values that only they would show are left out.
            ExecutionEnd::Faulted(_, text) => {
                let simple = readbacks.simple(asked, &Dump::read(text));
                values.extend(simple.map(|value| (asked.key().to_string(), value)));
            }
        }
    }
    Ok(RunResult::Done(match last {
        ExecutionEnd::Finished(_) => Outcome::executed(values),
        ExecutionEnd::Faulted(fault, _) => faulted(fault, values),
    }))
}

/// Runs a compiled program for this number of scans.
fn execute(workplace: &Workplace<'_>, recipe: &Recipe, scans: u32) -> Result<ExecutionEnd, Outcome> {
    let ended = workplace.step(recipe, Purpose::Execute(Some(scans)), &[])?;
    match ended.code()? {
        0 => Ok(ExecutionEnd::Finished(ended.stdout)),
        1 => {
            let known = Compiler::Ironplc.data().fault(&ended.stderr);
            let fault = known.unwrap_or_else(|| Fault::reported(&super::locate::first_error(&ended)));
            Ok(ExecutionEnd::Faulted(fault, ended.stdout))
        }
        _ => Err(ended.crashed()),
    }
}
