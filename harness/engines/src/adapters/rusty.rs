//! RuSTy: `plc` checks a program and compiles it to an object file, which is linked with a driver in C.
//!
//! Functions of Structured Text that are compiled beside the program pass the observed values to the driver. The program itself
//! is unchanged but for the name of its main program, since `main` is where a C program begins.
//!
//! Basis: rusty: its book, chapters *Using RuSTy*, *External Functions* and *Output format*, and what a build of April 2025
//! does, with LLVM 14.

mod diagnostics;
mod driver;
mod library;
mod pack;
mod program;

use super::Compiler;
use super::adapter::Adapter;
use super::builder::{Builder, C};
use super::compilers::path;
use super::fingerprint::Fingerprint;
use super::locate::{failed, unsupported};
use super::recipe::{PROGRAM, Purpose, Recipe, Tools, Workplace};
use super::rename::{TakenNames, library_words};
use super::source::{MainProgram, main_program};
use crate::{Diagnostic, NoReproduction, Outcome, Packed, RunRequest};
use diagnostics::OutputParser;
use diagnostics::{ErrorPart, LocatedDiagnostic, sorted};
use driver::RustyDriver;
use library::StandardLibrary;
use program::PackedProgram;
use std::ffi::OsStr;
use std::path::PathBuf;
use std::sync::LazyLock;
use stickler_types::DialectName;

/// Returns the recipe that gives a program to the compiler, for a command that says what it makes of it.
fn compilation(command: &str, source: &str) -> Recipe {
    Recipe::of(PROGRAM, source).step(Compiler::Rusty, Purpose::Translate, command, &[])
}

/// Returns the recipe that compiles programs with the functions that show their values, links them with the driver and the
/// standard library, and runs them.
fn execution(programs: &[PackedProgram<'_>], driver: &RustyDriver<'_>) -> Recipe {
    let names: Vec<&str> = programs
        .iter()
        .map(|program| &*program.file)
        .chain([FUNCTIONS])
        .collect();
    let files = programs.iter().fold(Recipe::default(), |recipe, program| {
        recipe.file(&program.file, program.text())
    });
    let position = if cfg!(target_os = "linux") { "-no-pie" } else { "" };
    let compiled = files.file(FUNCTIONS, driver.functions.concat()).step(
        Compiler::Rusty,
        Purpose::Translate,
        "compile",
        &[("files", &names.join(" "))],
    );
    library::share(compiled).driver(Compiler::Rusty, &driver.driver.text(), &[("position", position)])
}

/// The adapter: the compiler, its standard library, and the builder of a program from its object files.
pub(super) struct Rusty {
    compiler: PathBuf,
    declarations: PathBuf,
    library: StandardLibrary,
    builder: Builder,
    reader: OutputParser,
    /// The words of the declarations of the library.
    taken: TakenNames,
}

impl Rusty {
    /// Builds the driver of a recipe with the object file and the standard library.
    ///
    /// # Errors
    /// An outcome as [`Builder::build`] returns; [`Outcome::Error`] where there is no standard library to link.
    fn build(&self, recipe: &Recipe, workplace: &Workplace<'_>) -> Result<(), Outcome> {
        self.library.place(workplace).map_err(failed)?;
        self.builder.build(recipe, workplace)
    }
}

/// Shortens the version that the compiler reports: `0.2.0 (Tue Apr 8 10:00:00 2025 +0200, 1a2b3c4)` becomes `0.2.0 (1a2b3c4)`.
/// A build outside the compiler's repository has neither day nor revision.
pub(super) fn short(said: &str) -> String {
    let number = said
        .split_whitespace()
        .find(|word| word.starts_with(|first: char| first.is_ascii_digit()));
    let revision = said
        .strip_suffix(')')
        .and_then(|rest| rest.rsplit_once(", "))
        .map(|(_, revision)| revision.trim())
        .filter(|revision| !revision.is_empty());
    match (number, revision) {
        (Some(number), Some(revision)) => format!("{number} ({revision})"),
        (Some(number), None) => number.to_owned(),
        (None, _) => "unknown".to_owned(),
    }
}

/// The file of the functions that a driver calls.
const FUNCTIONS: &str = "show.st";

impl Adapter for Rusty {
    const COMPILER: Compiler = Compiler::Rusty;
    const PACK_SIZE: usize = 48;

    fn new(tools: &mut Tools) -> Result<Rusty, String> {
        let declarations = path(tools, "RUSTY_INCLUDE");
        let [headers, folder] = [&declarations; 2].map(PathBuf::clone);
        Ok(Rusty {
            compiler: path(tools, "PLC"),
            declarations,
            library: StandardLibrary::new(path(tools, "RUSTY_LIB")),
            builder: Builder::new(path(tools, "CC"), &C, headers, driver::HEADER)?,
            reader: OutputParser::new()?,
            taken: LazyLock::new(Box::new(move || library_words(&folder, "st", DialectName::RUSTY))),
        })
    }

    fn version(said: &str) -> String {
        short(said)
    }

    fn fingerprint(&self, fingerprint: Fingerprint) -> Fingerprint {
        fingerprint
            .program(&self.compiler)
            .folder(&self.declarations)
            .folder(self.library.folder())
            .with(self.builder.fingerprint())
    }

    fn translation(_: DialectName, source: &str) -> Result<Recipe, Outcome> {
        Ok(compilation("object", source))
    }

    fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Recipe, NoReproduction> {
        let program = [PackedProgram::alone(request, main)?];
        Ok(execution(&program, &RustyDriver::of(&program)))
    }

    fn run(&self, workplace: &Workplace<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let Some(main) = main_program(request) else {
            let warnings = self.accepts(workplace, request.source, "object")?;
            return Ok(Outcome::Accepted { warnings });
        };
        let programs = [PackedProgram::alone(request, &main).map_err(unsupported)?];
        let [program] = &programs;
        let driver = RustyDriver::of(&programs);
        let recipe = execution(&programs, &driver);
        let found = self.compile(workplace, &recipe, &[])?;
        if found.iter().any(|(_, reported)| reported.is_error()) {
            return Err(self.refused(workplace, program, found));
        }
        self.build(&recipe, workplace)?;
        let outcome = driver
            .driver
            .execute(&recipe, workplace)
            .map_err(diagnostics::steady)?;
        Ok(outcome.with_warnings(program.own(&found)))
    }

    fn run_pack(&self, workplace: &Workplace<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        pack::run(self, workplace, requests)
    }

    fn check(
        &self,
        workplace: &Workplace<'_>,
        _: DialectName,
        source: &str,
    ) -> Result<Vec<Diagnostic>, Outcome> {
        self.accepts(workplace, source, "check")
    }
}

impl Rusty {
    /// Returns the outcome of the errors about the only program that was compiled.
    fn refused(
        &self,
        workplace: &Workplace<'_>,
        program: &PackedProgram<'_>,
        found: Vec<LocatedDiagnostic>,
    ) -> Outcome {
        let own = |(about, _): &LocatedDiagnostic| matches!(about, ErrorPart::Program(_));
        let shows = |(about, _): &LocatedDiagnostic| matches!(about, ErrorPart::Functions(_));
        if found.iter().any(own) {
            let own = found.into_iter().filter(own);
            return diagnostics::rejected(own.map(|(_, diagnostic)| program.original(diagnostic)));
        }
        let Some((_, diagnostic)) = found.iter().find(|found| shows(found)) else {
            return diagnostics::rejected(found.into_iter().map(|(_, diagnostic)| diagnostic));
        };
        // The program alone decides whether it is accepted.
        match self.accepts(workplace, program.request.source, "object") {
            Ok(_) => unsupported(format!(
                "the functions that show its values are not accepted: {}",
                diagnostic.message
            )),
            Err(outcome) => outcome,
        }
    }

    /// Checks whether the compiler accepts a program as it is, and returns its warnings.
    fn accepts(
        &self,
        workplace: &Workplace<'_>,
        source: &str,
        command: &str,
    ) -> Result<Vec<Diagnostic>, Outcome> {
        let recipe = compilation(command, source);
        let found = self.compile(workplace, &recipe, &["--error-format=clang".as_ref()])?;
        let found = sorted(found.into_iter().map(|(_, diagnostic)| diagnostic));
        match found.iter().any(Diagnostic::is_error) {
            true => Err(Outcome::rejected(found)),
            false => Ok(found),
        }
    }

    /// Gives the files of a recipe to the compiler, with further options. Returns the errors, or the warnings where the compiler
    /// accepts its input.
    fn compile(
        &self,
        workplace: &Workplace<'_>,
        recipe: &Recipe,
        further: &[&OsStr],
    ) -> Result<Vec<LocatedDiagnostic>, Outcome> {
        workplace.begin(recipe)?;
        let ended = workplace.step(recipe, Purpose::Translate, further)?;
        self.reader.diagnostics(&ended)
    }
}
