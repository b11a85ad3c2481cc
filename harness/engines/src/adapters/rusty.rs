//! RuSTy: `plc` checks a program and compiles it to an object file, which is linked with a driver in C.
//!
//! Functions of Structured Text that are compiled beside the program pass the observed values to the driver. The program itself
//! is unchanged but for the name of its main program, since `main` is where a C program begins.
//!
//! Basis: rusty: its book, chapters *Using RuSTy*, *External Functions* and *Output format*, and what a build of April 2025
//! does, with LLVM 14.

mod diagnostics;
mod driver;
mod errors;
mod library;
mod pack;
mod program;

use super::adapter::{Adapter, AdapterEngine};
use super::builder::{self, Builder, Language};
use super::dependencies::{Dependency, DependencySearch};
use super::fingerprint::Fingerprint;
use super::locate::{self, failed, speaks, unsupported};
use super::recipe::{PROGRAM, Purpose, Recipe, Workplace};
use super::rename::library_words;
use super::reproduction::reproduce;
use super::source::main_program;
use crate::process::Folder;
use crate::{
    Ability, Diagnostic, Grade, Identity, NoReproduction, Outcome, Packed, Reproduction, RunRequest,
};
use diagnostics::OutputParser;
use driver::RustyDriver;
use errors::{ErrorPart, LocatedDiagnostic, sorted};
use library::StandardLibrary;
use program::PackedProgram;
use std::collections::HashSet;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use stickler_types::DialectName;

const COMPILER: Dependency = Dependency {
    key: "plc",
    variable: "STICKLER_PLC",
    name: "plc",
    script: "plc",
};

const DECLARATIONS: Dependency = Dependency {
    key: "include",
    variable: "STICKLER_RUSTY_INCLUDE",
    name: "the folder of the declarations (`*.st`) of RuSTy's standard functions",
    script: "$(dirname \"$(command -v \"$PLC\")\")/include",
};

const LIBRARY: Dependency = Dependency {
    key: "lib",
    variable: "STICKLER_RUSTY_LIB",
    name: "the folder of RuSTy's standard library (`libiec61131std`)",
    script: "$(dirname \"$(command -v \"$PLC\")\")/lib",
};

/// The dependencies of the adapter.
pub(super) const DEPENDENCIES: &[Dependency] = &[COMPILER, DECLARATIONS, LIBRARY, builder::CC];

/// The options that make an object file without optimisation; some mistakes are only found then.
const OBJECT: &str = "-c -O none -o program.o";

/// The option that puts each diagnostic on one line. A person needs it where there is a warning for each observed value.
const ONE_LINE: &str = "--error-format=clang";

/// Returns the recipe that gives files to the compiler.
fn compilation(files: &[(&str, &str)], options: &str) -> Recipe {
    let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
    let line = format!("{{PLC}} {} -i {{RUSTY_INCLUDE}}/*.st {options}", names.join(" "));
    let recipe = Recipe::default().step(DEPENDENCIES, Purpose::Translate, &line);
    files
        .iter()
        .fold(recipe, |recipe, (name, text)| recipe.file(name, *text))
}

/// Returns the recipe that compiles programs with the functions that show their values, links them with the driver and the
/// standard library, and runs them.
fn execution(programs: &[PackedProgram<'_>], driver: &RustyDriver<'_>) -> Recipe {
    let functions = driver.functions.concat();
    let mut files: Vec<(&str, &str)> = programs
        .iter()
        .map(|program| (&*program.file, program.text()))
        .collect();
    files.push((FUNCTIONS, &functions));
    // The object files hold addresses of texts, which a position-independent program must not have.
    let position = if cfg!(target_os = "linux") { " -no-pie" } else { "" };
    let build = format!(
        "{{CC}} -O0 -w driver.c program.o -o driver -L . -Wl,-rpath,. -liec61131std {}{position}",
        library::NEEDED
    );
    let (variables, share) = library::share();
    compilation(&files, &format!("{OBJECT} {ONE_LINE}"))
        .shell(&variables, share)
        .driver(DEPENDENCIES, &driver.driver.text(), &build)
}

/// The adapter: the compiler, its standard library, and the builder of a program from its object files.
pub(super) struct Rusty {
    compiler: PathBuf,
    declarations: PathBuf,
    library: StandardLibrary,
    builder: Builder,
    reader: OutputParser,
    /// The names that programs in a pack must not declare; read when first needed.
    taken: OnceLock<HashSet<String>>,
}

impl Rusty {
    /// Finds the compiler, its standard library, which otherwise lies beside it, and a C compiler.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(
        called: &str,
        search: &mut DependencySearch<'_>,
    ) -> Result<AdapterEngine<Rusty>, String> {
        let compiler = search.program(COMPILER)?;
        let beside = |path: &str| compiler.parent().unwrap_or(Path::new("")).join(path);
        // Where it is unpacked, where it is installed, and where its source is built.
        let include = [
            beside("include"),
            beside("../include/plc"),
            beside("../../libs/stdlib/iec61131-st"),
        ];
        let declarations = search.folder(DECLARATIONS, &include)?;
        let folders = [beside("lib"), beside("../lib/plc"), beside("")];
        let library = search.folder(LIBRARY, &folders)?;
        let builder = Builder::find(search, Language::C, declarations.clone(), driver::HEADER)?;
        let version = locate::version(&compiler, &["--version"], &Folder::new()?)?;
        Ok(AdapterEngine {
            identity: Identity {
                name: called.to_owned(),
                version: short(&version),
                dialects: vec![DialectName::RUSTY],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
                // The compiler's codes classify mistakes otherwise than the registry does.
                grade: Grade::Line,
                lacks: Vec::new(),
            },
            tools: vec![
                COMPILER.at(&compiler),
                DECLARATIONS.at(&declarations),
                LIBRARY.at(&library),
                builder::CC.at(builder.compiler()),
            ],
            adapter: Rusty {
                compiler,
                declarations,
                library: StandardLibrary::new(library),
                builder,
                reader: OutputParser::new()?,
                taken: OnceLock::new(),
            },
        })
    }

    /// Returns every word of the declarations of the library, in capitals.
    fn taken(&self) -> &HashSet<String> {
        self.taken
            .get_or_init(|| library_words(&self.declarations, "st", DialectName::RUSTY))
    }

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
fn short(said: &str) -> String {
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
    const PACK_SIZE: usize = 48;

    fn fingerprint(&self, fingerprint: Fingerprint) -> Fingerprint {
        fingerprint
            .program(&self.compiler)
            .folder(&self.declarations)
            .folder(self.library.folder())
            .with(self.builder.fingerprint())
    }

    fn reproduce(request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        speaks(DialectName::RUSTY, request.dialect)?;
        let translation = |text: String| compilation(&[(PROGRAM, &text)], OBJECT);
        let recipe = reproduce(request, ability, translation, |main| {
            let program = [PackedProgram::alone(request, main)?];
            Ok(execution(&program, &RustyDriver::of(&program)))
        })?;
        Ok(recipe.reproduction(DEPENDENCIES.iter().map(Dependency::usual)))
    }

    fn run(&self, workplace: &Workplace<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        speaks(DialectName::RUSTY, request.dialect)?;
        let Some(main) = main_program(request) else {
            let warnings = self.accepts(workplace, request.source, OBJECT)?;
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
        dialect: DialectName,
        source: &str,
    ) -> Result<Vec<Diagnostic>, Outcome> {
        speaks(DialectName::RUSTY, dialect)?;
        self.accepts(workplace, source, "--check")
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
        match self.accepts(workplace, program.request.source, OBJECT) {
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
        options: &str,
    ) -> Result<Vec<Diagnostic>, Outcome> {
        let recipe = compilation(&[(PROGRAM, source)], options);
        let found = self.compile(workplace, &recipe, &[ONE_LINE.as_ref()])?;
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

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn a_version_is_short_whatever_a_build_knows_of_itself() {
        for (said, shortened) in [
            (
                "0.2.0 (Tue Apr 8 10:00:00 2025 +0200, 1a2b3c4)",
                "0.2.0 (1a2b3c4)",
            ),
            ("0.1.0 (, )", "0.1.0"),
            ("plc 9.8.7", "9.8.7"),
            ("version information unavailable", "unknown"),
        ] {
            assert_eq!(short(said), shortened);
        }
    }
}
