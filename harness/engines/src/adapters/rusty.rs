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
mod reproduction;

use super::builder::{self, Builder, Language};
use super::dependencies::{Dependency, DependencySearch};
use super::fingerprint::Fingerprint;
use super::locate::{self, failed, speaks, unsupported};
use super::rename::library_words;
use crate::process::{Folder, ToolLimits, run_tool_with};
use crate::{
    Ability, Diagnostic, Engine, EngineError, Grade, Identity, NoReproduction, Outcome, Packed, Reproduction,
    RunRequest, Session,
};
use diagnostics::OutputParser;
use driver::{HEADER, driver, functions};
use errors::{ErrorPart, LocatedDiagnostic, sorted};
use library::StandardLibrary;
use program::PackedProgram;
pub(super) use reproduction::reproduce;
use std::collections::HashSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::slice;
use std::sync::OnceLock;
use stickler_types::DialectName;

const COMPILER: Dependency = Dependency {
    key: "plc",
    variable: "STICKLER_PLC",
    name: "plc",
};

const DECLARATIONS: Dependency = Dependency {
    key: "include",
    variable: "STICKLER_RUSTY_INCLUDE",
    name: "the folder of the declarations (`*.st`) of RuSTy's standard functions",
};

const LIBRARY: Dependency = Dependency {
    key: "lib",
    variable: "STICKLER_RUSTY_LIB",
    name: "the folder of RuSTy's standard library (`libiec61131std`)",
};

/// The dependencies of the adapter.
pub(super) const DEPENDENCIES: &[Dependency] = &[COMPILER, DECLARATIONS, LIBRARY, builder::CC];

/// The compiler, its standard library, and the builder of a program from its object files.
pub(super) struct Rusty {
    identity: Identity,
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
    pub(super) fn find(called: &str, search: &mut DependencySearch<'_>) -> Result<Rusty, String> {
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
        let library = StandardLibrary::new(search.folder(LIBRARY, &folders)?);
        let builder = Builder::find(search, Language::C, declarations.clone(), HEADER)?;
        let version = locate::version(&compiler, &["--version"], &Folder::new()?)?;
        Ok(Rusty {
            identity: Identity {
                name: called.to_owned(),
                version: short(&version),
                dialects: vec![DialectName::RUSTY],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
                // The compiler's codes classify mistakes otherwise than the registry does.
                grade: Grade::Line,
                lacks: Vec::new(),
            },
            compiler,
            declarations,
            library,
            builder,
            reader: OutputParser::new()?,
            taken: OnceLock::new(),
        })
    }

    /// Returns every word of the declarations of the library, in capitals.
    fn taken(&self) -> &HashSet<String> {
        self.taken
            .get_or_init(|| library_words(&self.declarations, "st", DialectName::RUSTY))
    }

    /// Returns the linker's inputs beside the driver: the object file, the standard library, and the libraries that it needs.
    ///
    /// # Errors
    /// A fragment that says why there is no standard library to link.
    fn linked(&self) -> Result<Vec<OsString>, String> {
        let library = self.library.shared(&self.builder)?;
        let mut path = OsString::from("-Wl,-rpath,");
        path.push(library);
        let mut words = vec![OsString::from(OBJECT_FILE), "-L".into(), library.into(), path];
        words.push("-liec61131std".into());
        words.extend(library::NEEDED.map(OsString::from));
        // The object files hold addresses of texts, which a position-independent program must not have.
        if cfg!(target_os = "linux") {
            words.push("-no-pie".into());
        }
        Ok(words)
    }

    /// Builds the driver with the object file and the standard library.
    ///
    /// # Errors
    /// An outcome as [`Builder::build`] returns; [`Outcome::Error`] where there is no standard library to link.
    fn build(&self, driver: &str, folder: &Folder) -> Result<(), Outcome> {
        let linked = self.linked().map_err(failed)?;
        self.builder.build_with(driver, &linked, folder)
    }
}

impl Engine for Rusty {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let folder = locate::session_folder(&self.identity)?;
        Ok(Box::new(RustySession { engine: self, folder }))
    }

    fn fingerprint(&self) -> Option<String> {
        Fingerprint::of("rusty")
            .program(&self.compiler)
            .folder(&self.declarations)
            .folder(self.library.folder())
            .with(self.builder.fingerprint())
            .finish()
    }

    /// Returns the size beyond which the cost of starting the compilers for each pack is less than that of a failing program to
    /// its pack.
    fn pack_size(&self) -> usize {
        48
    }

    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        reproduce(request, ability)
    }

    fn tools(&self) -> Vec<(String, PathBuf)> {
        let tools = [
            (COMPILER, self.compiler.as_path()),
            (DECLARATIONS, &self.declarations),
            (LIBRARY, self.library.folder()),
            (builder::CC, self.builder.compiler()),
        ];
        tools.map(|(tool, path)| tool.at(path)).to_vec()
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

/// A session: a folder in which programs are compiled, built and run.
struct RustySession<'e> {
    engine: &'e Rusty,
    folder: Folder,
}

impl Session for RustySession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        pack::run(self, requests)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match speaks(DialectName::RUSTY, dialect).and_then(|()| self.accepts(&["--check"], source)) {
            Ok(warnings) => Outcome::Accepted { warnings },
            Err(outcome) => outcome,
        }
    }
}

/// The options that make an object file without optimisation.
const OBJECT: [&str; 5] = ["-c", "-O", "none", "-o", OBJECT_FILE];

const OBJECT_FILE: &str = "program.o";

/// The file of the functions that a driver calls.
const FUNCTIONS: &str = "stickler.st";

impl RustySession<'_> {
    fn try_run(&self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        speaks(DialectName::RUSTY, request.dialect)?;
        let Some(program) = PackedProgram::alone(request) else {
            let warnings = self.accepts(&OBJECT, request.source)?;
            return Ok(Outcome::Accepted { warnings });
        };
        let subjects = [program.subject()];
        let driver = driver(&subjects, &PackedProgram::file_of(program.place)).map_err(unsupported)?;
        let found = self.compile(slice::from_ref(&program), &functions(&subjects, &driver.subjects))?;
        if found.iter().any(|(_, reported)| reported.is_error()) {
            return Err(self.refused(&program, found));
        }
        self.engine.build(&driver.text, &self.folder)?;
        let outcome = driver.execute(&self.folder).map_err(diagnostics::steady)?;
        Ok(outcome.with_warnings(program.own(&found)))
    }

    /// Returns the outcome of the errors about the only program that was compiled.
    fn refused(&self, program: &PackedProgram<'_>, found: Vec<LocatedDiagnostic>) -> Outcome {
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
        match self.accepts(&OBJECT, program.request.source) {
            Ok(_) => unsupported(format!(
                "the functions that show its values are not accepted: {}",
                diagnostic.message
            )),
            Err(outcome) => outcome,
        }
    }

    /// Checks whether the compiler accepts a program as it is, and returns its warnings.
    fn accepts(&self, options: &[&str], source: &str) -> Result<Vec<Diagnostic>, Outcome> {
        let file = PackedProgram::file_of(0);
        self.folder.write(&file, source).map_err(failed)?;
        let found = self.call(&[file], options)?;
        let found = sorted(found.into_iter().map(|(_, diagnostic)| diagnostic));
        match found.iter().any(Diagnostic::is_error) {
            true => Err(Outcome::rejected(found)),
            false => Ok(found),
        }
    }

    /// Compiles programs and the functions that show their values to an object file, unless there are errors. Returns the
    /// errors, or the warnings.
    fn compile(
        &self,
        programs: &[PackedProgram<'_>],
        functions: &str,
    ) -> Result<Vec<LocatedDiagnostic>, Outcome> {
        let mut files = Vec::with_capacity(programs.len() + 1);
        for program in programs {
            let file = PackedProgram::file_of(program.place);
            self.folder.write(&file, program.text()).map_err(failed)?;
            files.push(file);
        }
        self.folder.write(FUNCTIONS, functions).map_err(failed)?;
        files.push(FUNCTIONS.to_owned());
        self.call(&files, &OBJECT)
    }

    /// Calls the compiler and returns its errors, or the warnings where it accepts its input.
    fn call(&self, files: &[String], options: &[&str]) -> Result<Vec<LocatedDiagnostic>, Outcome> {
        let mut declarations = self.engine.declarations.clone();
        declarations.push("*.st");
        let mut arguments: Vec<OsString> = files.iter().map(OsString::from).collect();
        arguments.extend(["--error-format=clang", "-i"].map(OsString::from));
        arguments.push(declarations.into());
        arguments.extend(options.iter().map(OsString::from));
        let limits = ToolLimits::default();
        let ended = run_tool_with(
            &self.engine.compiler,
            &arguments,
            self.folder.path(),
            &limits,
            |start| {
                // Where the compiler panics, its message is worth more than the backtrace.
                start.env("RUST_BACKTRACE", "0");
            },
        )?;
        self.engine.reader.diagnostics(&ended)
    }
}

#[cfg(all(test, unix))]
mod tests;
