//! RuSTy: `plc` checks a program and compiles it to an object file, which is linked with a driver in C.
//!
//! What is observed the program itself tells the driver, by calls of external functions before its `END_PROGRAM`; no line
//! moves. Its main program gets another name there, since `main` is where a C program begins.
//!
//! Basis: rusty: its book, chapters *Using RuSTy*, *External Functions* and *Output format*. The compiler needs a release of
//! LLVM that was not at hand: this adapter is held to what the book shows and to stand-ins, not to the compiler itself.

mod driver;

use super::builder::{self, Builder, Language};
use super::described::DiagnosticPattern;
use super::fingerprint::Fingerprint;
use super::locate::{self, call, failed, told};
use super::places::{Place, Search};
use super::plain::without_colours;
use super::source::main_program;
use crate::process::{Ended, Folder};
use crate::{Ability, Diagnostic, Engine, EngineError, Grade, Identity, Outcome, RunRequest, Session};
use driver::{HEADER, driver, instrumented};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use stickler_types::{BuiltIn, Code, DialectName};

const COMPILER: Place = Place {
    key: "plc",
    variable: "STICKLER_PLC",
    name: "plc",
};

const DECLARATIONS: Place = Place {
    key: "include",
    variable: "STICKLER_RUSTY_INCLUDE",
    name: "the folder of the declarations (`*.st`) of RuSTy's standard functions",
};

const LIBRARY: Place = Place {
    key: "lib",
    variable: "STICKLER_RUSTY_LIB",
    name: "the folder of RuSTy's standard library (`libiec61131std`)",
};

/// What is to be found.
pub(super) const PLACES: &[Place] = &[COMPILER, DECLARATIONS, LIBRARY, builder::CC];

/// How it writes a diagnostic with `--error-format=clang`. Warnings have their own word.
const DIAGNOSTIC: &str = r"^(?<file>.+?):(?<line>\d+):(?<column>\d+):(?:\{\d+:\d+-(?<end_line>\d+):(?<end_column>\d+)\}:)? error\[(?<code>\w+)\]: (?<message>.*)$";

/// The compiler, its standard library, and what builds a program of its object files.
pub(super) struct Rusty {
    identity: Identity,
    compiler: PathBuf,
    declarations: PathBuf,
    library: PathBuf,
    builder: Builder,
    diagnostic: DiagnosticPattern,
}

impl Rusty {
    /// Finds the compiler, its standard library, which otherwise lies beside it, and a C compiler.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(called: &str, search: &mut Search<'_>) -> Result<Rusty, String> {
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
        let builder = Builder::find(search, Language::C, declarations.clone(), HEADER)?;
        let version = locate::version(&compiler, &["--version"], &Folder::new()?)?;
        Ok(Rusty {
            identity: Identity {
                name: called.to_owned(),
                version: version.rsplit(' ').next().unwrap_or_default().to_owned(),
                // It documents no dialect of ours; this one has what IronPLC takes over from it.
                dialects: vec![DialectName::IronplcRusty],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
                // Its codes divide mistakes otherwise than the registry does.
                grade: Grade::Line,
            },
            compiler,
            declarations,
            library,
            builder,
            diagnostic: DIAGNOSTIC.parse()?,
        })
    }

    /// What a driver is linked with besides the object file: the standard library, static where there is one, and what that
    /// is made of.
    fn libraries(&self) -> Vec<OsString> {
        let folder = &self.library;
        let whole = folder.join("libiec61131std.a");
        let mut words: Vec<OsString> = match whole.is_file() {
            true => vec![whole.into()],
            false => {
                let mut path = OsString::from("-Wl,-rpath,");
                path.push(folder);
                vec!["-L".into(), folder.into(), path, "-liec61131std".into()]
            }
        };
        words.extend(["-lm", "-lpthread", "-ldl"].map(OsString::from));
        words
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
            .file(&self.compiler)
            .folder(&self.declarations)
            .folder(&self.library)
            .with(self.builder.fingerprint())
            .finish()
    }

    fn own_command(&self, dialect: DialectName, file: &str) -> Option<String> {
        self.identity
            .speaks(dialect)
            .then(|| format!("plc --check {file}"))
    }
}

/// A folder in which one program at a time is compiled, built and run.
struct RustySession<'e> {
    engine: &'e Rusty,
    folder: Folder,
}

impl Session for RustySession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match speaks(dialect).and_then(|()| self.compile(&["--check"], source)) {
            Ok(()) => Outcome::Accepted,
            Err(outcome) => outcome,
        }
    }

    fn render(&mut self, _: DialectName, _: &str) -> Outcome {
        unsupported("plc gives no normalised source")
    }
}

fn unsupported(reason: &str) -> Outcome {
    Outcome::Unsupported {
        reason: reason.to_owned(),
    }
}

fn speaks(dialect: DialectName) -> Result<(), Outcome> {
    match dialect.base() {
        BuiltIn::IronplcRusty => Ok(()),
        _ => Err(unsupported(&format!("it does not speak {dialect}"))),
    }
}

/// The options that make an object file, without optimisation.
const OBJECT: [&str; 5] = ["-c", "-O", "none", "-o", "program.o"];

impl RustySession<'_> {
    fn try_run(&self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        speaks(request.dialect)?;
        let Some(main) = main_program(request.source) else {
            self.compile(&OBJECT, request.source)?;
            return Ok(Outcome::Accepted);
        };
        let driver = driver(request).map_err(|reason| Outcome::Unsupported { reason })?;
        let shown = match (main.returns, request.scans) {
            (true, _) => Err("a program that may return early shows nothing".to_owned()),
            (_, 0) => Err("before the first scan nothing is shown".to_owned()),
            _ => self
                .compile(&OBJECT, &instrumented(request, &main, driver.kinds()))
                .map_err(|outcome| {
                    format!(
                        "the calls that show its values are not accepted: {}",
                        told(&outcome)
                    )
                }),
        };
        if let Err(reason) = shown {
            // The program alone decides whether it is accepted.
            self.compile(&OBJECT, request.source)?;
            return Err(Outcome::Unsupported { reason });
        }
        let mut further = vec![OsString::from("program.o")];
        further.extend(self.engine.libraries());
        self.engine
            .builder
            .build_with(&driver.text, &further, &self.folder)?;
        driver.execute(&self.folder)
    }

    /// Calls the compiler on a program.
    fn compile(&self, options: &[&str], source: &str) -> Result<(), Outcome> {
        self.folder.write("program.st", source).map_err(failed)?;
        let mut declarations = self.engine.declarations.clone();
        declarations.push("*.st");
        let mut arguments: Vec<OsString> = ["program.st", "--error-format=clang", "-i"]
            .map(OsString::from)
            .to_vec();
        arguments.push(declarations.into());
        arguments.extend(options.iter().map(OsString::from));
        let ended = call(&self.engine.compiler, &arguments, &self.folder)?;
        match ended.code()? {
            0 => Ok(()),
            1 => Err(self.rejected(&ended)),
            _ => Err(ended.crashed()),
        }
    }

    fn rejected(&self, ended: &Ended) -> Outcome {
        let text = without_colours(&format!("{}\n{}", ended.stderr, ended.stdout));
        let told = self.engine.diagnostic.diagnostics(&text, "program.st");
        let mut diagnostics: Vec<Diagnostic> = told.into_iter().map(translated).collect();
        if diagnostics.is_empty() {
            return ended.crashed();
        }
        diagnostics.sort_by(|a, b| (a.line, a.column, &a.code).cmp(&(b.line, b.column, &b.code)));
        diagnostics.dedup();
        Outcome::Rejected { diagnostics }
    }
}

/// A diagnostic with the registry's code where one of the compiler's says the same.
///
/// Basis: rusty: its reference of error codes: E037 is an invalid assignment.
fn translated(diagnostic: Diagnostic) -> Diagnostic {
    match diagnostic.code.as_deref() {
        Some("E037") => Diagnostic {
            code: Some(Code::AssignmentTypeMismatch.as_str().to_owned()),
            message: format!("E037: {}", diagnostic.message),
            ..diagnostic
        },
        _ => diagnostic,
    }
}

#[cfg(all(test, unix))]
mod tests;
