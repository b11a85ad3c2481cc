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
mod reproduction;

use super::builder::{self, Builder, Language};
use super::dependencies::{Dependency, DependencySearch};
use super::fingerprint::Fingerprint;
use super::locate::{self, call, failed, speaks, unsupported};
use super::probe_variable::{ProbeVariables, translate_with};
use super::rename::library_words;
use super::source::{MainProgram, main_program, words_of};
use crate::process::{Ended, Folder};
use crate::{
    Ability, Diagnostic, Engine, EngineError, Grade, Identity, NoReproduction, Outcome, Packed, Reproduction,
    RunRequest, Session,
};
use driver::{LOCATIONS, MatiecSubject, driver};
pub(super) use reproduction::reproduce;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use stickler_types::DialectName;

/// Returns the configuration without which no C is written. It stands behind the program, so that no line of the program moves.
fn configuration(program: &str) -> String {
    format!(
        "\nCONFIGURATION stickler_configuration\n  RESOURCE stickler_resource ON PLC\n    \
         TASK stickler_task(INTERVAL := T#1s, PRIORITY := 0);\n    \
         PROGRAM stickler_instance WITH stickler_task : {program};\n  END_RESOURCE\nEND_CONFIGURATION\n"
    )
}

/// Returns the configuration that has to stand behind a program; nothing where the program brings its own.
fn added_configuration(request: &RunRequest<'_>, main: &MainProgram) -> String {
    match words_of(request).any(|word| word.is("CONFIGURATION")) {
        true => String::new(),
        false => configuration(&main.name),
    }
}

/// The header that every built program includes; it is compiled once.
const HEADER: &str =
    "#include \"iec_std_lib.h\"\n#include \"accessor.h\"\n#include <stdio.h>\n#include <string.h>\n";

const COMPILER: Dependency = Dependency {
    key: "iec2c",
    variable: "STICKLER_IEC2C",
    name: "iec2c",
};

const LIBRARY: Dependency = Dependency {
    key: "lib",
    variable: "STICKLER_MATIEC_LIB",
    name: "the library of iec2c",
};

/// The dependencies of the adapter.
pub(super) const DEPENDENCIES: &[Dependency] = &[COMPILER, LIBRARY, builder::CC];

/// The compiler, its library, and the builder of its C.
pub(super) struct Matiec {
    identity: Identity,
    compiler: PathBuf,
    library: PathBuf,
    builder: Builder,
    /// The names that programs in a pack must not declare; see [`Matiec::taken`].
    taken: OnceLock<HashSet<String>>,
}

impl Matiec {
    /// Finds the compiler, its library, which otherwise lies beside it, and a C compiler.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(called: &str, search: &mut DependencySearch<'_>) -> Result<Matiec, String> {
        let compiler = search.program(COMPILER)?;
        let library = search.folder(LIBRARY, &libraries(&compiler))?;
        let builder = Builder::find(search, Language::C, library.join("C"), HEADER)?;
        let version = locate::version(&compiler, &["-v"], &Folder::new()?)?;
        Ok(Matiec {
            identity: Identity {
                name: called.to_owned(),
                version: version.rsplit(' ').next().unwrap_or_default().to_owned(),
                dialects: vec![DialectName::MATIEC],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
                // The compiler has no diagnostic codes.
                grade: Grade::Line,
                lacks: Vec::new(),
            },
            compiler,
            library,
            builder,
            taken: OnceLock::new(),
        })
    }

    /// Returns every word of the library, in capitals. Structured Text is in the `.txt` files; beside them lie programs of
    /// other kinds.
    fn taken(&self) -> &HashSet<String> {
        self.taken
            .get_or_init(|| library_words(&self.library, "txt", DialectName::MATIEC))
    }
}

/// Returns the places where the library may be: in the source tree, or where it is installed.
fn libraries(compiler: &Path) -> [PathBuf; 3] {
    let beside = |path: &str| compiler.parent().unwrap_or(Path::new("")).join(path);
    [
        beside("lib"),
        beside("../lib/matiec"),
        beside("../share/matiec/lib"),
    ]
}

impl Engine for Matiec {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let folder = locate::session_folder(&self.identity)?;
        Ok(Box::new(MatiecSession { engine: self, folder }))
    }

    fn fingerprint(&self) -> Option<String> {
        Fingerprint::of("matiec")
            .program(&self.compiler)
            .folder(&self.library)
            .with(self.builder.fingerprint())
            .finish()
    }

    /// Returns the size beyond which the cost of starting the compilers for each pack is less than that of a failing program to
    /// its pack.
    fn pack_size(&self) -> usize {
        128
    }

    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        reproduce(request, ability)
    }

    fn tools(&self) -> Vec<(String, PathBuf)> {
        let tools = [
            (COMPILER, self.compiler.as_path()),
            (LIBRARY, self.library.as_path()),
            (builder::CC, self.builder.compiler()),
        ];
        tools.map(|(tool, path)| tool.at(path)).to_vec()
    }
}

/// A session: a folder in which one program at a time is translated, built and run.
struct MatiecSession<'e> {
    engine: &'e Matiec,
    folder: Folder,
}

impl Session for MatiecSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        pack::run(self, requests)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match speaks(DialectName::MATIEC, dialect).and_then(|()| self.translate(source)) {
            Ok(warnings) => Outcome::Accepted { warnings },
            Err(outcome) => outcome,
        }
    }
}

impl MatiecSession<'_> {
    fn try_run(&self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        speaks(DialectName::MATIEC, request.dialect)?;
        let Some(main) = main_program(request) else {
            let warnings = self.translate(request.source)?;
            return Ok(Outcome::Accepted { warnings });
        };
        let probes = ProbeVariables::of(request);
        let subject = MatiecSubject {
            request: *request,
            probes: &probes,
            program: main.name.clone(),
        };
        let driver = driver(&[subject]).map_err(unsupported)?;
        let configuration = added_configuration(request, &main);
        let warnings = translate_with(request, &main, probes.list(), |text| {
            self.translate(&format!("{text}{configuration}"))
        })?;
        self.engine.builder.build(&driver.text, &self.folder)?;
        Ok(driver.execute(&self.folder)?.with_warnings(warnings))
    }

    /// Translates a program to C and returns the warnings.
    fn translate(&self, source: &str) -> Result<Vec<Diagnostic>, Outcome> {
        diagnostics::accepted(&self.compile(source)?)
    }

    /// Runs the compiler on a program, which reports its diagnostics and writes its C.
    fn compile(&self, source: &str) -> Result<Ended, Outcome> {
        self.folder.write("program.st", source).map_err(failed)?;
        for left in ["POUS.c", "POUS.h", LOCATIONS] {
            // What an earlier program left behind must not be taken for this one.
            let _ = std::fs::remove_file(self.folder.path().join(left));
        }
        let library = self.engine.library.as_os_str();
        let arguments = [
            "-i".as_ref(),
            "-I".as_ref(),
            library,
            "-T".as_ref(),
            ".".as_ref(),
            "program.st".as_ref(),
        ];
        call(&self.engine.compiler, &arguments, &self.folder)
    }
}
