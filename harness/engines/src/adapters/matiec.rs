//! matiec: `iec2c` translates a program to C, a C compiler builds it together with a driver, and the driver prints the observed
//! values exactly.
//!
//! A program that `iec2c` accepts and whose C cannot be built counts as a crash of the compiler: it neither rejected the
//! program nor made one that runs.
//!
//! Basis: matiec: `iec2c -h` and the C that it writes; measured.

mod diagnostics;
mod driver;
mod pack;

use super::Compiler;
use super::adapter::Adapter;
use super::builder::{Builder, C};
use super::compilers::path;
use super::driver::DriverText;
use super::fingerprint::Fingerprint;
use super::locate::unsupported;
use super::probe_variable::{ProbeVariables, translate_with, with_shown_probes};
use super::recipe::{PROGRAM, Purpose, Recipe, Tools, Workplace};
use super::rename::{TakenNames, library_words};
use super::source::{MainProgram, main_program};
use crate::{Diagnostic, NoReproduction, Outcome, Packed, RunRequest};
use driver::{LOCATIONS, MatiecSubject, driver};
use std::path::PathBuf;
use std::sync::LazyLock;
use stickler_types::DialectName;

/// Returns the recipe that translates a text to C.
fn translation(text: impl Into<String>) -> Recipe {
    Recipe::of(PROGRAM, text)
        .makes(&["POUS.c", "POUS.h", LOCATIONS])
        .step(Compiler::Matiec, Purpose::Translate, "translate", &[])
}

/// Returns the recipe that translates a text to C, builds it with a driver, and runs it.
fn execution(text: impl Into<String>, driver: &DriverText) -> Recipe {
    translation(text).driver(Compiler::Matiec, driver, &[])
}

/// The adapter: the library of the compiler, and the builder of its C.
pub(super) struct Matiec {
    library: PathBuf,
    compiler: PathBuf,
    builder: Builder,
    /// The words of the library.
    taken: TakenNames,
}

impl Adapter for Matiec {
    const COMPILER: Compiler = Compiler::Matiec;
    const PACK_SIZE: usize = 128;

    fn new(tools: &mut Tools) -> Result<Matiec, String> {
        let library = path(tools, "MATIEC_LIB");
        let folder = library.clone();
        Ok(Matiec {
            compiler: path(tools, "IEC2C"),
            builder: Builder::new(path(tools, "CC"), &C, library.join("C"), driver::HEADER)?,
            library,
            // Structured Text is in the `.txt` files; beside them lie programs of other kinds.
            taken: LazyLock::new(Box::new(move || {
                library_words(&folder, "txt", DialectName::MATIEC)
            })),
        })
    }

    fn fingerprint(&self, fingerprint: Fingerprint) -> Fingerprint {
        fingerprint
            .program(&self.compiler)
            .folder(&self.library)
            .with(self.builder.fingerprint())
    }

    fn translation(_: DialectName, source: &str) -> Result<Recipe, Outcome> {
        Ok(translation(source))
    }

    fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Recipe, NoReproduction> {
        let probes = ProbeVariables::of(request);
        let text = with_shown_probes(request, main, probes.list())?;
        let driver = driver(&[MatiecSubject::of(request, &probes, &main.name)])?;
        Ok(execution(text, &driver.text()))
    }

    fn run(&self, workplace: &Workplace<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let Some(main) = main_program(request) else {
            let warnings = self.check(workplace, request.dialect, request.source)?;
            return Ok(Outcome::Accepted { warnings });
        };
        let probes = ProbeVariables::of(request);
        let driver = match driver(&[MatiecSubject::of(request, &probes, &main.name)]) {
            Ok(driver) => driver,
            // A program that is rejected has no values to observe.
            Err(reason) => {
                translate(workplace, &translation(request.source))?;
                return Err(unsupported(reason));
            }
        };
        let text = driver.text();
        let (recipe, warnings) = translate_with(request, &main, probes.list(), |source| {
            let recipe = execution(source, &text);
            let warnings = translate(workplace, &recipe)?;
            Ok((recipe, warnings))
        })?;
        self.builder.build(&recipe, workplace)?;
        Ok(driver.execute(&recipe, workplace)?.with_warnings(warnings))
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
        translate(workplace, &translation(source))
    }
}

/// Translates the program of a recipe to C and returns the warnings.
fn translate(workplace: &Workplace<'_>, recipe: &Recipe) -> Result<Vec<Diagnostic>, Outcome> {
    workplace.begin(recipe)?;
    diagnostics::accepted(&workplace.step(recipe, Purpose::Translate, &[])?)
}
